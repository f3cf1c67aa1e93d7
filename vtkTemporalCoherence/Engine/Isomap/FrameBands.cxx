// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/FrameBands.h"

#include "Isomap/TileGroups.h"
#include "Scene/Timers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

namespace TemporalCoherence
{
namespace
{

// Measured by the mean and the worst frames of drags, `Benchmark --scenarios drags`.

/// How much longer a frame may take than if all was traced, as a share: the first one of a drag,
/// and others. And how much of what look-ups are expected to save may be spent on that.
constexpr double AllowedAtFirst = 0.1, AllowedExtra = 0.15, SpentOfSavings = 0.8;

/// The same for any frame of a mesh: look-ups there save most of a frame, so that what is built
/// soon pays soon.
constexpr double AllowedInMeshes = 0.22;

/// The same where look-ups no longer cost what they did when the groups were traced: nobody knows
/// well what they save.
constexpr double SpentOfOldSavings = 0.5;

/// If no band is worth its cost, every so many frames that share of the picture is built, to see
/// whether that has changed. What it takes to set that up does not count.
constexpr std::uint64_t FramesBetweenProbes = 6;
constexpr double ShareOfProbe = 0.02;

/// A group that took more of tracing it, and an average group, than this was interrupted. Beyond
/// that its time tells nothing of bands.
constexpr double MostOfTracing = 8.0;

/// Tile bounds are found for a band and this many widths ahead, if that takes no more than a share
/// of what the frame may cost more. (Engine 70, 1024^2: they take a tenth of a cold frame's time;
/// bands take 0 to 10 % more without them where pixels are fine, and 50 % where they are coarse.)
constexpr double BandsInBounds = 2.0, ShareOfSetUp = 0.5;

/// Nothing is built where builders would take more than that share. What they are taken to cost
/// fades from frame to frame, so that they are tried again: after eight frames if they cost as much
/// as twice that share.
constexpr double FadeOfBuilders = 0.9;

/// Of so many groups whose bands end, one is traced first, to see what that costs. Not where
/// look-ups cost what they did when the groups were traced.
constexpr std::size_t GroupsToATrial = 8;

/// The share of the groups that a frame builds if the picture depends on it.
constexpr double FixedShare = 1.0 / 12.0;

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
  , IsExact(map.Form().Tolerance == 0.0 && !map.Form().HasNormals)
  , Work(map.Size(), GroupWork::LookUp)
  , IsTried(map.Size(), 0)
  , CostNow(map.Size(), 0)
{
  const std::vector<double>& isovalues = source.Key.Isosurfaces.Isovalues;
  ++state.Frame;
  state.Costs.Resize(map.Size());
  this->Costs = state.Costs.All();
  this->CostOfAll = std::accumulate(this->Costs.begin(), this->Costs.end(), 0.0);
  double saved = 0.0;
  for (std::size_t group = 0; group < map.Size(); ++group)
  {
    const bool isFound = map.Covers(group, isovalues);
    this->Work[group] = isFound ? GroupWork::LookUp : GroupWork::Trace;
    saved += isFound ? this->Costs[group] * std::max(1.0 - state.Plan.LookUpCost(), 0.0) : 0.0;
  }
  map.MarkUsed(isovalues, state.Frame);
  this->Builders.resize(isovalues.size());

  double extra = 0.0; // of building a group
  bool isJump = false, isWorthIt = true;
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    const BandPlan::Wish wish = this->WishFor(isovalues[i]);
    this->Bands.push_back(this->IsExact ? state.Plan.Choose(wish) : BandPlan::ChooseFixed(wish));
    this->IsMissing.push_back(!map.Covers({ isovalues[i] }));
    if (this->IsMissing[i])
    {
      isJump |= BandPlan::IsJump(wish);
      isWorthIt &= state.Plan.IsWorthIt(wish);
      extra += std::max(state.Plan.BuildCost(wish) - 1.0, 0.1);
    }
  }
  if (this->AreAllFound() || isJump)
  {
    return;
  }
  const double allowed = source.Key.Samples.Kind->Abilities().IsMesh ? AllowedInMeshes
    : saved > 0.0                                                    ? AllowedExtra
                                                                     : AllowedAtFirst;
  const double spent = state.Costs.AreOld() ? SpentOfOldSavings : SpentOfSavings;
  double most = spent * saved + allowed * (this->CostOfAll + source.SetUpCost);
  this->MostForSetUp = ShareOfSetUp * most;
  if (this->IsExact && !state.Costs.AreKnown())
  {
    most = 0.0; // nobody knows what the frame costs
  }
  else if (this->IsExact && state.CostOfBuilders > this->MostForSetUp)
  {
    most = 0.0;
    state.CostOfBuilders *= FadeOfBuilders;
  }
  else if (this->IsExact && !isWorthIt)
  {
    this->IsProbe = true;
    most = state.Frame % FramesBetweenProbes == 0 ? ShareOfProbe * this->CostOfAll : 0.0;
  }
  this->MostExtra = static_cast<std::int64_t>(most);
  if (most > 0.0)
  {
    this->Choose(extra);
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

BandPlan::Wish FrameBands::WishFor(double isovalue) const
{
  // Of several previous isovalues, the nearest is taken to be the one that moved.
  const std::vector<double>& before = this->From.IsovaluesBefore;
  const auto nearest = std::min_element(before.begin(), before.end(),
    [isovalue](double a, double b) { return std::abs(a - isovalue) < std::abs(b - isovalue); });
  const glm::dvec2& range = this->From.Pyramid.FiniteRange();
  return { isovalue, nearest != before.end() ? *nearest : isovalue, range.y - range.x };
}

/// Choose groups to build among those that would be traced: in each frame others, spread over the
/// picture, so that their bands do not all end at the same isovalue.
/// \param extra expected cost of building a group beyond tracing it, which costs 1
void FrameBands::Choose(double extra)
{
  const std::size_t groups = this->Work.size();
  const glm::ivec2& size = this->From.Key.View.Size;
  if (this->State.Order.size() != groups)
  {
    this->State.Order = OrderOfGroups(size, this->IsExact ? RowsOfSquare : 1);
  }
  const auto most = static_cast<double>(this->MostExtra);
  const auto mostGroups =
    static_cast<std::size_t>(std::ceil(FixedShare * static_cast<double>(groups)));
  const bool areOld = this->IsExact && this->State.Costs.AreOld();
  double planned = 0.0;
  std::size_t count = 0, guesses = 0, next = this->State.NextGroup;
  for (std::size_t i = 0; i < groups; ++i, next = (next + 1) % groups)
  {
    const std::size_t group = this->State.Order[next];
    if (this->Work[group] != GroupWork::Trace)
    {
      continue;
    }
    if (areOld && this->State.Costs.IsGuess(group) && guesses++ % GroupsToATrial == 0)
    {
      continue;
    }
    planned += this->Costs[group] * extra;
    if (count > 0 && (this->IsExact ? planned > most : count >= mostGroups))
    {
      break;
    }
    this->Work[group] = GroupWork::Build;
    ++count;
  }
  this->State.NextGroup = next;
  this->MakeRoom(count);
}

/// Bytes that the user's limit leaves for all that nobody asked for.
std::size_t FrameBands::RoomOfUser() const
{
  const std::size_t taken = Isomap::FixedMemory(this->From.Key) +
    this->Map.MemoryOf([](const GroupBand& band) { return band.IsAsked; });
  const std::size_t limit = this->From.Options.MemoryLimit;
  return limit > taken ? limit - taken : 0;
}

/// Bytes for all bands that nobody asked for.
std::size_t FrameBands::RoomForAll() const
{
  const std::size_t most = std::min(this->RoomOfUser(), MostRoom(this->From.Key.View.Size));
  const std::size_t bounds = this->Map.MemoryOfBounds();
  return most > bounds ? most - bounds : 0;
}

/// Bytes that the bounds of all isovalues may take beyond those that are kept.
std::size_t FrameBands::BytesOfNewBounds() const
{
  const std::size_t most = this->Bands.size() * TileBounds::MemoryFor(this->From.Key.View.Size);
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
    static_cast<std::size_t>(1.25 * this->State.BytesOfBand * static_cast<double>(planned)) +
    ofBounds;
  const std::size_t room = limit - std::min(wanted, limit);
  const std::size_t used = taken - idle;
  if (this->Map.Trim(room > used ? room - used : 0, isIdle))
  {
    this->State.HasDropped |= this->IsLimitedByUser();
  }
  const std::size_t left = this->Map.MemoryOf(IsAutomatic);
  this->Room = limit > left ? limit - left : 0;
  this->HasRoomForBounds = ofBounds <= this->Room;
  this->Room -= this->HasRoomForBounds ? ofBounds : 0;
  // If the picture depends on what is built, so does nothing on which group comes first.
  const std::size_t parts = planned * this->Bands.size();
  this->RoomForGroup = this->IsExact ? this->Room : this->Room / std::max<std::size_t>(parts, 1);
}

/// True if the user's limit of memory is lower than that of bands that nobody asked for.
bool FrameBands::IsLimitedByUser() const
{
  return this->RoomOfUser() < MostRoom(this->From.Key.View.Size);
}

std::size_t FrameBands::NumberOf(GroupWork work) const
{
  return static_cast<std::size_t>(std::count(this->Work.begin(), this->Work.end(), work));
}

void FrameBands::MakeBuilders(const Clock& clock)
{
  if (this->NumberOf(GroupWork::Build) == 0)
  {
    return;
  }
  const double begin = clock();
  double ofBounds = 0.0;
  try
  {
    this->Map.ResizeBounds(this->Bands.size());
    for (std::size_t i = 0; i < this->Bands.size(); ++i)
    {
      if (this->IsMissing[i])
      {
        const double before = clock();
        const TileBounds* const bounds = this->BoundsFor(i, clock);
        ofBounds += clock() - before;
        this->Builders[i] = std::make_unique<BandBuilder>(this->From.Key, this->Map,
          this->From.Pyramid, this->Bands[i], bounds, this->RoomForGroup);
      }
    }
  }
  catch (const std::bad_alloc&)
  {
    std::replace(this->Work.begin(), this->Work.end(), GroupWork::Build, GroupWork::Trace);
    this->IsOutOfMemory = true;
  }
  const double cost = clock() - begin;
  this->Extra += this->IsProbe ? 0 : static_cast<std::int64_t>(cost);
  this->State.CostOfBuilders = cost - ofBounds;
}

/// The bounds of a band: those kept from another frame, or new ones that frames to come can use,
/// too. Null if they take too much memory, or of what the frame may cost: rays of bands then begin
/// where the field does.
const TileBounds* FrameBands::BoundsFor(std::size_t isovalue, const Clock& clock)
{
  if (const TileBounds* const kept = this->Map.FindBounds(isovalue, this->Bands[isovalue]))
  {
    return kept;
  }
  double& cost = this->State.CostOfBounds;
  const double expected = cost > 0.0 ? cost : this->From.SetUpCost;
  if (!this->HasRoomForBounds || (this->IsExact && expected > this->MostForSetUp))
  {
    return nullptr;
  }
  const double begin = clock();
  this->Map.KeepBounds(isovalue, {}); // frees the old ones first
  BandBounds made{ this->Widened(isovalue) };
  BandBuilder::FindBounds(this->From.Key, this->From.Pyramid, made.Values, made.Tiles);
  this->Map.KeepBounds(isovalue, std::move(made));
  cost = clock() - begin;
  return this->Map.FindBounds(isovalue, this->Bands[isovalue]);
}

/// A band and what a drag comes to next.
ValueBand FrameBands::Widened(std::size_t isovalue) const
{
  const ValueBand& band = this->Bands[isovalue];
  constexpr double most = std::numeric_limits<double>::max();
  const double more = BandsInBounds * (band.High - band.Low);
  const bool isDown = band.High == this->From.Key.Isosurfaces.Isovalues[isovalue];
  return { isDown ? std::max(band.Low - more, -most) : band.Low,
    isDown ? band.High : std::min(band.High + more, most) };
}

GroupWork FrameBands::Prepare(std::size_t group, TraceCounts& counts)
{
  GroupWork& work = this->Work[group];
  if (work == GroupWork::Build)
  {
    const std::int64_t begin = TileTimer::Now();
    this->IsTried[group] = !this->IsExact || (this->Extra < this->MostExtra && !this->IsFull);
    const bool isBuilt = this->IsTried[group] != 0 && this->Build(group, counts.CellsRead);
    work = isBuilt ? GroupWork::Build : GroupWork::Trace;
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
      if (this->Map.Find(group, this->From.Key.Isosurfaces.Isovalues[i]))
      {
        continue;
      }
      GroupBand band = this->Builders[i]->Build(group, cellsRead);
      band.LastUse = band.Made = this->State.Frame;
      const std::size_t bytes = band.Memory;
      const bool fits = bytes <= this->RoomForGroup;
      const std::size_t taken = fits ? this->Taken += bytes : 0;
      if (!fits || (this->IsExact && taken > this->Room))
      {
        this->Taken -= fits ? bytes : 0;
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

void FrameBands::Done(std::size_t group, std::int64_t cost)
{
  this->CostNow[group] = std::max<std::int64_t>(cost, 1);
  if (this->IsTried[group])
  {
    this->Extra += cost - static_cast<std::int64_t>(this->Costs[group]);
  }
  else if (this->Work[group] == GroupWork::Trace)
  {
    this->State.Costs.SetTraced(group, cost);
  }
  else
  {
    this->State.Costs.SetLookedUp(group, cost);
  }
}

void FrameBands::Finish()
{
  this->IsFinished = true;
  this->State.Costs.Learn();
  this->Map.Count();
  BandPlan::Measured measured;
  measured.TracingAll = this->CostOfAll;
  measured.IsMemoryFull = this->IsFull;
  const double mean = this->CostOfAll / static_cast<double>(this->Work.size());
  for (std::size_t group = 0; group < this->Work.size(); ++group)
  {
    const bool isBuilt = this->Work[group] == GroupWork::Build;
    if (isBuilt || this->Work[group] == GroupWork::LookUp)
    {
      const double most = MostOfTracing * (this->Costs[group] + mean);
      const double cost = std::min(static_cast<double>(this->CostNow[group]), most);
      (isBuilt ? measured.Built : measured.LookedUp) += cost;
      (isBuilt ? measured.TracingBuilt : measured.TracingFound) += this->Costs[group];
    }
  }
  const glm::dvec2& range = this->From.Pyramid.FiniteRange();
  for (const ValueBand& band : this->Bands)
  {
    measured.Width = std::max(measured.Width, (band.High - band.Low) / (range.y - range.x));
  }
  const std::size_t built = this->NumberOf(GroupWork::Build);
  if (built > 0)
  {
    this->State.BytesOfBand = static_cast<double>(this->Taken.load()) / static_cast<double>(built);
    measured.Memory = this->State.BytesOfBand * static_cast<double>(this->Work.size()) /
      std::max(static_cast<double>(this->RoomForAll()), 1.0);
  }
  if (this->IsExact && std::isfinite(measured.Width))
  {
    this->State.Plan.Learn(measured);
  }
  this->State.HasDropped |= this->IsFull && this->IsLimitedByUser();
}

}
