// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The visible parts of cell segments, by bounds of their values. Kernels include this file once for
// each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsSeenParts_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsSeenParts_inl_h
#undef TemporalCoherence_KernelsSeenParts_inl_h
#else
#define TemporalCoherence_KernelsSeenParts_inl_h
#endif

#include "Volumes/Medium/KernelsCubic-inl.h"
#include "Volumes/Medium/KernelsVolumeSegments.h"

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentsKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using V = hn::Vec<Floats>;

using Line = Cubics::HWY_NAMESPACE::Cubic<V>;

/// Bounds of cubics, by their Bernstein points.
struct CubicBounds
{
  V Low, High, Slope, Bend;
};

HWY_INLINE CubicBounds BoundsOf(const Line& cubic)
{
  const Floats d;
  const V third = hn::Set(d, 1.0f / 3.0f);
  const V b0 = cubic.C[0];
  const V b1 = hn::Add(b0, hn::Mul(third, cubic.C[1]));
  const V b2 = hn::Add(hn::Add(b1, hn::Mul(third, cubic.C[1])), hn::Mul(third, cubic.C[2]));
  const V b3 = hn::Add(hn::Add(b0, cubic.C[1]), hn::Add(cubic.C[2], cubic.C[3]));
  const V r0 = hn::Sub(b1, b0), r1 = hn::Sub(b2, b1), r2 = hn::Sub(b3, b2);
  const V rise = hn::Max(hn::Abs(r0), hn::Max(hn::Abs(r1), hn::Abs(r2)));
  return { hn::Min(hn::Min(b0, b1), hn::Min(b2, b3)), hn::Max(hn::Max(b0, b1), hn::Max(b2, b3)),
    hn::Mul(hn::Set(d, 3.0f), rise), hn::Max(hn::Abs(hn::Sub(r1, r0)), hn::Abs(hn::Sub(r2, r1))) };
}

/// True where the bounds are finite and overlap a visible band.
HWY_INLINE hn::Mask<Floats> IsSeen(const CubicBounds& bounds, const SeenBins& seen)
{
  const Floats d;
  const V largest = hn::Set(d, 1e30f);
  auto any = seen.Count == 0 ? hn::Eq(largest, largest) : hn::Lt(largest, largest);
  for (std::size_t i = 0; i < seen.Count; ++i)
  {
    any = hn::Or(any,
      hn::And(hn::Le(bounds.Low, hn::Set(d, seen.Bands[i][1])),
        hn::Ge(bounds.High, hn::Set(d, seen.Bands[i][0]))));
  }
  // Cells with samples that are not finite are invisible.
  return hn::And(any,
    hn::And(hn::Lt(hn::Abs(bounds.Low), largest),
      hn::And(hn::Lt(hn::Abs(bounds.High), largest), hn::Lt(bounds.Bend, largest))));
}

/// Distance of values to the nearest visible band.
HWY_INLINE V DistanceToSeen(V value, const SeenBins& seen)
{
  const Floats d;
  V distance = hn::Set(d, seen.Count == 0 ? 0.0f : 1e30f);
  for (std::size_t i = 0; i < seen.Count; ++i)
  {
    const V below = hn::Sub(hn::Set(d, seen.Bands[i][0]), value);
    const V above = hn::Sub(value, hn::Set(d, seen.Bands[i][1]));
    distance = hn::Min(distance, hn::Max(below, above));
  }
  return hn::Max(distance, hn::Zero(d));
}

/// The visible interval of segments, in shares of them.
struct SeenPart
{
  V Begin, End;
};

/// Shrink the interval from both ends. Each leap ends where the steepest slope would reach a
/// visible band.
HWY_INLINE SeenPart PartSeen(const Line& cubic, const CubicBounds& bounds, const SeenBins& seen)
{
  const Floats d;
  constexpr int Leaps = 3;
  const V one = hn::Set(d, 1.0f);
  // Leap a little less far, as values are rounded.
  const V perValue = hn::Div(hn::Set(d, 0.999f), hn::Max(bounds.Slope, hn::Set(d, 1e-20f)));
  SeenPart part{ hn::Zero(d), one };
  for (int leap = 0; leap < Leaps; ++leap)
  {
    const V fromBegin = DistanceToSeen(cubic.At(part.Begin), seen);
    const V fromEnd = DistanceToSeen(cubic.At(part.End), seen);
    part.Begin = hn::Add(part.Begin, hn::Min(hn::Mul(fromBegin, perValue), one));
    part.End = hn::Sub(part.End, hn::Min(hn::Mul(fromEnd, perValue), one));
  }
  return part;
}

