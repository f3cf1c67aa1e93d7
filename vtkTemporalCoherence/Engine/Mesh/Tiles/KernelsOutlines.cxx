// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Finds the pixels of a tile that can see cells: projects outlines in vectors of cells, then tests
// each cell in vectors of pixels or of directions.

#include "Mesh/Tiles/KernelsOutlines.h"

#ifndef TemporalCoherence_PixelMasks // this file is included once for each kind of vectors
#define TemporalCoherence_PixelMasks
namespace TemporalCoherence
{

/// A hull is an outline with 16 edges: bounds of its pixels along these directions and against
/// them. Along each direction, pixels have whole numbers.
constexpr std::size_t Directions = 8;
constexpr std::size_t SidesOfHull = 2 * Directions;
constexpr int StepsX[Directions] = { 1, 0, 1, 1, 2, 2, 1, 1 };
constexpr int StepsY[Directions] = { 0, 1, 1, -1, 1, -1, 2, -2 };

/// The pixels of a tile up to each whole number along a side.
struct PixelsUpTo
{
  static constexpr int Numbers = 32;

  constexpr PixelsUpTo()
  {
    for (std::size_t side = 0; side < SidesOfHull; ++side)
    {
      const int sign = side < Directions ? 1 : -1;
      const int x = sign * StepsX[side % Directions], y = sign * StepsY[side % Directions];
      const int least = 7 * ((x < 0 ? x : 0) + (y < 0 ? y : 0));
      this->PerColumn[side] = static_cast<float>(x);
      this->Add[side] = static_cast<float>(1 - least);
      for (int pixel = 0; pixel < 64; ++pixel)
      {
        for (int number = pixel % 8 * x + pixel / 8 * y + 1 - least; number < Numbers; ++number)
        {
          this->Masks[side][number] |= std::uint64_t(1) << pixel;
        }
      }
    }
  }

  /// [side][number]: pixels below number - Add along the side.
  std::uint64_t Masks[SidesOfHull][Numbers] = {};
  alignas(64) float PerColumn[SidesOfHull] = {};
  alignas(64) float Add[SidesOfHull] = {};
};

inline constexpr PixelsUpTo Pixels;

struct ColumnsAndRows
{
  constexpr ColumnsAndRows()
  {
    for (int pixel = 0; pixel < 64; ++pixel)
    {
      this->Column[pixel] = static_cast<float>(pixel % 8);
      this->Row[pixel] = static_cast<float>(pixel / 8);
    }
  }
  alignas(64) float Column[64] = {}, Row[64] = {};
};

/// Columns and rows of a tile's pixels.
inline constexpr ColumnsAndRows Places;

}
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tiles/KernelsOutlines.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, SeenBlock::Size>;
using Cells = hn::Vec<Floats>;

/// How much rounding may move a coordinate, as a share of OutlineView::Reach.
constexpr float Rounding = 1e-6f;

/// The corners of cells in pixels.
struct SeenPoints
{
  HWY_INLINE SeenPoints(const OutlineView& view, const OutlinePoints& cells, std::size_t i)
    : View(view)
    , At(cells)
    , I(i)
  {
  }

  HWY_INLINE void See(std::size_t corner, Cells& column, Cells& row, Cells& depth) const
  {
    const Floats d;
    const Cells x = hn::LoadU(d, &this->At.At[this->At.PlaceOf(0, corner) + this->I]);
    const Cells y = hn::LoadU(d, &this->At.At[this->At.PlaceOf(1, corner) + this->I]);
    const Cells z = hn::LoadU(d, &this->At.At[this->At.PlaceOf(2, corner) + this->I]);
    const auto along = [&](std::size_t k) HWY_ATTR
    {
      const auto& to = this->View.Row[k];
      return hn::MulAdd(x, hn::Set(d, to[0]),
        hn::MulAdd(y, hn::Set(d, to[1]),
          hn::MulAdd(z, hn::Set(d, to[2]), hn::Set(d, this->View.Middle[k]))));
    };
    depth = along(0);
    column = along(1);
    row = along(2);
    if (this->View.IsPerspective)
    {
      const Cells perDepth = hn::Div(hn::Set(d, 1.0f), depth);
      column = hn::Mul(column, perDepth);
      row = hn::Mul(row, perDepth);
    }
  }

  const OutlineView& View;
  const OutlinePoints& At;
  std::size_t I;
};

