// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerCanvas_h
#define TemporalCoherence_LayerCanvas_h

#include "Scene/Frame.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"
#include "Shade/KernelsShading.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// A surface as it is composited.
struct ShadedLayer
{
  std::array<float, 3> Color, Normal;
  float Alpha;
};

/// Surfaces that are composited together, from front to back within each pixel.
struct LayerList
{
  std::size_t Count = 0;
  RayBatch::Array<std::size_t> Place; ///< of the pixel
  RayBatch::Array<LayerHit*> Hit;
  RayBatch::Array<const ShadedLayer*> Shaded;

  void Append(std::size_t place, LayerHit& hit, const ShadedLayer& shaded)
  {
    const std::size_t at = this->Count++;
    this->Place[at] = place;
    this->Hit[at] = &hit;
    this->Shaded[at] = &shaded;
  }
};

/// The pixels of a tile while layers are composited, from front to back with the "over" operator.
/// Pixels have the places of their rays: row by row.
class LayerCanvas
{
public:
  LayerCanvas(const PixelRect& part, Frame& frame)
    : Part(part)
    , Planes(frame)
    , Places(part, frame.Size.x)
  {
    this->Pixels.Passed.fill(1.0f);
    for (RayBatch::Array<float>& channel : this->Pixels.Sum)
    {
      channel.fill(0.0f);
    }
    this->Pixels.Colors.fill({});
    this->Pixels.Passing = ~std::uint64_t(0) >> (RayBatch::Capacity - part.Size.x * part.Size.y);
  }

  std::size_t PlaceOf(std::int32_t pixel) const { return this->Places.Find(pixel); }

  /// Composite surfaces behind the present ones. Each hit gets the colour of its pixel, composited
  /// up to this surface. The first visible surface of a pixel is written to the planes.
  /// \return one bit for each surface that light reaches; other surfaces are left out
  std::uint64_t Add(const LayerList& layers)
  {
    std::uint64_t reached = 0;
    for (std::size_t begin = 0, end = 0; begin < layers.Count; begin = end)
    {
      // The longest run that contains each pixel at most once.
      for (; end < layers.Count && (this->Round.Which >> layers.Place[end] & 1u) == 0; ++end)
      {
        if (this->Pixels.Passed[layers.Place[end]] > 0.0f)
        {
          this->Put(layers, end);
          reached |= std::uint64_t(1) << end;
        }
      }
      ShadingKernels::CompositeRound(this->Round, this->Pixels);
      for (std::size_t i = begin; i < end; ++i)
      {
        if ((reached >> i & 1u) != 0)
        {
          layers.Hit[i]->Color = this->Pixels.Colors[layers.Place[i]];
        }
      }
      this->Round.Which = 0;
      this->Round.Alpha.fill(0.0f);
    }
    return reached;
  }

  /// The share of light from behind that passes the surfaces of each pixel.
  const RayBatch::Array<float>& Transmittance() const { return this->Pixels.Passed; }

  /// One bit for each pixel, row by row: light from behind passes its surfaces.
  std::uint64_t Passing() const { return this->Pixels.Passing; }

  /// Write colours. A pixel whose surfaces are all invisible becomes a miss.
  void Finish()
  {
    std::size_t place = 0;
    for (int y = 0; y < this->Part.Size.y; ++y)
    {
      const int first = (this->Part.First.y + y) * this->Planes.Size.x + this->Part.First.x;
      for (int x = 0; x < this->Part.Size.x; ++x, ++place)
      {
        const auto pixel = static_cast<std::size_t>(first + x);
        this->Planes.Colors[pixel] = this->Pixels.Colors[place].Bytes();
        if (this->Pixels.Passed[place] == 1.0f)
        {
          this->Planes.Depth[pixel] = std::numeric_limits<double>::infinity();
          this->Planes.Isovalues[pixel] = Frame::NoSurface;
          this->Planes.Normals[pixel] = glm::vec3(0.0f);
        }
      }
    }
  }

private:
  /// Put a surface into the next round.
  void Put(const LayerList& layers, std::size_t i)
  {
    const ShadedLayer& layer = *layers.Shaded[i];
    const std::size_t place = layers.Place[i];
    if (layer.Alpha > 0.0f && this->Pixels.Passed[place] == 1.0f)
    {
      const LayerHit& hit = *layers.Hit[i];
      const auto pixel = static_cast<std::size_t>(hit.Pixel);
      this->Planes.Depth[pixel] = hit.Depth;
      this->Planes.Isovalues[pixel] = hit.Isovalue;
      this->Planes.Normals[pixel] = { layer.Normal[0], layer.Normal[1], layer.Normal[2] };
      if (!this->Planes.Cells.empty())
      {
        this->Planes.Cells[pixel] = hit.Cell;
      }
    }
    this->Round.Which |= std::uint64_t(1) << place;
    this->Round.Alpha[place] = layer.Alpha;
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Round.Color[c][place] = layer.Color[c];
    }
  }

  PixelRect Part;
  Frame& Planes;
  PlaceFinder Places;
  ShadingKernels::CompositedPixels Pixels;
  ShadingKernels::LayerRound Round;
};

}

#endif
