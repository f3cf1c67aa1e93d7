// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/Routes.h"

#include "ImageCache/FreeSpaceHint.h"
#include "ImageCache/LastHitHint.h"
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

/// Fewer rays than this are traced without space leaping: they are traced sooner than active cells
/// are found. Measured by the look-ups of `Benchmark --scenarios routes`.
constexpr std::int64_t FewRays = 256;

/// Get room for the frame, and find out where its rays can meet surfaces.
LeapedSpace Begin(FrameTask& task, bool leaps)
{
  Stopwatch watch(task.Statistics.TraceTime);
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  task.Frames.Begin(task.Key);
  return task.Structures.SpaceToLeap(leaps);
}

TileScene SceneOf(const FrameTask& task, const LeapedSpace& space, const RayHint* hint)
{
  // How near contacts are is of use to the free space of images alone.
  const bool isCached =
    task.Options.Reuse.ImageCache && task.Options.Accuracy == ReuseAccuracy::Bounded;
  return { task.Key, space.Active, space.Bounds, task.Structures.Pyramid().FiniteRange(), hint,
    isCached };
}

/// Call work(tile, part, frame) for all tiles of the frame.
template <typename Work>
bool WorkOnTiles(FrameTask& task, const ReportProgress& report, const Work& work)
{
  Frame& frame = task.Frames.Next().Picture;
  TraceCounts counts;
  const bool isDone = CountTiles(frame.Size, report, task.Statistics, counts,
    [&](std::int64_t tile, const PixelRect& part) { return work(tile, part, frame); });
  task.CellsRead += counts.CellsRead;
  return isDone;
}

/// Trace and shade all tiles.
/// \param shaded  hits whose normals and colours are not taken over
/// \param changes null, or tells which tiles are copied from the last frame instead
bool TraceTiles(FrameTask& task, const LeapedSpace& space, const RayHint* hint,
  HitSet shaded = HitSet::All, const SampleComparer* changes = nullptr)
{
  const Frame& last = task.Frames.Last().Picture;
  const TileTracer tracer(SceneOf(task, space, hint));
  const TileShader shader(task.Key, task.Structures.Pyramid().FiniteRange(), space, shaded, shaded);
  return WorkOnTiles(task, task.Report,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      if (changes && changes->CanCopy(tile))
      {
        return CopyTile(tile, part, last, task.Key.Seen.Parallel, frame);
      }
      TraceCounts counts = tracer.Trace(tile, part, frame);
      shader.Shade(tile, part, frame, counts);
      return counts;
    });
}

/// Every pixel of a picture that is shown again is an answer known before.
void CountKnownHits(FrameTask& task)
{
  const Plane<std::int16_t>& isovalues = task.Frames.Last().Picture.Isovalues;
  FrameStatistics& statistics = task.Statistics;
  statistics.DefiniteMisses = std::count(isovalues.begin(), isovalues.end(), Frame::NoSurface);
  statistics.DefiniteHits = statistics.Rays - statistics.DefiniteMisses;
}

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

