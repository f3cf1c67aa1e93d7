// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Which pixels of a tile can see the slabs of cells: corners in vectors of cells, then strips
// around slabs in vectors of pixels.

#include "MeshTiles/KernelsSlabs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "MeshTiles/KernelsSlabs.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using FloatLanes = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<FloatLanes>;

/// How much rounding may move a coordinate, as a share of OutlineView::Reach.
constexpr float RoundingOfPixels = 1e-6f;

/// Points of cells as the tile sees them, in pixels.
template <std::size_t Number>
struct SeenPoints
{
  HWY_INLINE SeenPoints(
    const OutlineView& view, const SlabOutlines& cells, std::size_t first, std::size_t i)
  {
    const FloatLanes d;
    for (std::size_t corner = 0; corner < Number; ++corner)
    {
      const Lanes x = hn::LoadU(d, &cells.At[cells.PlaceOf(0, first + corner) + i]);
      const Lanes y = hn::LoadU(d, &cells.At[cells.PlaceOf(1, first + corner) + i]);
      const Lanes z = hn::LoadU(d, &cells.At[cells.PlaceOf(2, first + corner) + i]);
      const auto along = [&](std::size_t row) HWY_ATTR
      {
        return hn::MulAdd(x, hn::Set(d, view.Row[row][0]),
          hn::MulAdd(y, hn::Set(d, view.Row[row][1]),
            hn::MulAdd(z, hn::Set(d, view.Row[row][2]), hn::Set(d, view.Middle[row]))));
      };
      this->X[corner] = along(1);
      this->Y[corner] = along(2);
      if (view.IsPerspective)
      {
        const Lanes perDepth = hn::Div(hn::Set(d, 1.0f), along(0));
        this->X[corner] = hn::Mul(this->X[corner], perDepth);
        this->Y[corner] = hn::Mul(this->Y[corner], perDepth);
      }
    }
  }

  Lanes X[Number], Y[Number];
};

/// Between which numbers a X + b Y lies for points.
struct Strip
{
  template <std::size_t Number>
  HWY_INLINE Strip(const SeenPoints<Number>& seen, Lanes a, Lanes b, float margin)
    : A(a)
    , B(b)
  {
    const FloatLanes d;
    for (std::size_t corner = 0; corner < Number; ++corner)
    {
      const Lanes at = hn::MulAdd(a, seen.X[corner], hn::Mul(b, seen.Y[corner]));
      this->Low = corner == 0 ? at : hn::Min(this->Low, at);
      this->High = corner == 0 ? at : hn::Max(this->High, at);
    }
    const Lanes room = hn::Mul(hn::Set(d, margin), hn::Add(hn::Abs(a), hn::Abs(b)));
    this->Low = hn::Sub(this->Low, room);
    this->High = hn::Add(this->High, room);
  }

  Lanes A, B, Low, High;
};

/// The rectangle around points.
struct AroundPoints
{
  template <std::size_t Number>
  HWY_INLINE AroundPoints(const SeenPoints<Number>& seen, float margin)
  {
    const FloatLanes d;
    for (std::size_t corner = 0; corner < Number; ++corner)
    {
      const Lanes x = seen.X[corner], y = seen.Y[corner];
      this->LowX = corner == 0 ? x : hn::Min(this->LowX, x);
      this->HighX = corner == 0 ? x : hn::Max(this->HighX, x);
      this->LowY = corner == 0 ? y : hn::Min(this->LowY, y);
      this->HighY = corner == 0 ? y : hn::Max(this->HighY, y);
    }
    const Lanes room = hn::Set(d, margin);
    this->LowX = hn::Sub(this->LowX, room);
    this->HighX = hn::Add(this->HighX, room);
    this->LowY = hn::Sub(this->LowY, room);
    this->HighY = hn::Add(this->HighY, room);
  }

