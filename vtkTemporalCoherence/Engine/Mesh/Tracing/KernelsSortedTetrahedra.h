// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsSortedTetrahedra_h
#define TemporalCoherence_KernelsSortedTetrahedra_h

#include "Mesh/Cells/KernelsKnownTetrahedra.h"
#include "Mesh/Tiles/MeshDifference.h"

namespace TemporalCoherence
{

/// Find the differences and the order of points of many tetrahedra, as MeshDifference and
/// TetrahedronPoints do, with the same bits.
/// \return one bit for each cell that the isovalue passes
std::uint64_t SortTetrahedra(const MeshKernels::TetrahedronLanes& cells,
  const MeshDifference& difference, MeshKernels::SortedTetrahedra& sorted);

}

#endif
