// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/BandPlan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

// All of these were chosen by the mean and the worst frames of drags, `Benchmark --scenarios
// isomap`. Documentation/Tried.md, "Building the isomap", tells what else was tried.

/// Width of the first band, as a share of the range of values: about a step of a slider.
constexpr double FirstWidth = 1.0 / 256.0;

/// How many more leaves than its isovalue a band may pass through, as a share: for the first band,
/// and for later ones. Rays read many more cells of these leaves than for one isovalue.
constexpr double FirstGrowth = 0.03, Growth = 1.0;
constexpr int MostHalvings = 8;

/// Number of narrow bands after one that was too costly.
constexpr int CarefulBands = 5;

/// How many cells building a band should read, relative to a cold frame. A cold frame spends two
/// thirds of its time on finding the first cells, so that this is less than twice its time.
constexpr double EnoughCells = 2.2;

/// How many steps ahead the first band and later ones reach: a band that does not hold the next
/// isovalues is hardly worth its cost. A change by more than a share of the range is not a step of
/// a drag.
constexpr double FirstSteps = 1.0, Steps = 2.5;
constexpr double LargestStep = 1.0 / 20.0;

}

ValueBand BandPlan::Choose(const Wish& wish, const LeafHistogram& leaves, bool isAhead) const
{
  const double c = wish.Isovalue;
  const double ahead = wish.Before > c ? -1.0 : 1.0;
  const bool isBothWays = wish.Before == c;
  const auto bandOf = [&](double width)
  {
    const double other = isBothWays ? c - ahead * width : c;
    return ValueBand{ std::min(other, c + ahead * width), std::max(other, c + ahead * width) };
  };

  const bool isFirst = this->Width == 0.0;
  const double allowed = (1.0 + (isFirst ? FirstGrowth : Growth)) * leaves.ShareOf({ c, c });
  double width = isFirst ? FirstWidth * leaves.Range() : this->Width;
  for (int halving = 0; halving < MostHalvings && leaves.ShareOf(bandOf(width)) > allowed;
       ++halving)
  {
    width *= 0.5;
  }

  width = std::max(width, isAhead && this->Careful == 0 ? this->WidthAhead(wish, leaves) : 0.0);

  // Backwards, the band reaches the bands that exist, or a little way.
  ValueBand band = bandOf(width);
  if (!isBothWays)
  {
    (ahead > 0.0 ? band.Low : band.High) -= ahead * 0.25 * width;
  }
  const double edge = ahead > 0.0 ? wish.Gap.Low : wish.Gap.High;
  const double behind = std::abs(wish.Before - edge) <= width ? edge : wish.Before;
  if (!isBothWays && std::abs(c - behind) <= width)
  {
    (ahead > 0.0 ? band.Low : band.High) = behind;
  }
  // A width may have overflowed.
  constexpr double most = std::numeric_limits<double>::max();
  return { std::max({ band.Low, wish.Gap.Low, -most }),
    std::min({ band.High, wish.Gap.High, most }) };
}

/// The band that holds the next isovalues.
double BandPlan::WidthAhead(const Wish& wish, const LeafHistogram& leaves) const
{
  const double step = std::abs(wish.Isovalue - wish.Before);
  return step > LargestStep * leaves.Range() ? 0.0
                                             : step * (this->Width == 0.0 ? FirstSteps : Steps);
}

void BandPlan::Shorten()
{
  this->Width = std::numeric_limits<double>::min();
  this->Careful = CarefulBands;
}

void BandPlan::Learn(const ValueBand& band, std::int64_t cellsRead, std::int64_t coldCells)
{
  const double cells =
    static_cast<double>(cellsRead) / static_cast<double>(std::max<std::int64_t>(coldCells, 1));
  if (this->Careful > 0)
  {
    --this->Careful;
    this->Width = this->Careful > 0 ? this->Width : 0.0; // begin again
    return;
  }
  // Little is learnt from a band that only fills a gap.
  const double width = std::min(
    std::max(band.High - band.Low, 0.5 * this->Width), 0.25 * std::numeric_limits<double>::max());
  this->Width = width * std::min(std::max(EnoughCells / std::max(cells, 0.01), 0.25), 2.0);
}

}
