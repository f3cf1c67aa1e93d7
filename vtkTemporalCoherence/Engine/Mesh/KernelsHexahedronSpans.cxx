// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/KernelsCells.h"

#include "Mesh/FoldedSpans.h"
#include "Mesh/HexahedronFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/KernelsHexahedronSpans.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/KernelsFaceHits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

void HexahedronSpansOf(const CornerPoints<8>& points, const HexahedronFaces& faces,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans, HexahedronHits& others)
{
  ForEachVector(rays, which, points,
    [&](auto d, const auto& cell, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    {
      const SeenCorners<decltype(d)> corners(vector, cell);
      const auto see = [&](std::size_t face, auto& seen) HWY_ATTR
      {
        for (std::size_t corner = 0; corner < 4; ++corner)
        {
          const std::size_t from = faces.Corners[face][corner];
          seen.X[corner] = corners.X[from];
          seen.Y[corner] = corners.Y[from];
          seen.T[corner] = corners.T[from];
          seen.Value[corner] = corners.Value[from];
        }
      };
      FindSpans(d, see, i, wanted, spans, others);
    });
}

void HexahedronPairSpansOf(
  const TurnedPairs<24>& pairs, const MeshRays& rays, CellSpans& spans, HexahedronHits& others)
{
  ForEachVectorOfPairs(rays, pairs,
    [&](auto d, const auto& cells, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    {
      const auto see = [&](std::size_t face, auto& seen) HWY_ATTR
      {
        for (std::size_t corner = 0; corner < 4; ++corner)
        {
          const std::size_t from = 4 * face + corner;
          vector.See(cells, from, seen.X[corner], seen.Y[corner], seen.T[corner]);
          seen.Value[corner] = cells.Value(from);
        }
      };
      FindSpans(d, see, i, wanted, spans, others);
    });
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace MeshKernels
{

HWY_EXPORT(HexahedronSpansOf);
HWY_EXPORT(HexahedronPairSpansOf);

void HexahedronSpans(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::uint64_t which, CellSpans& spans)
{
  spans.Count.fill(0);
  HexahedronHits others;
  const CornerPoints<8> points = { cell.Points, differences };
  HWY_DYNAMIC_DISPATCH(HexahedronSpansOf)
  (points, HexahedronFaces(points), rays, which, spans, others);
  FindFoldedSpans(
    others, rays, [&](std::size_t) -> const MeshCell& { return cell; }, spans);
}

void HexahedronSpansOfPairs(
  const MeshCell* cells, const CellDifferences* differences, const MeshRays& rays, CellSpans& spans)
{
  spans.Count.fill(0);
  HexahedronHits others;
  TurnedPairs<24> pairs;
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    const CornerPoints<8> points = { cells[i].Points, differences[i] };
    const HexahedronFaces faces(points);
    CornerPoints<24> listed;
    for (std::size_t corner = 0; corner < 24; ++corner)
    {
      const std::size_t from = faces.Corners[corner / 4][corner % 4];
      listed.Points[corner] = points.Points[from];
      listed.Values[corner] = points.Values[from];
    }
    pairs.Set(i, listed, rays.AxisOf(i));
  }
  pairs.FillUp(rays.Count);
  HWY_DYNAMIC_DISPATCH(HexahedronPairSpansOf)(pairs, rays, spans, others);
  FindFoldedSpans(
    others, rays, [&](std::size_t ray) -> const MeshCell& { return cells[ray]; }, spans);
}

}
}
#endif
