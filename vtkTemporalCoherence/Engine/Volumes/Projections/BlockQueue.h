// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlockQueue_h
#define TemporalCoherence_BlockQueue_h

#include "Volumes/Projections/ExtremeBlocks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// A priority queue of blocks. A search ends early, so blocks are sorted only as far as it gets.
class BlockQueue
{
public:
  explicit BlockQueue(std::size_t usual) { this->Blocks.reserve(usual); }

  void Add(const ExtremeBlock& block) { this->Blocks.push_back(block); }

  /// Call search(block) for blocks in order until it returns false, then clear the queue.
  template <typename Search>
  void Empty(const Search& search)
  {
    const Buckets ends = this->Distribute();
    std::size_t begin = 0;
    for (const std::size_t end : ends)
    {
      const auto first = this->Ordered.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = this->Ordered.begin() + static_cast<std::ptrdiff_t>(end);
      std::sort(first, last);
      if (!std::all_of(first, last, search))
      {
        break;
      }
      begin = end;
    }
    this->Blocks.clear();
  }

private:
  using Buckets = std::array<std::size_t, 64>;

  /// Put blocks into buckets by their bounds, the largest ones first.
  /// \return where each bucket ends
  Buckets Distribute()
  {
    this->Ordered.resize(this->Blocks.size());
    const auto ends = std::minmax_element(this->Blocks.begin(), this->Blocks.end(),
      [](const ExtremeBlock& a, const ExtremeBlock& b) { return a.Bound < b.Bound; });
    const float most = this->Blocks.empty() ? 0.0f : ends.second->Bound;
    const float range = this->Blocks.empty() ? 0.0f : most - ends.first->Bound;
    constexpr float last = static_cast<float>(std::tuple_size_v<Buckets> - 1);
    // Bounds may be infinite.
    const bool areApart = range > last * 1e-30f && range < 1e30f;
    const float scale = areApart ? last / range : 0.0f;
    const auto bucketOf = [&](const ExtremeBlock& block) {
      return areApart ? static_cast<std::size_t>(std::min((most - block.Bound) * scale, last)) : 0;
    };
    Buckets begins{};
    for (const ExtremeBlock& block : this->Blocks)
    {
      ++begins[bucketOf(block)];
    }
    std::size_t sum = 0;
    for (std::size_t& begin : begins)
    {
      sum += begin;
      begin = sum - begin;
    }
    for (const ExtremeBlock& block : this->Blocks)
    {
      this->Ordered[begins[bucketOf(block)]++] = block;
    }
    return begins;
  }

  std::vector<ExtremeBlock> Blocks, Ordered;
};

}

#endif
