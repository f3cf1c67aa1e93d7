// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/TileCompositor.h"

#include "Shade/LayerCanvas.h"
#include "Trace/RayPieces.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

template <typename T>
using Array = RayBatch::Array<T>;

/// Append a surface to those that are shaded next.
void AppendHit(const LayerHit& hit, const Frame& frame, const View& view, HitList& hits)
{
  const std::size_t at = hits.Rays.Count++;
  const glm::dvec2 centre = view.PixelCentre(hit.Pixel % frame.Size.x, hit.Pixel / frame.Size.x);
  hits.Pixel[at] = hit.Pixel;
  hits.Surface[at] = hit.Isovalue;
  hits.Kind[at] = hit.Kind;
  hits.X[at] = centre.x;
  hits.Y[at] = centre.y;
  hits.Rays.T[at] = hit.Depth;
}

/// The pixels of the first of some layers that are kept round by round.
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

/// Normalised device coordinates of the pixels of a tile, for rays that do not begin at one point.
struct TileCompositor::PixelCentres
{
  PixelCentres(const View& view, const PixelRect& part)
  {
    std::size_t place = 0;
    for (int y = 0; y < part.Size.y && view.Parallel; ++y)
    {
      for (int x = 0; x < part.Size.x; ++x, ++place)
      {
        const glm::dvec2 centre = view.PixelCentre(part.First.x + x, part.First.y + y);
        this->X[place] = centre.x;
        this->Y[place] = centre.y;
      }
    }
  }

  Array<double> X, Y;
};

TileCompositor::TileCompositor(
  const FrameKey& key, const NormalSource& source, const LeapedSpace& space)
  : Key(key)
  , Source(source)
  , Bounds(space.Active ? space.Bounds : nullptr)
  , Rays(key.View, key.Transform, key.Samples.Dimensions, key.Region)
  , Tracer(SurfaceTracer::Make({ key.Samples, key.Isosurfaces, source.FiniteRange, space.Active }))
  , Alphas(AlphasOf(key.Isosurfaces))
{
}

/// Set up the rays of a tile, and take their first hits from the planes.
void TileCompositor::SetUp(
  std::int64_t tile, const PixelRect& part, const Frame& frame, TileHits& found) const
{
  this->Rays.SetUp(part.First, part.Size, found.Rays, &found.World);
  if (this->Bounds)
  {
    this->Bounds->Narrow(tile, found.Rays);
  }
  const auto count = static_cast<std::size_t>(found.Rays.Count);
  found.Layers.Begin(count, this->Alphas);
  for (std::size_t ray = 0; ray < count; ++ray)
  {
    const auto pixel = static_cast<std::size_t>(found.Rays.Pixel[ray]);
    if (frame.Isovalues[pixel] != Frame::NoSurface)
    {
      found.Layers.Append(ray, frame.Depth[pixel], frame.Kinds[pixel], frame.Isovalues[pixel]);
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
  std::vector<LayerHit>& kept = frame.Layers[static_cast<std::size_t>(tile)];
  kept.clear();
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  TileHits fromPlanes;
  if (!found || !found->HasLayers)
  {
    found = &fromPlanes;
    this->SetUp(tile, part, frame, *found);
    counts.CellsRead += found->Layers.CellsRead;
  }
  const PixelCentres centres(this->Key.View, part);
  LayerCanvas canvas(part, frame);
  this->AddLayers(*found, centres, canvas, kept);
  while (
    found->Layers.BeginNext(static_cast<std::size_t>(found->Rays.Count), canvas.Transmittance()))
  {
    FindLayersWithin(this->Rays.Clipper, *this->Tracer, found->Rays, found->Layers);
    counts.CellsRead += found->Layers.CellsRead;
    this->AddLayers(*found, centres, canvas, kept);
  }
  counts.Layers += static_cast<std::int64_t>(kept.size());
  canvas.Finish();
  this->Paint(kept, frame);
}

/// Shade surfaces, composite them behind the present ones, and keep them: round by round, and by
/// pixel within a round.
void TileCompositor::AddLayers(const TileHits& found, const PixelCentres& centres,
  LayerCanvas& canvas, std::vector<LayerHit>& kept) const
{
  const LayerBatch& layers = found.Layers;
  LayerBatch::List<ShadedLayer> shaded;
  for (std::size_t first = 0; first < layers.Total; first += RayBatch::Capacity)
  {
    HitList hits;
    this->TakeHits(found, centres, first, hits);
    this->Shade(hits, shaded.data() + first);
  }
  const auto count = static_cast<std::size_t>(found.Rays.Count);
  std::uint64_t which = ~std::uint64_t(0) >> (RayBatch::Capacity - count);
  for (std::size_t round = 0; which != 0; ++round)
  {
    ForEachRay(which,
      [&](std::size_t ray)
      {
        if (round == layers.Count[ray] || canvas.Transmittance()[ray] == 0.0f)
        {
          which &= ~(std::uint64_t(1) << ray);
          return;
        }
        const std::size_t at = layers.Place[round][ray];
        LayerHit hit{ layers.Distance[at], found.Rays.Pixel[ray], layers.Surface[at],
          layers.Kind[at] };
        hit.Color = canvas.Add(ray, hit, shaded[at]);
        kept.push_back(hit);
      });
  }
}

/// Some surfaces, in the order in which they were found: so those in one cell lie together.
void TileCompositor::TakeHits(
  const TileHits& found, const PixelCentres& centres, std::size_t first, HitList& hits) const
{
  const LayerBatch& layers = found.Layers;
  const std::size_t count =
    std::min(layers.Total - first, static_cast<std::size_t>(RayBatch::Capacity));
  hits.Rays.Count = count;
  std::copy_n(layers.Surface.begin() + first, count, hits.Surface.begin());
  std::copy_n(layers.Kind.begin() + first, count, hits.Kind.begin());
  std::copy_n(layers.Distance.begin() + first, count, hits.Rays.T.begin());
  const auto take = [&](const auto& from, auto& to)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i] = from[layers.Ray[first + i]];
    }
  };
  take(found.Rays.Pixel, hits.Pixel);
  if (this->Key.View.Parallel)
  {
    take(centres.X, hits.X);
    take(centres.Y, hits.Y);
    FindHitRays(this->Key.View, hits);
    return;
  }
  hits.Rays.Eye = this->Key.View.Origin;
  for (std::size_t a = 0; a < 3; ++a)
  {
    take(found.World[a], hits.Rays.Own[a]);
    FillLastVector(count, hits.Rays.Own[a]);
  }
  FillLastVector(count, hits.Rays.T);
}

