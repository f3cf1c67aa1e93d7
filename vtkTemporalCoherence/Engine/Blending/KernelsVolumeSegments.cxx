// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/KernelsVolumeSegments.h"

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

HWY_INLINE void FindPaths(const RayWalks& walks, CellPaths& paths)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  const hn::Rebind<float, decltype(d)> df;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  using VD = hn::Vec<decltype(d)>;
  const std::size_t count = WholeVectors(static_cast<std::size_t>(walks.Rays.Count));
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    const auto rays = SegmentKernels::HWY_NAMESPACE::LoadRays(d, walks.Rays, i);
    const VD cell[3] = { hn::LoadU(d, &walks.Cell[0][i]), hn::LoadU(d, &walks.Cell[1][i]),
      hn::LoadU(d, &walks.Cell[2][i]) };
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

/// Bounds of cubics, by their Bernstein points.
struct CubicBounds
{
  V Low, High, Bend;
};

HWY_INLINE CubicBounds BoundsOf(const Cubics::HWY_NAMESPACE::Cubic<V>& cubic)
{
  const Floats d;
  const V third = hn::Set(d, 1.0f / 3.0f);
  const V b0 = cubic.C[0];
  const V b1 = hn::Add(b0, hn::Mul(third, cubic.C[1]));
  const V b2 = hn::Add(hn::Add(b1, hn::Mul(third, cubic.C[1])), hn::Mul(third, cubic.C[2]));
  const V b3 = hn::Add(hn::Add(b0, cubic.C[1]), hn::Add(cubic.C[2], cubic.C[3]));
  const V first = hn::Sub(hn::Sub(b2, b1), hn::Sub(b1, b0));
  const V second = hn::Sub(hn::Sub(b3, b2), hn::Sub(b2, b1));
  return { hn::Min(hn::Min(b0, b1), hn::Min(b2, b3)), hn::Max(hn::Max(b0, b1), hn::Max(b2, b3)),
    hn::Max(hn::Abs(first), hn::Abs(second)) };
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

/// \param loadCorners fills the corners of the cells from ray i on
template <typename LoadCorners>
HWY_INLINE void FindSeen(const RayWalks& walks, const LoadCorners& loadCorners,
  const SeenBins& seen, VolumeSegments& found)
{
  const Floats d;
  const Integers di;
  CellPaths paths;
  FindPaths(walks, paths);
  const auto count = static_cast<std::size_t>(walks.Rays.Count);
  std::size_t to = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    V corners[8], begin[3], across[3];
    loadCorners(paths, i, corners);
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = hn::LoadU(d, &paths.Begin[a][i]);
      across[a] = hn::LoadU(d, &paths.Across[a][i]);
    }
    const V length = hn::LoadU(d, &paths.Length[i]);
    const auto cubic = Cubics::HWY_NAMESPACE::CubicAlong(corners, begin, across);
    const CubicBounds bounds = BoundsOf(cubic);
    const auto isPath = hn::And(hn::FirstN(d, count - i), hn::Gt(length, hn::Zero(d)));
    const auto isSeen = hn::And(isPath, IsSeen(bounds, seen));
    const auto keep = [&](V value, VolumeSegments::Array<float>& array) HWY_ATTR
    { hn::CompressStore(value, isSeen, d, &array[to]); };
    const auto keepWhole = [&](const std::int32_t* from, VolumeSegments::Array<std::int32_t>& array)
                             HWY_ATTR
    { hn::CompressStore(hn::LoadU(di, from), hn::RebindMask(di, isSeen), di, &array[to]); };
    keep(hn::LoadU(d, &paths.Enter[i]), found.Enter);
    keep(length, found.Length);
    for (std::size_t a = 0; a < 3; ++a)
    {
      keep(begin[a], found.Begin[a]);
      keep(across[a], found.Across[a]);
      keepWhole(&paths.Cell[a][i], found.Cell[a]);
    }
    for (std::size_t power = 0; power < 4; ++power)
    {
      keep(cubic.C[power], found.Cubic[power]);
    }
    keep(hn::Mul(hn::Set(d, 0.5f), hn::Add(bounds.Low, bounds.High)), found.Middle);
    keep(hn::Mul(hn::Set(d, 0.5f), hn::Sub(bounds.High, bounds.Low)), found.Span);
    keep(bounds.Bend, found.Bend);
    std::int32_t rays[WidestVector];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      rays[lane] = static_cast<std::int32_t>(i + lane < count ? walks.From[i + lane] : 0);
    }
    keepWhole(rays, found.Ray);
    to += hn::CountTrue(d, isSeen);
  }
  found.Count = static_cast<int>(to);
}

void FindOfValues(
  const RayWalks& walks, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found)
{
  FindSeen(
    walks,
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
HWY_INLINE void FindOfSamples(const RayWalks& walks, const NarrowSamples<T>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  using Rows = PackedSamples::HWY_NAMESPACE::IntegerRows<T>;
  const Floats d;
  const V perValue = hn::Set(d, scale.PerValue), shift = hn::Set(d, scale.Shift);
  FindSeen(
    walks,
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
        typename Rows::V row[2];
        Rows::Load(rows[yz].data(), row);
        for (std::size_t x = 0; x < 2; ++x)
        {
          values[2 * yz + x] = hn::Add(hn::Mul(Rows::AsFloats(row[x]), perValue), shift);
        }
      }
    },
    seen, found);
}

void FindOfUInt8(const RayWalks& walks, const NarrowSamples<std::uint8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(walks, samples, scale, seen, found);
}

void FindOfInt8(const RayWalks& walks, const NarrowSamples<std::int8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(walks, samples, scale, seen, found);
}

void FindOfUInt16(const RayWalks& walks, const NarrowSamples<std::uint16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(walks, samples, scale, seen, found);
}

void FindOfInt16(const RayWalks& walks, const NarrowSamples<std::int16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  FindOfSamples(walks, samples, scale, seen, found);
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
  const RayWalks& rays, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfValues)(rays, corners, seen, found);
}

void FindSegments(const RayWalks& rays, const NarrowSamples<std::uint8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfUInt8)(rays, samples, scale, seen, found);
}

void FindSegments(const RayWalks& rays, const NarrowSamples<std::int8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfInt8)(rays, samples, scale, seen, found);
}

void FindSegments(const RayWalks& rays, const NarrowSamples<std::uint16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfUInt16)(rays, samples, scale, seen, found);
}

void FindSegments(const RayWalks& rays, const NarrowSamples<std::int16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found)
{
  HWY_DYNAMIC_DISPATCH(FindOfInt16)(rays, samples, scale, seen, found);
}

}
}
#endif
