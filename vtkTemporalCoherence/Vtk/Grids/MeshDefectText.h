// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshDefectText_h
#define TemporalCoherence_MeshDefectText_h

#include "Grids/CellOrigins.h"
#include "Grids/GridLeaves.h"

#include <cstddef>
#include <string>
#include <vector>

namespace TemporalCoherence
{

struct Mesh;
struct MeshProblem;

/// What is wrong with a mesh and what to do about it. Empty if it was not set up because it was
/// stopped.
/// \param limit of memory, in bytes
std::string TextOf(const MeshProblem& problem, const Mesh& mesh, const CellOrigins& origins,
  const std::vector<GridLeaf>& leaves, std::size_t limit);

}

#endif
