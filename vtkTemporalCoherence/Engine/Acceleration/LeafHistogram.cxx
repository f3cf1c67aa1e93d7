// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/LeafHistogram.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// This many nodes give a good estimate. Measured by `Benchmark --scenarios structures`.
constexpr std::int64_t EnoughNodes = 1 << 13;

/// The share at or above the beginning of each bin, from the counts of the bins.
std::vector<double> ShareAtLeast(const std::vector<std::int64_t>& counts, std::int64_t all)
{
  std::vector<double> shares(counts.size() + 1, 0.0);
  std::int64_t above = 0;
  for (std::size_t bin = counts.size(); bin-- > 0;)
  {
    above += counts[bin];
    shares[bin] = static_cast<double>(above) / static_cast<double>(std::max<std::int64_t>(all, 1));
  }
  return shares;
}

}

void LeafHistogram::Build(const Field& field, const ValueRangePyramid& pyramid)
{
  this->Release();
  const glm::dvec2& range = pyramid.FiniteRange();
  this->Low = range.x;
  this->High = range.y;
  std::vector<std::int64_t> mins(Bins), maxs(Bins);
  std::int64_t all = 0;
  const std::int64_t nodes = pyramid.NumberOfNodes();
  const std::int64_t step = (nodes + EnoughNodes - 1) / EnoughNodes;
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      const auto binOf = [&](T value)
      {
        const double bin = std::floor(this->BinOf(static_cast<double>(value)));
        return static_cast<std::size_t>(std::min(bin, Bins - 1.0));
      };
      for (std::int64_t node = 0; node < nodes; node += step)
      {
        const auto* leaves = pyramid.LeavesOf<T>(node);
        for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
        {
          all += leaves[leaf].Min <= leaves[leaf].Max;
          if (leaves[leaf].Min < leaves[leaf].Max)
          {
            ++mins[binOf(leaves[leaf].Min)];
            ++maxs[binOf(leaves[leaf].Max)];
          }
        }
      }
    });
  this->MaxAtLeast = ShareAtLeast(maxs, all);
  this->MinAtLeast = ShareAtLeast(mins, all);
}

void LeafHistogram::Release()
{
  this->MinAtLeast.clear();
  this->MaxAtLeast.clear();
}

double LeafHistogram::BinOf(double value) const
{
  if (!(value > this->Low))
  {
    return 0.0; // also for NaN
  }
  if (value >= this->High)
  {
    return Bins;
  }
  // Halved, because the range of values may overflow.
  const double share = (0.5 * value - 0.5 * this->Low) / (0.5 * this->High - 0.5 * this->Low);
  return std::min(share, 1.0) * Bins;
}

double LeafHistogram::ShareOf(const ValueBand& band) const
{
  if (this->IsEmpty())
  {
    return 0.0;
  }
  // Leaves that reach the lowest isovalue, without those that are above the highest.
  const auto low = static_cast<std::size_t>(std::floor(this->BinOf(band.Low)));
  const auto high = static_cast<std::size_t>(std::ceil(this->BinOf(band.High)));
  return std::max(this->MaxAtLeast[low] - this->MinAtLeast[std::min<std::size_t>(high, Bins)], 0.0);
}

}
