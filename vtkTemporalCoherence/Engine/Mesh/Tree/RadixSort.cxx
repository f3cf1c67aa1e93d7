// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/RadixSort.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// 2^11 write positions fit into the caches.
constexpr int MostDigitBits = 11;
constexpr std::size_t MostDigits = std::size_t(1) << MostDigitBits;

/// Keys are sorted in this many parts, whatever the number of threads is.
constexpr std::int64_t NumberOfParts = 32;

using Counts = std::array<std::int64_t, MostDigits>;

/// One pass, by one digit.
void SortByDigit(const std::uint64_t* from, std::uint64_t* to, std::int64_t count, int shift,
  int bits, std::vector<Counts>& places)
{
  const std::uint64_t mask = (std::uint64_t(1) << bits) - 1;
  const auto digitOf = [&](std::uint64_t key)
  { return static_cast<std::size_t>(key >> shift & mask); };
  const auto beginOf = [&](std::int64_t part) { return count * part / NumberOfParts; };
  ParallelFor(NumberOfParts, 1,
    [&](std::int64_t part)
    {
      Counts& counts = places[static_cast<std::size_t>(part)];
      counts.fill(0);
      for (std::int64_t i = beginOf(part); i < beginOf(part + 1); ++i)
      {
        ++counts[digitOf(from[i])];
      }
    });
  std::int64_t next = 0;
  for (std::size_t digit = 0; digit <= mask; ++digit)
  {
    for (Counts& counts : places)
    {
      const std::int64_t begin = next;
      next += counts[digit];
      counts[digit] = begin;
    }
  }
  ParallelFor(NumberOfParts, 1,
    [&](std::int64_t part)
    {
      Counts& place = places[static_cast<std::size_t>(part)];
      for (std::int64_t i = beginOf(part); i < beginOf(part + 1); ++i)
      {
        to[place[digitOf(from[i])]++] = from[i];
      }
    });
}

}

void SortByRadix(
  SortKeys& keys, SortKeys& spare, std::int64_t begin, std::int64_t end, int shift, int bits)
{
  const int passes = (bits + MostDigitBits - 1) / MostDigitBits;
  std::vector<Counts> places(static_cast<std::size_t>(NumberOfParts));
  std::uint64_t* from = keys.data() + begin;
  std::uint64_t* to = spare.data() + begin;
  for (int pass = 0; pass < passes; ++pass)
  {
    const int first = bits * pass / passes, last = bits * (pass + 1) / passes;
    SortByDigit(from, to, end - begin, shift + first, last - first, places);
    std::swap(from, to);
  }
  if (passes % 2 != 0)
  {
    ParallelForRanges(end - begin, 1 << 16,
      [&](std::int64_t first, std::int64_t last)
      { std::copy(from + first, from + last, to + first); });
  }
}

}
