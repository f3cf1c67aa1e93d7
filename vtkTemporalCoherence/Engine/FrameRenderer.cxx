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

/// True if the colours of a cached image may be taken over: those of the same surfaces under the
/// same lights, which may have moved, as a headlight moves with every view (the paper's choice).
bool HasColorsFor(const CachedImage& cached, const FrameKey& next)
{
  Appearance look = cached.Key.Look;
  if (look.Lights.size() != next.Look.Lights.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < look.Lights.size(); ++i)
  {
    look.Lights[i].Position = next.Look.Lights[i].Position;
    look.Lights[i].Direction = next.Look.Lights[i].Direction;
  }
  return look == next.Look && cached.Key.Sought == next.Sought && !next.Look.ColorByAnswer;
}

}

void FrameRenderer::Render(const FrameKey& key, const Options& options)
{
  FrameStatistics before = this->Counters;
  this->Counters = FrameStatistics();
  try
  {
    Stopwatch watch(this->Counters.FrameTime);
    const auto suits = [&](const CachedImage& image)
    {
      const bool isTooEroded = image.IsEroded && options.Accuracy == ReuseAccuracy::Bounded;
      return !isTooEroded && ImageQuery::CanAsk(image.Key, options.Accuracy);
    };
    const std::shared_ptr<CachedImage> nearest = this->Images.Find(key, options.Images, suits);
    this->Counters.Made = this->ChooseRoute(key, options, nearest);
    this->Counters.Rays = static_cast<std::int64_t>(key.Seen.Size.x) * key.Seen.Size.y;
    switch (this->Counters.Made)
    {
      case Route::Redisplay:
        this->CountKnownHits();
        break;
      case Route::Reshade:
        this->Front->Key = key;
        this->ShadeTiles(key, false, true, this->Front->Picture);
        this->CountKnownHits();
        break;
      case Route::ImageCache:
        this->MakeFrame(key, options, nearest.get());
        break;
      default:
        this->MakeFrame(key, options, nullptr);
        break;
    }
  }
  catch (...)
  {
    this->Counters = before;
    throw;
  }
}

Route FrameRenderer::ChooseRoute(
  const FrameKey& key, const Options& options, const std::shared_ptr<CachedImage>& nearest) const
{
  if (this->Front->Picture.IsEmpty())
  {
    return Route::Cold;
  }
  HeldForReuse held;
  held.IsExact = this->Front->IsExact;
  held.Image = nearest != nullptr;
  ReuseSwitches switches = options.Reuse;
  switches.RefineWhenStill |= options.Accuracy == ReuseAccuracy::Exact || !switches.ImageCache;
  const Route route = PlanRoute(this->Front->Key, key, switches, held);
  switch (route)
  {
    case Route::Redisplay:
    case Route::Reshade:
    case Route::ImageCache:
      return route;
    default:
      return Route::Cold; // the routes that are planned but not built yet
  }
}

/// Make a frame by tracing, from a cached image or, if that is null, cold.
void FrameRenderer::MakeFrame(const FrameKey& key, const Options& options, CachedImage* cached)
{
  if (!this->Back)
  {
    this->Back = std::make_shared<CachedImage>();
  }
  CachedImage& made = *this->Back;
  const bool isExact = !cached || options.Accuracy == ReuseAccuracy::Exact;
  const bool interpolates = !isExact && options.Accuracy == ReuseAccuracy::Paper &&
    options.InterpolateColors && HasColorsFor(*cached, key);
  {
    Stopwatch watch(this->Counters.TraceTime);
    this->PrepareStructures(key, options);
    made.Picture.Resize(key.Seen.Size);
    if (made.Key.Seen.Parallel != key.Seen.Parallel)
    {
      // The disparity of a miss is another one.
      std::fill(made.Picture.ClearTiles.begin(), made.Picture.ClearTiles.end(), std::uint8_t(0));
    }
    made.Key = key;
    made.Picture.IsFromCache = cached != nullptr;
  }
  std::unique_ptr<ImageQuery> query;
  if (!isExact)
  {
    Stopwatch watch(this->Counters.QueryTime);
    query = std::make_unique<ImageQuery>(*cached, key, options.Accuracy);
  }
  this->TraceTiles({ key, options.SpaceLeaping ? &this->Active : nullptr, &this->Bounds,
                     this->Pyramid.FiniteRange(), query.get(), interpolates },
    made.Picture);
  this->ShadeTiles(key, true, !interpolates, made.Picture);

  made.IsExact = isExact;
  made.IsEroded = !isExact && options.Accuracy == ReuseAccuracy::Paper;
  made.Free.Clear();
  const std::shared_ptr<CachedImage> dropped = this->Images.Keep(this->Back, options.Images);
  std::swap(this->Front, this->Back);
  if (this->Images.Holds(this->Back))
  {
    this->Back = dropped;
  }
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
    this->ActiveSurfaces = key.Sought;
    this->ActiveField = key.Samples;
  }
  this->Bounds.Build(key.Seen, key.Where, this->Active);
}

