// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Frame_h
#define TemporalCoherence_Frame_h

#include "Scene/DefaultInitAllocator.h"
#include "Scene/Tiles.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// What is known about a ray before it is traced; afterwards, how it was answered.
enum class Answer : std::uint8_t
{
  DefiniteMiss, ///< known to meet nothing: not traced
  DefiniteHit,  ///< the hit was known: not traced
  PossibleHit   ///< traced through the field
};

/// How a ray meets the surface that it hits.
enum class HitKind : std::uint8_t
{
  None,
  Entry, ///< the field rises to the isovalue: the ray comes from outside
  Exit,  ///< the field falls below the isovalue: the ray comes from inside
  Cap, ///< the ray begins in a THRESHOLD solid, or leaves hidden cells in it: the solid is clipped
       ///< there
  Within ///< no hit; the ray is inside where it first enters an active cell
};

/// The colour of composited layers: premultiplied RGBA. It has more bits than a colour of a
/// picture, so that the layers can be told apart again.
struct LayerColor
{
  /// Steps of the finest colour: 256 for each step of a byte.
  static constexpr int Steps = 255 * 256;
  /// Half a step of a byte is added to each value: its high byte is then the rounded colour.
  static constexpr std::uint16_t Half = 128;

  std::array<std::uint16_t, 4> Values{ Half, Half, Half, Half };

  /// The rounded colour.
  std::array<std::uint8_t, 4> Bytes() const
  {
    const auto high = [](std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); };
    return { high(this->Values[0]), high(this->Values[1]), high(this->Values[2]),
      high(this->Values[3]) };
  }
  bool operator==(const LayerColor& other) const { return this->Values == other.Values; }
};

/// The number of a cell of a mesh, for hits in such fields. NoCell: the field is no mesh, or the
/// cell is not known.
using CellNumber = std::uint32_t;
constexpr CellNumber NoCell = ~CellNumber(0);

/// A surface that a ray meets, opaque or translucent.
struct LayerHit
{
  double Depth;       ///< t
  std::int32_t Pixel; ///< position in the planes
  std::int16_t Isovalue;
  HitKind Kind;
  /// The composited colour of all layers in front of the next one that is kept. That of the last
  /// one kept is the pixel's colour.
  LayerColor Color{};
  CellNumber Cell = NoCell;
};

/// How many layers of a pixel a frame keeps. Light that passes so many is either faint or meets a
/// haze, in which no single layer can be told from the next one.
constexpr std::size_t MostKeptLayers = 32;

/// What is known about the layers of a tile besides those that are kept as they are composited.
struct LayersBehind
{
  /// Layers that no light reaches, those of a pixel from front to back. They have no colours.
  std::vector<LayerHit> Hits;
  /// One bit for each pixel of the tile, row by row: behind its last known layer there is none.
  std::uint64_t Ends = 0;
  /// One bit for each pixel of the tile, row by row: it has more layers than are kept. Each of
  /// those kept stands for itself and for all in front of the next one. What lies behind the first
  /// one is not known.
  std::uint64_t Merged = 0;
};

/// One value for each pixel.
template <typename T>
using Plane = std::vector<T, DefaultInitAllocator<T>>;

/// Planes that not all pictures need.
struct FrameExtras
{
  bool Disparities = false;  ///< views made from the picture need them
  bool FirstEntries = false; ///< the same
  bool Cells = false;        ///< the field is a mesh
  std::size_t Met = 0;       ///< numbers for each ray of a projection
};

/// A finished picture: planes with one value for each pixel. Row 0 is the bottom row; pixel (x, y)
/// is at [y * Size.x + x].
struct Frame
{
  static constexpr std::int16_t NoSurface = -1;

  glm::ivec2 Size{ 0 };
  Plane<double> Depth;           ///< t of the hit: world distance along the ray; or infinity
  Plane<glm::vec3> Normals;      ///< unit normal in the world, facing the viewer; or 0
  Plane<std::int16_t> Isovalues; ///< position of the hit isovalue in the list; or NoSurface
  Plane<HitKind> Kinds;
  Plane<Answer> Answers;
  Plane<std::array<std::uint8_t, 4>> Colors; ///< premultiplied RGBA; 0 where nothing is hit
  bool IsFromCache = false;                  ///< answers are those of a cached image

