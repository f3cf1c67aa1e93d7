// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MissingCells_h
#define TemporalCoherence_MissingCells_h

#include "Grids/GridLeaves.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Find the cells whose own values are NaN. They are hidden like flagged cells.
/// \param missing receives 1 for these cells and 0 for others; empty without such cells, or if
///                values lie at points
/// \throws std::bad_alloc
void FindMissingCells(
  const GridLeaf& leaf, const DrawnComponent& component, std::vector<std::uint8_t>& missing);

}

#endif
