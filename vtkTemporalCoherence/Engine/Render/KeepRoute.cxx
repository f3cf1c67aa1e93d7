// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerMerge.h"
#include "Render/RouteSteps.h"
#include "Shade/TileCompositor.h"
#include "Trace/RayHint.h"

#include <algorithm>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// The key of the new isovalues of a frame alone.
FrameKey KeyOfNew(const FrameKey& key, const SurfaceChange& change)
{
  FrameKey ofNew = key;
  ofNew.Isosurfaces = { {}, key.Isosurfaces.Mode };
  for (const std::int16_t isovalue : change.New)
  {
    const auto i = static_cast<std::size_t>(isovalue);
    ofNew.Isosurfaces.Isovalues.push_back(change.Next[i]);
    ofNew.Isosurfaces.Opacities.push_back(change.LeastAlphas[i]);
  }
  return ofNew;
}

/// What the tiles of a frame are made of.
struct KeepScene
{
  TileScene All;     ///< of the frame
  LeapedSpace Space; ///< of the frame
  TileScene New;     ///< of the new isovalues alone
  const SurfaceChange& Change;
  const Frame& Last;
};

/// Makes the tiles of a frame from the layers of kept isovalues and those of new ones.
class KeptTiles
{
public:
  explicit KeptTiles(const KeepScene& scene)
    : Scene(scene)
    , Key(scene.All.Key)
    , OfAll(scene.All)
    , OfNew(scene.New)
    , Source{ this->Key.Samples, this->Key.Transform,
      CapPlanes(RegionClipper(this->Key.Region, this->Key.Transform).Planes(), this->Key.Transform,
        this->Key.View),
      this->Key.Isosurfaces.Isovalues, scene.All.FiniteRange }
    , Compositor(this->Key, this->Source, scene.Space)
    , AlphasOfNew(AlphasOf(scene.New.Key.Isosurfaces))
  {
  }

  TraceCounts Make(std::int64_t tile, const PixelRect& part, Frame& frame) const
  {
    TraceCounts counts;
    const auto place = static_cast<std::size_t>(tile);
    TileHits found;
    if (!this->OfAll.SetUp(tile, part, found))
    {
      StoreClearTile(tile, part, this->Key.View.Parallel, frame);
      counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
      return counts;
    }
    LayerMerge merge(part, frame.Size.x, this->Scene.Change);
    this->Keep(tile, part, merge);
    if (this->IsMostUncovered(merge, part))
    {
      return this->TraceAll(tile, part, found, frame);
    }
    frame.ClearTiles[place] = 0;
    const std::uint64_t traced = this->AddNew(tile, part, merge, counts);
    {
      const TileTimer timer(tile, counts.ShadeTime);
      this->Compositor.CompositeKnown(tile, part, merge.Finish(), frame, counts);
    }
    this->StoreRays(part, found.Rays, frame.Layers[place], frame);
    this->Compositor.Paint(frame.Layers[place], frame);
    this->Count(part, traced, frame, counts);
    return counts;
  }

private:
  /// Take what the last picture knows.
  void Keep(std::int64_t tile, const PixelRect& part, LayerMerge& merge) const
  {
    const Frame& last = this->Scene.Last;
    if (last.ClearTiles[static_cast<std::size_t>(tile)])
    {
      merge.Keep(KnownLayers({}, ~std::uint64_t(0)));
    }
    else
    {
      merge.Keep(KnownLayers(tile, part, last));
    }
  }

  /// True if so many rays have to be searched for all isovalues that it is faster to search the
  /// whole tile for them, once.
  bool IsMostUncovered(const LayerMerge& merge, const PixelRect& part) const
  {
    constexpr std::size_t most = 4; // a quarter. Measured by skin and bone at opacity 0.9
    const auto rays = static_cast<std::size_t>(part.Size.x * part.Size.y);
    return !this->Scene.Change.New.empty() && most * merge.CountUncovered() > rays;
  }

  /// Make a tile as in a cold frame.
  TraceCounts TraceAll(
    std::int64_t tile, const PixelRect& part, TileHits& found, Frame& frame) const
  {
    TraceCounts counts = this->OfAll.Trace(tile, part, frame, found);
    const TileTimer timer(tile, counts.ShadeTime);
    this->Compositor.Composite(tile, part, &found, frame, counts);
    return counts;
  }

