// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/KernelsCells.h"

#include "Mesh/TetrahedronPoints.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/KernelsTetrahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/KernelsTetrahedronSpan-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

void CrossingsOf(
  const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  using D = Doubles;
  const D d;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const SamePoints<D, TetrahedronPoints> seen(points, axis);
    ForEachFullVector(which & rays.Along[axis],
      [&](const std::int64_t* places, std::uint64_t wanted) HWY_ATTR
      {
        const ShearedRays<D> vector(rays, hn::LoadU(hn::RebindToSigned<D>(), places));
        AppendCrossings(d, FindSpan(d, vector, seen), rays, places, wanted, found);
      });
  }
}

void SpansOf(
  const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which, CellSpans& spans)
{
  ForEachVector(rays, which, points,
    [&](auto d, const auto& seen, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    { StoreSpans(d, FindSpan(d, vector, seen), i, wanted, spans); });
}

void SpansWithin(const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which,
  double low, double high, const TileArray<double>& limits, SpanList& found)
{
  ForEachVector(rays, which, points,
    [&](auto d, const auto& seen, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    {
      const auto span = FindSpan(d, vector, seen);
      const auto isBefore = hn::Le(span.In, hn::LoadU(d, &limits[i]));
      AppendSpans(
        d, span, hn::Set(d, low), hn::Set(d, high), i, wanted & BitsOf(d, isBefore), found);
    });
}

void CrossingsOfPairs(const TurnedPairs<4>& pairs, const MeshRays& rays, Crossings& found)
{
  ForEachVectorOfPairs(rays, pairs,
    [&](auto d, const auto& seen, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    { AppendCrossings(d, FindSpan(d, vector, seen), rays, i, wanted, found); });
}

void SpansOfPairs(const TurnedPairs<4>& pairs, const MeshRays& rays, CellSpans& spans)
{
  ForEachVectorOfPairs(rays, pairs,
    [&](auto d, const auto& seen, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    { StoreSpans(d, FindSpan(d, vector, seen), i, wanted, spans); });
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

namespace
{

TurnedPairs<4> TurnPairs(
  const MeshCell* cells, const CellDifferences* differences, const MeshRays& rays)
{
  TurnedPairs<4> pairs;
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    pairs.Set(i, TetrahedronPoints(cells[i], differences[i]), rays.AxisOf(i));
  }
  pairs.FillUp(rays.Count);
  return pairs;
}

}

HWY_EXPORT(CrossingsOf);
HWY_EXPORT(SpansOf);
HWY_EXPORT(SpansWithin);
HWY_EXPORT(CrossingsOfPairs);
HWY_EXPORT(SpansOfPairs);

void TetrahedronCrossings(
  const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  HWY_DYNAMIC_DISPATCH(CrossingsOf)(points, rays, which, found);
}

void TetrahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  TetrahedronCrossings(TetrahedronPoints(cell, differences), rays, which, found);
}

void TetrahedronSpans(
  const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which, CellSpans& spans)
{
  spans.Count.fill(0);
  HWY_DYNAMIC_DISPATCH(SpansOf)(points, rays, which, spans);
}

void TetrahedronSpansWithin(const TetrahedronPoints& points, const MeshRays& rays,
  std::uint64_t which, double low, double high, const TileArray<double>& limits, SpanList& found)
{
  found.Count = 0;
  HWY_DYNAMIC_DISPATCH(SpansWithin)(points, rays, which, low, high, limits, found);
}

void TetrahedronSpans(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans)
{
  TetrahedronSpans(TetrahedronPoints(cell, differences), rays, which, spans);
}

void TetrahedronCrossingsOfPairs(
  const MeshCell* cells, const CellDifferences* differences, const MeshRays& rays, Crossings& found)
{
  HWY_DYNAMIC_DISPATCH(CrossingsOfPairs)(TurnPairs(cells, differences, rays), rays, found);
}

void TetrahedronSpansOfPairs(
  const MeshCell* cells, const CellDifferences* differences, const MeshRays& rays, CellSpans& spans)
{
  spans.Count.fill(0);
  HWY_DYNAMIC_DISPATCH(SpansOfPairs)(TurnPairs(cells, differences, rays), rays, spans);
}

}
}
#endif