void TileCompositor::CompositeAgain(std::int64_t tile, const PixelRect& part, Frame& frame) const
{
  std::vector<LayerHit>& layers = frame.Layers[static_cast<std::size_t>(tile)];
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  LayerCanvas canvas(part, frame);
  std::array<ShadedLayer, RayBatch::Capacity> shaded;
  for (std::size_t begin = 0; begin < layers.size(); begin += shaded.size())
  {
    const std::size_t end = std::min(begin + shaded.size(), layers.size());
    HitList hits;
    hits.Rays.Count = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      AppendHit(layers[i], frame, this->Key.View, hits);
    }
    FindHitRays(this->Key.View, hits);
    this->Shade(hits, shaded.data());
    for (std::size_t i = begin; i < end; ++i)
    {
      layers[i].Color = canvas.Add(canvas.PlaceOf(layers[i].Pixel), layers[i], shaded[i - begin]);
    }
  }
  canvas.Finish();
  this->Paint(layers, frame);
}

/// Find normals, colours and opacities of surfaces whose points are known.
void TileCompositor::Shade(HitList& hits, ShadedLayer* shaded) const
{
  const Surfaces& surfaces = this->Key.Isosurfaces;
  const GradientOpacity& byGradient = surfaces.ByGradient;
  std::array<Array<double>, 3> gradients;
  ComputeNormals(this->Source, hits, byGradient.Nodes.empty() ? nullptr : &gradients);
  ShadingKernels::PhongSums sums;
  SumLight(this->Key.Appearance, hits, sums);
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    double alpha = surfaces.Opacities.empty()
      ? 1.0
      : surfaces.Opacities[static_cast<std::size_t>(hits.Surface[i])];
    if (!byGradient.Nodes.empty())
    {
      const glm::dvec3 gradient(gradients[0][i], gradients[1][i], gradients[2][i]);
      alpha *= byGradient.At(glm::length(gradient * byGradient.PerStep));
    }
    shaded[i] = { { sums.Sum[0][i], sums.Sum[1][i], sums.Sum[2][i] }, hits.Normal[i],
      static_cast<float>(alpha) };
  }
}

/// Paint pixels whose first surface the appearance asks to paint.
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
