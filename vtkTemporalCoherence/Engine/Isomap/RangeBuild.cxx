// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/RangeBuild.h"

#include "Isomap/BandBuilder.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <new>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// A range is built in parts, each spread over the whole picture, with a report after each. Not
/// tuned.
constexpr std::size_t NumberOfParts = 16;

/// The bands of all groups, and the progress of building them.
class Work
{
public:
  Work(const RangeBuild& wanted, const Isomap& map)
    : Builder(wanted.Key, map, wanted.Pyramid, wanted.Band, wanted.MemoryLimit)
    , Bands(map.Size())
    , IsDone(map.Size(), 0)
    , Frame(wanted.Frame)
  {
  }

  /// Build groups of a part until all are done or it is time for a report.
  void BuildPart(std::size_t part, std::size_t memory, double patience)
  {
    this->Since = std::chrono::steady_clock::now();
    this->HasEnough = false;
    const std::size_t count = (this->Bands.size() + NumberOfParts - 1 - part) / NumberOfParts;
    ParallelFor(static_cast<std::int64_t>(count), 1,
      [&](std::int64_t i)
      {
        const std::size_t group = part + static_cast<std::size_t>(i) * NumberOfParts;
        if (!this->IsDone[group] && !this->HasEnough)
        {
          this->Build(group);
          const std::chrono::duration<double> taken =
            std::chrono::steady_clock::now() - this->Since;
          this->HasEnough = this->Memory > memory || this->HasFailed || taken.count() > patience;
        }
      });
  }

  double ShareDone() const
  {
    return static_cast<double>(std::count(this->IsDone.begin(), this->IsDone.end(), 1)) /
      static_cast<double>(std::max<std::size_t>(this->IsDone.size(), 1));
  }

  BandBuilder Builder;
  std::vector<GroupBand> Bands;
  std::vector<std::uint8_t> IsDone;
  std::atomic<std::size_t> Memory{ 0 };
  std::atomic<std::int64_t> Cells{ 0 };
  std::atomic<bool> HasFailed{ false }, HasEnough{ false };

private:
  /// Exceptions do not leave the thread.
  void Build(std::size_t group)
  {
    try
    {
      std::int64_t cells = 0;
      GroupBand& band = this->Bands[group];
      band = this->Builder.Build(group, cells);
      band.LastUse = band.Made = this->Frame;
      band.IsAsked = true;
      this->Memory += band.Memory;
      this->Cells += cells;
      this->IsDone[group] = 1;
    }
    catch (const std::bad_alloc&)
    {
      this->HasFailed = true;
    }
  }

  std::uint64_t Frame;
  std::chrono::steady_clock::time_point Since;
};

bool IsWithin(const ValueBand& inner, const ValueBand& outer)
{
  return outer.Low <= inner.Low && inner.High <= outer.High;
}

}

Isomap::Outcome BuildRange(const RangeBuild& wanted, Isomap& map, const ReportProgress& report,
  bool& isDropped, std::int64_t& cellsRead)
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  const std::size_t fixed = Isomap::FixedMemory(wanted.Key);
  const std::size_t limit = wanted.MemoryLimit > fixed ? wanted.MemoryLimit - fixed : 0;
  Work work(wanted, map);
  for (std::size_t part = 0; part < NumberOfParts; ++part)
  {
    const double whole = static_cast<double>(part + 1) / NumberOfParts;
    for (bool isWhole = false; !isWhole;)
    {
      work.BuildPart(part, limit, report ? wanted.Patience : endless);
      if (work.HasFailed)
      {
        throw std::bad_alloc();
      }
      if (work.Memory > limit)
      {
        return Isomap::Outcome::TooLarge;
      }
      isWhole = !work.HasEnough;
      const double done = std::min(work.ShareDone(), whole);
      if (report && !report(isWhole ? whole : done))
      {
        return Isomap::Outcome::Stopped;
      }
    }
  }
  cellsRead += work.Cells;
  map.Drop([&](const GroupBand& band) { return IsWithin(band.Values, wanted.Band); });
  isDropped |= map.Trim(limit - work.Memory, [](const GroupBand&) { return true; });
  for (std::size_t group = 0; group < map.Size(); ++group)
  {
    map.Add(group, std::move(work.Bands[group]));
  }
  map.Count();
  return Isomap::Outcome::Built;
}

}
