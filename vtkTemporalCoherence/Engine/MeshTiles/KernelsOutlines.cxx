// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Which pixels of a tile can see cells: outlines in vectors of cells, then polygons in vectors of
// pixels.

#include "MeshTiles/KernelsOutlines.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "MeshTiles/KernelsOutlines.cxx"
#include <hwy/foreach_target.h>

#include <algorithm>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Cells = hn::Vec<Floats>;

/// How much rounding may move a coordinate, as a share of OutlineView::Reach.
constexpr float Rounding = 1e-6f;

/// Cells as the tile sees them, in pixels.
struct SeenOutlines
{
  HWY_INLINE SeenOutlines(const OutlineView& view, const CellOutlines& cells, std::size_t i)
  {
    const Floats d;
    for (std::size_t corner = 0; corner < CellOutlines::Corners; ++corner)
    {
      const Cells x = hn::LoadU(d, &cells.At[cells.PlaceOf(0, corner) + i]);
      const Cells y = hn::LoadU(d, &cells.At[cells.PlaceOf(1, corner) + i]);
      const Cells z = hn::LoadU(d, &cells.At[cells.PlaceOf(2, corner) + i]);
      const auto along = [&](std::size_t row) HWY_ATTR
      {
        return hn::MulAdd(x, hn::Set(d, view.Row[row][0]),
          hn::MulAdd(y, hn::Set(d, view.Row[row][1]),
            hn::MulAdd(z, hn::Set(d, view.Row[row][2]), hn::Set(d, view.Middle[row]))));
      };
      const Cells w = along(0);
      this->Nearest = corner == 0 ? w : hn::Min(this->Nearest, w);
      this->X[corner] = along(1);
      this->Y[corner] = along(2);
      if (view.IsPerspective)
      {
        const Cells perDepth = hn::Div(hn::Set(d, 1.0f), w);
        this->X[corner] = hn::Mul(this->X[corner], perDepth);
        this->Y[corner] = hn::Mul(this->Y[corner], perDepth);
      }
    }
  }

  /// Twice the area of a triangle.
  HWY_INLINE Cells AreaOf(std::size_t a, std::size_t b, std::size_t c) const
  {
    return hn::Sub(hn::Mul(hn::Sub(this->X[b], this->X[a]), hn::Sub(this->Y[c], this->Y[a])),
      hn::Mul(hn::Sub(this->Y[b], this->Y[a]), hn::Sub(this->X[c], this->X[a])));
  }

  /// Tetrahedra none of whose faces is seen edge on, or nearly so: the search of such a face may be
  /// wrong about where a ray meets it, by rounding errors.
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

  Cells X[CellOutlines::Corners], Y[CellOutlines::Corners], Nearest;
};

/// The rectangles around cells.
struct Rectangles
{
  HWY_INLINE Rectangles(const SeenOutlines& seen, std::size_t first)
    : LowX(seen.X[first])
    , HighX(seen.X[first])
    , LowY(seen.Y[first])
    , HighY(seen.Y[first])
  {
  }

  HWY_INLINE void Widen(const SeenOutlines& seen, std::size_t first, std::size_t end)
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

/// A function of the pixel for each edge of a polygon, not negative on its side:
/// A column + B row + C.
struct PolygonEdges
{
  static constexpr std::size_t Count = 4;
  HWY_ALIGN float A[Count][16], B[Count][16], C[Count][16];

  /// \param isSure of which cells the polygon can be trusted; others have edges that leave nothing
  ///               out
  /// \param lost   how much rounding may change a function within the polygon's rectangle: the
  ///               direction of a short edge is inexact
  HWY_INLINE void Set(
    const SeenOutlines& seen, hn::Mask<Floats> isSure, Cells turn, float margin, Cells lost)
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
      const Cells c = hn::Sub(slack, through);
      hn::Store(hn::IfThenElseZero(isSure, a), d, this->A[edge]);
      hn::Store(hn::IfThenElseZero(isSure, b), d, this->B[edge]);
      hn::Store(hn::IfThenElse(isSure, c, one), d, this->C[edge]);
    }
  }

  /// One bit for each pixel on the side of all edges of a cell.
  HWY_INLINE std::uint64_t PixelsOf(std::size_t lane) const
  {
    const Floats d;
    const Cells steps = hn::Iota(d, 0.0f);
    constexpr float columns = 8.0f;
    std::uint64_t pixels = 0;
    for (std::size_t first = 0; first < 64; first += hn::Lanes(d))
    {
      const Cells pixel = hn::Add(steps, hn::Set(d, static_cast<float>(first)));
      const Cells row = hn::Floor(hn::Mul(pixel, hn::Set(d, 1.0f / columns)));
      const Cells column = hn::NegMulAdd(row, hn::Set(d, columns), pixel);
      Cells least = hn::Set(d, 1.0f);
      for (std::size_t edge = 0; edge < Count; ++edge)
      {
        const Cells value = hn::MulAdd(hn::Set(d, this->A[edge][lane]), column,
          hn::MulAdd(hn::Set(d, this->B[edge][lane]), row, hn::Set(d, this->C[edge][lane])));
        least = hn::Min(least, value);
      }
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::Ge(least, hn::Zero(d)), bits);
      pixels |= static_cast<std::uint64_t>(bits[0] | bits[1] << 8) << first;
    }
    return pixels;
  }
};

