// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Slabs.h"

#include <algorithm>
#include <future>
#include <vector>

using TemporalCoherence::ScalarType;

namespace
{

std::size_t BytesOfSlice(const glm::ivec3& dimensions, ScalarType type)
{
  return static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y) *
    TemporalCoherence::SizeOf(type);
}

/// Make a slab: half of it by another thread.
void MakeSlab(const MixingLayer& layer, ScalarType type, int first, int count, std::byte* samples)
{
  const int half = count / 2;
  std::byte* const rest =
    samples + static_cast<std::size_t>(half) * BytesOfSlice(layer.Dimensions(), type);
  const auto other =
    std::async(std::launch::async, [&] { layer.Slices(first + half, count - half, type, rest); });
  layer.Slices(first, half, type, samples);
  other.wait();
}

}

bool ForEachSlab(const MixingLayer& layer, ScalarType type, int slices, const TakeSlab& take)
{
  const int all = layer.Dimensions().z;
  const std::size_t bytes =
    static_cast<std::size_t>(std::min(slices, all)) * BytesOfSlice(layer.Dimensions(), type);
  std::vector<std::byte> now(bytes), next(bytes);
  const auto countAt = [&](int first) { return std::min(slices, all - first); };
  MakeSlab(layer, type, 0, countAt(0), now.data());
  for (int first = 0; first < all; first += slices)
  {
    std::future<void> making;
    const int following = first + slices;
    if (following < all)
    {
      making = std::async(std::launch::async,
        [&, following] { MakeSlab(layer, type, following, countAt(following), next.data()); });
    }
    const bool goesOn = take(first, countAt(first), now.data());
    if (making.valid())
    {
      making.wait();
    }
    if (!goesOn)
    {
      return false;
    }
    now.swap(next);
  }
  return true;
}

int SlicesOfSlab(const glm::ivec3& dimensions, ScalarType type)
{
  constexpr std::size_t wanted = std::size_t(32) << 20;
  const std::size_t slices = wanted / BytesOfSlice(dimensions, type);
  return static_cast<int>(std::clamp<std::size_t>(slices, 1, 1024));
}
