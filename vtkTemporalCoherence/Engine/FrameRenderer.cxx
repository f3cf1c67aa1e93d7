// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameRenderer.h"

#include "Parallel.h"
#include "RayBatch.h"
#include "Stopwatch.h"
#include "SurfaceTracer.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Neighbouring tiles that one thread takes at a time: enough to share what they read, few enough
/// to balance the load.
constexpr std::int64_t TileGrain = 8;

PixelRect PixelsOfTile(const glm::ivec2& pixels, std::int64_t tile)
{
  const int columns = TileBounds::TilesOf(pixels).x;
  const glm::ivec2 first = TileBounds::TileSize *
    glm::ivec2(static_cast<int>(tile % columns), static_cast<int>(tile / columns));
  return { first, glm::min(glm::ivec2(TileBounds::TileSize), pixels - first) };
}

std::int64_t NumberOfTiles(const glm::ivec2& pixels)
{
  const glm::ivec2 tiles = TileBounds::TilesOf(pixels);
  return static_cast<std::int64_t>(tiles.x) * tiles.y;
}

/// A tile through which no surface can be seen.
void FillWithMisses(const PixelRect& part, Frame& frame)
{
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
      static_cast<std::size_t>(part.First.x);
    const auto count = static_cast<std::size_t>(part.Size.x);
    std::fill_n(&frame.Depth[row], count, std::numeric_limits<double>::infinity());
    std::fill_n(&frame.Isovalues[row], count, Frame::NoSurface);
    std::fill_n(&frame.Caps[row], count, std::uint8_t(0));
    std::fill_n(&frame.Answers[row], count, Answer::DefiniteMiss);
  }
}

/// Narrow the walks of a tile's rays to its bounds.
void NarrowWalks(const TileBounds::Bounds& bounds, RayBatch& rays)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    rays.WalkBegin[i] = std::max(rays.WalkBegin[i], static_cast<double>(bounds.Near));
    rays.WalkEnd[i] = std::min(rays.WalkEnd[i], static_cast<double>(bounds.Far));
  }
}

/// Write the hits of a batch into the planes of a frame.
/// \return the number of rays that were traced
int StoreHits(const RayBatch& rays, const HitBatch& hits, Frame& frame)
{
  int traced = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
    const bool isTraced = rays.WalkBegin[i] < rays.WalkEnd[i] || hits.Cap[i];
    traced += isTraced;
    frame.Depth[pixel] = hits.Depth[i];
    frame.Isovalues[pixel] = hits.Surface[i];
    frame.Caps[pixel] = hits.Cap[i];
    frame.Answers[pixel] = isTraced ? Answer::PossibleHit : Answer::DefiniteMiss;
  }
  return traced;
}

}

void FrameRenderer::Render(const FrameKey& key, const Options& options)
{
  FrameStatistics before = this->Counters;
  this->Counters = FrameStatistics();
  try
  {
    Stopwatch watch(this->Counters.FrameTime);
    this->Counters.Made = this->ChooseRoute(key, options);
    this->Counters.Rays = static_cast<std::int64_t>(key.Seen.Size.x) * key.Seen.Size.y;
    switch (this->Counters.Made)
    {
      case Route::Redisplay:
        this->CountKnownHits();
        break;
      case Route::Reshade:
        this->ShadeTiles(key, false, this->Front);
        this->CountKnownHits();
        break;
      default:
        this->RenderCold(key, options);
        break;
    }
    this->Key = key;
  }
  catch (...)
  {
    this->Counters = before;
    throw;
  }
}

Route FrameRenderer::ChooseRoute(const FrameKey& key, const Options& options) const
{
  if (this->Front.IsEmpty())
  {
    return Route::Cold;
  }
  switch (PlanRoute(this->Key, key, options.Reuse, false))
  {
    case Route::Redisplay:
      return Route::Redisplay;
    case Route::Reshade:
      return Route::Reshade;
    default:
      return Route::Cold; // the routes that are planned but not built yet
  }
}

