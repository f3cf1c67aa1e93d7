// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/Routes.h"

#include "ImageCache/PaperHint.h"
#include "Render/ColdTiles.h"
#include "Render/RouteSteps.h"
#include "Render/SavedColors.h"
#include "Scene/Timers.h"
#include "Shade/TileShader.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Trace and shade all tiles.
/// \param shaded  the hits to shade
/// \param changes tells which tiles to copy from the last frame instead; may be null
bool TraceTiles(FrameTask& task, const LeapedSpace& space, const RayHint* hint,
  HitSet shaded = HitSet::All, const SampleComparer* changes = nullptr)
{
  const Frame& last = task.Store.Last().Picture;
  const TileTracer tracer(SceneOf(task, space, hint));
  const TileShader shader(ShadeSceneOf(task, space), shaded, shaded);
  const LayerOptions& layers = task.Options.Layers;
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      if (changes && changes->CanCopy(tile) && KeepsAllLayers(tile, last, layers))
      {
        return CopyTile(tile, part, last, task.Key.View.Parallel, frame);
      }
      TileHits found;
      TraceCounts counts = tracer.Trace(tile, part, frame, found);
      shader.Shade(tile, part, &found, frame, counts);
      return counts;
    });
}

/// Count the answers of a picture that repeats the hits of the last one: all of them are definite.
void CountKnownHits(FrameTask& task, const Frame& picture)
{
  const Plane<SurfaceIndex>& isovalues = picture.Isovalues;
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
  return appearance == next.Appearance && cached.Key.Isosurfaces() == next.Isosurfaces() &&
    !next.Appearance.ColorByAnswer;
}

/// The space for tracing merged layers again. Without merged layers nothing is prepared.
LeapedSpace SpaceOfMerged(FrameTask& task, const Frame& picture)
{
  const bool leaps = task.Options.SpaceLeaping &&
    std::any_of(picture.Behind.begin(), picture.Behind.end(),
      [](const LayersBehind& tile) { return tile.Merged != 0; });
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  return task.Structures.SpaceToLeap(leaps);
}

}

void ShowAgain(FrameTask& task)
{
  CountKnownHits(task, task.Store.Last().Picture);
}

bool ShadeAgain(FrameTask& task)
{
  CachedImage& last = task.Store.LastToRecolor();
  Frame& picture = last.Picture;
  FrameStatistics counted;
  {
    Stopwatch watch(task.Statistics.ShadeTime);
    FrameKey key = task.Key;
    ShadeScene scene = ShadeSceneOf(task, SpaceOfMerged(task, picture));
    scene.Values = task.Values;
    const TileShader shader(scene, HitSet::None, HitSet::All);
    // Without a report nothing from here on can stop the frame.
    std::optional<SavedColors> saved;
    if (task.Report)
    {
      saved.emplace(picture);
    }
    const auto shade = [&](std::size_t group, TraceCounts& counts)
    {
      const TileRange tiles = TilesOfGroup(picture.Size, group);
      for (std::int64_t tile = tiles.First; tile < tiles.End; ++tile)
      {
        const PixelRect part = PixelsOfTile(picture.Size, tile);
        if (saved)
        {
          saved->Save(tile, part);
        }
        shader.Shade(tile, part, nullptr, picture, counts);
      }
    };
    if (!CountGroups(picture.Size, task.Report, counted, shade))
    {
      return false;
    }
    last.Key = std::move(key);
    picture.ForgetAntialiased();
    if (saved)
    {
      saved->Drop();
    }
  }
  task.Statistics.TracedRays = counted.TracedRays;
  task.Statistics.FieldSamples = counted.FieldSamples;
  task.Statistics.Layers = counted.Layers;
  task.Statistics.MergedLayers = counted.MergedLayers;
  CountKnownHits(task, picture);
  return true;
}

bool TraceCold(FrameTask& task)
{
  return TraceTiles(task, Begin(task, task.Options.SpaceLeaping, ExtrasOf(task)), nullptr);
}

LeapedSpace BeginSurfaces(FrameTask& task)
{
  return Begin(task, task.Options.SpaceLeaping, ExtrasOf(task));
}

TileWork SurfaceWork(const FrameTask& task, const LeapedSpace& space)
{
  const auto tracer = std::make_shared<const TileTracer>(SceneOf(task, space, nullptr));
  const auto shader =
    std::make_shared<const TileShader>(ShadeSceneOf(task, space), HitSet::All, HitSet::All);
  return [tracer, shader](std::int64_t tile, const PixelRect& part, Frame& frame)
  {
    TileHits found;
    TraceCounts counts = tracer->Trace(tile, part, frame, found);
    shader->Shade(tile, part, &found, frame, counts);
    return counts;
  };
}

bool TraceFromImage(FrameTask& task, const CachedImage& image)
{
  const FrameOptions& options = task.Options;
  const bool interpolates = options.InterpolateColors && HasColorsFor(image, task.Key) &&
    !task.Key.Isosurfaces().IsTranslucent();
  const LeapedSpace space = Begin(task, options.SpaceLeaping, ExtrasOf(task));
  CachedImage& made = task.Store.Next();
  made.Picture.IsFromCache = true;
  made.IsExact = false;
  std::unique_ptr<ImageQuery> query;
  {
    Stopwatch watch(task.Statistics.QueryTime);
    query = std::make_unique<ImageQuery>(image, task.Key);
  }
  const bool isSolid = task.Key.Isosurfaces().Mode == SurfaceMode::Threshold;
  const PaperHint hint(*query, isSolid, task.Key.View.Parallel, interpolates);
  return TraceTiles(task, space, &hint, interpolates ? HitSet::NotDefinite : HitSet::All);
}

bool TraceChangedTiles(FrameTask& task, const SampleComparer& changes)
{
  const FrameExtras extras = ExtrasToCopy(task);
  return TraceTiles(
    task, Begin(task, task.Options.SpaceLeaping, extras), nullptr, HitSet::All, &changes);
}

bool CompositeKnownLayers(FrameTask& task)
{
  const Frame& last = task.Store.Last().Picture;
  const bool leaps = task.Options.SpaceLeaping && task.Key.Isosurfaces().IsTranslucent();
  const LeapedSpace space = Begin(task, leaps, ExtrasToCopy(task));
  Frame& next = task.Store.Next().Picture;
  next.Behind.resize(last.ClearTiles.size()); // opaque surfaces hide layers, too
  next.IsFromCache = last.IsFromCache;
  const TileShader shader(ShadeSceneOf(task, space), HitSet::All, HitSet::All);
  const bool isDone = MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      TraceCounts counts;
      shader.ShadeKnown(tile, part, last, frame, counts);
      return counts;
    });
  if (isDone)
  {
    CountKnownHits(task, next);
  }
  return isDone;
}

}