  /// Find the layers of the new isovalues, each ray up to its limit.
  /// \return one bit for each ray that is traced
  std::uint64_t AddNew(
    std::int64_t tile, const PixelRect& part, LayerMerge& merge, TraceCounts& counts) const
  {
    TileHits found;
    if (!this->OfNew.SetUp(tile, part, found))
    {
      return 0;
    }
    RayBatch& rays = found.Rays;
    LayerBatch& batch = found.Layers;
    const auto count = static_cast<std::size_t>(rays.Count);
    batch.Begin(count, this->AlphasOfNew);
    std::uint64_t traced = 0;
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      rays.WalkEnd[ray] = std::min(rays.WalkEnd[ray], merge.EndOf(ray));
      traced |= static_cast<std::uint64_t>(rays.HasWalk(ray)) << ray;
    }
    do
    {
      this->OfNew.FindLayers(rays, batch);
      counts.CellsRead += batch.CellsRead;
      for (std::size_t i = 0; i < batch.Total; ++i)
      {
        const std::size_t ray = batch.Ray[i];
        merge.Add(ray,
          { batch.Distance[i], rays.Pixel[ray],
            this->Scene.Change.New[static_cast<std::size_t>(batch.Surface[i])], batch.Kind[i] });
      }
    } while (batch.BeginNext(count, batch.Transmittance));
    counts.TracedRays += static_cast<std::int64_t>(hwy::PopCount(traced));
    return traced;
  }

  /// Write what the first layers tell about rays, as in a cold frame.
  void StoreRays(const PixelRect& part, const RayBatch& rays, const std::vector<LayerHit>& layers,
    Frame& frame) const
  {
    const auto count = static_cast<std::size_t>(rays.Count);
    HitBatch first;
    first.Clear(rays.Count);
    const PlaceFinder places(part, frame.Size.x);
    for (const LayerHit& hit : layers)
    {
      const std::size_t ray = places.Find(hit.Pixel);
      if (first.Kind[ray] != HitKind::None)
      {
        break; // of the second round
      }
      first.Depth[ray] = hit.Depth;
      first.Kind[ray] = hit.Kind;
    }
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
      frame.Kinds[pixel] = first.Kind[ray];
      frame.Answers[pixel] = RayHint().TellOf({}, rays, first, ray).Known;
      if (!frame.Disparities.empty())
      {
        frame.Disparities[pixel] =
          DisparityAt(rays, ray, first.Depth[ray], this->Key.View.Parallel);
      }
    }
  }

  /// Count what was known about the rays of a tile.
  static void Count(
    const PixelRect& part, std::uint64_t traced, const Frame& frame, TraceCounts& counts)
  {
    std::uint64_t ray = 1;
    for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
    {
      for (int x = part.First.x; x < part.First.x + part.Size.x; ++x, ray <<= 1)
      {
        const auto pixel = static_cast<std::size_t>(y * frame.Size.x + x);
        const bool isHit = frame.Isovalues[pixel] != Frame::NoSurface;
        ++(traced & ray ? counts.PossibleHits
            : isHit     ? counts.DefiniteHits
                        : counts.DefiniteMisses);
      }
    }
  }

  const KeepScene& Scene;
  const FrameKey& Key;
  TileTracer OfAll, OfNew;
  NormalSource Source;
  TileCompositor Compositor;
  std::vector<float> AlphasOfNew;
};

}

bool KeepKnownLayers(FrameTask& task)
{
  const CachedImage& last = task.Store.Last();
  const SurfaceChange change(last.Key.Isosurfaces, task.Key.Isosurfaces);
  const FrameKey ofNew = KeyOfNew(task.Key, change);
  const bool leaps = task.Options.SpaceLeaping;
  task.Costs = nullptr; // most layers are known
  // Translucent surfaces leave no first entries.
  const LeapedSpace space = Begin(task, leaps, ExtrasWithoutEntries(task));
  FrameStructures structures(task.Structures.Sharing());
  if (leaps)
  {
    Stopwatch watch(task.Statistics.TraceTime);
    structures.PrepareRanges(ofNew);
    structures.PrepareActiveCells(ofNew);
  }
  const LeapedSpace spaceOfNew = structures.SpaceToLeap(leaps);
  const ValueRangePyramid& ranges = task.Structures.Pyramid();
  const KeepScene scene{ SceneOf(task, space, nullptr), space,
    { ofNew, spaceOfNew.Active, spaceOfNew.Bounds, ranges.FiniteRange(), nullptr, &ranges }, change,
    last.Picture };
  const KeptTiles tiles(scene);
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    { return tiles.Make(tile, part, frame); });
}

}
