// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/RangeBuild.h"

#include "Isomap/BandBuilder.h"
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

/// What groups will take that are not built yet is taken to be less than the mean of the others by
/// so many standard errors: a range that might fit is not given up.
constexpr double Doubt = 3.0;

/// Groups that are built first, to learn that from, if a part has fewer. Not tuned.
constexpr std::size_t LeastTried = 64;

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
    , States(map.Size(), State::Open)
    , Bytes(map.Size(), 0)
    , Order(map.Size())
    , Size(wanted.Key.View.Size)
    , Frame(wanted.Frame)
  {
    const std::size_t groups = map.Size(), stride = StrideOfGroups(groups);
    for (std::size_t i = 0; i < groups; ++i)
    {
      this->Order[i] = i * stride % groups;
    }
  }

  /// Build some groups, to see what they take, until all of them are seen or it is time for a
  /// report. Those that exceed the room are not kept.
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

  /// Build groups of a part until all are done or it is time for a report.
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
      this->Order = OrderOfGroups(this->Size, RowsOfSquare);
    }
  }

  /// True if the groups will most probably take more. Where they are built in squares, those that
  /// were seen do not tell of the others.
  bool IsMoreThan(double room) const
  {
    return !this->AreInSquares && this->MemoryOfAll(-Doubt) > room;
  }

  TileBounds Bounds;
  BandBuilder Builder;
  std::vector<GroupBand> Bands;
  std::atomic<std::size_t> Memory{ 0 };     ///< of the bands
  std::atomic<std::size_t> MemorySeen{ 0 }; ///< those that were not kept among them
  std::atomic<std::int64_t> Cells{ 0 };
  std::atomic<bool> HasFailed{ false }, HasEnough{ false };

private:
  /// What is known of a group: nothing, what its band takes, or its band.
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
    BandBuilder::FindBounds(wanted.Key, wanted.Pyramid, wanted.Band, bounds);
    return bounds;
  }

  /// What all groups take, by those that were seen.
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

  /// Call build(group) for groups that are not as far as `wanted`, until it is true or patience
  /// ends. Numbers of groups are those of the order.
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

  /// Build a group. Keep its band if all of them fit into the room. Exceptions do not leave the
  /// thread.
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
  bool AreInSquares = false;      ///< they are, in that order
  glm::ivec2 Size;                ///< of the picture
  std::uint64_t Frame;
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

/// Build some groups, which tell whether the whole may fit, before other bands make room.
/// \return Built, or how it ended
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
