// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Which pixels of a tile can see the slabs of cells: corners in vectors of cells, then strips
// around slabs in vectors of pixels.

#include "MeshTiles/KernelsSlabs.h"

#include "MeshTiles/MeshDifference.h"

#include <algorithm>

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

/// How much rounding may move a value, as a share of the largest one: far more than needed.
constexpr float RoundingOfValues = 1e-6f;

/// The vertices of cells as the tile sees them, in pixels.
struct SeenVertices
{
  HWY_INLINE SeenVertices(const OutlineView& view, const SlabOutlines& cells, std::size_t i)
  {
    const FloatLanes d;
    for (std::size_t at = 0; at < SlabOutlines::Vertices; ++at)
    {
      const Lanes x = hn::LoadU(d, &cells.At[cells.PlaceOf(0, at) + i]);
      const Lanes y = hn::LoadU(d, &cells.At[cells.PlaceOf(1, at) + i]);
      const Lanes z = hn::LoadU(d, &cells.At[cells.PlaceOf(2, at) + i]);
      const auto along = [&](std::size_t row) HWY_ATTR
      {
        return hn::MulAdd(x, hn::Set(d, view.Row[row][0]),
          hn::MulAdd(y, hn::Set(d, view.Row[row][1]),
            hn::MulAdd(z, hn::Set(d, view.Row[row][2]), hn::Set(d, view.Middle[row]))));
      };
      const Lanes one = hn::Set(d, 1.0f);
      this->W[at] = view.IsPerspective ? along(0) : one;
      const Lanes perDepth = hn::Div(one, this->W[at]);
      this->X[at] = hn::Mul(along(1), perDepth);
      this->Y[at] = hn::Mul(along(2), perDepth);
    }
  }

  Lanes X[4], Y[4], W[4]; ///< W: depth
};

/// Between which numbers a X + b Y lies for points.
struct Strip
{
  HWY_INLINE Strip()
    : Low(hn::Set(FloatLanes(), 1e30f))
    , High(hn::Set(FloatLanes(), -1e30f))
  {
  }

  /// \param isPoint which of the points count
  HWY_INLINE void Widen(Lanes from, Lanes to, hn::Mask<FloatLanes> isPoint)
  {
    const FloatLanes d;
    const Lanes far = hn::Set(d, 1e30f);
    this->Low = hn::Min(this->Low, hn::IfThenElse(isPoint, hn::Min(from, to), far));
    this->High = hn::Max(this->High, hn::IfThenElse(isPoint, hn::Max(from, to), hn::Neg(far)));
  }

  Lanes Low, High;
};

/// The edges of tetrahedra within a band: its slab is the hull of these.
struct SlabEdges
{
  static constexpr std::size_t Count = 6;
  static constexpr std::size_t Ends[Count][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 },
    { 2, 3 } };

  HWY_INLINE SlabEdges(const SeenVertices& seen, const Lanes values[4], Lanes low, Lanes high)
  {
    const FloatLanes d;
    const Lanes zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    for (std::size_t edge = 0; edge < Count; ++edge)
    {
      const std::size_t i = Ends[edge][0], j = Ends[edge][1];
      const Lanes first = values[i], last = values[j];
      this->IsIn[edge] =
        hn::And(hn::Le(hn::Min(first, last), high), hn::Ge(hn::Max(first, last), low));
      const Lanes change = hn::Sub(last, first);
      const auto isFlat = hn::Eq(change, zero);
      const Lanes per = hn::Div(one, hn::IfThenElse(isFlat, one, change));
      const Lanes atLow = hn::Mul(hn::Sub(low, first), per);
      const Lanes atHigh = hn::Mul(hn::Sub(high, first), per);
      // The same shares of the edge in the picture, by its depths.
      const auto share = [&](Lanes at) HWY_ATTR
      {
        const Lanes to = hn::Mul(at, seen.W[j]);
        return hn::Div(to, hn::MulAdd(hn::Sub(one, at), seen.W[i], to));
      };
      const Lanes from = hn::Max(hn::Min(atLow, atHigh), zero);
      const Lanes to = hn::Min(hn::Max(atLow, atHigh), one);
      this->From[edge] = hn::IfThenElseZero(hn::Not(isFlat), share(from));
      this->To[edge] = hn::IfThenElse(isFlat, one, share(to));
    }
  }

  /// The strip around slabs, by numbers of vertices.
  HWY_INLINE Strip Around(const Lanes at[4]) const
  {
    Strip strip;
    for (std::size_t edge = 0; edge < Count; ++edge)
    {
      const Lanes first = at[Ends[edge][0]], way = hn::Sub(at[Ends[edge][1]], first);
      strip.Widen(hn::MulAdd(this->From[edge], way, first), hn::MulAdd(this->To[edge], way, first),
        this->IsIn[edge]);
    }
    return strip;
  }

  Lanes From[Count], To[Count]; ///< as shares of the edges
  hn::Mask<FloatLanes> IsIn[Count];
};

