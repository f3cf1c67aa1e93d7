// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerCanvas_h
#define TemporalCoherence_LayerCanvas_h

#include "Scene/Frame.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"

#include <algorithm>
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

/// The pixels of a tile while layers are composited, from front to back with the "over" operator.
/// A pixel's place is that of its ray: row by row.
class LayerCanvas
{
public:
  LayerCanvas(const PixelRect& part, Frame& frame)
    : Part(part)
    , Planes(frame)
  {
    this->Passed.fill(1.0f);
    for (RayBatch::Array<float>& channel : this->Color)
    {
      channel.fill(0.0f);
    }
  }

  std::size_t PlaceOf(std::int32_t pixel) const
  {
    return PlaceInTile(this->Part, this->Planes.Size.x, pixel);
  }

  /// Composite a surface behind the present ones. The first visible surface is written to the
  /// planes. \return the colour of the pixel if no further surface follows
  LayerColor Add(std::size_t place, const LayerHit& hit, const ShadedLayer& layer)
  {
    const auto pixel = static_cast<std::size_t>(hit.Pixel);
    float& passed = this->Passed[place];
    if (layer.Alpha > 0.0f && passed == 1.0f)
    {
      this->Planes.Depth[pixel] = hit.Depth;
      this->Planes.Isovalues[pixel] = hit.Isovalue;
      this->Planes.Normals[pixel] = { layer.Normal[0], layer.Normal[1], layer.Normal[2] };
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Color[c][place] += passed * layer.Alpha * ClampToOne(layer.Color[c]);
    }
    passed = PassedBehind(passed, layer.Alpha);
    return this->ColorAt(place);
  }

  /// The share of light from behind that passes the surfaces of each pixel.
  const RayBatch::Array<float>& Transmittance() const { return this->Passed; }

  /// One bit for each pixel, row by row: light from behind passes its surfaces.
  std::uint64_t Passing() const
  {
    std::uint64_t passing = 0;
    for (std::size_t place = 0;
         place < static_cast<std::size_t>(this->Part.Size.x * this->Part.Size.y); ++place)
    {
      passing |= static_cast<std::uint64_t>(this->Passed[place] > 0.0f) << place;
    }
    return passing;
  }

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
        this->Planes.Colors[pixel] = this->ColorAt(place).Bytes();
        if (this->Passed[place] == 1.0f)
        {
          this->Planes.Depth[pixel] = std::numeric_limits<double>::infinity();
          this->Planes.Isovalues[pixel] = Frame::NoSurface;
          this->Planes.Normals[pixel] = glm::vec3(0.0f);
        }
      }
    }
  }

private:
  /// NaN becomes 0.
  static float ClampToOne(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

  static std::uint16_t ValueOf(float value)
  {
    constexpr auto steps = static_cast<float>(LayerColor::Steps);
    constexpr auto half = static_cast<float>(LayerColor::Half);
    return static_cast<std::uint16_t>(ClampToOne(value) * steps + half);
  }

  LayerColor ColorAt(std::size_t place) const
  {
    return { { ValueOf(this->Color[0][place]), ValueOf(this->Color[1][place]),
      ValueOf(this->Color[2][place]), ValueOf(1.0f - this->Passed[place]) } };
  }

  PixelRect Part;
  Frame& Planes;
  std::array<RayBatch::Array<float>, 3> Color;
  RayBatch::Array<float> Passed;
};

}

#endif
