// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/FrameBands.h"

#include "Isomap/TileGroups.h"
#include "Scene/Timers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Tile bounds are found for a band and this many widths ahead. (Engine 70, 1024^2: they take a
/// tenth of a cold frame's time; bands take 0 to 10 % more without them where pixels are fine, and
/// 50 % where they are coarse.)
constexpr double BandsInBounds = 2.0;

/// New bands may take that many times what earlier ones took on average: groups differ.
constexpr double SpareRoom = 1.25;

/// Memory of all bands that nobody asked for, by pixels.
constexpr std::size_t BytesAPixel = 32;

/// Bytes for all that nobody asked for, whatever the user's limit.
std::size_t MostRoom(const glm::ivec2& pixels)
{
  return BytesAPixel * static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(pixels.y);
}

bool IsAutomatic(const GroupBand& band)
{
  return !band.IsAsked;
}

}

FrameBands::FrameBands(const Source& source, Isomap& map, DragState& state)
  : From(source)
  , Map(map)
  , State(state)
  , Work(map.Size(), GroupWork::LookUp)
  , CellsRead(map.Size(), 0)
{
  const std::vector<double>& isovalues = source.Bands.Key.Isosurfaces().Isovalues;
  ++state.Frame;
  for (std::size_t group = 0; group < map.Size(); ++group)
  {
    this->Work[group] = map.Covers(group, isovalues) ? GroupWork::LookUp : GroupWork::Trace;
  }
  map.MarkUsed(isovalues, state.Frame);
  this->Builders.resize(isovalues.size());
  bool isJump = false;
  for (const double isovalue : isovalues)
  {
    const DragRule::Step step = this->StepTo(isovalue);
    this->Bands.push_back(state.Rule.BandFor(step));
    this->IsMissing.push_back(!map.Covers({ isovalue }));
    isJump |= this->IsMissing.back() && DragRule::IsJump(step);
    this->Steps = std::min(this->Steps, state.Rule.StepsIn(step));
  }
  const std::size_t most = isJump ? 0 : state.Rule.GroupsToBuild(map.Size(), this->Steps);
  if (most > 0 && !this->AreAllFound())
  {
    this->Choose(most);
  }
}

FrameBands::~FrameBands()
{
  if (this->IsFinished)
  {
    return;
  }
  const std::uint64_t frame = this->State.Frame;
  this->Map.Drop([frame](const GroupBand& band) { return band.Made == frame; });
  if (this->Map.NumberOfBands() == 0)
  {
    this->Map.Release();
  }
}

DragRule::Step FrameBands::StepTo(double isovalue) const
{
  // The nearest previous isovalue is taken to be the one that moved.
  const std::vector<double>& before = this->From.IsovaluesBefore;
  const auto nearest = std::min_element(before.begin(), before.end(),
    [isovalue](double a, double b) { return std::abs(a - isovalue) < std::abs(b - isovalue); });
  const glm::dvec2& range = this->From.Bands.Pyramid.FiniteRange();
  return { isovalue, nearest != before.end() ? *nearest : isovalue, range.y - range.x };
}

/// Choose groups to build among those that would be traced. Each frame takes other groups, spread
/// over the picture, so that bands end at different isovalues.
void FrameBands::Choose(std::size_t most)
{
  const std::size_t groups = this->Work.size();
  if (this->State.Order.size() != groups)
  {
    this->State.Order = OrderOfGroups(this->From.Bands.Key.View.Size);
  }
  std::size_t planned = 0, next = this->State.NextGroup;
  for (std::size_t i = 0; i < groups && planned < most; ++i, next = (next + 1) % groups)
  {
    GroupWork& work = this->Work[this->State.Order[next]];
    if (work == GroupWork::Trace)
    {
      work = GroupWork::Build;
      ++planned;
    }
  }
  this->State.NextGroup = next;
  this->MakeRoom(planned);
}

/// Bytes that the user's limit leaves for all that nobody asked for.
std::size_t FrameBands::RoomOfUser() const
{
  const std::size_t taken = Isomap::FixedMemory(this->From.Bands.Key) +
    this->Map.MemoryOf([](const GroupBand& band) { return band.IsAsked; });
  const std::size_t limit = this->From.Options.MemoryLimit;
  return limit > taken ? limit - taken : 0;
}

/// Bytes for all bands that nobody asked for.
std::size_t FrameBands::RoomForAll() const
{
  const std::size_t most = std::min(this->RoomOfUser(), MostRoom(this->From.Bands.Key.View.Size));
  const std::size_t bounds = this->Map.MemoryOfBounds();
  return most > bounds ? most - bounds : 0;
}

/// Bytes that the bounds of all isovalues may take beyond those that are kept.
std::size_t FrameBands::BytesOfNewBounds() const
{
  const std::size_t most =
    this->Bands.size() * TileBounds::MemoryFor(this->From.Bands.Key.View.Size);
  const std::size_t kept = this->Map.MemoryOfBounds();
  return most > kept ? most - kept : 0;
}