/// Some of the lanes of a block.
struct LanesOf
{
  HWY_INLINE void Store(SeenBlock::Lanes& to, Cells value) const
  {
    hn::Store(value, Floats(), &to[this->First]);
  }

  HWY_INLINE void StoreSides(const Cells* values, std::size_t count) const
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      this->Store(this->Block.Sides[k], values[k]);
    }
  }

  /// \param nearest w of the nearest point
  HWY_INLINE void StoreDepth(const OutlineView& view, Cells nearest) const
  {
    this->Store(this->Block.Depth, hn::Sub(nearest, hn::Set(Floats(), Rounding * view.DepthReach)));
  }

  SeenBlock& Block;
  std::size_t First;
};

/// The first corners of cells in pixels: the vertices of tetrahedra, then the corners of their
/// polygons.
template <std::size_t Corners>
struct SeenCorners
{
  HWY_INLINE explicit SeenCorners(const SeenPoints& points)
  {
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      Cells depth;
      points.See(corner, this->X[corner], this->Y[corner], depth);
      this->Nearest = corner == 0 ? depth : hn::Min(this->Nearest, depth);
    }
  }

  /// Twice the area of a triangle.
  HWY_INLINE Cells AreaOf(std::size_t a, std::size_t b, std::size_t c) const
  {
    return hn::Sub(hn::Mul(hn::Sub(this->X[b], this->X[a]), hn::Sub(this->Y[c], this->Y[a])),
      hn::Mul(hn::Sub(this->Y[b], this->Y[a]), hn::Sub(this->X[c], this->X[a])));
  }

  /// Lanes of tetrahedra without a face that is seen nearly edge on. By rounding errors, the search
  /// may misplace the hits on such a face.
  HWY_INLINE hn::Mask<Floats> AreFacesSeen(Cells largest, Cells error) const
  {
    const Floats d;
    const Cells least = hn::Mul(largest, hn::MulAdd(largest, hn::Set(d, 1e-5f), error));
    const Cells faces[4] = { this->AreaOf(0, 1, 2), this->AreaOf(0, 1, 3), this->AreaOf(0, 2, 3),
      this->AreaOf(1, 2, 3) };
    Cells smallest = hn::Abs(faces[0]);
    for (std::size_t face = 1; face < 4; ++face)
    {
      smallest = hn::Min(smallest, hn::Abs(faces[face]));
    }
    return hn::Gt(smallest, least);
  }

  Cells X[Corners], Y[Corners], Nearest;
};

using SeenVertices = SeenCorners<4>;
using SeenPolygons = SeenCorners<8>;

/// Bounding rectangles of cells, in pixels.
struct Rectangles
{
  template <std::size_t Corners>
  HWY_INLINE Rectangles(const SeenCorners<Corners>& seen, std::size_t first)
    : LowX(seen.X[first])
    , HighX(seen.X[first])
    , LowY(seen.Y[first])
    , HighY(seen.Y[first])
  {
  }

  template <std::size_t Corners>
  HWY_INLINE void Widen(const SeenCorners<Corners>& seen, std::size_t first, std::size_t end)
  {
    for (std::size_t corner = first; corner < end; ++corner)
    {
      this->LowX = hn::Min(this->LowX, seen.X[corner]);
      this->HighX = hn::Max(this->HighX, seen.X[corner]);
      this->LowY = hn::Min(this->LowY, seen.Y[corner]);
      this->HighY = hn::Max(this->HighY, seen.Y[corner]);
    }
  }

  HWY_INLINE Cells Size() const
  {
    return hn::Add(hn::Sub(this->HighX, this->LowX), hn::Sub(this->HighY, this->LowY));
  }

  Cells LowX, HighX, LowY, HighY;
};

/// Edge functions of a polygon, not negative on the polygon's side: A column + B row + C.
struct PolygonEdges
{
  static constexpr std::size_t Count = 4;

