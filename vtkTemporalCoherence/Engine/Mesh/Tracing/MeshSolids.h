// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshSolids_h
#define TemporalCoherence_MeshSolids_h

#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Cells/MeshCell.h"
#include "Scene/RayBatch.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Two places on a ray in touching cells count as one if they differ by less than this share of the
/// distance: more than rounding errors.
constexpr double TouchingPlaces = 0x1p-36;

/// A part of a ray that is inside a THRESHOLD solid in one cell.
struct SolidPart
{
  double From, To;
  HitKind Kind; ///< Entry: it begins where the field rises; Cap: where the ray enters the cell
  std::uint8_t Ray;
  CellNumber Cell;
  bool IsAtEnd; ///< it begins where the ray leaves the cell, within rounding
};

/// Append the parts of rays that are inside a cell's solid, between Begin and End of the rays.
/// The parts of one ray ascend.
/// \param differences of the cell's values from the isovalue
/// \param inMesh      the rays, without limits (RayLimits::None)
/// \param which       one bit for each ray
/// \throws std::bad_alloc
void AppendSolidParts(const MeshCell& cell, const MeshKernels::CellDifferences& differences,
  CellNumber number, const RayBatch& rays, const MeshKernels::MeshRays& inMesh, std::uint64_t which,
  std::vector<SolidPart>& parts);

}

#endif
