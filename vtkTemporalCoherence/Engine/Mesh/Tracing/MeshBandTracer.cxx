// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshBandTracer.h"

#include "Mesh/Tiles/CellVisits.h"
#include "Mesh/Tiles/MeshDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Most passages of a tile that wait until rays take note of them.
constexpr std::size_t MostAhead = 4096;

/// Leaves between two checks whether all rays of a tile have ended.
constexpr std::size_t LeavesAtOnce = 8;

/// Bound of the rounding errors of depths, as a share of a depth.
constexpr double RoundingOfDepth = 1e-9;

bool AreFinite(const double* differences, std::size_t count)
{
  bool areFinite = true;
  for (std::size_t i = 0; i < count; ++i)
  {
    areFinite &= MeshDifference::IsFinite(differences[i]);
  }
  return areFinite;
}

/// The depth of a ray: From + distance Per.
struct DepthOfRay
{
  DepthOfRay(const MeshTile& tile, std::size_t ray)
  {
    const RayBatch& rays = tile.Rays;
    this->From =
      tile.Grid.DepthOf({ rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray] });
    this->Per =
      tile.Grid.DepthOf({ rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray] });
  }

  double From, Per;
};

/// Bounds of the values along a ray in a cell.
struct Bounds
{
  double Low, High;
};

/// Bounds of the values along a ray in a hexahedron, from their linear fit.
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
  const BandScene& scene, const FieldShape& shape, const MeshTree& tree, const BoxLevels& boxes)
  : Scene(scene)
  , Tree(tree)
  , Leaves(shape, tree, boxes, scene.Active)
  , Unit(BandScale(scene.Samples.Type, scene.Band, scene.FiniteRange).Isovalues.Factor /
      MeshDifference(scene.Band.Low, scene.FiniteRange).Unit())
  , Width(BandScale(scene.Samples.Type, scene.Band, scene.FiniteRange).Span / this->Unit)
  , Prepared(tree, { scene.Band.Low }, scene.FiniteRange, CellPurpose::Bands,
      this->IsSolid() ? Infinity : this->Width)
{
}

std::int64_t MeshBandTracer::Trace(const RayBatch& rays, TileKnots& knots) const
{
  MeshBandRays band(this->Scene, rays);
  const MeshTile tile(rays, this->Tree, this->Leaves, RayLimits::None);
  const std::uint64_t wanted = RaysWithWalk(rays);
  std::int64_t cellsRead = 0;
  PreparedCells spare;
  std::size_t mostAhead = MostAhead;
  bool hasRoom = true;
  for (std::size_t i = 0; i < tile.Leaves.size() && hasRoom; ++i)
  {
    const ActiveLeaves::Leaf& leaf = tile.Leaves[i];
    if (i % LeavesAtOnce == 0 && leaf.Depth > FarthestDepth(tile, wanted, band.Limits()))
    {
      break; // all rays have ended
    }
    const FloatBox& box = this->Tree.LeafBox(leaf.Number);
    const std::uint64_t ofLeaf = RaysThrough(rays, wanted, band.Limits(), box, tile.Margin);
    if (ofLeaf != 0)
    {
      const PreparedCells& cells =
        this->Prepared.Of(leaf.Number, 0, this->Leaves.CellsOf(leaf.Number), spare);
      cellsRead += this->Visit(cells, leaf.Number, tile, ofLeaf, band);
    }
    if (band.NumberAhead() > mostAhead)
    {
      hasRoom = band.GoOnTo(DistancesAt(tile, leaf.Depth));
      mostAhead = std::max(MostAhead, 2 * band.NumberAhead());
    }
  }
  band.GoOnTo(DistancesAt(tile, Infinity));
  band.HandOver(knots);
  return cellsRead;
}

/// Linear fit of a hexahedron's differences from the middle of the band. Bend includes half of the
/// band, so the difference may be 0 wherever values are within the band.
NearlyLinear MeshBandTracer::FromMiddle(const PreparedHexahedron& cell) const
{
  NearlyLinear values = cell.Values;
  values.AtZero -= 0.5 * this->Width;
  values.Bend += 0.5 * this->Width + MeshDifference::Slack(this->Width);
  const bool isAll = this->IsSolid() || !AreFinite(cell.Differences.data(), 8);
  return isAll ? NearlyLinear() : values;
}

