// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/RangeBuild.h"

#include "Isomap/TileGroups.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
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

/// Standard errors by which the memory estimate of all groups is lowered before a range is given
/// up, and raised before all groups are taken to fit.
constexpr double Doubt = 3.0;

/// Groups that are built first as a sample for the estimate, if a part has fewer. Not tuned.
constexpr std::size_t LeastTried = 64;

/// Other bands make room for a range in steps of the memory limit divided by this number, which is
/// not tuned.
constexpr std::size_t PartsOfRoom = 64;

/// The bands of all groups, and the progress of building them.
class Work
{
public:
  Work(const RangeBuild& wanted, const Isomap& map)
    : Bounds(BoundsOf(wanted))
    , Builder(wanted.Source, map, wanted.Band, &this->Bounds, wanted.MemoryLimit)
    , Bands(map.Size())
    , States(map.Size(), State::Open)
    , Bytes(map.Size(), 0)
    , Order(map.Size())
    , Size(wanted.Source.Key.View.Size)
    , Frame(wanted.Frame)
  {
    const std::size_t groups = map.Size(), stride = StrideOfGroups(groups);
    for (std::size_t i = 0; i < groups; ++i)
    {
      this->Order[i] = i * stride % groups;
    }
  }

  /// Build sample groups to estimate memory, until all of them are seen or a report is due. Bands
  /// that exceed the room are not kept.
  void Try(std::size_t room, std::size_t most, double patience)
  {
    const std::size_t tried = std::max(this->BeginOf(1), std::min(LeastTried, this->Bands.size()));
    this->ForGroups(0, tried, State::Seen, patience,
      [&](std::size_t group)
      {
        this->Build(group, room);
        return this->MemorySeen > most;
      });
  }

  /// Build the groups of one part, but stop when a report is due.
  void BuildPart(std::size_t part, std::size_t room, double patience)
  {
    this->ForGroups(this->BeginOf(part), this->BeginOf(part + 1), State::Done, patience,
      [&](std::size_t group)
      {
        this->Build(group, std::numeric_limits<std::size_t>::max());
        return this->Memory > room;
      });
  }

  double ShareDone() const
  {
    return static_cast<double>(std::count(this->States.begin(), this->States.end(), State::Done)) /
      static_cast<double>(std::max<std::size_t>(this->States.size(), 1));
  }

  /// If some groups were tried and all will surely fit, the others are built in squares.
  /// \throws std::bad_alloc
  void ChooseOrder(double room)
  {
    this->AreInSquares = this->MemoryOfAll(Doubt) <= room;
    if (this->AreInSquares)
    {
      this->Order = OrderOfGroups(this->Size);
    }
  }

  /// True if all groups will most probably take more than `room`. False when building in squares,
  /// where the groups seen are no fair sample.
  bool IsMoreThan(double room) const
  {
    return !this->AreInSquares && this->MemoryOfAll(-Doubt) > room;
  }

  TileBounds Bounds;
  BandBuilder Builder;
  std::vector<GroupBand> Bands;
  std::atomic<std::size_t> Memory{ 0 };     ///< of the bands
  std::atomic<std::size_t> MemorySeen{ 0 }; ///< of all bands built, kept or not
  std::atomic<std::int64_t> Cells{ 0 };
  std::atomic<bool> HasFailed{ false }, HasEnough{ false };

private:
  /// State of a group: unknown, memory of its band known, or band kept.
  enum class State : std::uint8_t
  {
    Open,
    Seen,
    Done
  };

  /// Number of the first group of a part.
  std::size_t BeginOf(std::size_t part) const
  {
    return (part * this->Bands.size() + NumberOfParts - 1) / NumberOfParts;
  }

  static TileBounds BoundsOf(const RangeBuild& wanted)
  {
    TileBounds bounds;
    BandBuilder::FindBounds(wanted.Source, wanted.Band, bounds);
    return bounds;
  }