void FrameRenderer::TraceTiles(const TileScene& scene, Frame& frame)
{
  double seconds = 0.0;
  std::atomic<std::int64_t> hits{ 0 }, misses{ 0 }, possible{ 0 }, traced{ 0 }, cells{ 0 };
  std::atomic<std::int64_t> queryTime{ 0 }, tileTime{ 0 };
  {
    Stopwatch watch(seconds);
    const TileTracer tracer(scene);
    ParallelFor(NumberOfTiles(frame.Size), TileGrain,
      [&](std::int64_t tile)
      {
        const TraceCounts counts = tracer.Trace(tile, PixelsOfTile(frame.Size, tile), frame);
        hits.fetch_add(counts.DefiniteHits, std::memory_order_relaxed);
        misses.fetch_add(counts.DefiniteMisses, std::memory_order_relaxed);
        possible.fetch_add(counts.PossibleHits, std::memory_order_relaxed);
        traced.fetch_add(counts.TracedRays, std::memory_order_relaxed);
        cells.fetch_add(counts.CellsRead, std::memory_order_relaxed);
        queryTime.fetch_add(counts.QueryTime, std::memory_order_relaxed);
        tileTime.fetch_add(counts.TileTime, std::memory_order_relaxed);
      });
  }
  this->Counters.DefiniteHits = hits;
  this->Counters.DefiniteMisses = misses;
  this->Counters.PossibleHits = possible;
  this->Counters.TracedRays = traced;
  this->Counters.FieldSamples = 8 * cells;
  // Threads ask and trace tile by tile: the time of both is told apart by their shares.
  const double queryShare =
    tileTime > 0 ? static_cast<double>(queryTime) / static_cast<double>(tileTime) : 0.0;
  this->Counters.QueryTime += queryShare * seconds;
  this->Counters.TraceTime += (1.0 - queryShare) * seconds;
}

void FrameRenderer::ShadeTiles(
  const FrameKey& key, bool withNormals, bool withDefiniteHits, Frame& frame)
{
  Stopwatch watch(this->Counters.ShadeTime);
  const NormalSource source{ key.Samples, key.Where, key.Sought.Isovalues,
    this->Pyramid.FiniteRange() };
  ParallelFor(NumberOfTiles(frame.Size), TileGrain,
    [&](std::int64_t tile)
    {
      if (frame.ClearTiles[static_cast<std::size_t>(tile)])
      {
        return;
      }
      HitList hits;
      GatherHits(key.Seen, PixelsOfTile(frame.Size, tile), withDefiniteHits, frame, hits);
      if (withNormals)
      {
        ComputeNormals(source, hits, frame);
      }
      ShadeHits(key.Look, hits, frame);
    });
}

/// Every pixel of a picture that is shown again is an answer known before.
void FrameRenderer::CountKnownHits()
{
  const std::vector<std::int16_t>& isovalues = this->Front->Picture.Isovalues;
  this->Counters.DefiniteMisses = std::count(isovalues.begin(), isovalues.end(), Frame::NoSurface);
  this->Counters.DefiniteHits = this->Counters.Rays - this->Counters.DefiniteMisses;
}

void FrameRenderer::Release()
{
  *this = FrameRenderer();
}

}
