// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/SurfaceHistogram.h"

#include "Acceleration/ValueRangePyramid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// Count the parts that the ranges of leaves reach, as differences from one part to the next.
template <typename T>
void CountLeaves(const ValueRangePyramid& ranges, std::vector<std::int64_t>& differences)
{
  const glm::dvec2 all = ranges.FiniteRange();
  const auto parts = static_cast<double>(differences.size() - 1);
  const double perValue = all.y > all.x ? parts / (all.y - all.x) : 0.0;
  const auto partOf = [&](double value)
  {
    const double part = std::floor((value - all.x) * perValue);
    return static_cast<std::size_t>(std::min(std::max(part, 0.0), parts - 1.0));
  };
  for (std::int64_t node = 0; node < ranges.NumberOfNodes(); ++node)
  {
    const ValueRangePyramid::Range<T>* const leaves = ranges.LeavesOf<T>(node);
    for (std::int64_t leaf = 0; leaf < CellBlocks::LeavesPerNode; ++leaf)
    {
      if (leaves[leaf].Min < leaves[leaf].Max)
      {
        ++differences[partOf(static_cast<double>(leaves[leaf].Min))];
        --differences[partOf(static_cast<double>(leaves[leaf].Max)) + 1];
      }
    }
  }
}

}

double SurfaceHistogram::IsovalueAt(double share) const
{
  const double all =
    static_cast<double>(std::accumulate(this->Counts.begin(), this->Counts.end(), std::int64_t(0)));
  const double part = (this->Range.y - this->Range.x) / static_cast<double>(this->Counts.size());
  double below = 0.0;
  for (std::size_t i = 0; i < this->Counts.size(); ++i)
  {
    const auto count = static_cast<double>(this->Counts[i]);
    if (count > 0.0 && below + count >= share * all)
    {
      return this->Range.x + part * (static_cast<double>(i) + (share * all - below) / count);
    }
    below += count;
  }
  return this->Range.y;
}

SurfaceHistogram CountSurfaces(ScalarType type, const ValueRangePyramid& ranges, std::size_t parts)
{
  SurfaceHistogram histogram{ ranges.FiniteRange(), {} };
  if (!ranges.HasFiniteSamples() || ranges.IsEmpty())
  {
    return histogram;
  }
  std::vector<std::int64_t> differences(parts + 1, 0);
  DispatchScalarType(
    type, [&](auto sample) { CountLeaves<decltype(sample)>(ranges, differences); });
  std::partial_sum(differences.begin(), differences.end() - 1, differences.begin());
  differences.pop_back();
  histogram.Counts = std::move(differences);
  return histogram;
}

}
