// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Adaptive/AmrNeighbours.h"

#include <algorithm>
#include <numeric>

namespace TemporalCoherence
{

std::vector<std::vector<std::size_t>> NeighboursOf(const std::vector<AmrBlock>& blocks)
{
  // Sorted by their begins along x, blocks need no comparison with blocks that begin behind their
  // end.
  const std::size_t count = blocks.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto begin = [&](std::size_t b) { return blocks[b].Finest.First.x; };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return begin(a) != begin(b) ? begin(a) < begin(b) : a < b; });
  std::vector<std::vector<std::size_t>> found(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const AmrBox& box = blocks[order[i]].Finest;
    const AmrBox around{ box.First - std::int64_t(1), box.End + std::int64_t(1) };
    for (std::size_t j = i + 1; j < count && begin(order[j]) <= box.End.x; ++j)
    {
      if (!IsEmpty(Common(around, blocks[order[j]].Finest)))
      {
        found[order[i]].push_back(order[j]);
        found[order[j]].push_back(order[i]);
      }
    }
  }
  for (std::vector<std::size_t>& neighbours : found)
  {
    std::sort(neighbours.begin(), neighbours.end());
  }
  return found;
}

}
