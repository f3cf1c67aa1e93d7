// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshDefectText_h
#define TemporalCoherence_MeshDefectText_h

#include "Grids/CellOrigins.h"
#include "Grids/GridLeaves.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

struct Mesh;
struct MeshProblem;

/// What is wrong with a mesh and what to do about it. Empty if it was not set up because it was
/// stopped, or for lack of memory.
std::string TextOf(const MeshProblem& problem, const Mesh& mesh, const CellOrigins& origins,
  const std::vector<GridLeaf>& leaves);

/// Tells that a mesh needs too much memory, and what to do about it.
/// \param cells of the input
/// \param needed at least, and the limit, in bytes
std::string TextOfMemory(std::int64_t cells, std::size_t needed, std::size_t limit);

}

#endif
