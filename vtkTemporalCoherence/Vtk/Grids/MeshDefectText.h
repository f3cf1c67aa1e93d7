// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshDefectText_h
#define TemporalCoherence_MeshDefectText_h

#include "Grids/GridLeaves.h"
#include "Input/CellOrigins.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

struct Mesh;
struct MeshProblem;

/// The error message for a defect of a mesh, with the remedy. Empty if the set-up was stopped, or
/// lacked memory.
std::string TextOf(const MeshProblem& problem, const Mesh& mesh, const CellOrigins& origins,
  const std::vector<GridLeaf>& leaves);

/// The error message for a mesh that needs too much memory, with the remedy.
/// \param cells of the input
/// \param needed at least, in bytes, and the limit
std::string TextOfMemory(std::int64_t cells, std::size_t needed, std::size_t limit);

}

#endif
