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

// All of these are measured by the mean and the worst frames of drags, `Benchmark --scenarios
// isomap`; what else was tried: Documentation/Tried.md, "Building the isomap".

/// Width of the first band, as a share of the range of values: about a step of a slider.
constexpr double FirstWidth = 1.0 / 256.0;

/// Leaves that a band may pass through beyond those of its isovalue, as a share of these: the
/// first, and later ones. Rays read many more cells of these leaves than they would for one
/// isovalue.
constexpr double FirstGrowth = 0.03, Growth = 1.0;
constexpr int MostHalvings = 8;

/// Bands that hold little but their isovalue after one that was too costly.
constexpr int CarefulBands = 5;

/// Cells that building a band should read, in units of those that a cold frame reads. Two thirds of
/// a cold frame's time go into finding the first of them, so that this is less than twice its time.
constexpr double EnoughCells = 2.2;

/// A band that does not hold the next isovalues is hardly worth its cost: steps that the first band
/// and later ones hold ahead. Changes of more than a share of the range are no steps of a drag.
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

  // Behind, the band goes back to what is there already, or a little way.
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
  // A width may have been too large for a number.
  constexpr double most = std::numeric_limits<double>::max();
  return { std::max({ band.Low, wish.Gap.Low, -most }),
    std::min({ band.High, wish.Gap.High, most }) };
}

/// What holds the next isovalues.
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
  // A band that only fills a gap tells little.
  const double width = std::min(
    std::max(band.High - band.Low, 0.5 * this->Width), 0.25 * std::numeric_limits<double>::max());
  this->Width = width * std::min(std::max(EnoughCells / std::max(cells, 0.01), 0.25), 2.0);
}

}