  /// \param isSure cells with a reliable polygon; the edges of other cells exclude nothing
  /// \param lost   how much rounding may change a function within the polygon's rectangle: the
  ///               direction of a short edge is inexact
  HWY_INLINE PolygonEdges(
    const SeenPolygons& seen, hn::Mask<Floats> isSure, Cells turn, float margin, Cells lost)
  {
    const Floats d;
    const Cells one = hn::Set(d, 1.0f), room = hn::Set(d, margin);
    for (std::size_t edge = 0; edge < Count; ++edge)
    {
      const std::size_t from = 4 + edge, to = 4 + (edge + 1) % Count;
      const Cells a = hn::Mul(turn, hn::Sub(seen.Y[from], seen.Y[to]));
      const Cells b = hn::Mul(turn, hn::Sub(seen.X[to], seen.X[from]));
      const Cells through = hn::MulAdd(a, seen.X[from], hn::Mul(b, seen.Y[from]));
      const Cells slack = hn::MulAdd(room, hn::Add(hn::Abs(a), hn::Abs(b)), lost);
      this->Functions[edge] = hn::IfThenElseZero(isSure, a);
      this->Functions[Count + edge] = hn::IfThenElseZero(isSure, b);
      this->Functions[2 * Count + edge] = hn::IfThenElse(isSure, hn::Sub(slack, through), one);
    }
  }

  Cells Functions[3 * Count];
};

HWY_INLINE void SeePolygons(
  const OutlineView& view, const OutlinePoints& cells, std::size_t i, const LanesOf& to)
{
  const Floats d;
  const SeenPolygons outlines(SeenPoints(view, cells, i));
  Rectangles polygon(outlines, 4);
  polygon.Widen(outlines, 5, 8);
  Rectangles whole = polygon;
  whole.Widen(outlines, 0, 4);
  const Cells error = hn::Set(d, 8.0f * Rounding * view.Reach);
  const auto isCut = outlines.AreFacesSeen(whole.Size(), error);
  const Cells area = hn::Add(outlines.AreaOf(4, 5, 6), outlines.AreaOf(4, 6, 7));
  const Cells size = polygon.Size();
  const auto isSure = hn::And(
    isCut, hn::Gt(hn::Abs(area), hn::Mul(size, hn::MulAdd(size, hn::Set(d, 1e-5f), error))));
  const float margin = view.Margin + 4.0f * Rounding * view.Reach;
  const PolygonEdges edges(outlines, isSure,
    hn::IfThenElse(hn::Lt(area, hn::Zero(d)), hn::Set(d, -1.0f), hn::Set(d, 1.0f)), margin,
    hn::Mul(error, hn::Add(size, hn::Set(d, 1.0f))));
  to.StoreSides(edges.Functions, 3 * PolygonEdges::Count);
  const Cells room = hn::Set(d, margin);
  to.Store(to.Block.LowX, hn::Sub(hn::IfThenElse(isCut, polygon.LowX, whole.LowX), room));
  to.Store(to.Block.HighX, hn::Add(hn::IfThenElse(isCut, polygon.HighX, whole.HighX), room));
  to.Store(to.Block.LowY, hn::Sub(hn::IfThenElse(isCut, polygon.LowY, whole.LowY), room));
  to.Store(to.Block.HighY, hn::Add(hn::IfThenElse(isCut, polygon.HighY, whole.HighY), room));
  to.StoreDepth(view, outlines.Nearest);
}

/// Bounds of points of cells along all directions.
struct HullBounds
{
  HWY_INLINE HullBounds()
    : Nearest(hn::Set(Floats(), Far))
  {
    for (std::size_t k = 0; k < Directions; ++k)
    {
      this->Low[k] = hn::Set(Floats(), Far);
      this->High[k] = hn::Set(Floats(), -Far);
    }
  }

  HWY_INLINE void Widen(const SeenPoints& points, std::size_t first, std::size_t end)
  {
    for (std::size_t corner = first; corner < end; ++corner)
    {
      Cells x, y, depth;
      points.See(corner, x, y, depth);
      const Cells sum = hn::Add(x, y), difference = hn::Sub(x, y);
      const Cells along[Directions] = { x, y, sum, difference, hn::Add(x, sum),
        hn::Add(x, difference), hn::Add(sum, y), hn::Sub(difference, y) };
      this->Nearest = hn::Min(this->Nearest, depth);
      for (std::size_t k = 0; k < Directions; ++k)
      {
        this->Low[k] = hn::Min(this->Low[k], along[k]);
        this->High[k] = hn::Max(this->High[k], along[k]);
      }
    }
  }