/// Drop bands without the present isovalues if the memory might not suffice for those planned.
void FrameBands::MakeRoom(std::size_t planned)
{
  const std::size_t limit = this->RoomForAll();
  const auto isIdle = [this](const GroupBand& band)
  { return !band.IsAsked && band.LastUse != this->State.Frame; };
  const std::size_t taken = this->Map.MemoryOf(IsAutomatic), idle = this->Map.MemoryOf(isIdle);
  const std::size_t ofBounds = this->BytesOfNewBounds();
  const auto wanted =
    static_cast<std::size_t>(SpareRoom * this->State.BytesOfBand * static_cast<double>(planned)) +
    ofBounds;
  const std::size_t room = limit - std::min(wanted, limit);
  const std::size_t used = taken - idle;
  if (this->Map.Trim(room > used ? room - used : 0, isIdle))
  {
    this->State.HasDropped |= this->IsLimitedByUser();
  }
  const std::size_t left = this->Map.MemoryOf(IsAutomatic);
  const std::size_t all = limit > left ? limit - left : 0;
  this->HasRoomForBounds = ofBounds <= all;
  // Each band may take an equal part, so that it does not depend on threads which ones fit.
  const std::size_t parts = planned * this->Bands.size();
  this->RoomForGroup =
    (all - (this->HasRoomForBounds ? ofBounds : 0)) / std::max<std::size_t>(parts, 1);
}

/// True if the user's limit of memory is lower than the limit of bands that were not asked for.
bool FrameBands::IsLimitedByUser() const
{
  return this->RoomOfUser() < MostRoom(this->From.Bands.Key.View.Size);
}

std::size_t FrameBands::NumberOf(GroupWork work) const
{
  return static_cast<std::size_t>(std::count(this->Work.begin(), this->Work.end(), work));
}

void FrameBands::MakeBuilders()
{
  if (this->NumberOf(GroupWork::Build) == 0)
  {
    return;
  }
  try
  {
    this->Map.ResizeBounds(this->Bands.size());
    for (std::size_t i = 0; i < this->Bands.size(); ++i)
    {
      if (this->IsMissing[i])
      {
        this->Builders[i] = std::make_unique<BandBuilder>(
          this->From.Bands, this->Map, this->Bands[i], this->BoundsFor(i), this->RoomForGroup);
      }
    }
  }
  catch (const std::bad_alloc&)
  {
    std::replace(this->Work.begin(), this->Work.end(), GroupWork::Build, GroupWork::Trace);
    this->IsOutOfMemory = true;
  }
}

/// The bounds of a band: those kept from another frame, or new ones that frames to come can use,
/// too. Null if they take too much memory: rays of bands then begin where the field does.
const TileBounds* FrameBands::BoundsFor(std::size_t isovalue)
{
  const TileBounds* const kept = this->Map.FindBounds(isovalue, this->Bands[isovalue]);
  if (kept || !this->HasRoomForBounds)
  {
    return kept;
  }
  this->Map.KeepBounds(isovalue, {}); // frees the old ones first
  BandBounds made{ this->Widened(isovalue) };
  BandBuilder::FindBounds(this->From.Bands, made.Values, made.Tiles);
  this->Map.KeepBounds(isovalue, std::move(made));
  return this->Map.FindBounds(isovalue, this->Bands[isovalue]);
}

/// A band and what a drag comes to next.
ValueBand FrameBands::Widened(std::size_t isovalue) const
{
  const ValueBand& band = this->Bands[isovalue];
  constexpr double most = std::numeric_limits<double>::max();
  const double more = BandsInBounds * (band.High - band.Low);
  const bool isDown = band.High == this->From.Bands.Key.Isosurfaces().Isovalues[isovalue];
  return { isDown ? std::max(band.Low - more, -most) : band.Low,
    isDown ? band.High : std::min(band.High + more, most) };
}

GroupWork FrameBands::Prepare(std::size_t group, TraceCounts& counts)
{
  GroupWork& work = this->Work[group];
  if (work == GroupWork::Build)
  {
    const std::int64_t begin = TileTimer::Now();
    work = this->Build(group, counts.CellsRead) ? GroupWork::Build : GroupWork::Trace;
    counts.BuildTime += TileTimer::Now() - begin;
  }
  return work;
}

/// Build the bands that a group lacks. Exceptions do not leave the thread.
bool FrameBands::Build(std::size_t group, std::int64_t& cellsRead)
{
  try
  {
    for (std::size_t i = 0; i < this->Bands.size(); ++i)
    {
      if (this->Map.Find(group, this->From.Bands.Key.Isosurfaces().Isovalues[i]))
      {
        continue;
      }
      GroupBand band = this->Builders[i]->Build(group, cellsRead);
      band.LastUse = band.Made = this->State.Frame;
      this->BytesBuilt += band.Memory;
      if (band.Memory > this->RoomForGroup)
      {
        this->IsFull = true;
        return false;
      }
      this->Map.Add(group, std::move(band));
    }
    return true;
  }
  catch (const std::bad_alloc&)
  {
    this->IsOutOfMemory = true;
    return false;
  }
}

void FrameBands::Finish()
{
  this->IsFinished = true;
  this->Map.Count();
  DragRule::Outcome outcome;
  for (std::size_t group = 0; group < this->Work.size(); ++group)
  {
    const bool isBuilt = this->Work[group] == GroupWork::Build;
    if (isBuilt || this->Work[group] == GroupWork::Trace)
    {
      (isBuilt ? outcome.GroupsBuilt : outcome.GroupsTraced) += 1;
      (isBuilt ? outcome.CellsBuilt : outcome.CellsTraced) +=
        static_cast<double>(this->CellsRead[group]);
    }
  }
  if (outcome.GroupsBuilt > 0)
  {
    this->State.BytesOfBand =
      static_cast<double>(this->BytesBuilt.load()) / static_cast<double>(outcome.GroupsBuilt);
    outcome.MemoryShare = this->State.BytesOfBand * static_cast<double>(this->Work.size()) /
      std::max(static_cast<double>(this->RoomForAll()), 1.0);
    outcome.Steps = this->Steps;
  }
  this->State.Rule.Learn(outcome);
  this->State.HasDropped |= this->IsFull && this->IsLimitedByUser();
}

}