/// Bits of the pixels of a row of a tile between two coordinates.
HWY_INLINE std::uint64_t BitsBetween(float low, float high)
{
  // Moved above 0, where conversion rounds down.
  const int from = static_cast<int>(9.0f - std::min(std::max(-0.5f, low), 8.0f));  // 9 - ceil(low)
  const int last = static_cast<int>(std::max(std::min(7.0f, high), -1.0f) + 1.0f); // floor + 1
  const int first = 9 - from;
  return first >= last ? 0 : ((std::uint64_t(1) << last) - 1) & ~((std::uint64_t(1) << first) - 1);
}

/// One bit for each pixel of a rectangle.
HWY_INLINE std::uint64_t PixelsWithin(float lowX, float highX, float lowY, float highY)
{
  const std::uint64_t columns = BitsBetween(lowX, highX), lines = BitsBetween(lowY, highY);
  // Spread the bits of the rows over bytes (seven by one product), and fill these with the columns.
  const std::uint64_t spread =
    ((lines & 0x7f) * 0x0002040810204081u & 0x0101010101010101u) | lines >> 7 << 56;
  return spread * columns;
}

/// The same for a vector of cells.
HWY_INLINE void FindPixelsOf(
  const OutlineView& view, const CellOutlines& cells, std::size_t i, SeenCells& seen)
{
  const Floats d;
  const SeenOutlines outlines(view, cells, i);
  Rectangles polygon(outlines, 4);
  polygon.Widen(outlines, 5, 8);
  Rectangles whole = polygon;
  whole.Widen(outlines, 0, 4);
  const Cells error = hn::Set(d, 8.0f * Rounding * view.Reach);
  const auto isCut = hn::And(
    hn::Gt(hn::LoadU(d, &cells.IsCut[i]), hn::Zero(d)), outlines.AreFacesSeen(whole.Size(), error));
  const Cells area = hn::Add(outlines.AreaOf(4, 5, 6), outlines.AreaOf(4, 6, 7));
  const Cells size = polygon.Size();
  const auto isSure = hn::And(
    isCut, hn::Gt(hn::Abs(area), hn::Mul(size, hn::MulAdd(size, hn::Set(d, 1e-5f), error))));
  const float margin = view.Margin + 4.0f * Rounding * view.Reach;
  PolygonEdges edges;
  edges.Set(outlines, isSure,
    hn::IfThenElse(hn::Lt(area, hn::Zero(d)), hn::Set(d, -1.0f), hn::Set(d, 1.0f)), margin,
    hn::Mul(error, hn::Add(size, hn::Set(d, 1.0f))));

  HWY_ALIGN float sides[4][16];
  const Cells room = hn::Set(d, margin);
  const Cells lowX = hn::Sub(hn::IfThenElse(isCut, polygon.LowX, whole.LowX), room);
  const Cells highX = hn::Add(hn::IfThenElse(isCut, polygon.HighX, whole.HighX), room);
  const Cells lowY = hn::Sub(hn::IfThenElse(isCut, polygon.LowY, whole.LowY), room);
  const Cells highY = hn::Add(hn::IfThenElse(isCut, polygon.HighY, whole.HighY), room);
  hn::Store(lowX, d, sides[0]);
  hn::Store(highX, d, sides[1]);
  hn::Store(lowY, d, sides[2]);
  hn::Store(highY, d, sides[3]);
  hn::Store(outlines.Nearest, d, &seen.Depth[i]);
  const Cells last = hn::Set(d, 7.0f), zero = hn::Zero(d);
  const auto isNear = hn::And(hn::And(hn::Ge(highX, zero), hn::Le(lowX, last)),
    hn::And(hn::Ge(highY, zero), hn::Le(lowY, last)));
  std::uint8_t bits[2][8] = {};
  hn::StoreMaskBits(d, isNear, bits[0]);
  hn::StoreMaskBits(d, isSure, bits[1]);
  const unsigned int near = bits[0][0] | bits[0][1] << 8, sure = bits[1][0] | bits[1][1] << 8;
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
  {
    std::uint64_t pixels = 0;
    if ((near >> lane & 1u) != 0)
    {
      pixels = PixelsWithin(sides[0][lane], sides[1][lane], sides[2][lane], sides[3][lane]);
      if (pixels != 0 && (sure >> lane & 1u) != 0)
      {
        pixels &= edges.PixelsOf(lane);
      }
    }
    seen.Pixels[i + lane] = pixels;
  }
}

void FindPixelsOfCells(const OutlineView& view, const CellOutlines& cells, SeenCells& seen)
{
  for (std::size_t i = 0; i < cells.Count; i += hn::Lanes(Floats()))
  {
    FindPixelsOf(view, cells, i, seen);
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindPixelsOfCells);

void PixelsOfCells(const OutlineView& view, const CellOutlines& cells, SeenCells& seen)
{
  HWY_DYNAMIC_DISPATCH(FindPixelsOfCells)(view, cells, seen);
}

}
#endif