  HWY_INLINE void Store(const OutlineView& view, const LanesOf& to)
  {
    const Floats d;
    const float margin = view.Margin + 4.0f * Rounding * view.Reach;
    Cells bounds[SidesOfHull];
    for (std::size_t k = 0; k < Directions; ++k)
    {
      const int steps =
        (StepsX[k] < 0 ? -StepsX[k] : StepsX[k]) + (StepsY[k] < 0 ? -StepsY[k] : StepsY[k]);
      const Cells room = hn::Set(d, margin * static_cast<float>(steps));
      this->Low[k] = hn::Sub(this->Low[k], room);
      this->High[k] = hn::Add(this->High[k], room);
      bounds[k] = this->High[k];
      bounds[Directions + k] = hn::Neg(this->Low[k]);
    }
    to.StoreSides(bounds, SidesOfHull);
    to.Store(to.Block.LowX, this->Low[0]);
    to.Store(to.Block.HighX, this->High[0]);
    to.Store(to.Block.LowY, this->Low[1]);
    to.Store(to.Block.HighY, this->High[1]);
    to.StoreDepth(view, this->Nearest);
  }

  static constexpr float Far = 1e30f;
  Cells Low[Directions], High[Directions], Nearest;
};

HWY_INLINE void SeeHulls(
  const OutlineView& view, const OutlinePoints& cells, std::size_t i, const LanesOf& to)
{
  HullBounds hull;
  hull.Widen(SeenPoints(view, cells, i), 0, cells.Corners);
  hull.Store(view, to);
}

/// Bound cells by their slab, or by the whole tetrahedron if it has a face seen nearly edge on.
HWY_INLINE void SeeSlabs(
  const OutlineView& view, const OutlinePoints& cells, std::size_t i, const LanesOf& to)
{
  const Floats d;
  const SeenPoints points(view, cells, i);
  const SeenVertices vertices(points);
  Rectangles rectangle(vertices, 0);
  rectangle.Widen(vertices, 1, 4);
  const auto areSeen =
    vertices.AreFacesSeen(rectangle.Size(), hn::Set(d, 8.0f * Rounding * view.Reach));
  HullBounds hull;
  hull.Widen(points, 4, cells.Corners);
  HullBounds whole = hull;
  whole.Widen(points, 0, 4);
  hull.Nearest = whole.Nearest;
  for (std::size_t k = 0; k < Directions; ++k)
  {
    hull.Low[k] = hn::IfThenElse(areSeen, hull.Low[k], whole.Low[k]);
    hull.High[k] = hn::IfThenElse(areSeen, hull.High[k], whole.High[k]);
  }
  hull.Store(view, to);
}

template <class See>
HWY_INLINE void AppendBlocks(const OutlinePoints& cells, std::size_t first, bool isOfPolygons,
  std::vector<SeenBlock>& blocks, const See& see)
{
  for (std::size_t i = 0; i < cells.Count; i += SeenBlock::Size)
  {
    blocks.emplace_back();
    SeenBlock& block = blocks.back();
    block.IsOfPolygons = isOfPolygons;
    block.First = first + i;
    block.Count = HWY_MIN(cells.Count - i, SeenBlock::Size);
    for (std::size_t j = 0; j < block.Count; j += hn::Lanes(Floats()))
    {
      see(i + j, LanesOf{ block, j });
    }
  }
}

void AppendSeenCells(
  const OutlineView& view, const CellOutlines& cells, std::vector<SeenBlock>& blocks)
{
  AppendBlocks(cells.Polygons, 0, true, blocks,
    [&](std::size_t i, const LanesOf& to) HWY_ATTR { SeePolygons(view, cells.Polygons, i, to); });
  AppendBlocks(cells.Slabs, cells.Polygons.Count, false, blocks,
    [&](std::size_t i, const LanesOf& to) HWY_ATTR { SeeSlabs(view, cells.Slabs, i, to); });
  AppendBlocks(cells.Hulls, cells.Polygons.Count + cells.Slabs.Count, false, blocks,
    [&](std::size_t i, const LanesOf& to) HWY_ATTR { SeeHulls(view, cells.Hulls, i, to); });
}

/// One bit for each pixel of a tile within the bounds of a hull.
HWY_INLINE std::uint64_t PixelsOfHull(const SeenBlock& block, std::size_t cell, float column)
{
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  HWY_ALIGN std::int32_t numbers[SidesOfHull];
  const Cells first = hn::Set(d, column), zero = hn::Zero(d);
  const Cells last = hn::Set(d, static_cast<float>(PixelsUpTo::Numbers - 1));
  const auto steps =
    hn::Mul(hn::Iota(di, 0), hn::Set(di, static_cast<std::int32_t>(SeenBlock::Size)));
  for (std::size_t k = 0; k < SidesOfHull; k += hn::Lanes(d))
  {
    const Cells moved = hn::NegMulAdd(first, hn::Load(d, &Pixels.PerColumn[k]),
      hn::Add(hn::GatherIndex(d, &block.Sides[k][cell], steps), hn::Load(d, &Pixels.Add[k])));
    hn::Store(hn::ConvertTo(di, hn::Min(hn::Max(moved, zero), last)), di, &numbers[k]);
  }
  std::uint64_t pixels = ~std::uint64_t(0);
  for (std::size_t k = 0; k < SidesOfHull; ++k)
  {
    pixels &= Pixels.Masks[k][numbers[k]];
  }
  return pixels;
}

