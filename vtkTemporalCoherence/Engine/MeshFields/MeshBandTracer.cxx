// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshBandTracer.h"

#include "MeshTiles/CellVisits.h"
#include "MeshTiles/MeshDifference.h"

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
  , Prepared(tree, { scene.Band.Low }, scene.FiniteRange, CellPurpose::Bands)
  , Unit(BandScale(scene.Samples.Type, scene.Band, scene.FiniteRange).Isovalues.Factor /
      MeshDifference(scene.Band.Low, scene.FiniteRange).Unit())
{
}

std::int64_t MeshBandTracer::Trace(const RayBatch& rays, TileKnots& knots) const
{
  MeshBandRays band(this->Scene, rays);
  const MeshTile tile(rays, this->Tree, this->Leaves, RayLimits::None);
  std::uint64_t wanted = RaysWithWalk(rays);
  std::int64_t cellsRead = 0;
  PreparedCells spare;
  for (std::size_t i = 0; i < tile.Leaves.size() && wanted != 0; ++i)
  {
    const ActiveLeaves::Leaf& leaf = tile.Leaves[i];
    if (i % LeavesAtOnce == 0)
    {
      wanted &= ~band.GoOnTo(DistancesAt(tile, leaf.Depth));
    }
    const FloatBox& box = this->Tree.LeafBox(leaf.Number);
    const std::uint64_t ofLeaf = RaysThrough(rays, rays.WalkEnd, box, tile.Margin) & wanted;
    if (ofLeaf != 0)
    {
      const PreparedCells& cells =
        this->Prepared.Of(leaf.Number, 0, this->Leaves.CellsOf(leaf.Number), spare);
      cellsRead += VisitCellsOf(cells, box, tile, ofLeaf, rays.WalkEnd,
        [&](std::size_t cell, std::uint64_t which)
        { this->Append(cells, cell, leaf.Number, tile, which, band); });
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

namespace
{

/// Find the parts of rays in a prepared cell.
/// \return its differences
const double* FindSpans(const PreparedCells& cells, std::size_t cell,
  const MeshKernels::MeshRays& rays, std::uint64_t which, MeshKernels::CellSpans& spans)
{
  if (cells.IsTetrahedron(cell))
  {
    const MeshKernels::TetrahedronPoints& points = cells.Tetrahedra[cell];
    MeshKernels::TetrahedronSpans(points, rays, which, spans);
    return points.Values.data();
  }
  const PreparedHexahedron& hexahedron = cells.HexahedronAt(cell);
  MeshKernels::HexahedronSpans(hexahedron.Cell, hexahedron.Differences, rays, which, spans);
  return hexahedron.Differences.data();
}

}

void MeshBandTracer::Append(const PreparedCells& cells, std::size_t cell, std::int64_t leaf,
  const MeshTile& tile, std::uint64_t which, MeshBandRays& band) const
{
  MeshKernels::CellSpans spans;
  const bool isExact = cells.IsTetrahedron(cell);
  const double* const differences = FindSpans(cells, cell, tile.InMesh, which, spans);
  const double* const end = differences + (isExact ? 4 : 8);
  const bool isFinite = std::all_of(differences, end, MeshDifference::IsFinite);
  const auto [least, most] = std::minmax_element(differences, end);
  const double bend = isExact ? 0.0 : 2.0 * cells.HexahedronAt(cell).Values.Bend;
  const glm::ivec3 place = MeshTree::PlaceOf(MeshLattice::SizeOfBlock * leaf + cells.Places[cell]);
  const CellIndex index = { static_cast<std::uint16_t>(place.x),
    static_cast<std::uint16_t>(place.y), static_cast<std::uint16_t>(place.z) };
  ForEachRay(which,
    [&](std::size_t ray)
    {
      const double begin = tile.Rays.Begin[ray], stop = tile.Rays.End[ray];
      for (std::size_t i = 0; i < spans.Count[ray]; ++i)
      {
        const MeshKernels::CellSpan& span = spans.Spans[ray][i];
        if (span.Out < begin || span.In > stop)
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