  /// Estimated bytes of all groups, from the groups seen.
  /// \param doubt standard errors that are added to the mean
  double MemoryOfAll(double doubt) const
  {
    double count = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t group = 0; group < this->Bytes.size(); ++group)
    {
      const auto bytes = static_cast<double>(this->Bytes[group]);
      count += this->States[group] != State::Open;
      sum += bytes;
      squares += bytes * bytes;
    }
    if (count < 2.0)
    {
      return sum;
    }
    const double mean = sum / count;
    const double variance = std::max(squares / count - mean * mean, 0.0);
    const double most = mean + doubt * std::sqrt(variance / (count - 1.0));
    return sum + std::max(most, 0.0) * (static_cast<double>(this->Bytes.size()) - count);
  }

  /// Call build(group) for groups below state `wanted`, until a call returns true or patience ends.
  /// `first` and `end` are places in Order.
  template <typename BuildGroup>
  void ForGroups(
    std::size_t first, std::size_t end, State wanted, double patience, const BuildGroup& build)
  {
    const auto since = std::chrono::steady_clock::now();
    this->HasEnough = false;
    ParallelFor(static_cast<std::int64_t>(end - first), 1,
      [&](std::int64_t i)
      {
        const std::size_t group = this->Order[first + static_cast<std::size_t>(i)];
        if (this->States[group] < wanted && !this->HasEnough)
        {
          const bool isEnough = build(group) || this->HasFailed;
          const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - since;
          this->HasEnough = this->HasEnough || isEnough || taken.count() > patience;
        }
      });
  }

  /// Build a group, and keep its band if all kept bands fit into the room. Sets HasFailed if memory
  /// runs out: exceptions must not leave the thread.
  void Build(std::size_t group, std::size_t room)
  {
    try
    {
      std::int64_t cells = 0;
      GroupBand band = this->Builder.Build(group, cells);
      const std::size_t bytes = this->Bytes[group] = band.Memory;
      this->MemorySeen += this->States[group] == State::Open ? bytes : 0;
      this->Cells += cells;
      this->States[group] = State::Seen;
      if ((this->Memory += bytes) > room)
      {
        this->Memory -= bytes;
        return;
      }
      band.LastUse = band.Made = this->Frame;
      band.IsAsked = true;
      this->Bands[group] = std::move(band);
      this->States[group] = State::Done;
    }
    catch (const std::bad_alloc&)
    {
      this->HasFailed = true;
    }
  }

  std::vector<State> States;      ///< of the groups
  std::vector<std::size_t> Bytes; ///< of their bands, as far as they were seen
  std::vector<std::size_t> Order; ///< of groups, spread over the picture
  bool AreInSquares = false;      ///< Order goes by squares of groups
  glm::ivec2 Size;                ///< of the picture
  std::uint64_t Frame;
};

/// The memory for new bands, and the old bands of a map that make room.
class Room
{
public:
  Room(const RangeBuild& wanted, Isomap& map)
    : Wanted(wanted.Band)
    , Fixed(Isomap::FixedMemory(wanted.Source.Key))
    , Limit(wanted.MemoryLimit > this->Fixed ? wanted.MemoryLimit - this->Fixed : 0)
    , Map(map)
  {
  }

  /// Bytes that new bands may take in all, and bytes that are free now.
  std::size_t AtMost() const { return this->Limit; }
  std::size_t Now() const
  {
    const std::size_t taken = this->Map.MemoryInBytes() - this->Fixed;
    return this->Limit > taken ? this->Limit - taken : 0;
  }

  /// Drop bands until `bytes` are free: first bands that the new one contains, then the least
  /// recently used bands.
  /// \return true if a band was dropped that the new one does not contain
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

/// Build sample groups before other bands make room: they show whether the range may fit.
/// \return Built, or the reason to end
Isomap::Outcome TrySome(Work& work, const Room& room, const ReportProgress& report, double patience)
{
  for (bool isTried = false; !isTried;)
  {
    work.Try(room.Now(), room.AtMost(), patience);
    if (work.HasFailed)
    {
      throw std::bad_alloc();
    }
    if (work.MemorySeen > room.AtMost())
    {
      return Isomap::Outcome::TooLarge;
    }
    isTried = !work.HasEnough;
    if (!isTried && report && !report(std::min(work.ShareDone(), 1.0 / NumberOfParts)))
    {
      return Isomap::Outcome::Stopped;
    }
  }
  return Isomap::Outcome::Built;
}

}

Isomap::Outcome BuildRange(const RangeBuild& wanted, Isomap& map, const ReportProgress& report,
  bool& isDropped, std::int64_t& cellsRead)
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  map.DropBounds();
  const double patience = report ? wanted.Patience : endless;
  Room room(wanted, map);
  Work work(wanted, map);
  const auto most = static_cast<double>(room.AtMost());
  const Isomap::Outcome tried = TrySome(work, room, report, patience);
  if (tried != Isomap::Outcome::Built)
  {
    return tried;
  }
  work.ChooseOrder(most);
  for (std::size_t part = 0; part < NumberOfParts; ++part)
  {
    const double whole = static_cast<double>(part + 1) / NumberOfParts;
    for (bool isWhole = false; !isWhole;)
    {
      if (work.IsMoreThan(most))
      {
        return Isomap::Outcome::TooLarge;
      }
      work.BuildPart(part, room.Now(), patience);
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
