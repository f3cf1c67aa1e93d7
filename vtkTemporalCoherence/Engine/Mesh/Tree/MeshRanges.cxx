// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshRanges.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{

MeshRanges::MeshRanges(std::int64_t leaves)
  : NumberOfLeaves(leaves)
  , Leaves(new Leaf[static_cast<std::size_t>(leaves)]())
{
}

std::uint8_t MeshRanges::Scale::ByteOf(double value) const
{
  if (std::isinf(value))
  {
    return value > 0.0 ? Infinite : std::uint8_t(0);
  }
  constexpr double most = Steps;
  const double place = (value - this->Low) * this->PerValue;
  return static_cast<std::uint8_t>(1.0 + (place > 0.0 ? std::min(place, most) : 0.0));
}

void MeshRanges::Keep(std::int64_t leaf, const OfCells& ranges, std::size_t count)
{
  CellRange finite;
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    for (const double value : { ranges[cell].Min, ranges[cell].Max })
    {
      if (std::isfinite(value))
      {
        finite.Widen(value);
      }
    }
  }
  Scale scale;
  // The scale stays 0 if the leaf holds one value, or values too far apart: then no cell is left
  // out.
  const double perValue = Steps / (finite.Max - finite.Min);
  if (std::isfinite(perValue))
  {
    scale = { finite.Min, perValue };
  }
  std::array<std::uint64_t, WordsInLeaf> least{}, most{};
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    const std::size_t word = cell / CellsInWord, shift = 8 * (cell % CellsInWord);
    least[word] |= std::uint64_t(scale.ByteOf(ranges[cell].Min)) << shift;
    most[word] |= std::uint64_t(scale.ByteOf(ranges[cell].Max)) << shift;
  }
  Leaf& kept = this->Leaves[static_cast<std::size_t>(leaf)];
  kept.Low.store(scale.Low, std::memory_order_relaxed);
  kept.PerValue.store(scale.PerValue, std::memory_order_relaxed);
  kept.Count.store(static_cast<std::uint8_t>(count), std::memory_order_relaxed);
  for (std::size_t word = 0; word < WordsInLeaf; ++word)
  {
    kept.Least[word].store(least[word], std::memory_order_relaxed);
    kept.Most[word].store(most[word], std::memory_order_relaxed);
  }
  kept.IsKnown.store(true, std::memory_order_release);
}

bool MeshRanges::FindCells(
  std::int64_t leaf, const std::vector<ValueBand>& bands, std::uint64_t& cells) const
{
  const Leaf& kept = this->Leaves[static_cast<std::size_t>(leaf)];
  if (!kept.IsKnown.load(std::memory_order_acquire))
  {
    return false;
  }
  const Scale scale{ kept.Low.load(std::memory_order_relaxed),
    kept.PerValue.load(std::memory_order_relaxed) };
  const std::size_t count = kept.Count.load(std::memory_order_relaxed);
  cells = 0;
  for (const ValueBand& band : bands)
  {
    const std::uint8_t low = scale.ByteOf(band.Low), high = scale.ByteOf(band.High);
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      const std::size_t word = cell / CellsInWord, shift = 8 * (cell % CellsInWord);
      const auto least =
        static_cast<std::uint8_t>(kept.Least[word].load(std::memory_order_relaxed) >> shift);
      const auto most =
        static_cast<std::uint8_t>(kept.Most[word].load(std::memory_order_relaxed) >> shift);
      cells |= static_cast<std::uint64_t>(most >= low && least <= high) << cell;
    }
  }
  return true;
}

std::size_t MeshRanges::MemoryInBytes() const
{
  return static_cast<std::size_t>(this->NumberOfLeaves) * sizeof(Leaf);
}

}
