// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap.h"

#include "BandTracer.h"
#include "Parallel.h"
#include "TileBounds.h"

#include <algorithm>
#include <atomic>
#include <new>

namespace TemporalCoherence
{
namespace
{

/// Neighbouring tiles that one thread takes at a time.
constexpr std::int64_t TileGrain = 8;

/// Tiles between two reports of progress.
constexpr std::int64_t TilesPerReport = 1024;

}

bool Isomap::IsOf(const FrameKey& key) const
{
  return this->IsBegun && this->Key.Samples == key.Samples && this->Key.Where == key.Where &&
    this->Key.Seen == key.Seen && this->Key.Sought.Mode == key.Sought.Mode;
}

void Isomap::Begin(const FrameKey& key)
{
  this->Release();
  this->Key = key;
  this->IsBegun = true;
}

void Isomap::Release()
{
  this->Kept.clear();
  this->IsBegun = false;
  this->Dropped = false;
}

Isomap::Outcome Isomap::Build(const ValueBand& band, const ValueRangePyramid& pyramid,
  std::size_t limit, const ReportProgress& report)
{
  const std::int64_t tiles = NumberOfTiles(this->Key.Seen.Size);
  auto built = std::make_unique<Band>();
  built->Values = band;
  built->Tiles.resize(static_cast<std::size_t>(tiles));
  built->Memory = built->Tiles.size() * sizeof(TileKnots);

  ActiveCells active;
  active.Build(this->Key.Samples, pyramid, band);
  TileBounds bounds;
  bounds.Build(this->Key.Seen, this->Key.Where, active);
  const RaySource source(this->Key.Seen, this->Key.Where, this->Key.Samples.Dimensions);
  const bool isSolid = this->Key.Sought.Mode == SurfaceMode::Threshold;
  const auto tracer = BandTracer::Make(
    { this->Key.Samples, pyramid.FiniteRange(), &pyramid, &active, band, this->Key.Sought.Mode });

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
  for (std::int64_t first = 0; first < tiles; first += TilesPerReport)
  {
    const std::int64_t count = std::min(TilesPerReport, tiles - first);
    ParallelFor(count, TileGrain, [&](std::int64_t i) { traceTile(first + i); });
    built->Memory = fixed + static_cast<std::size_t>(memory);
    if (hasFailed)
    {
      throw std::bad_alloc();
    }
    if (!this->MakeRoom(built->Memory, limit))
    {
      return Outcome::TooLarge;
    }
    if (report && !report(static_cast<double>(first + count) / static_cast<double>(tiles)))
    {
      return Outcome::Stopped;
    }
  }
  built->NumberOfKnots = static_cast<std::size_t>(knots);
  built->CellsRead = cells;
  this->Kept.push_back(std::move(built));
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

const Isomap::Band* Isomap::Use(double isovalue)
{
  for (const std::unique_ptr<Band>& band : this->Kept)
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
  for (const std::unique_ptr<Band>& band : this->Kept)
  {
    bytes += band->Memory;
  }
  return bytes;
}

std::size_t Isomap::NumberOfKnots() const
{
  std::size_t knots = 0;
  for (const std::unique_ptr<Band>& band : this->Kept)
  {
    knots += band->NumberOfKnots;
  }
  return knots;
}

}
