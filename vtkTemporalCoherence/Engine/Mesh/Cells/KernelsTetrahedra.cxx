// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsCells.h"

#include "Mesh/Cells/TetrahedronPoints.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsTetrahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/Cells/KernelsTetrahedronSpan-inl.h"

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

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace MeshKernels
{

HWY_EXPORT(CrossingsOf);
HWY_EXPORT(SpansOf);
HWY_EXPORT(SpansWithin);

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

void TetrahedronSpansWithin(const TetrahedronPoints& points, const MeshRays& rays,
  std::uint64_t which, double low, double high, const TileArray<double>& limits, SpanList& found)
{
  found.Count = 0;
  HWY_DYNAMIC_DISPATCH(SpansWithin)(points, rays, which, low, high, limits, found);
}

void TetrahedronSpans(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans)
{
  spans.Count.fill(0);
  HWY_DYNAMIC_DISPATCH(SpansOf)(TetrahedronPoints(cell, differences), rays, which, spans);
}

}
}
#endif
