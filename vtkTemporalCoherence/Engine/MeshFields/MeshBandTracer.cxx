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

/// Bounds of what a ray meets in a cell.
struct Bounds
{
  double Low, High;
};

/// Bounds of the values along a ray in a hexahedron, by the linear function that they are near to.
Bounds BoundsAlong(
  const NearlyLinear& values, const RayBatch& rays, std::size_t ray, double in, double out)
{
  double atIn = values.AtZero, atOut = values.AtZero, largest = std::abs(values.AtZero);
  const double farther = std::max(std::abs(in), std::abs(out));
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double slope = values.Gradient[static_cast<int>(a)];
    const double origin = rays.Origin[a][ray], direction = rays.Direction[a][ray];
    atIn += slope * (origin + in * direction);
    atOut += slope * (origin + out * direction);
    largest += std::abs(slope) * (std::abs(origin) + farther * std::abs(direction));
  }
  // Far more than rounding errors of distances and places.
  constexpr double rounding = 1e-12;
  const double bend = values.Bend + rounding * largest;
  return { std::min(atIn, atOut) - bend, std::max(atIn, atOut) + bend };
}

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
    const std::uint64_t ofLeaf = RaysThrough(rays, wanted, rays.WalkEnd, box, tile.Margin);
    if (ofLeaf != 0)
    {
      const PreparedCells& cells =
        this->Prepared.Of(leaf.Number, 0, this->Leaves.CellsOf(leaf.Number), spare);
      cellsRead += VisitCellsOf(cells, leaf.Number, box, tile, ofLeaf, rays.WalkEnd,
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
  const NearlyLinear values = isExact ? NearlyLinear() : cells.HexahedronAt(cell).Values;
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
        Bounds bounds{ std::min(atIn, span.AtOut), std::max(atIn, span.AtOut) };
        if (!isExact)
        {
          // Two bounds, of which either may be the better one.
          const Bounds linear = BoundsAlong(values, tile.Rays, ray, span.In, span.Out);
          bounds.Low = std::max({ *least, bounds.Low - 2.0 * values.Bend, linear.Low });
          bounds.High = std::min({ *most, bounds.High + 2.0 * values.Bend, linear.High });
        }
        band.Append({ span.In, this->Unit * atIn, this->Unit * span.AtOut, this->Unit * bounds.Low,
          this->Unit * bounds.High, isFinite, beginsHere && !isExact,
          static_cast<std::uint8_t>(ray), index });
      }
    });
}

}
