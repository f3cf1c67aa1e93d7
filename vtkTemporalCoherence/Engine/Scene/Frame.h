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

/// Knowledge about a ray: a prediction before the trace, the outcome afterwards.
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
  Cap ///< the ray begins in a THRESHOLD solid, or leaves hidden cells in it: the solid is clipped
      ///< there
};

/// The colour of composited layers: premultiplied RGBA. It has 16 bits a channel, so that the
/// colours of single layers can be computed from it.
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

/// The position of a surface in the list of isovalues or of drawn labels; Frame::NoSurface for
/// none.
using SurfaceIndex = std::int32_t;

/// The number of a cell of a mesh, for hits in such fields. NoCell: the field is no mesh, or the
/// cell is not known.
using CellNumber = std::uint32_t;
constexpr CellNumber NoCell = ~CellNumber(0);

/// A surface that a ray meets, opaque or translucent.
struct LayerHit
{
  double Depth;       ///< t
  std::int32_t Pixel; ///< position in the planes
  SurfaceIndex Isovalue;
  HitKind Kind;
  /// The composite of all layers in front of the next kept one. The last kept layer holds the
  /// pixel's colour.
  LayerColor Color{};
  CellNumber Cell = NoCell;
};

/// The most layers of a pixel that a frame keeps. Light behind so many layers is faint, or they
/// form a haze in which no single layer can be seen.
constexpr std::size_t MostKeptLayers = 32;

/// Facts about a tile's layers, in addition to the visible layers in Frame::Layers.
struct LayersBehind
{
  /// Layers that no light reaches, within a pixel from front to back. They have no colours.
  std::vector<LayerHit> Hits;
  /// One bit for each pixel of the tile, row by row: no layer lies behind its last known one.
  std::uint64_t Ends = 0;
  /// One bit for each pixel of the tile, row by row: it has merged layers. A kept layer stands for
  /// itself and for all layers in front of the next kept one. Layers behind the first one are not
  /// known.
  std::uint64_t Merged = 0;
};

/// One value for each pixel.
template <typename T>
using Plane = std::vector<T, DefaultInitAllocator<T>>;

/// Optional planes of a picture.
struct FrameExtras
{
  bool Disparities = false; ///< views made from the picture need them
  bool Cells = false;       ///< the field is a mesh
  std::size_t Met = 0;      ///< kept numbers for each ray of a projection
};

/// A finished picture: planes with one value for each pixel. Row 0 is the bottom row; pixel (x, y)
/// is at [y * Size.x + x].
struct Frame
{
  static constexpr SurfaceIndex NoSurface = -1;

  glm::ivec2 Size{ 0 };
  Plane<double> Depth;           ///< t of the hit: world distance along the ray; or infinity
  Plane<glm::vec3> Normals;      ///< unit normal in the world, facing the viewer; or 0
  Plane<SurfaceIndex> Isovalues; ///< position of the hit isovalue in the list; or NoSurface
  Plane<HitKind> Kinds;
  Plane<Answer> Answers;
  Plane<std::array<std::uint8_t, 4>> Colors; ///< premultiplied RGBA; 0 where nothing is hit
  bool IsFromCache = false;                  ///< a cached image gave the answers

  /// Colors, but with the mean of several rays at edges. Empty: no pixel has more than one ray.
  /// Routes read and write Colors alone, so their pictures do not depend on it.
  Plane<std::array<std::uint8_t, 4>> Antialiased;
  /// For each tile: 1 while its edges still have one ray a pixel, for want of time.
  /// Empty: all of Antialiased is made.
  std::vector<std::uint8_t> OpenEdges;

  // FrameExtras: an unneeded plane is empty.
  Plane<float> Disparities; ///< of the hit, or of a miss (Disparity.h)
  Plane<CellNumber> Cells;  ///< in which the surface is hit

  /// The layers of each tile: round by round from front to back, and by pixel within a round. If a
  /// pixel has more than LayersOfPixel layers, every second (fourth, ...) layer is kept. Empty if
  /// surfaces are opaque. Colors holds the composite of all layers; depth, normal and isovalue
  /// belong to the first layer.
  std::vector<std::vector<LayerHit>> Layers;

  /// For each tile: pixels with merged layers, and hidden layers that other opacities may show.
  /// Hidden layers are no part of the picture. Empty if nothing is known.
  std::vector<LayersBehind> Behind;

  /// The limit of kept layers of a pixel: a power of two.
  std::size_t LayersOfPixel = MostKeptLayers;

  /// Values that the rays of a projection met, so that new colours need no search: for each tile
  /// that is not clear, consecutive arrays over its rays. No part of the picture. Empty if nothing
  /// is kept.
  Plane<double> Met;
  glm::dvec2 MetWithin{ 0.0 }; ///< kept extremes lie within; extremes of other rays lie beyond

  /// 1 for each clear tile: its planes are known to hold definite misses only. Clear tiles need no
  /// more reading or writing.
  std::vector<std::uint8_t> ClearTiles;

  /// The list of planes. Calls visit(plane, miss) for each plane, even if it is empty: a pointer to
  /// the member, and its value for a miss.
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
    visit(&Frame::Cells, NoCell);
  }

  /// Resize every plane to `size` pixels. Contents are undefined if that changes anything.
  /// \throws std::bad_alloc; the frame is then empty
  void Resize(const glm::ivec2& size, const FrameExtras& extras = {})
  {
    const auto tiles = static_cast<std::size_t>(NumberOfTiles(size));
    const std::size_t met = tiles * TileSize * TileSize * extras.Met;
    if (size == this->Size && extras.Disparities == !this->Disparities.empty() &&
      extras.Cells == !this->Cells.empty() && met == this->Met.size())
    {
      return;
    }
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    this->Size = glm::ivec2(0);
    this->Antialiased = {};
    this->OpenEdges.clear();
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

  /// True if some edges have several rays a pixel.
  bool IsAntialiased() const { return !this->Antialiased.empty(); }

  /// True if all have.
  bool IsSmooth() const { return this->IsAntialiased() && this->OpenEdges.empty(); }

  void ForgetAntialiased()
  {
    this->Antialiased.clear();
    this->OpenEdges.clear();
  }

  /// Colours for showing the picture.
  const Plane<std::array<std::uint8_t, 4>>& ShownColors() const
  {
    return this->IsAntialiased() ? this->Antialiased : this->Colors;
  }

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
  static bool IsWanted(Plane<float> Frame::*, const FrameExtras& extras)
  {
    return extras.Disparities;
  }
};

}

#endif
