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

/// While a range is built, other bands make room for it, so much of the limit at a time. Not tuned.
constexpr std::size_t PartsOfRoom = 64;

/// The bands of all groups, and the progress of building them.
class Work
{
public:
  Work(const RangeBuild& wanted, const Isomap& map)
    : Bounds(BoundsOf(wanted))
    , Builder(wanted.Key, map, wanted.Pyramid, wanted.Band, &this->Bounds, wanted.MemoryLimit)
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

  TileBounds Bounds;
  BandBuilder Builder;
  std::vector<GroupBand> Bands;
  std::vector<std::uint8_t> IsDone;
  std::atomic<std::size_t> Memory{ 0 };
  std::atomic<std::int64_t> Cells{ 0 };
  std::atomic<bool> HasFailed{ false }, HasEnough{ false };

private:
  static TileBounds BoundsOf(const RangeBuild& wanted)
  {
    TileBounds bounds;
    BandBuilder::FindBounds(wanted.Key, wanted.Pyramid, wanted.Band, bounds);
    return bounds;
  }

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

/// The bands of a map that make room for new ones.
class Room
{
public:
  Room(const RangeBuild& wanted, Isomap& map)
    : Wanted(wanted.Band)
    , Fixed(Isomap::FixedMemory(wanted.Key))
    , Limit(wanted.MemoryLimit > this->Fixed ? wanted.MemoryLimit - this->Fixed : 0)
    , Map(map)
  {
  }

  /// What new bands may take in all, and what they may take now.
  std::size_t AtMost() const { return this->Limit; }
  std::size_t Now() const
  {
    const std::size_t taken = this->Map.MemoryInBytes() - this->Fixed;
    return this->Limit > taken ? this->Limit - taken : 0;
  }

  /// Drop bands until so much is free: first those that the new one contains, then the least
  /// recently used ones.
  /// \return true if any of the others was dropped
  /// \throws std::bad_alloc
  bool Make(std::size_t bytes)
  {
    if (this->Now() < bytes)
    {
      this->DropContained();
    }
    return this->Map.Trim(this->Limit > bytes ? this->Limit - bytes : 0, IsAny);
  }

  void DropContained()
  {
    this->Map.Drop([this](const GroupBand& band) { return IsWithin(band.Values, this->Wanted); });
  }

private:
  static bool IsAny(const GroupBand&) { return true; }

  ValueBand Wanted;
  std::size_t Fixed, Limit;
  Isomap& Map;
};

}

Isomap::Outcome BuildRange(const RangeBuild& wanted, Isomap& map, const ReportProgress& report,
  bool& isDropped, std::int64_t& cellsRead)
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  map.DropBounds();
  Room room(wanted, map);
  Work work(wanted, map);
  for (std::size_t part = 0; part < NumberOfParts; ++part)
  {
    const double whole = static_cast<double>(part + 1) / NumberOfParts;
    for (bool isWhole = false; !isWhole;)
    {
      work.BuildPart(part, room.Now(), report ? wanted.Patience : endless);
      if (work.HasFailed)
      {
        throw std::bad_alloc();
      }
      if (work.Memory > room.AtMost())
      {
        return Isomap::Outcome::TooLarge;
      }
      isWhole = !work.HasEnough;
      if (work.Memory > room.Now())
      {
        isDropped |= room.Make(work.Memory + room.AtMost() / PartsOfRoom);
      }
      const double done = std::min(work.ShareDone(), whole);
      if (report && !report(isWhole ? whole : done))
      {
        return Isomap::Outcome::Stopped;
      }
    }
  }
  cellsRead += work.Cells;
  room.DropContained();
  isDropped |= room.Make(work.Memory);
  map.AddToAll(std::move(work.Bands));
  return Isomap::Outcome::Built;
}

}
