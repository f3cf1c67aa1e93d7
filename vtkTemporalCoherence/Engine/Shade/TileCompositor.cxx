// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/TileCompositor.h"

#include "Trace/RayPieces.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

template <typename T>
using Array = RayBatch::Array<T>;

/// A lower transmittance is taken as opaque: half a step of a colour.
constexpr float Opaque = 1.0f / 512.0f;

/// NaN becomes 0.
float ClampToOne(float value)
{
  return value > 0.0f ? std::min(value, 1.0f) : 0.0f;
}

std::uint8_t RoundToByte(float value)
{
  return static_cast<std::uint8_t>(ClampToOne(value) * 255.0f + 0.5f);
}

/// Append a surface to a layer.
void AppendHit(const LayerHit& hit, const Frame& frame, const View& view, HitList& layer)
{
  const std::size_t at = layer.Rays.Count++;
  const glm::dvec2 centre = view.PixelCentre(hit.Pixel % frame.Size.x, hit.Pixel / frame.Size.x);
  layer.Pixel[at] = hit.Pixel;
  layer.Surface[at] = hit.Isovalue;
  layer.Kind[at] = hit.Kind;
  layer.Rays.X[at] = centre.x;
  layer.Rays.Y[at] = centre.y;
  layer.Rays.T[at] = hit.Depth;
}

/// Append the hit of a ray of one batch to another.
void AppendHit(const HitBatch& from, std::size_t ray, std::size_t at, HitBatch& to)
{
  to.Depth[at] = from.Depth[ray];
  to.Surface[at] = from.Surface[ray];
  to.Kind[at] = from.Kind[ray];
}

}

/// The pixels of a tile while layers are composited.
class TileCompositor::Canvas
{
public:
  Canvas(const PixelRect& part, Frame& frame)
    : Part(part)
    , Planes(frame)
  {
    this->Transmittance.fill(1.0f);
    for (Array<float>& channel : this->Color)
    {
      channel.fill(0.0f);
    }
  }

  const Frame& Picture() const { return this->Planes; }

  /// Composite a surface behind the present ones. The first visible surface is written to the
  /// planes.
  void Add(const HitList& layer, std::size_t i, const std::array<float, 3>& color, float alpha)
  {
    const std::size_t at = this->PlaceOf(layer.Pixel[i]);
    const auto pixel = static_cast<std::size_t>(layer.Pixel[i]);
    if (alpha > 0.0f && this->Transmittance[at] == 1.0f)
    {
      this->Planes.Depth[pixel] = layer.Rays.T[i];
      this->Planes.Isovalues[pixel] = layer.Surface[i];
      this->Planes.Normals[pixel] = { layer.Normal[i][0], layer.Normal[i][1], layer.Normal[i][2] };
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Color[c][at] += this->Transmittance[at] * alpha * ClampToOne(color[c]);
    }
    this->Transmittance[at] *= 1.0f - alpha;
    this->Transmittance[at] = this->Transmittance[at] <= Opaque ? 0.0f : this->Transmittance[at];
  }

  /// True if something behind a pixel's surfaces would be visible.
  bool IsTranslucent(std::int32_t pixel) const
  {
    return this->Transmittance[this->PlaceOf(pixel)] > 0.0f;
  }

  /// The colour of a pixel if no further surface follows.
  std::array<std::uint8_t, 4> ColorOf(std::int32_t pixel) const
  {
    const std::size_t at = this->PlaceOf(pixel);
    return { RoundToByte(this->Color[0][at]), RoundToByte(this->Color[1][at]),
      RoundToByte(this->Color[2][at]), RoundToByte(1.0f - this->Transmittance[at]) };
  }

  /// Write colours. A pixel whose surfaces are all invisible becomes a miss.
  void Finish()
  {
    for (int y = 0; y < this->Part.Size.y; ++y)
    {
      for (int x = 0; x < this->Part.Size.x; ++x)
      {
        const glm::ivec2 place = this->Part.First + glm::ivec2(x, y);
        const std::int32_t pixel = place.y * this->Planes.Size.x + place.x;
        this->Planes.Colors[static_cast<std::size_t>(pixel)] = this->ColorOf(pixel);
        if (this->Transmittance[this->PlaceOf(pixel)] == 1.0f)
        {
          this->Planes.Depth[static_cast<std::size_t>(pixel)] =
            std::numeric_limits<double>::infinity();
          this->Planes.Isovalues[static_cast<std::size_t>(pixel)] = Frame::NoSurface;
          this->Planes.Normals[static_cast<std::size_t>(pixel)] = glm::vec3(0.0f);
        }
      }
    }
  }

private:
  std::size_t PlaceOf(std::int32_t pixel) const
  {
    const int x = pixel % this->Planes.Size.x - this->Part.First.x;
    const int y = pixel / this->Planes.Size.x - this->Part.First.y;
    return static_cast<std::size_t>(y * TileSize + x);
  }

  PixelRect Part;
  Frame& Planes;
  std::array<Array<float>, 3> Color;
  Array<float> Transmittance; ///< the share of light from behind that passes
};