/// Tetrahedra none of whose faces is seen edge on, or nearly so: the search of such a face may be
/// wrong about where a ray meets it, by rounding errors.
HWY_INLINE hn::Mask<FloatLanes> AreFacesSeen(const SeenVertices& seen, Lanes largest, Lanes error)
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

/// Where a vector of slabs may be seen: a rectangle around each, and strips.
struct SlabStrips
{
  static constexpr std::size_t Count = 4; ///< beside the rectangle
  HWY_ALIGN float LowX[16], HighX[16], LowY[16], HighY[16];
  HWY_ALIGN float A[Count][16], B[Count][16], Low[Count][16], High[Count][16];

  /// Set a strip: Low <= a X + b Y <= High.
  HWY_INLINE void Set(std::size_t at, Lanes a, Lanes b, const Strip& strip, float margin)
  {
    const FloatLanes d;
    const Lanes room = hn::Mul(hn::Set(d, margin), hn::Add(hn::Abs(a), hn::Abs(b)));
    hn::Store(a, d, this->A[at]);
    hn::Store(b, d, this->B[at]);
    hn::Store(hn::Sub(strip.Low, room), d, this->Low[at]);
    hn::Store(hn::Add(strip.High, room), d, this->High[at]);
  }

  /// \return which cells have a pixel of the tile
  HWY_INLINE hn::Mask<FloatLanes> Set(const Strip& x, const Strip& y, float margin)
  {
    const FloatLanes d;
    const Lanes room = hn::Set(d, margin), last = hn::Set(d, 7.0f), zero = hn::Zero(d);
    const Lanes lowX = hn::Sub(x.Low, room), highX = hn::Add(x.High, room);
    const Lanes lowY = hn::Sub(y.Low, room), highY = hn::Add(y.High, room);
    hn::Store(lowX, d, this->LowX);
    hn::Store(highX, d, this->HighX);
    hn::Store(lowY, d, this->LowY);
    hn::Store(highY, d, this->HighY);
    return hn::And(hn::And(hn::Ge(highX, zero), hn::Le(lowX, last)),
      hn::And(hn::Ge(highY, zero), hn::Le(lowY, last)));
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

/// The strip around vertices.
HWY_INLINE Strip AroundVertices(const Lanes at[4])
{
  Strip strip;
  strip.Low = hn::Min(hn::Min(at[0], at[1]), hn::Min(at[2], at[3]));
  strip.High = hn::Max(hn::Max(at[0], at[1]), hn::Max(at[2], at[3]));
  return strip;
}

/// The wider strip where slabs cannot be trusted.
HWY_INLINE Strip Choose(hn::Mask<FloatLanes> isSure, const Strip& slab, const Strip& whole)
{
  Strip strip;
  strip.Low = hn::IfThenElse(isSure, slab.Low, whole.Low);
  strip.High = hn::IfThenElse(isSure, slab.High, whole.High);
  return strip;
}

/// Faces of a tetrahedron.
constexpr std::size_t FacesOfSlab[4][3] = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } };

