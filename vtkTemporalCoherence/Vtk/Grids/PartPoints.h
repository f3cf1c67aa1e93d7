// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PartPoints_h
#define TemporalCoherence_PartPoints_h

#include "Mesh/Cells/MeshCell.h"

#include <algorithm>
#include <cstdint>

namespace TemporalCoherence
{

/// Call `visit(point)` for the points of a cell of any type, also of a hidden one. Invalid ids are
/// left out: the set-up of the mesh reports them.
template <typename Visit>
void ForEachPoint(const MeshPart& part, std::int64_t cell, const Visit& visit)
{
  if (part.Dimensions.x > 0)
  {
    const glm::i64vec3 cells = glm::i64vec3(part.Dimensions) - std::int64_t(1);
    const std::int64_t row = part.Dimensions.x, slice = row * part.Dimensions.y;
    const std::int64_t first =
      cell % cells.x + cell / cells.x % cells.y * row + cell / cells.x / cells.y * slice;
    for (std::int64_t corner = 0; corner < 8; ++corner)
    {
      visit(first + (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * slice);
    }
    return;
  }
  const std::int64_t end = std::min(part.OffsetOf(cell + 1), part.ConnectivitySize);
  for (std::int64_t at = std::max<std::int64_t>(part.OffsetOf(cell), 0); at < end; ++at)
  {
    const std::int64_t id = part.Connectivity.IdAt(at);
    if (id >= 0 && id < part.NumberOfPoints)
    {
      visit(id);
    }
  }
}

}

#endif
