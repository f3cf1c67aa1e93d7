// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/IsomapBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// How many cells an automatic band may read, relative to a cold frame. This takes three times as
/// long as that frame, as most of its time goes into finding the first cell. And how often a
/// narrower band is tried. Measured by the worst frames of drags, `Benchmark --scenarios isomap`.
constexpr double MostCells = 3.0;
constexpr int MostAttempts = 2;

/// The band that the user asks for, if it holds an isovalue, limited to the range of the samples.
ValueBand RangeAskedFor(
  const Isomap::Options& options, const ValueRangePyramid& pyramid, double isovalue)
{
  const glm::dvec2& samples = pyramid.FiniteRange();
  return { std::max(options.Range.Low, std::min(samples.x, isovalue)),
    std::min(options.Range.High, std::max(samples.y, isovalue)) };
}

}

bool IsomapBuilder::CanBuild(const FrameKey& key, const Isomap::Options& options) const
{
  const bool hasFailed = this->FailedLimit >= options.MemoryLimit && this->Map.IsOf(key, options);
  return options.MemoryLimit > 0 && Isomap::CanHold(key.Samples) && !IsTooCoarse(key, options) &&
    !hasFailed;
}

Isomap::Outcome IsomapBuilder::Build(const FrameKey& key, const Isomap::Options& options,
  const CachedImage& last, const ValueRangePyramid& pyramid, const ColdFrame& cold,
  const ReportProgress& report)
{
  if (!this->Map.IsOf(key, options))
  {
    this->Map.Begin(key, options);
    this->Plan = BandPlan();
    this->FailedLimit = 0;
  }
  if (this->Leaves.IsEmpty())
  {
    this->Leaves.Build(key.Samples, pyramid);
  }
  this->Cells = 0;
  const Context context{ options, last.Key.Isosurfaces.Isovalues, pyramid, cold, report };
  for (const double isovalue : key.Isosurfaces.Isovalues)
  {
    if (!this->Map.Use(isovalue))
    {
      const Isomap::Outcome outcome = this->BuildFor(isovalue, context);
      if (outcome != Isomap::Outcome::Built)
      {
        return outcome;
      }
    }
  }
  // Another band that is needed may have been dropped to make room.
  const bool fits = this->Map.Covers(key.Isosurfaces.Isovalues);
  this->FailedLimit = fits ? 0 : options.MemoryLimit;
  return fits ? Isomap::Outcome::Built : Isomap::Outcome::TooLarge;
}

/// Estimate the cells that a cold frame of an isovalue reads: from the cells of another one, and
/// the leaves that both pass through.
std::int64_t IsomapBuilder::ColdCellsAt(double isovalue, const ColdFrame& cold) const
{
  double before = 0.0;
  for (const double old : cold.Isosurfaces.Isovalues)
  {
    before += this->Leaves.ShareOf({ old, old });
  }
  const double now = this->Leaves.ShareOf({ isovalue, isovalue });
  const double ratio = before > 0.0 ? std::min(std::max(now / before, 0.1), 10.0) : 1.0;
  return static_cast<std::int64_t>(ratio * static_cast<double>(cold.CellsRead)) + 1;
}

/// Build a band for an isovalue, or a narrower one if the first choice turns out to be too costly.
Isomap::Outcome IsomapBuilder::BuildFor(double isovalue, const Context& context)
{
  const ValueBand range = RangeAskedFor(context.Options, context.Pyramid, isovalue);
  const std::int64_t coldCells = this->ColdCellsAt(isovalue, context.Cold);
  Isomap::Outcome outcome = Isomap::Outcome::TooLarge;
  for (int attempt = 0; attempt < MostAttempts; ++attempt)
  {
    // A band that the user asks for may take any time.
    const bool isAsked = attempt == 0 && range.Holds(isovalue);
    const bool isLimited = !isAsked && attempt + 1 < MostAttempts;
    const Isomap::Limits limits{ context.Options.MemoryLimit,
      isLimited ? MostCells * static_cast<double>(coldCells)
                : std::numeric_limits<double>::infinity() };
    const BandPlan::Wish wish = this->WishFor(isovalue, context.IsovaluesBefore);
    const ValueBand band = isAsked
      ? ValueBand{ std::max(range.Low, wish.Gap.Low), std::min(range.High, wish.Gap.High) }
      : this->Plan.Choose(wish, this->Leaves, attempt == 0);
    outcome = this->Map.Build(band, context.Pyramid, limits, context.Report);
    if (outcome == Isomap::Outcome::Built)
    {
      const std::int64_t cells = this->Map.Bands().back()->CellsRead;
      this->Cells += cells;
      if (!isAsked)
      {
        this->Plan.Learn(band, cells, coldCells);
      }
      return outcome;
    }
    if (outcome == Isomap::Outcome::Stopped)
    {
      return outcome;
    }
    if (!isAsked)
    {
      this->Plan.Shorten();
    }
  }
  this->FailedLimit = context.Options.MemoryLimit;
  return outcome;
}

/// The wish for a band.
BandPlan::Wish IsomapBuilder::WishFor(double isovalue, const std::vector<double>& before) const
{
  // Of several previous isovalues, the nearest is taken to be the one that moved.
  const auto nearest = std::min_element(before.begin(), before.end(),
    [isovalue](double a, double b) { return std::abs(a - isovalue) < std::abs(b - isovalue); });
  return { isovalue, nearest != before.end() ? *nearest : isovalue, this->Map.GapAround(isovalue) };
}

void IsomapBuilder::DropNarrowBands(
  const FrameKey& key, const Isomap::Options& options, const ValueRangePyramid& pyramid)
{
  const std::vector<double>& isovalues = key.Isosurfaces.Isovalues;
  const bool isNarrow = this->Covers(key, options) &&
    std::any_of(isovalues.begin(), isovalues.end(),
      [&](double isovalue)
      {
        const ValueBand range = RangeAskedFor(options, pyramid, isovalue);
        const ValueBand& held = this->Map.Use(isovalue)->Values;
        return range.Holds(isovalue) && !(held.Holds(range.Low) && held.Holds(range.High));
      });
  if (isNarrow)
  {
    this->Map.Begin(key, options);
  }
}

std::vector<const Isomap::Band*> IsomapBuilder::BandsFor(const FrameKey& key)
{
  std::vector<const Isomap::Band*> bands;
  for (const double isovalue : key.Isosurfaces.Isovalues)
  {
    bands.push_back(this->Map.Use(isovalue));
  }
  return bands;
}

}
