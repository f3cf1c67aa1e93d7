// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/IsomapBuilder.h"

#include "Isomap/RangeBuild.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// Half the width of a band that is built ahead around an isovalue outside of any range, as a share
/// of the range of values: about a step of a slider.
constexpr double HalfWidthAhead = 1.0 / 256.0;

bool AreEqual(const ValueBand& a, const ValueBand& b)
{
  return a.Low == b.Low && a.High == b.High;
}

/// The band that the user asks for, if it holds an isovalue, limited to the range of the samples.
ValueBand RangeAskedFor(
  const Isomap::Options& options, const ValueRangePyramid& pyramid, double isovalue)
{
  const glm::dvec2& samples = pyramid.FiniteRange();
  return { std::max(options.Range.Low, std::min(samples.x, isovalue)),
    std::min(options.Range.High, std::max(samples.y, isovalue)) };
}

/// Remembers at most this many ranges that exceeded the limit; older ranges are tried again.
constexpr std::size_t MostFailed = 64;

ValueBand BandAround(const ValueRangePyramid& pyramid, double isovalue)
{
  constexpr double most = std::numeric_limits<double>::max();
  const glm::dvec2& samples = pyramid.FiniteRange();
  const double half = HalfWidthAhead * samples.y - HalfWidthAhead * samples.x;
  return { std::max(isovalue - half, -most), std::min(isovalue + half, most) };
}

}

bool IsomapBuilder::CanBuild(const FrameKey& key, const Isomap::Options& options) const
{
  const bool hasFailed = this->FailedLimit >= options.MemoryLimit &&
    (this->Map.IsOf(key, options) || Isomap::FixedMemory(key) > options.MemoryLimit);
  return options.MemoryLimit > 0 && Isomap::CanHold(key.Samples) && !hasFailed;
}

/// Ask for a range. A new range replaces the previous request.
void IsomapBuilder::Ask(const ValueBand& range, const ValueRangePyramid& pyramid)
{
  if (AreEqual(range, this->RangeAsked))
  {
    return;
  }
  this->RangeAsked = range;
  this->Map.ForgetAsked();
  const glm::dvec2& samples = pyramid.FiniteRange();
  const ValueBand met{ std::max(range.Low, samples.x), std::min(range.High, samples.y) };
  if (met.Low <= met.High)
  {
    this->Map.MarkAsked(met);
  }
}

/// \return false if the limit of memory is too low
bool IsomapBuilder::Begin(const BandSource& source, const Isomap::Options& options)
{
  const FrameKey& key = source.Key;
  this->Cells = 0;
  if (Isomap::FixedMemory(key) > options.MemoryLimit)
  {
    this->Map.Release();
    this->FailedLimit = options.MemoryLimit;
    return false;
  }
  if (!this->Map.IsOf(key, options))
  {
    this->State = DragState();
    this->FailedLimit = 0;
    this->FailedRanges.clear();
    this->Map.Begin(key, options);
  }
  this->Ask(options.Range, source.Pyramid);
  this->FailedLimit = 0;
  return true;
}

/// True if a range is known not to fit into a limit of memory.
bool IsomapBuilder::HasFailed(const ValueBand& range, std::size_t limit) const
{
  return std::any_of(this->FailedRanges.begin(), this->FailedRanges.end(),
    [&](const FailedRange& failed)
    { return failed.Limit >= limit && AreEqual(failed.Range, range); });
}

/// Take note of whether a range fits into a limit of memory.
void IsomapBuilder::Note(const ValueBand& range, std::size_t limit, bool hasFailed)
{
  std::vector<FailedRange>& all = this->FailedRanges;
  all.erase(std::remove_if(all.begin(), all.end(),
              [&](const FailedRange& failed) { return AreEqual(failed.Range, range); }),
    all.end());
  if (hasFailed)
  {
    all.erase(all.begin(), all.size() < MostFailed ? all.begin() : all.begin() + 1);
    all.push_back({ range, limit });
  }
}

Isomap::Outcome IsomapBuilder::Build(const ValueBand& range, const BandSource& source,
  const Isomap::Options& options, const ReportProgress& report)
{
  if (this->Map.Holds(range))
  {
    this->Map.MarkAsked(range);
    return Isomap::Outcome::Built;
  }
  if (this->HasFailed(range, options.MemoryLimit))
  {
    return Isomap::Outcome::TooLarge;
  }
  const RangeBuild wanted{ source, range, options.MemoryLimit, ++this->State.Frame };
  const Isomap::Outcome outcome =
    BuildRange(wanted, this->Map, report, this->State.HasDropped, this->Cells);
  if (outcome != Isomap::Outcome::Stopped)
  {
    this->Note(range, options.MemoryLimit, outcome == Isomap::Outcome::TooLarge);
  }
  return outcome;
}

Isomap::Outcome IsomapBuilder::Prepare(
  const BandSource& source, const Isomap::Options& options, const ReportProgress& report)
{
  if (!this->Begin(source, options))
  {
    return Isomap::Outcome::TooLarge;
  }
  this->IsRangeTooLarge = false;
  for (const double isovalue : source.Key.Isosurfaces().Isovalues)
  {
    const ValueBand range = RangeAskedFor(options, source.Pyramid, isovalue);
    if (!range.Holds(isovalue) || this->Map.Covers({ isovalue }))
    {
      continue;
    }
    const Isomap::Outcome outcome = this->Build(range, source, options, report);
    if (outcome == Isomap::Outcome::Stopped)
    {
      this->ForgetIfEmpty();
      return outcome;
    }
    this->IsRangeTooLarge |= outcome == Isomap::Outcome::TooLarge;
  }
  return Isomap::Outcome::Built;
}

Isomap::Outcome IsomapBuilder::BuildAhead(
  const BandSource& source, const Isomap::Options& options, const ReportProgress& report)
{
  const std::vector<double>& isovalues = source.Key.Isosurfaces().Isovalues;
  Isomap::Outcome outcome =
    this->Begin(source, options) ? Isomap::Outcome::Built : Isomap::Outcome::TooLarge;
  this->Map.ForgetAsked();
  for (const double isovalue : isovalues)
  {
    if (outcome == Isomap::Outcome::Built)
    {
      const ValueBand range = RangeAskedFor(options, source.Pyramid, isovalue);
      outcome = this->Build(range.Holds(isovalue) ? range : BandAround(source.Pyramid, isovalue),
        source, options, report);
    }
  }
  // Another band that is needed may have been dropped to make room.
  if (outcome == Isomap::Outcome::Built && !this->Map.Covers(isovalues))
  {
    outcome = Isomap::Outcome::TooLarge;
  }
  this->ForgetIfEmpty();
  return outcome;
}

void IsomapBuilder::Trim(std::size_t limit)
{
  if (this->Map.MemoryInBytes() <= limit)
  {
    return;
  }
  this->Map.DropBounds();
  const std::size_t fixed = Isomap::FixedMemory(this->Map.FirstKey());
  const bool isDropped =
    this->Map.Trim(limit > fixed ? limit - fixed : 0, [](const GroupBand&) { return true; });
  this->State.HasDropped =
    (this->State.HasDropped || isDropped) && limit > 0; // a limit of 0 asks for no isomap
  if (limit < fixed)
  {
    this->Map.Release();
  }
}

/// Release an isomap without bands, which a stopped build leaves behind.
void IsomapBuilder::ForgetIfEmpty()
{
  if (this->Map.NumberOfBands() == 0)
  {
    this->Map.Release();
  }
}

void IsomapBuilder::Release()
{
  *this = IsomapBuilder();
}

}
