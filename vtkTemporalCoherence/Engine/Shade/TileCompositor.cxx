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
  hits.Rays.X[at] = centre.x;
  hits.Rays.Y[at] = centre.y;
  hits.Rays.T[at] = hit.Depth;
}

/// Opacities of isovalues, as they are composited. Empty if only shading tells them.
std::vector<float> AlphasOf(const Surfaces& surfaces)
{
  return surfaces.ByGradient.Nodes.empty()
    ? std::vector<float>(surfaces.Opacities.begin(), surfaces.Opacities.end())
    : std::vector<float>();
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

/// The rays of a tile, and where their pixels are.
struct TileCompositor::TileRays
{
  RayBatch Rays;
  WorldDirections World;
  Array<double> X, Y; ///< normalised device coordinates
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

/// The rays of a tile.
void TileCompositor::SetUp(std::int64_t tile, const PixelRect& part, TileRays& rays) const
{
  this->Rays.SetUp(part.First, part.Size, rays.Rays, &rays.World);
  if (this->Bounds)
  {
    this->Bounds->Narrow(tile, rays.Rays);
  }
  std::size_t ray = 0;
  for (int y = 0; y < part.Size.y; ++y)
  {
    for (int x = 0; x < part.Size.x; ++x, ++ray)
    {
      const glm::dvec2 centre = this->Key.View.PixelCentre(part.First.x + x, part.First.y + y);
      rays.X[ray] = centre.x;
      rays.Y[ray] = centre.y;
    }
  }
}

/// Begin with the first hits of a tile. Where only shading tells which surfaces are opaque, it
/// looks for few surfaces first.
void TileCompositor::TakeFirst(const RayBatch& rays, const Frame& frame, LayerBatch& layers) const
{
  layers.Begin(static_cast<std::size_t>(rays.Count));
  layers.Alphas = this->Alphas.empty() ? nullptr : this->Alphas.data();
  layers.Limit = layers.Alphas ? LayerBatch::MostLayers : 1;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
    if (frame.Isovalues[pixel] != Frame::NoSurface)
    {
      layers.Append(ray, frame.Depth[pixel], frame.Kinds[pixel], frame.Isovalues[pixel]);
    }
    else
    {
      layers.Close(ray);
    }
  }
}

void TileCompositor::Composite(
  std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const
{
  std::vector<LayerHit>& kept = frame.Layers[static_cast<std::size_t>(tile)];
  kept.clear();
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  TileRays rays;
  this->SetUp(tile, part, rays);
  LayerBatch layers;
  this->TakeFirst(rays.Rays, frame, layers);
  LayerCanvas canvas(part, frame);
  const auto count = static_cast<std::size_t>(rays.Rays.Count);
  do
  {
    this->FindLayers(rays.Rays, layers);
    counts.CellsRead += layers.CellsRead;
    this->AddLayers(rays, layers, canvas, kept);
  } while (layers.BeginNext(count, canvas.Transmittance()));
  counts.Layers += static_cast<std::int64_t>(kept.size());
  canvas.Finish();
  this->Paint(kept, frame);
}

/// Find the next surfaces of each ray within the region.
void TileCompositor::FindLayers(const RayBatch& rays, LayerBatch& layers) const
{
  if (!this->Rays.Clipper.HasPieces())
  {
    this->Tracer->FindLayers(rays, layers);
    return;
  }
  FindLayersInPieces(this->Rays.Clipper, rays, layers,
    [this](const RayBatch& part, LayerBatch& found) { this->Tracer->FindLayers(part, found); });
}

/// Shade surfaces, composite them behind the present ones, and keep them: round by round, and by
/// pixel within a round.
void TileCompositor::AddLayers(const TileRays& rays, const LayerBatch& layers, LayerCanvas& canvas,
  std::vector<LayerHit>& kept) const
{
  LayerBatch::List<ShadedLayer> shaded;
  for (std::size_t first = 0; first < layers.Total; first += RayBatch::Capacity)
  {
    HitList hits;
    this->TakeHits(rays, layers, first, hits);
    this->Shade(hits, shaded.data() + first);
  }
  const auto count = static_cast<std::size_t>(rays.Rays.Count);
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
        LayerHit hit{ layers.Distance[at], rays.Rays.Pixel[ray], layers.Surface[at],
          layers.Kind[at] };
        hit.Color = canvas.Add(ray, hit, shaded[at]);
        kept.push_back(hit);
      });
  }
}

/// Some surfaces, in the order in which they were found: so those in one cell lie together.
void TileCompositor::TakeHits(
  const TileRays& rays, const LayerBatch& layers, std::size_t first, HitList& hits) const
{
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
  take(rays.Rays.Pixel, hits.Pixel);
  if (this->Key.View.Parallel)
  {
    take(rays.X, hits.Rays.X);
    take(rays.Y, hits.Rays.Y);
    FindHitPoints(this->Key.View, hits);
    return;
  }
  WorldDirections directions;
  for (std::size_t a = 0; a < 3; ++a)
  {
    take(rays.World[a], directions[a]);
    FillLastVector(count, directions[a]);
  }
  FillLastVector(count, hits.Rays.T);
  ShadingKernels::FindPointsFrom(this->Key.View.Origin, directions, hits.Rays.T, hits.Rays);
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
    FindHitPoints(this->Key.View, hits);
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
