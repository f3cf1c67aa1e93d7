// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap.h"

#include "BandTracer.h"
#include "FramePlanes.h"
#include "Parallel.h"
#include "TileBounds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <new>

namespace TemporalCoherence
{
namespace
{

/// Neighbouring tiles that one thread takes at a time.
constexpr std::int64_t TileGrain = 8;

/// Parts in which a band is built, each spread over the whole picture, with a report after each.
constexpr std::int64_t NumberOfParts = 16;

/// Let rays that begin below the band underneath walk from where they come to its end; those that
/// do not come there have nowhere to go. (Rays that meet no cell of that band may begin above it.)
void NarrowByCells(const TileKnots& knots, const BandScale& scale, RayBatch& rays)
{
  const CellKnots& table = knots.Cells[static_cast<std::size_t>(Course::Rising)];
  const BandScale::Key end = scale.KeyOf(scale.Span);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count) && !table.IsEmpty(); ++i)
  {
    const bool beginsBelow = knots.Entries.empty() || !std::isfinite(knots.Entries[i]);
    const std::size_t first = table.Begin(i), last = table.Begin(i + 1);
    if (!beginsBelow || first == last)
    {
      continue;
    }
    const std::size_t knot = FirstOf(table.Get<1>(), first, last, end);
    if (knot == last)
    {
      rays.WalkEnd[i] = rays.WalkBegin[i];
    }
    else
    {
      rays.WalkBegin[i] = std::max(rays.WalkBegin[i], EntryInto(table.Get<2>()[knot], rays, i));
    }
  }
}

/// The same by fitted knots.
void NarrowByFit(
  const TileKnots& knots, const BandScale& scale, double tolerance, RayBatch& rays)
{
  constexpr float error = 1e-5f; // of progress
  const FittedKnots& table = knots.Fitted[static_cast<std::size_t>(Course::Rising)];
  const auto span = static_cast<float>(scale.Span);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count) && !table.IsEmpty(); ++i)
  {
    const bool beginsBelow = knots.Entries.empty() || !std::isfinite(knots.Entries[i]);
    const std::size_t first = table.Begin(i), last = table.Begin(i + 1);
    if (!beginsBelow || first == last || (knots.Untold >> i & 1u))
    {
      continue;
    }
    const float* const progress = table.Get<0>();
    if (progress[last - 1] < span - error * span)
    {
      rays.WalkEnd[i] = rays.WalkBegin[i];
      continue;
    }
    const auto end = std::lower_bound(progress + first, progress + last, span - error * span);
    const std::size_t before = std::max(static_cast<std::size_t>(end - progress), first + 1) - 1;
    const double t = static_cast<double>(table.Get<1>()[before]) + rays.Begin[i];
    rays.WalkBegin[i] = std::max(rays.WalkBegin[i], t - 2.0 * tolerance);
  }
}

}

bool Isomap::CanHold(const Field& field)
{
  constexpr int largest = std::numeric_limits<CellIndex::value_type>::max();
  return field.HasCells() && glm::all(glm::lessThanEqual(field.Dimensions, glm::ivec3(largest)));
}

namespace
{

KnotForm FormOf(const FrameKey& key, const Isomap::Options& options)
{
  // Faces between nearest samples are where they are.
  const bool isFitted = options.Tolerance > 0.0 && key.Samples.Between == Interpolation::Linear;
  return { isFitted ? options.Tolerance * VoxelEdges(key.Where).x : 0.0, options.HasNormals };
}

}

bool Isomap::IsOf(const FrameKey& key, const Options& options) const
{
  return this->IsBegun && this->Form == FormOf(key, options) && this->Key.Samples == key.Samples && this->Key.Where == key.Where &&
    this->Key.Seen == key.Seen && this->Key.Sought.Mode == key.Sought.Mode;
}

void Isomap::Begin(const FrameKey& key, const Options& options)
{
  this->Release();
  this->Key = key;
  this->Form = FormOf(key, options);
  this->IsBegun = true;
}

void Isomap::Release()
{
  this->Kept.clear();
  this->IsBegun = false;
  this->Dropped = false;
}