/// The cubic on a part, with parameters 0 and 1 at its ends.
HWY_INLINE Line Within(const Line& cubic, const SeenPart& part)
{
  const Floats d;
  const V x = part.Begin, width = hn::Sub(part.End, part.Begin);
  const V third = hn::Mul(hn::Set(d, 3.0f), hn::Mul(cubic.C[3], x));
  const V slope = hn::Add(cubic.C[1], hn::Mul(x, hn::Add(hn::Add(cubic.C[2], cubic.C[2]), third)));
  Line within;
  within.C[0] = cubic.At(x);
  within.C[1] = hn::Mul(width, slope);
  within.C[2] = hn::Mul(hn::Mul(width, width), hn::Add(cubic.C[2], third));
  within.C[3] = hn::Mul(hn::Mul(width, width), hn::Mul(width, cubic.C[3]));
  return within;
}

/// Appends lanes of vectors to segments.
class Appender
{
public:
  HWY_INLINE Appender(hn::Mask<Floats> lanes, VolumeSegments& found)
    : Lanes(lanes)
    , To(static_cast<std::size_t>(found.Count))
  {
  }

  // Store whole vectors, as there is room behind: stores of some lanes are slow on some machines.
  HWY_INLINE void operator()(V value, VolumeSegments::Array<float>& array) const
  {
    hn::StoreU(hn::Compress(value, this->Lanes), Floats(), &array[this->To]);
  }
  HWY_INLINE void operator()(
    const std::int32_t* from, VolumeSegments::Array<std::int32_t>& array) const
  {
    const Integers di;
    const auto lanes = hn::RebindMask(di, this->Lanes);
    hn::StoreU(hn::Compress(hn::LoadU(di, from), lanes), di, &array[this->To]);
  }

private:
  hn::Mask<Floats> Lanes;
  std::size_t To;
};

/// A vector of cell segments.
struct SegmentsOfCells
{
  V Enter, Length, Begin[3], Across[3];
  Line Values;
};

/// Append the visible parts of a vector of segments.
/// \param which lanes are segments
/// \param cells of the segments, by axis
HWY_INLINE void AppendSeen(hn::Mask<Floats> which, const SegmentsOfCells& segments,
  const std::int32_t* const cells[3], const std::int32_t* rays, const SeenBins& seen,
  VolumeSegments& found)
{
  const Floats d;
  const V half = hn::Set(d, 0.5f);
  const CubicBounds bounds = BoundsOf(segments.Values);
  const SeenPart part = PartSeen(segments.Values, bounds, seen);
  const V share = hn::Sub(part.End, part.Begin);
  const V length = hn::Mul(share, segments.Length);
  const auto isSeen =
    hn::And(which, hn::And(hn::Gt(hn::Min(share, length), hn::Zero(d)), IsSeen(bounds, seen)));
  if (hn::AllFalse(d, isSeen))
  {
    return;
  }
  const Appender append(isSeen, found);
  append(hn::Add(segments.Enter, hn::Mul(part.Begin, segments.Length)), found.Enter);
  append(length, found.Length);
  for (std::size_t a = 0; a < 3; ++a)
  {
    append(hn::Add(segments.Begin[a], hn::Mul(part.Begin, segments.Across[a])), found.Begin[a]);
    append(hn::Mul(share, segments.Across[a]), found.Across[a]);
    append(cells[a], found.Cell[a]);
  }
  const Line within = Within(segments.Values, part);
  for (std::size_t power = 0; power < 4; ++power)
  {
    append(within.C[power], found.Cubic[power]);
  }
  const CubicBounds inside = BoundsOf(within);
  append(hn::Mul(half, hn::Add(inside.Low, inside.High)), found.Middle);
  append(hn::Mul(half, hn::Sub(inside.High, inside.Low)), found.Span);
  append(inside.Bend, found.Bend);
  append(rays, found.Ray);
  found.Count += static_cast<int>(hn::CountTrue(d, isSeen));
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
