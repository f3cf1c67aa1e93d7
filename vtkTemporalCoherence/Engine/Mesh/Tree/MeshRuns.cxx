// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshRuns.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Runs up to this length stay as they are, although the curve cannot separate their cells: half a
/// leaf.
constexpr std::int64_t ShortRun = 32;

/// All threads together sort a run with more cells.
constexpr std::int64_t LongRun = 1 << 18;

/// Each curve divides the box around a run 2^10 times or more along each axis. Points that this
/// many curves cannot separate count as equal.
constexpr int MostCurves = 5;

struct Run
{
  std::int64_t Begin, End;
};

}

/// Call `work(begin, end)` for the keys with equal places, if there are many.
template <typename Work>
void RunSorter::ForEachRun(
  const std::uint64_t* keys, std::int64_t begin, std::int64_t end, const Work& work) const
{
  const int shift = this->Layout.NumberBits;
  while (end - begin > ShortRun)
  {
    const std::uint64_t place = keys[begin] >> shift;
    // Most runs are short: one look ahead tells.
    if (keys[begin + ShortRun] >> shift != place)
    {
      do
      {
        ++begin;
      } while (keys[begin] >> shift == place);
      continue;
    }
    const auto* const last = std::partition_point(keys + begin + ShortRun, keys + end,
      [&](std::uint64_t key) { return key >> shift == place; });
    const std::int64_t next = last - keys;
    // The work may change keys.
    work(begin, next);
    begin = next;
  }
}

glm::dvec3 RunSorter::CentreOf(std::uint64_t key) const
{
  std::array<glm::dvec3, 8> points;
  const int count = this->Reader.ReadPoints(this->Layout.NumberOf(key), points);
  return TemporalCoherence::CentreOf(points, count);
}

void RunSorter::SortRuns(
  SortKeys& keys, SortKeys& spare, std::int64_t begin, std::int64_t end, int curve) const
{
  std::vector<Run> shorter;
  this->ForEachRun(keys.data(), begin, end,
    [&](std::int64_t first, std::int64_t last)
    {
      if (last - first <= LongRun)
      {
        shorter.push_back({ first, last });
      }
      else if (curve < MostCurves && this->Renew(keys.data(), first, last))
      {
        SortByRadix(keys, spare, first, last, this->Layout.NumberBits, this->Layout.PlaceBits());
        this->SortRuns(keys, spare, first, last, curve + 1);
      }
    });
  ParallelFor(static_cast<std::int64_t>(shorter.size()), 16,
    [&](std::int64_t i)
    {
      const Run& run = shorter[static_cast<std::size_t>(i)];
      this->SortAlone(keys.data(), run.Begin, run.End, curve);
    });
}

/// Give keys the places on a curve through their own box.
/// \return false if it has no size
bool RunSorter::Renew(std::uint64_t* keys, std::int64_t begin, std::int64_t end) const
{
  PointBox box;
  for (std::int64_t i = begin; i < end; ++i)
  {
    box.Widen(this->CentreOf(keys[i]));
  }
  if (box.Low == box.High)
  {
    return false;
  }
  const Curve curve(box, this->Layout);
  const auto renew = [&](std::int64_t i)
  { keys[i] = curve.KeyOf(this->CentreOf(keys[i]), this->Layout.NumberOf(keys[i])); };
  if (end - begin > LongRun)
  {
    ParallelFor(end - begin, 1 << 12, [&](std::int64_t i) { renew(begin + i); });
    return true;
  }
  for (std::int64_t i = begin; i < end; ++i)
  {
    renew(i);
  }
  return true;
}

/// Sort one run by the calling thread.
void RunSorter::SortAlone(
  std::uint64_t* keys, std::int64_t begin, std::int64_t end, int curve) const
{
  if (curve < MostCurves && this->Renew(keys, begin, end))
  {
    std::sort(keys + begin, keys + end);
    this->ForEachRun(keys, begin, end,
      [&](std::int64_t first, std::int64_t last)
      { this->SortAlone(keys, first, last, curve + 1); });
  }
}

}
