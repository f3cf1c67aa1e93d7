// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/Routes.h"

#include "ImageCache/FreeSpaceHint.h"
#include "ImageCache/PaperHint.h"
#include "Isomap/IsomapLookup.h"
#include "Render/TileLoop.h"
#include "Render/TileTracer.h"
#include "Scene/Stopwatch.h"
#include "Shade/TileShader.h"

#include <algorithm>
#include <bitset>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Fewer rays than this are traced without space leaping: that is faster than finding active cells
/// first. Measured by the look-ups of `Benchmark --scenarios routes`.
constexpr std::int64_t FewRays = 256;

/// What views made from the frame may need.
FrameExtras ExtrasOf(const FrameTask& task)
{
  const FrameOptions& options = task.Options;
  const bool isPaper = options.Accuracy == ReuseAccuracy::Paper;
  const bool isBounded =
    options.Accuracy == ReuseAccuracy::Bounded && IsFasterFrom(task.Key, task.Key);
  const bool isCached = options.Reuse.ImageCache;
  return { isCached && (isPaper || isBounded), isCached && isBounded };
}

/// Make room for the frame, and find out where its rays can meet surfaces.
LeapedSpace Begin(FrameTask& task, bool leaps, const FrameExtras& extras)
{
  Stopwatch watch(task.Statistics.TraceTime);
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  task.Store.Begin(task.Key, extras);
  return task.Structures.SpaceToLeap(leaps);
}

TileScene SceneOf(const FrameTask& task, const LeapedSpace& space, const RayHint* hint)
{
  return { task.Key, space.Active, space.Bounds, task.Structures.Pyramid().FiniteRange(), hint };
}

/// Call work(tile, part, frame) for all tiles of the frame.
template <typename Work>
bool WorkOnTiles(FrameTask& task, const ReportProgress& report, const Work& work)
{
  Frame& frame = task.Store.Next().Picture;
  TraceCounts counts;
  const bool isDone = CountTiles(frame.Size, report, task.Statistics, counts,
    [&](std::int64_t tile, const PixelRect& part) { return work(tile, part, frame); });
  task.CellsRead += counts.CellsRead;
  return isDone;
}

/// Trace and shade all tiles.
/// \param shaded  the hits to shade
/// \param changes tells which tiles to copy from the last frame instead; may be null
bool TraceTiles(FrameTask& task, const LeapedSpace& space, const RayHint* hint,
  HitSet shaded = HitSet::All, const SampleComparer* changes = nullptr)
{
  const Frame& last = task.Store.Last().Picture;
  const TileTracer tracer(SceneOf(task, space, hint));
  const TileShader shader(task.Key, task.Structures.Pyramid().FiniteRange(), space, shaded, shaded);
  return WorkOnTiles(task, task.Report,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      if (changes && changes->CanCopy(tile))
      {
        return CopyTile(tile, part, last, task.Key.View.Parallel, frame);
      }
      TileHits found;
      TraceCounts counts = tracer.Trace(tile, part, frame, found);
      shader.Shade(tile, part, &found, frame, counts);
      return counts;
    });
}

/// If a picture is shown again, the answers of all pixels were known before.
void CountKnownHits(FrameTask& task)
{
  const Plane<std::int16_t>& isovalues = task.Store.Last().Picture.Isovalues;
  FrameStatistics& statistics = task.Statistics;
  statistics.DefiniteMisses = std::count(isovalues.begin(), isovalues.end(), Frame::NoSurface);
  statistics.DefiniteHits = statistics.Rays - statistics.DefiniteMisses;
}

/// True if the colours of a cached image may be re-used: surfaces and lights must be the same.
/// Lights may have moved, as a headlight does with every view (the paper's choice).
bool HasColorsFor(const CachedImage& cached, const FrameKey& next)
{
  Appearance appearance = cached.Key.Appearance;
  if (appearance.Lights.size() != next.Appearance.Lights.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < appearance.Lights.size(); ++i)
  {
    appearance.Lights[i].Position = next.Appearance.Lights[i].Position;
    appearance.Lights[i].Direction = next.Appearance.Lights[i].Direction;
  }
  return appearance == next.Appearance && cached.Key.Isosurfaces == next.Isosurfaces &&
    !next.Appearance.ColorByAnswer;
}

/// Trace the rays that an isomap leaves unresolved, one bit each, tile by tile, and shade these
/// tiles.
bool TraceUnresolvedRays(FrameTask& task, const std::vector<std::uint64_t>& unresolved,
  const TileShader& shader, const ReportProgress& report)
{
  const std::int64_t rays = std::accumulate(unresolved.begin(), unresolved.end(), std::int64_t(0),
    [](std::int64_t sum, std::uint64_t tile)
    { return sum + static_cast<std::int64_t>(std::bitset<64>(tile).count()); });
  if (rays == 0)
  {
    return true;
  }
  const bool leaps = task.Options.SpaceLeaping && rays > FewRays;
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  const TileTracer tracer(SceneOf(task, task.Structures.SpaceToLeap(leaps), nullptr));
  return WorkOnTiles(task, report,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      TraceCounts counts;
      const std::uint64_t which = unresolved[static_cast<std::size_t>(tile)];
      if (which != 0)
      {
        counts = tracer.TraceSome(tile, part, which, frame);
        shader.Shade(tile, part, nullptr, frame, counts);
      }
      return counts;
    });
}

}