/// Trace the rays that an isomap leaves open, one bit each, tile by tile, and shade these tiles.
bool TraceOpenRays(FrameTask& task, const std::vector<std::uint64_t>& open,
  const TileShader& shader, const ReportProgress& report)
{
  const std::int64_t rays = std::accumulate(open.begin(), open.end(), std::int64_t(0),
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
      const std::uint64_t which = open[static_cast<std::size_t>(tile)];
      if (which != 0)
      {
        counts = tracer.TraceSome(tile, part, which, frame);
        shader.Shade(tile, part, frame, counts);
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
  CachedImage& last = task.Frames.LastToRecolor();
  {
    Stopwatch watch(task.Statistics.ShadeTime);
    FrameKey key = task.Key;
    const TileShader shader(
      task.Key, task.Structures.Pyramid().FiniteRange(), {}, HitSet::None, HitSet::All);
    std::swap(last.Key, key); // nothing from here on needs memory
    ParallelFor(NumberOfTiles(last.Picture.Size), TileGrain,
      [&](std::int64_t tile)
      {
        TraceCounts counts;
        shader.Shade(tile, PixelsOfTile(last.Picture.Size, tile), last.Picture, counts);
      });
  }
  CountKnownHits(task);
}

bool TraceCold(FrameTask& task)
{
  return TraceTiles(task, Begin(task, task.Options.SpaceLeaping), nullptr);
}

bool TraceWithLastHits(FrameTask& task)
{
  const LeapedSpace space = Begin(task, task.Options.SpaceLeaping);
  const CachedImage& last = task.Frames.Last();
  const LastHitHint hint(
    last.Picture, CompareFrames(last.Key, task.Key).Raised, task.Key.Seen.Parallel);
  return TraceTiles(task, space, &hint);
}

bool TraceFromImage(FrameTask& task, CachedImage& image)
{
  const FrameOptions& options = task.Options;
  const bool isPaper = options.Accuracy == ReuseAccuracy::Paper;
  const bool interpolates = isPaper && options.InterpolateColors && HasColorsFor(image, task.Key) &&
    !task.Key.Sought.IsTranslucent();
  const LeapedSpace space = Begin(task, options.SpaceLeaping);
  CachedImage& made = task.Frames.Next();
  made.Picture.IsFromCache = true;
  made.IsExact = false;
  made.IsEroded = isPaper;
  std::unique_ptr<ImageQuery> query;
  {
    Stopwatch watch(task.Statistics.QueryTime);
    query = std::make_unique<ImageQuery>(image, task.Key, options.Accuracy);
  }
  const bool isSolid = task.Key.Sought.Mode == SurfaceMode::Threshold;
  if (query->IsBounded())
  {
    const FreeSpaceHint hint(*query, isSolid);
    return TraceTiles(task, space, &hint);
  }
  const PaperHint hint(*query, isSolid, task.Key.Seen.Parallel, interpolates);
  return TraceTiles(task, space, &hint, interpolates ? HitSet::NotDefinite : HitSet::All);
}

bool TraceChangedTiles(FrameTask& task, const SampleComparer& changes)
{
  return TraceTiles(task, Begin(task, task.Options.SpaceLeaping), nullptr, HitSet::All, &changes);
}

bool LookUp(FrameTask& task, IsomapBuilder& map, std::vector<std::uint64_t>& open)
{
  const bool hasNormals = task.Options.Map.HasNormals;
  // Only what shines through opaque surfaces is found without a walk.
  const bool leaps = task.Options.SpaceLeaping && task.Key.Sought.IsTranslucent();
  const LeapedSpace space = Begin(task, leaps);
  const glm::dvec2& finiteRange = task.Structures.Pyramid().FiniteRange();
  const double tolerance = map.Built().Tolerance();
  const IsomapLookup lookup(task.Key, map.BandsFor(task.Key), tolerance, finiteRange);
  const TileShader shader(
    task.Key, finiteRange, space, hasNormals ? HitSet::NotDefinite : HitSet::All, HitSet::All);
  open.resize(static_cast<std::size_t>(NumberOfTiles(task.Key.Seen.Size)));
  const bool isLookedUp = WorkOnTiles(task, PartOf(task.Report, 0.0, 0.5),
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      std::uint64_t& left = open[static_cast<std::size_t>(tile)];
      TraceCounts counts = lookup.Look(tile, part, frame, left);
      if (left == 0)
      {
        shader.Shade(tile, part, frame, counts);
      }
      return counts;
    });
  CachedImage& made = task.Frames.Next();
  made.IsExact = tolerance == 0.0 && !hasNormals;
  made.IsEroded = tolerance > 0.0;
  return isLookedUp && TraceOpenRays(task, open, shader, PartOf(task.Report, 0.5, 1.0));
}

}
