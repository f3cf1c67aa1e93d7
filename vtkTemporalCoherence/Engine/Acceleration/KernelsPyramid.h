// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsPyramid_h
#define TemporalCoherence_KernelsPyramid_h

#include "Scene/Field.h"

namespace TemporalCoherence
{

/// The most rows of nodes to scan at once: neighbours share samples, and long stretches of memory
/// are read faster than short ones.
constexpr int MostNodeRows = 4;

/// Find the value ranges of rows of nodes along x and of their leaves, as ValueRangePyramid::Range
/// of the field's sample type.
/// \param first  y and z of the first row, counted in nodes
/// \param rows   rows of nodes, along y; at most MostNodeRows
/// \param nodes  first node of the first row
/// \param leaves of the first node
void FindRangesOfNodes(
  const Field& field, const glm::ivec2& first, int rows, void* nodes, void* leaves);

}

#endif
