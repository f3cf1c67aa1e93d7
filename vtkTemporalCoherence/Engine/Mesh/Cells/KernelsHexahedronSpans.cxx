// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsCells.h"

#include "Mesh/Cells/FoldedSpans.h"
#include "Mesh/Cells/HexahedronFaces.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsHexahedronSpans.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/Cells/KernelsFaceHits-inl.h"

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
    { FindSpans(d, SeenCorners<decltype(d)>(vector, cell), faces, i, wanted, spans, others); });
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

void HexahedronSpans(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::uint64_t which, CellSpans& spans)
{
  spans.Count.fill(0);
  HexahedronHits others;
  const CornerPoints<8> points = { cell.Points, differences };
  HWY_DYNAMIC_DISPATCH(HexahedronSpansOf)
  (points, HexahedronFaces(points), rays, which, spans, others);
  FindFoldedSpans(cell, others, rays, spans);
}

}
}
#endif