  /// Which of them have a pixel of the tile.
  HWY_INLINE hn::Mask<FloatLanes> AreNear() const
  {
    const FloatLanes d;
    const Lanes last = hn::Set(d, 7.0f), zero = hn::Zero(d);
    return hn::And(hn::And(hn::Ge(this->HighX, zero), hn::Le(this->LowX, last)),
      hn::And(hn::Ge(this->HighY, zero), hn::Le(this->LowY, last)));
  }

  HWY_INLINE Lanes Size() const
  {
    return hn::Add(hn::Sub(this->HighX, this->LowX), hn::Sub(this->HighY, this->LowY));
  }

  Lanes LowX, HighX, LowY, HighY;
};

/// Tetrahedra none of whose faces is seen edge on, or nearly so: the search of such a face may be
/// wrong about where a ray meets it, by rounding errors.
HWY_INLINE hn::Mask<FloatLanes> AreFacesSeen(
  const SeenPoints<SlabOutlines::Vertices>& seen, Lanes largest, Lanes error)
{
  const FloatLanes d;
  const auto areaOf = [&](std::size_t a, std::size_t b, std::size_t c) HWY_ATTR
  {
    return hn::Abs(hn::Sub(hn::Mul(hn::Sub(seen.X[b], seen.X[a]), hn::Sub(seen.Y[c], seen.Y[a])),
      hn::Mul(hn::Sub(seen.Y[b], seen.Y[a]), hn::Sub(seen.X[c], seen.X[a]))));
  };
  const Lanes least = hn::Mul(largest, hn::MulAdd(largest, hn::Set(d, 1e-5f), error));
  const Lanes smallest =
    hn::Min(hn::Min(areaOf(0, 1, 2), areaOf(0, 1, 3)), hn::Min(areaOf(0, 2, 3), areaOf(1, 2, 3)));
  return hn::Gt(smallest, least);
}

/// What is known of the slabs of a vector of cells: strips around each, of which the first two are
/// along the axes.
struct SlabStrips
{
  static constexpr std::size_t Count = 4; ///< beside the rectangle
  HWY_ALIGN float LowX[16], HighX[16], LowY[16], HighY[16];
  HWY_ALIGN float A[Count][16], B[Count][16], Low[Count][16], High[Count][16];

  HWY_INLINE void Set(const AroundPoints& around)
  {
    const FloatLanes d;
    hn::Store(around.LowX, d, this->LowX);
    hn::Store(around.HighX, d, this->HighX);
    hn::Store(around.LowY, d, this->LowY);
    hn::Store(around.HighY, d, this->HighY);
  }

  /// \param isSure which slabs can be trusted; others have strips that leave nothing out
  HWY_INLINE void Set(std::size_t at, const Strip& strip, hn::Mask<FloatLanes> isSure)
  {
    const FloatLanes d;
    const Lanes one = hn::Set(d, 1.0f);
    hn::Store(hn::IfThenElseZero(isSure, strip.A), d, this->A[at]);
    hn::Store(hn::IfThenElseZero(isSure, strip.B), d, this->B[at]);
    hn::Store(hn::IfThenElse(isSure, strip.Low, hn::Neg(one)), d, this->Low[at]);
    hn::Store(hn::IfThenElse(isSure, strip.High, one), d, this->High[at]);
  }

