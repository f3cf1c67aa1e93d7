// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MissingCells_h
#define TemporalCoherence_MissingCells_h

#include "Grids/GridLeaves.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Find the cells whose own values are not numbers. They are hidden, as flagged cells are.
/// \param missing gets 1 for each of them and 0 for the others; empty if there are none, or if the
///                values lie at points
/// \throws std::bad_alloc
void FindMissingCells(
  const GridLeaf& leaf, const DrawnComponent& component, std::vector<std::uint8_t>& missing);

}

#endif