/// The pixels that may see the slabs of a vector of cells.
HWY_INLINE void FindPixelsOfSlabs(const OutlineView& view, const SlabOutlines& cells, std::size_t i,
  float width, std::array<std::uint64_t, 64>& pixels)
{
  const FloatLanes d;
  const float margin = view.Margin + 4.0f * RoundingOfPixels * view.Reach;
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
  {
    pixels[i + lane] = 0;
  }
  const SeenVertices seen(view, cells, i);
  const Strip wholeX = AroundVertices(seen.X), wholeY = AroundVertices(seen.Y);
  SlabStrips strips;
  if (hn::AllFalse(d, strips.Set(wholeX, wholeY, margin)))
  {
    return;
  }
  Lanes values[4], largest = hn::Zero(d);
  for (std::size_t at = 0; at < 4; ++at)
  {
    values[at] = hn::LoadU(d, &cells.At[cells.PlaceOf(3, at) + i]);
    largest = hn::Max(largest, hn::Abs(values[at]));
  }
  const Lanes size = hn::Add(hn::Sub(wholeX.High, wholeX.Low), hn::Sub(wholeY.High, wholeY.Low));
  const Lanes error = hn::Set(d, 8.0f * RoundingOfPixels * view.Reach);
  const auto isFinite = hn::Lt(largest, hn::Set(d, static_cast<float>(MeshDifference::Largest)));
  const auto isSure = hn::And(isFinite, AreFacesSeen(seen, size, error));
  const Lanes span = hn::Set(d, width);
  const Lanes slack = hn::Mul(hn::Set(d, RoundingOfValues), hn::Add(largest, span));
  const SlabEdges slab(seen, values, hn::Neg(slack), hn::Add(span, slack));
  unsigned int left = BitsOfCells(strips.Set(Choose(isSure, slab.Around(seen.X), wholeX),
    Choose(isSure, slab.Around(seen.Y), wholeY), margin));
  // Strips along the lines of equal values on faces: any others would do, too.
  for (std::size_t at = 0; at < SlabStrips::Count; ++at)
  {
    const std::size_t p = FacesOfSlab[at][0], q = FacesOfSlab[at][1], r = FacesOfSlab[at][2];
    const Lanes toQ = hn::Sub(values[q], values[p]), toR = hn::Sub(values[r], values[p]);
    const auto along = [&](const Lanes of[4]) HWY_ATTR
    { return hn::Sub(hn::Mul(toQ, hn::Sub(of[r], of[p])), hn::Mul(toR, hn::Sub(of[q], of[p]))); };
    const Lanes a = hn::IfThenElseZero(isSure, along(seen.Y));
    const Lanes b = hn::IfThenElseZero(isSure, hn::Neg(along(seen.X)));
    Lanes numbers[4];
    for (std::size_t vertex = 0; vertex < 4; ++vertex)
    {
      numbers[vertex] = hn::MulAdd(a, seen.X[vertex], hn::Mul(b, seen.Y[vertex]));
    }
    strips.Set(at, a, b, Choose(isSure, slab.Around(numbers), AroundVertices(numbers)), margin);
  }
  for (; left != 0; left &= left - 1)
  {
    const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    pixels[i + lane] = strips.PixelsOf(lane);
  }
}

void FindPixelsOfAllSlabs(const OutlineView& view, const SlabOutlines& cells, float width,
  std::array<std::uint64_t, 64>& pixels)
{
  for (std::size_t i = 0; i < cells.Count; i += hn::Lanes(FloatLanes()))
  {
    FindPixelsOfSlabs(view, cells, i, width, pixels);
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindPixelsOfAllSlabs);

void PixelsOfSlabs(const OutlineView& view, const SlabOutlines& cells, double width,
  std::array<std::uint64_t, 64>& pixels)
{
  // Rounded, and limited to what a value may be, as infinity times 0 is no number.
  const auto span = static_cast<float>(std::min(width, MeshDifference::Largest));
  HWY_DYNAMIC_DISPATCH(FindPixelsOfAllSlabs)(view, cells, span, pixels);
}

}
#endif
