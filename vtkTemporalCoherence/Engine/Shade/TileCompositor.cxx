// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/TileCompositor.h"

#include "Lattice/RayPieces.h"
#include "Shade/RecoloredLayers.h"

#include <algorithm>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{
namespace
{

/// Prefetch some layers that a frame keeps: from number `first` on, as many as are shaded at once.
void PrefetchLayers(const std::vector<LayerHit>& layers, std::size_t first)
{
  constexpr std::size_t perLine = 64 / sizeof(LayerHit);
  const std::size_t end = std::min(first + RayBatch::Capacity, layers.size());
  for (std::size_t i = first; i < end; i += perLine)
  {
    hwy::Prefetch(&layers[i]);
  }
}

/// Takes layers that no later frame needs.
struct UnkeptLayers
{
  void Keep(std::size_t, const LayerHit&) {}
};

/// \param layers that are kept
void CountLayers(
  const LimitedLayers& kept, const std::vector<LayerHit>& layers, TraceCounts& counts)
{
  counts.Layers += kept.Total();
  counts.MergedLayers += kept.Total() - static_cast<std::int64_t>(layers.size());
}

/// Find the pixels of the first round of kept layers.
void FindFirstRound(const std::vector<LayerHit>& layers, HitList& hits)
{
  std::size_t& count = hits.Rays.Count;
  for (count = 0; count < layers.size(); ++count)
  {
    if (count > 0 && layers[count].Pixel <= layers[count - 1].Pixel)
    {
      return;
    }
    hits.Pixel[count] = layers[count].Pixel;
  }
}

}

TileCompositor::TileCompositor(const FrameKey& key, const NormalSource& source,
  std::shared_ptr<const SurfaceTracer> tracer, const TileBounds* bounds, SurfaceLight* light)
  : Key(key)
  , Shader(key, source, light)
  , Bounds(bounds)
  , Rays(key.View, key.Transform, key.Samples.Dimensions, key.Region)
  , Tracer(std::move(tracer))
  , Alphas(AlphasOf(key.Isosurfaces()))
{
}

void TileCompositor::SetUpRays(std::int64_t tile, const PixelRect& part, TileHits& found) const
{
  this->Rays.SetUp(part.First, part.Size, found.Rays, &found.World);
  if (this->Bounds)
  {
    this->Bounds->Narrow(tile, found.Rays);
  }
}

/// Set up the rays of a tile, and take their first hits from the planes.
void TileCompositor::SetUp(
  std::int64_t tile, const PixelRect& part, const Frame& frame, TileHits& found) const
{
  this->SetUpRays(tile, part, found);
  const auto count = static_cast<std::size_t>(found.Rays.Count);
  found.Layers.Begin(count, this->Alphas);
  for (std::size_t ray = 0; ray < count; ++ray)
  {
    const auto pixel = static_cast<std::size_t>(found.Rays.Pixel[ray]);
    if (frame.Isovalues[pixel] != Frame::NoSurface)
    {
      found.Layers.Append(ray, frame.Depth[pixel], frame.Kinds[pixel], frame.Isovalues[pixel],
        frame.Cells.empty() ? NoCell : frame.Cells[pixel]);
    }
    else
    {
      found.Layers.Close(ray);
    }
  }
  FindLayersWithin(this->Rays.Clipper, *this->Tracer, found.Rays, found.Layers);
}