  // FrameExtras: each is empty if no view will need it.
  Plane<float> Disparities;  ///< of the hit, or of a miss (Disparity.h)
  Plane<float> FirstEntries; ///< disparity at which the ray first entered an active cell
  Plane<CellNumber> Cells;   ///< in which the surface is hit

  /// If surfaces are translucent, all layers of each tile: round by round from front to back, and
  /// by pixel within a round. Of a pixel with more than LayersOfPixel layers, every second one is
  /// kept, or every fourth, and so on. Empty if surfaces are opaque. Colors holds the composite of
  /// all layers; depth, normal and isovalue are those of the first.
  std::vector<std::vector<LayerHit>> Layers;

  /// For each tile, which pixels have merged layers, and what a picture with other opacities may
  /// need. The latter is no part of the picture. Empty if nothing is known.
  std::vector<LayersBehind> Behind;

  /// The most layers that are kept of a pixel: a power of two.
  std::size_t LayersOfPixel = MostKeptLayers;

  /// What the rays of a projection have met, so that other colours need no search: for each tile
  /// that is not clear, arrays over its rays, one after the other. No part of the picture. Empty if
  /// nothing is kept.
  Plane<double> Met;
  glm::dvec2 MetWithin{ 0.0 }; ///< extremes that are kept; those of other rays lie beyond

  /// 1 for each tile whose planes are known to hold definite misses only. Such a tile is neither
  /// read nor written again.
  std::vector<std::uint8_t> ClearTiles;

  /// The list of planes. Calls visit(plane, miss) for each, also those that are empty: a pointer to
  /// the member, and its value where nothing is hit.
  /// \param disparityOfMiss in the frame's projection
  template <typename Visit>
  static void ForEachPlane(float disparityOfMiss, const Visit& visit)
  {
    visit(&Frame::Depth, std::numeric_limits<double>::infinity());
    visit(&Frame::Normals, glm::vec3(0.0f));
    visit(&Frame::Isovalues, NoSurface);
    visit(&Frame::Kinds, HitKind::None);
    visit(&Frame::Answers, Answer::DefiniteMiss);
    visit(&Frame::Colors, std::array<std::uint8_t, 4>{ 0, 0, 0, 0 });
    visit(&Frame::Disparities, disparityOfMiss);
    visit(&Frame::FirstEntries, disparityOfMiss);
    visit(&Frame::Cells, NoCell);
  }

  /// Resize every plane to `size` pixels. Contents are undefined if that changes anything.
  /// \throws std::bad_alloc; the frame is then empty
  void Resize(const glm::ivec2& size, const FrameExtras& extras = {})
  {
    const auto tiles = static_cast<std::size_t>(NumberOfTiles(size));
    const std::size_t met = tiles * TileSize * TileSize * extras.Met;
    if (size == this->Size && extras.Disparities == !this->Disparities.empty() &&
      extras.FirstEntries == !this->FirstEntries.empty() && extras.Cells == !this->Cells.empty() &&
      met == this->Met.size())
    {
      return;
    }
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    this->Size = glm::ivec2(0);
    ForEachPlane(0.0f,
      [&](auto plane, const auto&)
      {
        if (IsWanted(plane, extras))
        {
          (this->*plane).resize(pixels);
        }
        else
        {
          (this->*plane) = {};
        }
      });
    Plane<double>(met).swap(this->Met);
    this->ClearTiles.assign(tiles, 0);
    this->Size = size;
  }

  bool IsEmpty() const { return this->Size.x == 0; }

private:
  template <typename T>
  static bool IsWanted(Plane<T> Frame::*, const FrameExtras&)
  {
    return true;
  }
  static bool IsWanted(Plane<CellNumber> Frame::*, const FrameExtras& extras)
  {
    return extras.Cells;
  }
  static bool IsWanted(Plane<float> Frame::*plane, const FrameExtras& extras)
  {
    return plane == &Frame::Disparities ? extras.Disparities : extras.FirstEntries;
  }
};

}

#endif