/// Visit the cells of a leaf that rays pass.
/// \return their number
std::int64_t MeshBandTracer::Visit(const PreparedCells& cells, std::int64_t leaf,
  const MeshTile& tile, std::uint64_t wanted, MeshBandRays& band) const
{
  const auto placeOf = [&](std::size_t cell)
  {
    const glm::ivec3 place =
      MeshTree::PlaceOf(MeshLattice::SizeOfBlock * leaf + cells.Places[cell]);
    return CellIndex{ static_cast<std::uint16_t>(place.x), static_cast<std::uint16_t>(place.y),
      static_cast<std::uint16_t>(place.z) };
  };
  return VisitCellsOf(cells, leaf, this->Tree.LeafBox(leaf), tile, wanted, band.Limits(),
    [&](std::size_t cell, std::uint64_t which)
    {
      if (cells.IsTetrahedron(cell))
      {
        this->Append(cells.Tetrahedra[cell], placeOf(cell), tile, which, band);
        return;
      }
      const PreparedHexahedron& hexahedron = cells.HexahedronAt(cell);
      which = RaysAcross(tile.Rays, which, band.Limits(), hexahedron.Box, tile.MarginOfLanes,
        this->FromMiddle(hexahedron));
      if (which != 0)
      {
        this->Append(hexahedron, placeOf(cell), tile, which, band);
      }
    });
}

/// The largest depth of some rays at their limits.
double MeshBandTracer::FarthestDepth(
  const MeshTile& tile, std::uint64_t which, const RayBatch::Array<double>& limits)
{
  double farthest = -Infinity;
  ForEachRay(which,
    [&](std::size_t ray)
    {
      const DepthOfRay depth(tile, ray);
      const double way = limits[ray] * depth.Per;
      const double slack = RoundingOfDepth * (std::abs(depth.From) + std::abs(way));
      if (limits[ray] > -Infinity)
      {
        farthest = std::max(farthest, depth.Per > 0.0 ? depth.From + way + slack : Infinity);
      }
    });
  return farthest;
}

/// The distance at which each ray reaches a depth.
RayBatch::Array<double> MeshBandTracer::DistancesAt(const MeshTile& tile, double depth)
{
  RayBatch::Array<double> distances;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(tile.Rays.Count); ++ray)
  {
    const DepthOfRay ofRay(tile, ray);
    const double distance = (depth - ofRay.From) / ofRay.Per;
    distances[ray] = depth == Infinity ? Infinity
      : ofRay.Per > 0.0                ? distance - RoundingOfDepth * std::abs(distance)
                                       : -Infinity;
  }
  return distances;
}

void MeshBandTracer::Append(const MeshKernels::TetrahedronPoints& cell, const CellIndex& index,
  const MeshTile& tile, std::uint64_t which, MeshBandRays& band) const
{
  const bool isFinite = AreFinite(cell.Values.data(), cell.Values.size());
  // Solids, and cells with infinities, also need spans beside the band.
  const bool isAll = !isFinite || this->IsSolid();
  const double slack = isAll ? Infinity : MeshDifference::Slack(this->Width);
  MeshKernels::SpanList spans;
  MeshKernels::TetrahedronSpansWithin(
    cell, tile.InMesh, which, -slack, this->Width + slack, band.Limits(), spans);
  for (std::size_t i = 0; i < spans.Count; ++i)
  {
    const std::size_t ray = spans.Ray[i];
    const double begin = tile.Rays.Begin[ray], in = spans.In[i], out = spans.Out[i];
    if (out < begin || in > tile.Rays.End[ray])
    {
      continue;
    }
    // Interpolate the first value of a ray that begins in the tetrahedron, where values are linear.
    const double share = in < begin ? (begin - in) / (out - in) : 0.0;
    const double atIn = this->Unit * ((1.0 - share) * spans.AtIn[i] + share * spans.AtOut[i]);
    const double atOut = this->Unit * spans.AtOut[i];
    band.Append({ in, out, atIn, atOut, std::min(atIn, atOut), std::max(atIn, atOut), isFinite,
      false, spans.Ray[i], index });
  }
}