void TileCompositor::Composite(std::int64_t tile, const PixelRect& part, TileHits* found,
  Frame& frame, TraceCounts& counts) const
{
  std::vector<LayerHit>& layers = frame.Layers[static_cast<std::size_t>(tile)];
  LimitedLayers kept(frame.LayersOfPixel, layers);
  LayersBehind* behind =
    frame.Behind.empty() ? nullptr : &frame.Behind[static_cast<std::size_t>(tile)];
  if (behind)
  {
    *behind = {};
  }
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    GiveBackMemory(layers);
    return;
  }
  TileHits fromPlanes;
  if (!found || !found->HasLayers)
  {
    found = &fromPlanes;
    this->SetUp(tile, part, frame, *found);
    counts.CellsRead += found->Layers.CellsRead;
  }
  PixelCentres centres;
  if (this->Key.View.Parallel)
  {
    centres.Find(this->Key.View, part); // other rays begin at one point
  }
  LayerCanvas canvas(part, frame);
  this->AddAll(tile, *found, centres, canvas, kept, counts);
  kept.Finish();
  if (behind)
  {
    behind->Merged = kept.Merged();
    behind->Ends = canvas.Passing() & ~kept.Merged(); // else the search would have gone on
  }
  CountLayers(kept, layers, counts);
  GiveBackMemory(layers);
  canvas.Finish();
  this->Paint(layers, frame);
}

void TileCompositor::CompositeAt(
  std::int64_t tile, const RayPlaces& at, TileHits& found, Frame& rays, TraceCounts& counts) const
{
  found.Layers.Begin(static_cast<std::size_t>(found.Rays.Count), this->Alphas);
  FindLayersWithin(this->Rays.Clipper, *this->Tracer, found.Rays, found.Layers);
  counts.CellsRead += found.Layers.CellsRead;
  LayerCanvas canvas({ glm::ivec2(0), glm::ivec2(found.Rays.Count, 1) }, rays);
  UnkeptLayers unkept;
  this->AddAll(tile, found, { at.X, at.Y }, canvas, unkept, counts);
  canvas.Finish();
}

/// Shade and composite the found layers, then find and add the layers behind them, until the pixels
/// are opaque.
/// \param kept takes the layers
template <typename Keeper>
void TileCompositor::AddAll(std::int64_t tile, TileHits& found, const PixelCentres& centres,
  LayerCanvas& canvas, Keeper& kept, TraceCounts& counts) const
{
  this->AddLayers(tile, found, centres, canvas, kept);
  while (found.Layers.BeginNext(static_cast<std::size_t>(found.Rays.Count), canvas.Transmittance()))
  {
    FindLayersWithin(this->Rays.Clipper, *this->Tracer, found.Rays, found.Layers);
    counts.CellsRead += found.Layers.CellsRead;
    this->AddLayers(tile, found, centres, canvas, kept);
  }
}

void TileCompositor::CompositeKnown(std::int64_t tile, const PixelRect& part,
  const KnownLayers& known, Frame& frame, TraceCounts& counts) const
{
  std::vector<LayerHit>& layers = frame.Layers[static_cast<std::size_t>(tile)];
  LayersBehind& behind = frame.Behind[static_cast<std::size_t>(tile)];
  LimitedLayers kept(frame.LayersOfPixel, layers);
  behind.Hits.clear();
  PixelCentres centres;
  centres.Find(this->Key.View, part);
  LayerCanvas canvas(part, frame);
  this->AddKnown(tile, known.Composited(), centres, canvas, kept, behind.Hits);
  const std::size_t inOrder = layers.size();
  this->AddKnown(tile, known.Behind(), centres, canvas, kept, behind.Hits);
  const std::uint64_t open = canvas.Passing() & ~known.Ends();
  if (open != 0)
  {
    const auto setLast = [&](LayerBatch& next)
    {
      known.ForEach([&](const LayerHit& hit)
        { next.SetLast(canvas.PlaceOf(hit.Pixel), hit); }); // the last layer wins
    };
    this->AddUnknown(open, setLast, tile, part, centres, canvas, kept, counts);
  }
  const bool isInOrder = layers.size() == inOrder;
  kept.Finish();
  if (!isInOrder)
  {
    OrderByRounds(part, frame.Size.x, layers);
  }
  behind.Merged = kept.Merged();
  behind.Ends = (known.Ends() | canvas.Passing()) & ~kept.Incomplete();
  CountLayers(kept, layers, counts);
  GiveBackMemory(layers);
  GiveBackMemory(behind.Hits);
  canvas.Finish();
  this->Paint(layers, frame);
}

