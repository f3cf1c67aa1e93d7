// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/KernelsVolumeSegments.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Blending/KernelsVolumeSegments.cxx"
#include <hwy/foreach_target.h>

#include "Blending/KernelsCubic-inl.h"
#include "Shade/KernelsPacked-inl.h"
#include "Trace/KernelsSegment-inl.h"

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

/// The paths of rays through their cells.
struct CellPaths
{
  RayBatch::Array<float> Enter, Length;
  std::array<RayBatch::Array<float>, 3> Begin, Across;
  std::array<RayBatch::Array<std::int32_t>, 3> Cell;
};

HWY_INLINE void FindPaths(const CellRow& row, CellPaths& paths)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  const hn::Rebind<float, decltype(d)> df;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  using VD = hn::Vec<decltype(d)>;
  const std::size_t count = WholeVectors(static_cast<std::size_t>(row.Walks.Rays.Count));
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    const auto rays = SegmentKernels::HWY_NAMESPACE::LoadRays(d, row.Walks.Rays, i);
    const VD cell[3] = { hn::LoadU(d, &row.Cells()[0][i]), hn::LoadU(d, &row.Cells()[1][i]),
      hn::LoadU(d, &row.Cells()[2][i]) };
    const auto path = SegmentKernels::HWY_NAMESPACE::FindPath(d, rays, cell);
    hn::StoreU(hn::DemoteTo(df, hn::Sub(path.Enter, rays.Begin)), df, &paths.Enter[i]);
    hn::StoreU(hn::DemoteTo(df, hn::Sub(path.Leave, path.Enter)), df, &paths.Length[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      hn::StoreU(hn::DemoteTo(df, path.Begin[a]), df, &paths.Begin[a][i]);
      hn::StoreU(hn::DemoteTo(df, hn::Sub(path.End[a], path.Begin[a])), df, &paths.Across[a][i]);
      hn::StoreU(hn::DemoteTo(di, cell[a]), di, &paths.Cell[a][i]);
    }
  }
}

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

/// True where something may be seen between the bounds, which are numbers.
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
  // Not where samples are not finite.
  return hn::And(any,
    hn::And(hn::Lt(hn::Abs(bounds.Low), largest),
      hn::And(hn::Lt(hn::Abs(bounds.High), largest), hn::Lt(bounds.Bend, largest))));
}

/// How far values are from what is seen.
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

/// Where something may be seen of segments, in shares of them.
struct SeenPart
{
  V Begin, End;
};

/// From both ends, leap as far as the steepest slope leaves nothing to see.
HWY_INLINE SeenPart PartSeen(const Line& cubic, const CubicBounds& bounds, const SeenBins& seen)
{
  const Floats d;
  constexpr int Leaps = 3;
  const V one = hn::Set(d, 1.0f);
  // A little less, for the rounding of values.
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

/// The same cubic, counted from where the part begins to where it ends.
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

  // Stored whole, as there is room behind: stores of some lanes are slow on some machines.
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

/// Append those parts of a vector of segments in which something may be seen.
/// \param which lanes are segments
/// \param cells their cells, by axis
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

/// \param loadCorners fills the corners of the cells from ray i on
template <typename LoadCorners>
HWY_INLINE void FindSeen(
  const CellRow& row, const LoadCorners& loadCorners, const SeenBins& seen, VolumeSegments& found)
{
  const Floats d;
  const Integers di;
  CellPaths paths;
  FindPaths(row, paths);
  RayBatch::Array<std::int32_t> rays;
  const auto count = static_cast<std::size_t>(row.Walks.Rays.Count);
  for (std::size_t i = 0; i < count; ++i)
  {
    rays[i] = static_cast<std::int32_t>(row.Walks.From[i]);
  }
  std::fill(&rays[count - 1] + 1, rays.data() + WholeVectors(count), 0);
  const auto place = hn::Set(di, static_cast<std::int32_t>(row.Place));
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    V corners[8];
    loadCorners(paths, i, corners);
    SegmentsOfCells segments;
    segments.Enter = hn::LoadU(d, &paths.Enter[i]);
    segments.Length = hn::LoadU(d, &paths.Length[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      segments.Begin[a] = hn::LoadU(d, &paths.Begin[a][i]);
      segments.Across[a] = hn::LoadU(d, &paths.Across[a][i]);
    }
    segments.Values = Cubics::HWY_NAMESPACE::CubicAlong(corners, segments.Begin, segments.Across);
    const auto isListed =
      hn::And(hn::FirstN(di, count - i), hn::Gt(hn::LoadU(di, &row.Next.Count[i]), place));
    const std::int32_t* const cells[3] = { &paths.Cell[0][i], &paths.Cell[1][i],
      &paths.Cell[2][i] };
    AppendSeen(hn::RebindMask(d, isListed), segments, cells, &rays[i], seen, found);
  }
}

void FindOfValues(
  const CellRow& row, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found)
{
  FindSeen(
    row,
    [&](const CellPaths&, std::size_t i, V values[8]) HWY_ATTR
    {
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        values[corner] = hn::LoadU(Floats(), &corners[corner][i]);
      }
    },
    seen, found);
}