namespace
{

/// Some rays of a tile, packed into full vectors.
struct PackedRays
{
  PackedRays(const MeshKernels::MeshRays& rays, std::uint64_t which)
  {
    this->Rays.Count = 0;
    this->Rays.Along = {};
    ForEachRay(which,
      [&](std::size_t ray)
      {
        const std::size_t at = this->Rays.Count++;
        this->From[at] = static_cast<std::uint8_t>(ray);
        this->Rays.Take(rays, ray, at);
      });
    this->Rays.FillUp();
  }

  MeshKernels::MeshRays Rays;
  std::array<std::uint8_t, MeshKernels::MeshRays::Capacity> From;
};

/// Bits of packed rays that miss a hexahedron so closely that a search, which allows for rounding
/// errors, might find crossings in it.
/// \param spans of all packed rays in the cell
std::uint64_t RaysBeside(
  const PreparedHexahedron& cell, const PackedRays& packed, const MeshKernels::CellSpans& spans)
{
  constexpr double larger = 1.0 + 1e-8; // rounding errors are smaller up to 10^6 cells away
  std::uint64_t beside = 0;
  for (std::size_t at = 0; at < packed.Rays.Count; ++at)
  {
    beside |= static_cast<std::uint64_t>(spans.Count[at] == 0) << at;
  }
  if (beside == 0)
  {
    return 0;
  }
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& point : cell.Cell.Points)
  {
    middle += 0.125 * point;
  }
  MeshCell around = cell.Cell;
  for (glm::dvec3& point : around.Points)
  {
    point = middle + larger * (point - middle);
  }
  MeshKernels::CellSpans spansAround;
  MeshKernels::HexahedronSpans(around, cell.Differences, packed.Rays, beside, spansAround);
  std::uint64_t close = 0;
  ForEachRay(beside,
    [&](std::size_t at) { close |= static_cast<std::uint64_t>(spansAround.Count[at] > 0) << at; });
  return close;
}

}

void MeshBandTracer::Append(const PreparedHexahedron& cell, const CellIndex& index,
  const MeshTile& tile, std::uint64_t which, MeshBandRays& band) const
{
  if (cell.Folds)
  {
    ForEachRay(which, [&](std::size_t ray) { band.GiveUp(ray); });
    return;
  }
  MeshKernels::CellSpans spans;
  const PackedRays packed(tile.InMesh, which);
  const std::size_t count = packed.Rays.Count;
  MeshKernels::HexahedronSpans(cell.Cell, cell.Differences, packed.Rays,
    ~std::uint64_t(0) >> (MeshKernels::MeshRays::Capacity - count), spans);
  ForEachRay(
    RaysBeside(cell, packed, spans), [&](std::size_t at) { band.GiveUp(packed.From[at]); });
  const auto& differences = cell.Differences;
  const bool isFinite = AreFinite(differences.data(), differences.size());
  const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
  for (std::size_t at = 0; at < count; ++at)
  {
    const std::size_t ray = packed.From[at];
    const double begin = tile.Rays.Begin[ray], stop = tile.Rays.End[ray];
    const bool isSimple = isFinite && spans.Count[at] == 1;
    for (std::size_t i = 0; i < spans.Count[at]; ++i)
    {
      const MeshKernels::CellSpan& span = spans.Spans[at][i];
      if (span.Out < begin || span.In > stop)
      {
        continue;
      }
      // Take the tighter of two bounds.
      const double bend = 2.0 * cell.Values.Bend;
      const Bounds linear = BoundsAlong(cell.Values, tile.Rays, ray, span.In, span.Out);
      const double low = std::max({ *least, std::min(span.AtIn, span.AtOut) - bend, linear.Low });
      const double high = std::min({ *most, std::max(span.AtIn, span.AtOut) + bend, linear.High });
      band.Append(
        { span.In, span.Out, this->Unit * span.AtIn, this->Unit * span.AtOut, this->Unit * low,
          this->Unit * high, isSimple, span.In < begin, static_cast<std::uint8_t>(ray), index });
    }
  }
}

}
