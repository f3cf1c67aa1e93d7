// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrLeaves_h
#define TemporalCoherence_AmrLeaves_h

#include "Adaptive/AmrBlocks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Numbers the leaves of an adaptive grid. A leaf is a cell that is neither refined nor hidden, and
/// that no earlier block covers. Leaves do not overlap.
class AmrLeaves
{
public:
  /// \return false if there are more leaves than numbers
  /// \throws std::bad_alloc
  bool Find(const AmrBlocks& blocks);

  std::int32_t Count() const { return this->Total; }

  /// The number of a cell of a block; -1 if it is no leaf.
  std::int32_t NumberOf(std::size_t block, std::int64_t cell) const
  {
    return this->Numbers[block][static_cast<std::size_t>(cell)];
  }

  /// The numbers of all cells of a block.
  const std::int32_t* NumbersOf(std::size_t block) const { return this->Numbers[block].data(); }

private:
  std::vector<std::vector<std::int32_t>> Numbers;
  std::int32_t Total = 0;
};

}

#endif
