// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/RouteSteps.h"
#include "Shade/KeptLayers.h"
#include "Shade/LayerMerge.h"
#include "Shade/TileCompositor.h"
#include "Trace/RayHint.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// The key of some isovalues of a frame alone, with the least opacities that they may have.
FrameKey KeyOf(const FrameKey& key, const std::vector<std::int16_t>& isovalues)
{
  FrameKey some = key;
  some.Isosurfaces = { {}, key.Isosurfaces.Mode };
  const std::vector<double> least = LeastOpacitiesOf(key.Isosurfaces);
  for (const std::int16_t isovalue : isovalues)
  {
    const auto i = static_cast<std::size_t>(isovalue);
    some.Isosurfaces.Isovalues.push_back(key.Isosurfaces.Isovalues[i]);
    some.Isosurfaces.Opacities.push_back(least[i]);
  }
  return some;
}

/// What the tiles of a frame are made of.
struct MergeScene
{
  TileScene All;     ///< of the frame
  LeapedSpace Space; ///< of the frame
  TileScene New;     ///< of the new isovalues alone
  KeptIsovalues Kept;
  const CachedImage& Last;
};

/// Makes the tiles of a frame from the layers of kept isovalues and those of new ones.
class MergedTiles
{
public:
  explicit MergedTiles(const MergeScene& scene)
    : Scene(scene)
    , Key(scene.All.Key)
    , OfAll(scene.All)
    , OfNew(scene.New)
    , Source{ this->Key.Samples, this->Key.Transform,
      RegionClipper(this->Key.Region, this->Key.Transform).Planes(),
      this->Key.Isosurfaces.Isovalues, scene.All.FiniteRange }
    , Compositor(this->Key, this->Source, scene.Space)
    , AlphasOfNew(AlphasOf(scene.New.Key.Isosurfaces))
  {
    for (const double opacity : LeastOpacitiesOf(this->Key.Isosurfaces))
    {
      this->LeastAlphas.push_back(static_cast<float>(opacity));
    }
  }

  TraceCounts Make(std::int64_t tile, const PixelRect& part, Frame& frame) const
  {
    TraceCounts counts;
    const auto place = static_cast<std::size_t>(tile);
    TileHits found;
    if (!this->OfAll.SetUp(tile, part, found))
    {
      frame.Layers[place].clear();
      frame.Behind[place] = {};
      StoreMisses(tile, part, this->Key.View.Parallel, frame);
      counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
      return counts;
    }
    frame.ClearTiles[place] = 0;
    std::uint64_t traced = 0;
    const KnownLayers known = this->FindLayers(tile, part, traced, counts);
    {
      const TileTimer timer(tile, counts.ShadeTime);
      this->Compositor.CompositeKnown(tile, part, known, frame, counts);
    }
    this->StoreRays(part, found.Rays, frame.Layers[place], frame);
    this->Compositor.Paint(frame.Layers[place], frame);
    this->Count(part, traced, frame, counts);
    return counts;
  }

private:
  /// Find all layers of a tile, as far as they are known or light surely reaches.
  /// \param traced gets one bit for each ray that is traced
  KnownLayers FindLayers(
    std::int64_t tile, const PixelRect& part, std::uint64_t& traced, TraceCounts& counts) const
  {
    const CachedImage& last = this->Scene.Last;
    const int width = this->Key.View.Size.x;
    const bool wasClear = last.Picture.ClearTiles[static_cast<std::size_t>(tile)];
    const KnownLayers known =
      wasClear ? KnownLayers({}, ~std::uint64_t(0)) : KnownLayers(tile, part, last.Picture);
    KeptLayers kept(
      known, part, width, last.Key.Isosurfaces.Isovalues, this->Scene.Kept, this->LeastAlphas);
    std::vector<LayerHit> layers = std::move(kept.Hits);
    traced = this->AddNew(tile, part, kept, layers, counts);
    MergeLayers(part, width, this->Key.Isosurfaces.Isovalues, layers);
    const std::uint64_t opaque = DropUnlit(part, width, this->LeastAlphas, layers);
    return KnownLayers(std::move(layers), ~(kept.Limited | opaque));
  }