Isomap::Outcome Isomap::Build(const ValueBand& band, const ValueRangePyramid& pyramid,
  const Start& start, const Limits& limits, const ReportProgress& report)
{
  const std::int64_t tiles = NumberOfTiles(this->Key.Seen.Size);
  const auto built = std::make_shared<Band>();
  built->Values = band;
  built->HasNormals = this->Form.HasNormals;
  built->Tiles.resize(static_cast<std::size_t>(tiles));
  built->Memory = built->Tiles.size() * sizeof(TileKnots);

  ActiveCells active;
  active.Build(this->Key.Samples, pyramid, band);
  TileBounds bounds;
  bounds.Build(this->Key.Seen, this->Key.Where, active);
  const RaySource source(this->Key.Seen, this->Key.Where, this->Key.Samples.Dimensions);
  const bool isSolid = this->Key.Sought.Mode == SurfaceMode::Threshold;
  const auto tracer = BandTracer::Make(
    { this->Key.Samples, pyramid.FiniteRange(), &pyramid, &active, band, this->Key.Sought.Mode,
      this->Form, this->Key.Where });

  const auto below = std::find_if(this->Kept.begin(), this->Kept.end(),
    [&](const auto& kept) { return kept->Values.High == band.Low; });
  const std::shared_ptr<Band> underneath = below != this->Kept.end() ? *below : nullptr;
  const bool hasStart = start.Picture && start.Isovalue <= band.Low;

  std::atomic<std::int64_t> memory{ 0 }, knots{ 0 }, cells{ 0 };
  std::atomic<bool> hasFailed{ false };
  const auto traceTile = [&](std::int64_t tile)
  {
    // A solid may be cut open where there is no active cell.
    if (!isSolid && bounds.At(tile).IsEmpty())
    {
      return;
    }
    const PixelRect part = PixelsOfTile(this->Key.Seen.Size, tile);
    RayBatch rays;
    source.SetUp(part.First, part.Size, rays);
    bounds.Narrow(tile, rays);
    if (underneath)
    {
      const BandScale scale(underneath->Values);
      const TileKnots& knots = underneath->Tiles[static_cast<std::size_t>(tile)];
      NarrowByCells(knots, scale, rays);
      NarrowByFit(knots, scale, this->Form.Tolerance, rays);
    }
    else if (hasStart)
    {
      BeginAtContacts(*start.Picture, this->Key.Seen.Parallel, rays);
    }
    try
    {
      TileKnots& to = built->Tiles[static_cast<std::size_t>(tile)];
      cells.fetch_add(tracer->Trace(rays, to), std::memory_order_relaxed);
      memory.fetch_add(
        static_cast<std::int64_t>(to.MemoryInBytes()), std::memory_order_relaxed);
      knots.fetch_add(static_cast<std::int64_t>(to.NumberOfKnots()), std::memory_order_relaxed);
    }
    catch (const std::bad_alloc&)
    {
      hasFailed = true; // exceptions do not leave a thread
    }
  };
  const std::size_t fixed = built->Memory;
  const std::int64_t groups = (tiles + TileGrain - 1) / TileGrain;
  for (std::int64_t part = 0; part < NumberOfParts; ++part)
  {
    ParallelFor((groups - part + NumberOfParts - 1) / NumberOfParts, 1,
      [&](std::int64_t i)
      {
        const std::int64_t first = (part + i * NumberOfParts) * TileGrain;
        for (std::int64_t tile = first; tile < std::min(first + TileGrain, tiles); ++tile)
        {
          traceTile(tile);
        }
      });
    built->Memory = fixed + static_cast<std::size_t>(memory);
    const double done = static_cast<double>(part + 1) / NumberOfParts;
    if (hasFailed)
    {
      throw std::bad_alloc();
    }
    if (!this->MakeRoom(built->Memory, limits.Memory))
    {
      return Outcome::TooLarge;
    }
    if (static_cast<double>(cells) > limits.Cells * done)
    {
      return Outcome::TooCostly;
    }
    if (report && !report(done))
    {
      return Outcome::Stopped;
    }
  }
  built->NumberOfKnots = static_cast<std::size_t>(knots);
  built->CellsRead = cells;
  this->Kept.push_back(built);
  this->Kept.back()->LastUse = ++this->Uses;
  return Outcome::Built;
}

/// Drop the bands not used for longest until there is room for so many bytes more.
bool Isomap::MakeRoom(std::size_t bytes, std::size_t limit)
{
  while (!this->Kept.empty() && this->MemoryInBytes() + bytes > limit)
  {
    this->Kept.erase(std::min_element(this->Kept.begin(), this->Kept.end(),
      [](const auto& a, const auto& b) { return a->LastUse < b->LastUse; }));
    this->Dropped = true;
  }
  return bytes <= limit;
}

ValueBand Isomap::GapAround(double isovalue) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ValueBand gap{ -infinity, infinity };
  for (const auto& band : this->Kept)
  {
    if (band->Values.High < isovalue)
    {
      gap.Low = std::max(gap.Low, band->Values.High);
    }
    else
    {
      gap.High = std::min(gap.High, band->Values.Low);
    }
  }
  return gap;
}

const Isomap::Band* Isomap::Use(double isovalue)
{
  for (const std::shared_ptr<Band>& band : this->Kept)
  {
    if (band->Values.Holds(isovalue))
    {
      band->LastUse = ++this->Uses;
      return band.get();
    }
  }
  return nullptr;
}

bool Isomap::Covers(const std::vector<double>& isovalues) const
{
  return std::all_of(isovalues.begin(), isovalues.end(),
    [this](double isovalue)
    {
      return std::any_of(this->Kept.begin(), this->Kept.end(),
        [isovalue](const auto& band) { return band->Values.Holds(isovalue); });
    });
}

std::size_t Isomap::MemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const std::shared_ptr<Band>& band : this->Kept)
  {
    bytes += band->Memory;
  }
  return bytes;
}

std::size_t Isomap::NumberOfKnots() const
{
  std::size_t knots = 0;
  for (const std::shared_ptr<Band>& band : this->Kept)
  {
    knots += band->NumberOfKnots;
  }
  return knots;
}

}
