// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Medium/KernelsVolumeSegments.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Volumes/Medium/KernelsVolumeSegments.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsPacked-inl.h"
#include "Lattice/KernelsSegment-inl.h"
#include "Volumes/Medium/KernelsSeenParts-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentsKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

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
      // Copy the samples, as a gather reads more than the two samples of a row.
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