/// Shade known layers, composite them behind the present ones, and keep them. Layers that no light
/// reaches go to `behind`.
void TileCompositor::AddKnown(std::int64_t tile, const std::vector<LayerHit>& known,
  const PixelCentres& centres, LayerCanvas& canvas, LimitedLayers& kept,
  std::vector<LayerHit>& behind) const
{
  const RayBatch::Array<float>& transmittance = canvas.Transmittance();
  std::array<ShadedLayer, RayBatch::Capacity> shaded;
  std::array<LayerHit, RayBatch::Capacity> taken;
  PrefetchLayers(known, 0);
  for (auto next = known.begin(); next != known.end();)
  {
    PrefetchLayers(known, static_cast<std::size_t>(next - known.begin()) + RayBatch::Capacity);
    HitList hits;
    LayerList list;
    hits.Rays.Count = 0;
    for (; next != known.end() && list.Count < taken.size(); ++next)
    {
      const std::size_t place = canvas.PlaceOf(next->Pixel);
      if (transmittance[place] == 0.0f)
      {
        kept.KeepBehind(place, *next, behind);
        continue;
      }
      taken[list.Count] = *next;
      list.Append(place, taken[list.Count], shaded[list.Count]);
      centres.Append(*next, place, hits);
    }
    if (list.Count > 0)
    {
      FindHitRays(this->Key.View, hits);
      this->Shader.Shade(tile, hits, shaded.data());
    }
    // A layer of the list may make its pixel opaque, and hide later layers.
    const std::uint64_t reached = canvas.Add(list);
    for (std::size_t i = 0; i < list.Count; ++i)
    {
      if ((reached >> i & 1u) != 0)
      {
        kept.Keep(list.Place[i], taken[i]);
      }
      else
      {
        kept.KeepBehind(list.Place[i], taken[i], behind);
      }
    }
  }
}

/// Find and add the layers behind all known layers, along the rays in `open`.
/// \param setLast sets the last known layers of these rays
/// \param kept    takes the layers
template <typename Keeper, typename SetLast>
void TileCompositor::AddUnknown(std::uint64_t open, const SetLast& setLast, std::int64_t tile,
  const PixelRect& part, const PixelCentres& centres, LayerCanvas& canvas, Keeper& kept,
  TraceCounts& counts) const
{
  TileHits found;
  this->SetUpRays(tile, part, found);
  LayerBatch& layers = found.Layers;
  layers.BeginBehind(
    static_cast<std::size_t>(found.Rays.Count), this->Alphas, open, canvas.Transmittance());
  setLast(layers);
  FindLayersWithin(this->Rays.Clipper, *this->Tracer, found.Rays, layers);
  counts.TracedRays += static_cast<std::int64_t>(hwy::PopCount(open));
  counts.CellsRead += layers.CellsRead;
  this->AddAll(tile, found, centres, canvas, kept, counts);
}

