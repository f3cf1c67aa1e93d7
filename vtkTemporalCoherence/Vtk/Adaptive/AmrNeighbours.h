// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrNeighbours_h
#define TemporalCoherence_AmrNeighbours_h

#include "Adaptive/AmrBlocks.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// For each block, the blocks whose boxes on the finest lattice touch or overlap its own,
/// ascending.
/// \throws std::bad_alloc
std::vector<std::vector<std::size_t>> NeighboursOf(const std::vector<AmrBlock>& blocks);

}

#endif
