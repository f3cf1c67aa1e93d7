// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshBandTracer.h"

#include "MeshTiles/CellValues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Leaves between two looks at which rays are done.
constexpr std::size_t LeavesAtOnce = 6;

}

MeshBandTracer::MeshBandTracer(
  const BandScene& scene, const FieldKind& kind, const MeshTree& tree, const BoxLevels& boxes)
  : Scene(scene)
  , Tree(tree)
  , Leaves(kind, tree, boxes, scene.Active)
  , Cells(tree, this->Leaves)
  , FromLowest(scene.Band.Low, scene.FiniteRange)
  , Unit(BandScale(scene.Samples.Type, scene.Band, scene.FiniteRange).Isovalues.Factor /
      this->FromLowest.Unit())
{
}

std::int64_t MeshBandTracer::Trace(const RayBatch& rays, TileKnots& knots) const
{
  MeshBandRays band(this->Scene, rays);
  const MeshTile tile(rays, this->Tree, this->Leaves, RayLimits::None);
  std::uint64_t wanted = RaysWithWalk(rays);
  std::int64_t cellsRead = 0;
  LeafCells::Leaf spare;
  for (std::size_t i = 0; i < tile.Leaves.size() && wanted != 0; ++i)
  {
    const ActiveLeaves::Leaf& leaf = tile.Leaves[i];
    if (i % LeavesAtOnce == 0)
    {
      wanted &= ~band.GoOnTo(DistancesAt(tile, leaf.Depth));
    }
    const std::uint64_t ofLeaf =
      RaysThrough(rays, wanted, rays.WalkEnd, this->Tree.LeafBox(leaf.Number), tile.Margin);
    if (ofLeaf != 0)
    {
      cellsRead += VisitCellsOf(this->Cells.Of(leaf.Number, spare), tile, ofLeaf, rays.WalkEnd,
        [&](const ActiveCell& cell, std::uint64_t which)
        { this->Append(cell, tile, which, band); });
    }
  }
  band.GoOnTo(DistancesAt(tile, Infinity));
  band.HandOver(knots);
  return cellsRead;
}

/// How far each ray has come where it comes to a depth.
RayBatch::Array<double> MeshBandTracer::DistancesAt(const MeshTile& tile, double depth)
{
  RayBatch::Array<double> distances;
  const RayBatch& rays = tile.Rays;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const double from =
      tile.Grid.DepthOf({ rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray] });
    const double per =
      tile.Grid.DepthOf({ rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray] });
    constexpr double slack = 1e-9;
    const double distance = (depth - from) / per;
    distances[ray] = depth == Infinity ? Infinity
      : per > 0.0                      ? distance - slack * std::abs(distance)
                                       : -Infinity;
  }
  return distances;
}

void MeshBandTracer::Append(
  const ActiveCell& cell, const MeshTile& tile, std::uint64_t which, MeshBandRays& band) const
{
  MeshKernels::CellDifferences differences;
  this->FromLowest.Of(cell.Cell, differences);
  const auto count = static_cast<std::ptrdiff_t>(cell.Cell.NumberOfPoints());
  const bool isFinite = std::all_of(cell.Cell.Values.begin(), cell.Cell.Values.begin() + count,
    [](double value) { return std::isfinite(value); });
  const auto [least, most] = std::minmax_element(differences.begin(), differences.begin() + count);
  const glm::ivec3 place = MeshTree::PlaceOf(cell.Rank);
  const CellIndex index = { static_cast<std::uint16_t>(place.x),
    static_cast<std::uint16_t>(place.y), static_cast<std::uint16_t>(place.z) };

  MeshKernels::CellSpans spans;
  const bool isExact = cell.Cell.Shape == MeshCellShape::Tetrahedron;
  const double bend = isExact ? 0.0 : BendOf(cell.Cell.Points, differences);
  (isExact ? MeshKernels::TetrahedronSpans : MeshKernels::HexahedronSpans)(
    cell.Cell, differences, tile.InMesh, which, spans);
  ForEachRay(which,
    [&](std::size_t ray)
    {
      const double begin = tile.Rays.Begin[ray], end = tile.Rays.End[ray];
      for (std::size_t i = 0; i < spans.Count[ray]; ++i)
      {
        const MeshKernels::CellSpan& span = spans.Spans[ray][i];
        if (span.Out < begin || span.In > end)
        {
          continue;
        }
        // Where a ray begins within a tetrahedron, its values are linear.
        const bool beginsHere = span.In < begin;
        const double share = isExact && beginsHere ? (begin - span.In) / (span.Out - span.In) : 0.0;
        const double atIn = (1.0 - share) * span.AtIn + share * span.AtOut;
        const double low = std::max(*least, std::min(atIn, span.AtOut) - bend);
        const double high = std::min(*most, std::max(atIn, span.AtOut) + bend);
        band.Append({ span.In, this->Unit * atIn, this->Unit * span.AtOut, this->Unit * low,
          this->Unit * high, isFinite, beginsHere && !isExact, static_cast<std::uint8_t>(ray),
          index });
      }
    });
}

}