template <typename T>
HWY_INLINE void FindOfSamples(const CellRow& row, const NarrowSamples<T>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  using Rows = PackedSamples::HWY_NAMESPACE::IntegerRows<T>;
  const Floats d;
  const V perValue = hn::Set(d, scale.PerValue), shift = hn::Set(d, scale.Shift);
  FindSeen(
    row,
    [&](const CellPaths& paths, std::size_t i, V values[8]) HWY_ATTR
    {
      // Not gathered, as a gather reads more than the two samples of a row.
      HWY_ALIGN std::array<std::array<std::array<T, 2>, WidestVector>, 4> rows;
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      {
        const T* const from = samples.Samples + paths.Cell[0][i + lane] +
          static_cast<std::ptrdiff_t>(paths.Cell[1][i + lane]) * samples.StrideY +
          static_cast<std::ptrdiff_t>(paths.Cell[2][i + lane]) * samples.StrideZ;
        for (std::size_t yz = 0; yz < 4; ++yz)
        {
          const T* const at =
            from + ((yz & 1u) != 0 ? samples.StrideY : 0) + ((yz & 2u) != 0 ? samples.StrideZ : 0);
          std::memcpy(&rows[yz][lane], at, sizeof(rows[yz][lane]));
        }
      }
      for (std::size_t yz = 0; yz < 4; ++yz)
      {
        typename Rows::V two[2];
        Rows::Load(rows[yz].data(), two);
        for (std::size_t x = 0; x < 2; ++x)
        {
          values[2 * yz + x] = hn::Add(hn::Mul(Rows::AsFloats(two[x]), perValue), shift);
        }
      }
    },
    seen, found);
}

void FindOfUInt8(const CellRow& row, const NarrowSamples<std::uint8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(row, samples, scale, seen, found);
}

void FindOfInt8(const CellRow& row, const NarrowSamples<std::int8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(row, samples, scale, seen, found);
}

void FindOfUInt16(const CellRow& row, const NarrowSamples<std::uint16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(row, samples, scale, seen, found);
}

void FindOfInt16(const CellRow& row, const NarrowSamples<std::int16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(row, samples, scale, seen, found);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace SegmentsKernels
{

HWY_EXPORT(FindOfValues);
HWY_EXPORT(FindOfUInt8);
HWY_EXPORT(FindOfInt8);
HWY_EXPORT(FindOfUInt16);
HWY_EXPORT(FindOfInt16);

void FindSegments(
  const CellRow& row, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfValues)(row, corners, seen, found);
}

void FindSegments(const CellRow& row, const NarrowSamples<std::uint8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfUInt8)(row, samples, scale, seen, found);
}

void FindSegments(const CellRow& row, const NarrowSamples<std::int8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfInt8)(row, samples, scale, seen, found);
}

void FindSegments(const CellRow& row, const NarrowSamples<std::uint16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfUInt16)(row, samples, scale, seen, found);
}

void FindSegments(const CellRow& row, const NarrowSamples<std::int16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfInt16)(row, samples, scale, seen, found);
}

}
}
#endif