/// Bits of a tile's pixels inside of all edges of a polygon and of its rectangle.
HWY_INLINE std::uint64_t PixelsOfPolygon(const SeenBlock& block, std::size_t cell, float column)
{
  const Floats d;
  constexpr std::size_t count = PolygonEdges::Count;
  const auto side = [&](std::size_t k) { return block.Sides[k][cell]; };
  const Cells lowX = hn::Set(d, block.LowX[cell] - column);
  const Cells highX = hn::Set(d, block.HighX[cell] - column);
  const Cells lowY = hn::Set(d, block.LowY[cell]), highY = hn::Set(d, block.HighY[cell]);
  std::uint64_t pixels = 0;
  for (std::size_t first = 0; first < 64; first += hn::Lanes(d))
  {
    const Cells x = hn::Load(d, &Places.Column[first]), y = hn::Load(d, &Places.Row[first]);
    Cells least = hn::Min(
      hn::Min(hn::Sub(x, lowX), hn::Sub(highX, x)), hn::Min(hn::Sub(y, lowY), hn::Sub(highY, y)));
    for (std::size_t edge = 0; edge < count; ++edge)
    {
      const Cells a = hn::Set(d, side(edge)), b = hn::Set(d, side(count + edge));
      const Cells c = hn::Set(d, side(2 * count + edge) + side(edge) * column);
      least = hn::Min(least, hn::MulAdd(a, x, hn::MulAdd(b, y, c)));
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Ge(least, hn::Zero(d)), bits);
    pixels |= static_cast<std::uint64_t>(bits[0] | bits[1] << 8) << first;
  }
  return pixels;
}

/// One bit for each cell of a block whose rectangle meets a tile.
HWY_INLINE std::uint32_t CellsAt(const SeenBlock& block, float column)
{
  const Floats d;
  std::uint32_t near = 0;
  const Cells left = hn::Set(d, column), right = hn::Set(d, column + 7.0f);
  const Cells bottom = hn::Zero(d), top = hn::Set(d, 7.0f);
  for (std::size_t i = 0; i < SeenBlock::Size; i += hn::Lanes(d))
  {
    const auto isBeside = hn::Or(
      hn::Lt(hn::Load(d, &block.HighX[i]), left), hn::Gt(hn::Load(d, &block.LowX[i]), right));
    const auto isAbove = hn::Or(
      hn::Lt(hn::Load(d, &block.HighY[i]), bottom), hn::Gt(hn::Load(d, &block.LowY[i]), top));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Or(isBeside, isAbove), bits);
    near |= static_cast<std::uint32_t>(bits[0] | bits[1] << 8) << i;
  }
  return ~near & ((1u << block.Count) - 1u);
}

void FindPixelsOfCells(const SeenBlock* blocks, std::size_t count, float column, SeenCells& seen)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const SeenBlock& block = blocks[i];
    for (std::uint32_t near = CellsAt(block, column); near != 0; near &= near - 1)
    {
      const std::size_t cell = hwy::Num0BitsBelowLS1Bit_Nonzero32(near);
      const std::uint64_t pixels = block.IsOfPolygons ? PixelsOfPolygon(block, cell, column)
                                                      : PixelsOfHull(block, cell, column);
      if (pixels != 0)
      {
        seen.Append(block.First + cell, pixels, block.Depth[cell]);
      }
    }
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(AppendSeenCells);
HWY_EXPORT(FindPixelsOfCells);

void SeeCells(const OutlineView& view, const CellOutlines& cells, std::vector<SeenBlock>& blocks)
{
  HWY_DYNAMIC_DISPATCH(AppendSeenCells)(view, cells, blocks);
}

void PixelsOfCells(const SeenBlock* blocks, std::size_t count, float column, SeenCells& seen)
{
  HWY_DYNAMIC_DISPATCH(FindPixelsOfCells)(blocks, count, column, seen);
}

}
#endif