  /// One bit for each pixel within all strips of a cell.
  HWY_INLINE std::uint64_t PixelsOf(std::size_t lane) const
  {
    const FloatLanes d;
    constexpr float columns = 8.0f;
    const Lanes steps = hn::Iota(d, 0.0f);
    const Lanes step = hn::Floor(hn::Mul(steps, hn::Set(d, 1.0f / columns)));
    const Lanes column = hn::NegMulAdd(step, hn::Set(d, columns), steps);
    const auto isInX = hn::And(
      hn::Ge(column, hn::Set(d, this->LowX[lane])), hn::Le(column, hn::Set(d, this->HighX[lane])));
    std::uint64_t pixels = 0;
    const float rows = static_cast<float>(hn::Lanes(d)) / columns;
    float first = 0.0f;
    for (std::size_t i = 0; i < 64; i += hn::Lanes(d), first += rows)
    {
      if (this->HighY[lane] < first || this->LowY[lane] > first + rows)
      {
        continue;
      }
      const Lanes row = hn::Add(step, hn::Set(d, first));
      auto isIn = hn::And(isInX,
        hn::And(
          hn::Ge(row, hn::Set(d, this->LowY[lane])), hn::Le(row, hn::Set(d, this->HighY[lane]))));
      for (std::size_t at = 0; at < Count; ++at)
      {
        const Lanes value = hn::MulAdd(
          hn::Set(d, this->A[at][lane]), column, hn::Mul(hn::Set(d, this->B[at][lane]), row));
        isIn = hn::And(isIn,
          hn::And(hn::Ge(value, hn::Set(d, this->Low[at][lane])),
            hn::Le(value, hn::Set(d, this->High[at][lane]))));
      }
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, isIn, bits);
      pixels |= static_cast<std::uint64_t>(bits[0] | bits[1] << 8) << i;
    }
    return pixels;
  }
};

HWY_INLINE unsigned int BitsOfCells(hn::Mask<FloatLanes> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(FloatLanes(), mask, bits);
  return bits[0] | static_cast<unsigned int>(bits[1]) << 8;
}

/// The pixels that a vector of cells may be seen in.
HWY_INLINE void FindPixelsOfSlabs(const OutlineView& view, const SlabOutlines& cells, std::size_t i,
  std::array<std::uint64_t, 64>& pixels)
{
  const FloatLanes d;
  const float margin = view.Margin + 4.0f * RoundingOfPixels * view.Reach;
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
  {
    pixels[i + lane] = 0;
  }
  const SeenPoints<SlabOutlines::Vertices> vertices(view, cells, 0, i);
  AroundPoints around(vertices, margin);
  const auto isNear = around.AreNear();
  if (hn::AllFalse(d, isNear))
  {
    return;
  }
  const Lanes error = hn::Set(d, 8.0f * RoundingOfPixels * view.Reach);
  const auto isSure = AreFacesSeen(vertices, around.Size(), error);
  const SeenPoints<SlabOutlines::SlabCorners> slab(view, cells, SlabOutlines::Vertices, i);
  const AroundPoints aroundSlab(slab, margin);
  around.LowX = hn::IfThenElse(isSure, aroundSlab.LowX, around.LowX);
  around.HighX = hn::IfThenElse(isSure, aroundSlab.HighX, around.HighX);
  around.LowY = hn::IfThenElse(isSure, aroundSlab.LowY, around.LowY);
  around.HighY = hn::IfThenElse(isSure, aroundSlab.HighY, around.HighY);
  SlabStrips strips;
  strips.Set(around);
  // Strips along the edges of the polygon that the slab begins with. Any others would do, too.
  for (std::size_t at = 0; at < SlabStrips::Count; ++at)
  {
    const std::size_t to = (at + 1) % SlabStrips::Count;
    const Strip strip(
      slab, hn::Sub(slab.Y[at], slab.Y[to]), hn::Sub(slab.X[to], slab.X[at]), margin);
    strips.Set(at, strip, isSure);
  }
  for (unsigned int left = BitsOfCells(around.AreNear()); left != 0; left &= left - 1)
  {
    const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    pixels[i + lane] = strips.PixelsOf(lane);
  }
}

void FindPixelsOfAllSlabs(
  const OutlineView& view, const SlabOutlines& cells, std::array<std::uint64_t, 64>& pixels)
{
  for (std::size_t i = 0; i < cells.Count; i += hn::Lanes(FloatLanes()))
  {
    FindPixelsOfSlabs(view, cells, i, pixels);
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindPixelsOfAllSlabs);

void PixelsOfSlabs(
  const OutlineView& view, const SlabOutlines& cells, std::array<std::uint64_t, 64>& pixels)
{
  HWY_DYNAMIC_DISPATCH(FindPixelsOfAllSlabs)(view, cells, pixels);
}

}
#endif