/// Shade surfaces, composite them behind the present ones, and keep them: round by round, and by
/// pixel within a round.
template <typename Keeper>
void TileCompositor::AddLayers(std::int64_t tile, const TileHits& found,
  const PixelCentres& centres, LayerCanvas& canvas, Keeper& kept) const
{
  const LayerBatch& layers = found.Layers;
  LayerBatch::List<ShadedLayer> shaded;
  for (std::size_t first = 0; first < layers.Total; first += RayBatch::Capacity)
  {
    HitList hits;
    this->Shader.TakeHits(found, centres, first, hits);
    this->Shader.Shade(tile, hits, shaded.data() + first);
  }
  // A round contains the rays that have a further layer, and let light pass.
  const auto count = static_cast<std::size_t>(found.Rays.Count);
  std::array<std::uint64_t, LayerBatch::MostLayers + 1> ends{}; // one bit for each ray
  for (std::size_t ray = 0; ray < count; ++ray)
  {
    ends[layers.Count[ray]] |= std::uint64_t(1) << ray;
  }
  std::array<LayerHit, RayBatch::Capacity> hits;
  std::uint64_t which = canvas.Passing() & ~ends[0];
  for (std::size_t round = 0; which != 0; which &= canvas.Passing() & ~ends[++round])
  {
    LayerList list;
    ForEachRay(which,
      [&](std::size_t ray)
      {
        const std::size_t at = layers.Place[round][ray];
        LayerHit& hit = hits[list.Count];
        // Store members one by one: copying a struct right after its construction waits for all
        // stores.
        hit.Depth = layers.Distance[at];
        hit.Pixel = found.Rays.Pixel[ray];
        hit.Isovalue = layers.Surface[at];
        hit.Kind = layers.Kind[at];
        hit.Cell = layers.Cell[at];
        list.Append(ray, hit, shaded[at]);
      });
    canvas.Add(list);
    for (std::size_t i = 0; i < list.Count; ++i)
    {
      kept.Keep(list.Place[i], hits[i]);
    }
  }
}

void TileCompositor::CompositeAgain(
  std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const
{
  std::vector<LayerHit>& layers = frame.Layers[static_cast<std::size_t>(tile)];
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  PrefetchLayers(layers, 0);
  PixelCentres centres;
  centres.Find(this->Key.View, part);
  LayerCanvas canvas(part, frame);
  const std::uint64_t merged = frame.Behind[static_cast<std::size_t>(tile)].Merged;
  std::uint64_t begun = 0; // pixels with merged layers whose first layer is done
  std::array<ShadedLayer, RayBatch::Capacity> shaded;
  for (std::size_t next = 0; next < layers.size();)
  {
    HitList hits;
    LayerList list;
    for (hits.Rays.Count = 0; next < layers.size() && list.Count < shaded.size(); ++next)
    {
      const std::size_t place = canvas.PlaceOf(layers[next].Pixel);
      const std::uint64_t bit = std::uint64_t(1) << place & merged;
      if ((begun & bit) == 0)
      {
        begun |= bit;
        list.Append(place, layers[next], shaded[list.Count]);
        centres.Append(layers[next], place, hits);
      }
    }
    if (list.Count == 0)
    {
      break; // the rest is merged
    }
    PrefetchLayers(layers, next);
    FindHitRays(this->Key.View, hits);
    this->Shader.Shade(tile, hits, shaded.data());
    canvas.Add(list);
    counts.Layers += static_cast<std::int64_t>(list.Count);
  }
  if (merged != 0)
  {
    this->RecolorMerged(merged, tile, part, centres, canvas, frame, counts);
  }
  canvas.Finish();
  this->Paint(layers, frame);
}

/// For pixels with merged layers, find the layers behind the first layer again, and composite them.
void TileCompositor::RecolorMerged(std::uint64_t merged, std::int64_t tile, const PixelRect& part,
  const PixelCentres& centres, LayerCanvas& canvas, Frame& frame, TraceCounts& counts) const
{
  RecoloredLayers kept(part, frame.Size.x, merged, frame.Layers[static_cast<std::size_t>(tile)]);
  const auto setLast = [&](LayerBatch& next)
  { ForEachRay(merged, [&](std::size_t ray) { next.SetLast(ray, kept.FirstOf(ray)); }); };
  this->AddUnknown(merged, setLast, tile, part, centres, canvas, kept, counts);
  counts.Layers += kept.Total();
  counts.MergedLayers += kept.NumberMerged();
}

/// Paint pixels whose first surface the appearance asks to paint.
/// \param layers of a tile of the frame
void TileCompositor::Paint(const std::vector<LayerHit>& layers, Frame& frame) const
{
  if (this->Key.Appearance.ColorByAnswer && !layers.empty())
  {
    HitList first;
    FindFirstRound(layers, first);
    PaintAnswers(this->Key.Appearance, first, frame);
  }
}

}