  /// Find the layers of the new isovalues, each ray up to its limit.
  /// \return one bit for each ray that is traced
  std::uint64_t AddNew(std::int64_t tile, const PixelRect& part, const KeptLayers& kept,
    std::vector<LayerHit>& layers, TraceCounts& counts) const
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
      rays.WalkEnd[ray] = std::min(rays.WalkEnd[ray], kept.EndOf(ray));
      traced |= static_cast<std::uint64_t>(rays.HasWalk(ray)) << ray;
    }
    do
    {
      batch.CellsRead = 0;
      this->OfNew.FindLayers(rays, batch);
      counts.CellsRead += batch.CellsRead;
      for (std::size_t i = 0; i < batch.Total; ++i)
      {
        this->Append(batch, i, rays, kept, layers);
      }
    } while (batch.BeginNext(count, batch.Transmittance));
    counts.TracedRays += static_cast<std::int64_t>(hwy::PopCount(traced));
    return traced;
  }

  void Append(const LayerBatch& batch, std::size_t i, const RayBatch& rays, const KeptLayers& kept,
    std::vector<LayerHit>& layers) const
  {
    const auto surface = static_cast<std::size_t>(batch.Surface[i]);
    const MetSurface met{ batch.Distance[i], batch.Kind[i],
      this->Scene.New.Key.Isosurfaces.Isovalues[surface] };
    if (kept.IsWithin(batch.Ray[i], met))
    {
      layers.push_back(
        { met.Distance, rays.Pixel[batch.Ray[i]], this->Scene.Kept.New[surface], met.Kind });
    }
  }

  /// Write what the first layers tell about rays, as in a cold frame.
  void StoreRays(const PixelRect& part, const RayBatch& rays, const std::vector<LayerHit>& layers,
    Frame& frame) const
  {
    const auto count = static_cast<std::size_t>(rays.Count);
    HitBatch first;
    first.Clear(rays.Count);
    for (const LayerHit& hit : layers)
    {
      const std::size_t ray = PlaceInTile(part, frame.Size.x, hit.Pixel);
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

  const MergeScene& Scene;
  const FrameKey& Key;
  TileTracer OfAll, OfNew;
  NormalSource Source;
  TileCompositor Compositor;
  std::vector<float> LeastAlphas, AlphasOfNew;
};

}

bool MergeNewLayers(FrameTask& task)
{
  const CachedImage& last = task.Store.Last();
  const bool leaps = task.Options.SpaceLeaping;
  task.Costs = nullptr; // most layers are known
  // Translucent surfaces leave no first entries.
  const LeapedSpace space = Begin(task, leaps, { ExtrasOf(task).Disparities, false });
  const KeptIsovalues kept(last.Key.Isosurfaces.Isovalues, task.Key.Isosurfaces.Isovalues);
  const FrameKey ofNew = KeyOf(task.Key, kept.New);
  FrameStructures structures(task.Structures.Sharing());
  if (leaps)
  {
    Stopwatch watch(task.Statistics.TraceTime);
    structures.PrepareRanges(ofNew);
    structures.PrepareActiveCells(ofNew);
  }
  const LeapedSpace spaceOfNew = structures.SpaceToLeap(leaps);
  const ValueRangePyramid& ranges = task.Structures.Pyramid();
  const MergeScene scene{ SceneOf(task, space, nullptr), space,
    { ofNew, spaceOfNew.Active, spaceOfNew.Bounds, ranges.FiniteRange(), nullptr, &ranges }, kept,
    last };
  const MergedTiles tiles(scene);
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    { return tiles.Make(tile, part, frame); });
}

}