void ShowAgain(FrameTask& task)
{
  CountKnownHits(task);
}

void ShadeAgain(FrameTask& task)
{
  CachedImage& last = task.Store.LastToRecolor();
  {
    Stopwatch watch(task.Statistics.ShadeTime);
    FrameKey key = task.Key;
    const TileShader shader(
      task.Key, task.Structures.Pyramid().FiniteRange(), {}, HitSet::None, HitSet::All);
    std::swap(last.Key, key); // nothing from here on allocates
    ParallelFor(NumberOfTiles(last.Picture.Size), TileGrain,
      [&](std::int64_t tile)
      {
        TraceCounts counts;
        shader.Shade(tile, PixelsOfTile(last.Picture.Size, tile), nullptr, last.Picture, counts);
      });
  }
  CountKnownHits(task);
}

bool TraceCold(FrameTask& task)
{
  return TraceTiles(task, Begin(task, task.Options.SpaceLeaping, ExtrasOf(task)), nullptr);
}

bool TraceFromImage(FrameTask& task, CachedImage& image)
{
  const FrameOptions& options = task.Options;
  const bool isPaper = options.Accuracy == ReuseAccuracy::Paper;
  const bool interpolates = isPaper && options.InterpolateColors && HasColorsFor(image, task.Key) &&
    !task.Key.Isosurfaces.IsTranslucent();
  const LeapedSpace space = Begin(task, options.SpaceLeaping, ExtrasOf(task));
  CachedImage& made = task.Store.Next();
  made.Picture.IsFromCache = true;
  made.IsExact = false;
  std::unique_ptr<ImageQuery> query;
  {
    Stopwatch watch(task.Statistics.QueryTime);
    query = std::make_unique<ImageQuery>(image, task.Key, options.Accuracy);
  }
  const bool isSolid = task.Key.Isosurfaces.Mode == SurfaceMode::Threshold;
  if (query->IsBounded())
  {
    const FreeSpaceHint hint(*query, isSolid);
    return TraceTiles(task, space, &hint);
  }
  const PaperHint hint(*query, isSolid, task.Key.View.Parallel, interpolates);
  return TraceTiles(task, space, &hint, interpolates ? HitSet::NotDefinite : HitSet::All);
}

bool TraceChangedTiles(FrameTask& task, const SampleComparer& changes)
{
  // What is copied has no more than the last frame has.
  const Frame& last = task.Store.Last().Picture;
  FrameExtras extras = ExtrasOf(task);
  extras.Disparities &= !last.Disparities.empty();
  extras.FirstEntries &= !last.FirstEntries.empty();
  return TraceTiles(
    task, Begin(task, task.Options.SpaceLeaping, extras), nullptr, HitSet::All, &changes);
}

bool LookUp(FrameTask& task, IsomapBuilder& map, std::vector<std::uint64_t>& unresolved)
{
  const bool hasNormals = task.Options.Map.HasNormals;
  // A walk is only needed for layers behind translucent surfaces.
  const bool leaps = task.Options.SpaceLeaping && task.Key.Isosurfaces.IsTranslucent();
  // A look-up finds no first entries.
  const LeapedSpace space = Begin(task, leaps, { ExtrasOf(task).Disparities, false });
  const glm::dvec2& finiteRange = task.Structures.Pyramid().FiniteRange();
  const double tolerance = map.Built().Tolerance();
  const IsomapLookup lookup(task.Key, map.BandsFor(task.Key), tolerance, finiteRange);
  const TileShader shader(
    task.Key, finiteRange, space, hasNormals ? HitSet::NotDefinite : HitSet::All, HitSet::All);
  unresolved.resize(static_cast<std::size_t>(NumberOfTiles(task.Key.View.Size)));
  const bool isLookedUp = WorkOnTiles(task, PartOf(task.Report, 0.0, 0.5),
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      std::uint64_t& left = unresolved[static_cast<std::size_t>(tile)];
      TileHits found;
      TraceCounts counts = lookup.LookUpTile(tile, part, frame, left, found);
      if (left == 0)
      {
        shader.Shade(tile, part, &found, frame, counts);
      }
      return counts;
    });
  CachedImage& made = task.Store.Next();
  made.IsExact = tolerance == 0.0 && !hasNormals;
  return isLookedUp && TraceUnresolvedRays(task, unresolved, shader, PartOf(task.Report, 0.5, 1.0));
}

}