TileCompositor::TileCompositor(
  const FrameKey& key, const NormalSource& source, const LeapedSpace& space)
  : Key(key)
  , Source(source)
  , Bounds(space.Active ? space.Bounds : nullptr)
  , Rays(key.View, key.Transform, key.Samples.Dimensions, key.Region)
  , Tracer(SurfaceTracer::Make({ key.Samples, key.Isosurfaces, source.FiniteRange, space.Active }))
{
}

/// The rays of a tile and their first hits.
void TileCompositor::SetUp(std::int64_t tile, const PixelRect& part, const Frame& frame,
  RayBatch& rays, HitBatch& hits) const
{
  this->Rays.SetUp(part.First, part.Size, rays);
  if (this->Bounds)
  {
    this->Bounds->Narrow(tile, rays);
  }
  hits.Clear(rays.Count);
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
    if (frame.Isovalues[pixel] != Frame::NoSurface)
    {
      hits.Depth[ray] = frame.Depth[pixel];
      hits.Surface[ray] = frame.Isovalues[pixel];
      hits.Kind[ray] = frame.Kinds[pixel];
    }
  }
}

void TileCompositor::Composite(
  std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const
{
  std::vector<LayerHit>& layers = frame.Layers[static_cast<std::size_t>(tile)];
  layers.clear();
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  RayBatch rays;
  HitBatch hits;
  this->SetUp(tile, part, frame, rays, hits);
  Canvas canvas(part, frame);
  HitList first;
  for (bool isFirst = true; rays.Count > 0; isFirst = false)
  {
    HitList layer;
    layer.Rays.Count = 0;
    const auto count = static_cast<std::size_t>(rays.Count);
    const std::size_t begin = layers.size();
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      if (hits.Surface[ray] != Frame::NoSurface)
      {
        layers.push_back({ hits.Depth[ray], rays.Pixel[ray], hits.Surface[ray], hits.Kind[ray] });
        AppendHit(layers.back(), frame, this->Key.View, layer);
      }
    }
    this->AddLayer(layer, layers.data() + begin, canvas);
    if (isFirst)
    {
      first = layer;
    }
    // Go on with pixels that are still translucent.
    RayBatch translucent;
    HitBatch last;
    last.CellsRead = 0;
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      if (hits.Surface[ray] != Frame::NoSurface && canvas.IsTranslucent(rays.Pixel[ray]))
      {
        AppendHit(hits, ray, static_cast<std::size_t>(translucent.Count), last);
        AppendRay(rays, ray, translucent);
      }
    }
    rays = translucent;
    hits = last;
    this->FindNext(rays, hits);
    counts.CellsRead += hits.CellsRead;
  }
  canvas.Finish();
  PaintAnswers(this->Key.Appearance, first, frame);
}

void TileCompositor::CompositeAgain(std::int64_t tile, const PixelRect& part, Frame& frame) const
{
  std::vector<LayerHit>& layers = frame.Layers[static_cast<std::size_t>(tile)];
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  Canvas canvas(part, frame);
  HitList first;
  first.Rays.Count = 0;
  for (std::size_t begin = 0; begin < layers.size();)
  {
    // A new round begins where pixel numbers stop ascending.
    HitList layer;
    layer.Rays.Count = 0;
    std::size_t i = begin;
    for (; i < layers.size() && (i == begin || layers[i].Pixel > layers[i - 1].Pixel); ++i)
    {
      AppendHit(layers[i], frame, this->Key.View, layer);
    }
    this->AddLayer(layer, &layers[begin], canvas);
    if (begin == 0)
    {
      first = layer;
    }
    begin = i;
  }
  canvas.Finish();
  PaintAnswers(this->Key.Appearance, first, frame);
}

/// Shade a layer and composite it behind the present ones. \param hits the same layer as the frame
/// stores it
void TileCompositor::AddLayer(HitList& layer, LayerHit* hits, Canvas& canvas) const
{
  if (layer.Rays.Count == 0)
  {
    return;
  }
  FindHitPoints(this->Key.View, layer);
  std::array<Array<double>, 3> gradients;
  ComputeNormals(this->Source, layer, &gradients);
  ShadingKernels::PhongSums sums;
  SumLight(this->Key.Appearance, layer, sums);
  const Surfaces& surfaces = this->Key.Isosurfaces;
  for (std::size_t i = 0; i < layer.Rays.Count; ++i)
  {
    double alpha = surfaces.Opacities.empty()
      ? 1.0
      : surfaces.Opacities[static_cast<std::size_t>(layer.Surface[i])];
    if (!surfaces.ByGradient.Nodes.empty())
    {
      const glm::dvec3 gradient(gradients[0][i], gradients[1][i], gradients[2][i]);
      alpha *= surfaces.ByGradient.At(glm::length(gradient * surfaces.ByGradient.PerStep));
    }
    canvas.Add(
      layer, i, { sums.Sum[0][i], sums.Sum[1][i], sums.Sum[2][i] }, static_cast<float>(alpha));
    hits[i].Color = canvas.ColorOf(layer.Pixel[i]);
  }
}

/// Find the next surface of each ray within the region.
void TileCompositor::FindNext(const RayBatch& rays, HitBatch& hits) const
{
  if (!this->Rays.Clipper.HasPieces())
  {
    this->Tracer->FindNext(rays, hits);
    return;
  }
  FindInPieces(this->Rays.Clipper, rays, hits,
    [this](const RayBatch& part, HitBatch& found) { this->Tracer->FindNext(part, found); });
}

}