void FrameRenderer::RenderCold(const FrameKey& key, const Options& options)
{
  {
    Stopwatch watch(this->Counters.TraceTime);
    this->PrepareStructures(key, options);
    this->Back.Resize(key.Seen.Size);
    this->TraceTiles(key, options, this->Back);
  }
  this->ShadeTiles(key, true, this->Back);
  std::swap(this->Front, this->Back);
}

void FrameRenderer::PrepareStructures(const FrameKey& key, const Options& options)
{
  if (!key.Samples.HasCells() || key.Sought.Isovalues.empty())
  {
    return;
  }
  if (this->Pyramid.IsEmpty() || !(this->PyramidField == key.Samples))
  {
    this->Active.Release();
    this->ActiveField = Field();
    this->Pyramid.Build(key.Samples);
    this->PyramidField = key.Samples;
  }
  if (!options.SpaceLeaping)
  {
    return;
  }
  if (!(this->ActiveField == key.Samples) || !(this->ActiveSurfaces == key.Sought))
  {
    this->ActiveField = Field();
    this->Active.Build(key.Samples, this->Pyramid, key.Sought);
    this->ActiveField = key.Samples;
    this->ActiveSurfaces = key.Sought;
  }
  this->Bounds.Build(key.Seen, key.Where, this->Active);
}

void FrameRenderer::TraceTiles(const FrameKey& key, const Options& options, Frame& frame)
{
  const bool hasSurfaces = key.Samples.HasCells() && !key.Sought.Isovalues.empty();
  const bool leaps = options.SpaceLeaping;
  const bool isSolid = key.Sought.Mode == SurfaceMode::Threshold;
  const std::unique_ptr<SurfaceTracer> tracer = SurfaceTracer::Make(
    { key.Samples, key.Sought, this->Pyramid.FiniteRange(), leaps ? &this->Active : nullptr });

  std::atomic<std::int64_t> traced{ 0 }, cellsRead{ 0 };
  ParallelFor(NumberOfTiles(frame.Size), TileGrain,
    [&](std::int64_t tile)
    {
      const PixelRect part = PixelsOfTile(frame.Size, tile);
      // A solid may be cut open where there is no active cell.
      const bool canMiss = leaps && !isSolid && hasSurfaces;
      if (!hasSurfaces || (canMiss && this->Bounds.At(static_cast<int>(tile)).IsEmpty()))
      {
        FillWithMisses(part, frame);
        return;
      }
      RayBatch rays;
      HitBatch hits;
      SetUpRays(key.Seen, key.Where, key.Samples.Dimensions, part.First, part.Size, rays);
      if (leaps)
      {
        NarrowWalks(this->Bounds.At(static_cast<int>(tile)), rays);
      }
      tracer->Trace(rays, hits);
      traced.fetch_add(StoreHits(rays, hits, frame), std::memory_order_relaxed);
      cellsRead.fetch_add(hits.CellsRead, std::memory_order_relaxed);
    });

  this->Counters.TracedRays = traced;
  this->Counters.PossibleHits = traced;
  this->Counters.DefiniteMisses = this->Counters.Rays - traced;
  this->Counters.FieldSamples = 8 * cellsRead;
}

void FrameRenderer::ShadeTiles(const FrameKey& key, bool withNormals, Frame& frame)
{
  Stopwatch watch(this->Counters.ShadeTime);
  const NormalSource source{ key.Samples, key.Where, key.Sought.Isovalues,
    this->Pyramid.FiniteRange() };
  ParallelFor(NumberOfTiles(frame.Size), TileGrain,
    [&](std::int64_t tile)
    {
      const PixelRect part = PixelsOfTile(frame.Size, tile);
      if (withNormals)
      {
        ComputeNormals(source, key.Seen, part, frame);
      }
      ShadePixels(key.Look, key.Seen, part, frame);
    });
}

/// Every pixel of a picture that is shown again is an answer known before.
void FrameRenderer::CountKnownHits()
{
  this->Counters.DefiniteMisses =
    std::count(this->Front.Isovalues.begin(), this->Front.Isovalues.end(), Frame::NoSurface);
  this->Counters.DefiniteHits = this->Counters.Rays - this->Counters.DefiniteMisses;
}

void FrameRenderer::Release()
{
  *this = FrameRenderer();
}

}
