// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshTracer.h"

#include "Lattice/HitRules.h"
#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Tiles/CellVisits.h"
#include "Mesh/Tracing/MeshSolids.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace TemporalCoherence
{

MeshTracer::MeshTracer(const TraceScene& scene, const FieldShape& shape, const MeshTree& tree,
  const BoxLevels& boxes, std::shared_ptr<const PreparedLeaves> prepared)
  : Isosurfaces(scene.Isosurfaces)
  , Tree(tree)
  , Leaves(shape, tree, boxes, scene.Active)
  , Prepared(std::move(prepared))
{
}

/// Call take(met) for all crossings found in a cell.
template <typename Take>
void MeshTracer::TakeCrossings(std::size_t surface, CellNumber number,
  const MeshKernels::Crossings& found, const Take& take) const
{
  const auto isovalue = static_cast<SurfaceIndex>(surface);
  const double value = this->IsovalueOf(surface);
  for (std::size_t i = 0; i < found.Count; ++i)
  {
    const HitKind kind = HitRules::KindOf(!found.Rises[i]);
    take(MetInCell{ { found.T[i], kind, value }, isovalue, found.Ray[i], number });
  }
}

/// Call take(met) for the first point of each part of a ray in the solid of a cell.
template <typename Take>
void MeshTracer::TakeSolids(std::size_t surface, CellNumber number, const MeshCell& cell,
  const MeshKernels::CellDifferences& differences, const RayBatch& rays,
  const MeshKernels::MeshRays& inMesh, std::uint64_t which, const Take& take) const
{
  const auto isovalue = static_cast<SurfaceIndex>(surface);
  const double value = this->IsovalueOf(surface);
  std::vector<SolidPart> parts;
  AppendSolidParts(cell, differences, number, rays, inMesh, which, parts);
  for (const SolidPart& part : parts)
  {
    take(MetInCell{ { part.From, part.Kind, value }, isovalue, part.Ray, number });
  }
}

/// Search a cell for one surface: every crossing, or with THRESHOLD the first point of each ray in
/// the solid.
/// \param take called as take(met)
template <typename Take>
void MeshTracer::Search(std::size_t surface, const PreparedCells& cells, std::size_t at,
  const MeshTile& tile, std::uint64_t which, const Take& take) const
{
  const CellNumber number = cells.Numbers[at];
  if (this->IsSolid())
  {
    const SolidCell cell = cells.SolidAt(at);
    this->TakeSolids(
      surface, number, cell.Cell, cell.Differences, tile.Rays, tile.InMesh, which, take);
    return;
  }
  MeshKernels::Crossings found;
  if (cells.IsTetrahedron(at))
  {
    MeshKernels::TetrahedronCrossings(cells.Tetrahedra[at], tile.InMesh, which, found);
  }
  else
  {
    const PreparedHexahedron& cell = cells.HexahedronAt(at);
    MeshKernels::HexahedronCrossings(
      cell.Functions, cell.Cell, cell.Differences, tile.InMesh, which, found);
  }
  this->TakeCrossings(surface, number, found, take);
}

void MeshTracer::Trace(const RayBatch& rays, HitBatch& hits) const
{
  hits.Clear(rays.Count);
  const std::uint64_t wanted = RaysWithWalk(rays);
  if (wanted == 0)
  {
    return;
  }
  const MeshTile tile(rays, this->Tree, this->Leaves, this->LimitsOfRays());
  RayBatch::Array<double> limits = rays.WalkEnd;
  hits.CellsRead = VisitCells(tile, this->Leaves, *this->Prepared, wanted, limits,
    [&](std::size_t surface, const PreparedCells& cells, std::size_t at, std::uint64_t which)
    {
      this->Search(surface, cells, at, tile, which,
        [&](const MetInCell& met)
        {
          KeepNearest(met, this->Isosurfaces.Isovalues, hits);
          limits[met.Ray] = std::min(limits[met.Ray], met.Surface.Distance);
        });
    });
}

SearchedCells MeshTracer::SearchCells(
  const RayBatch& rays, const RayCells& cells, HitBatch& hits) const
{
  std::shared_ptr<RecentHexahedra>& recent = this->Recent.Local();
  if (!recent)
  {
    recent = std::make_shared<RecentHexahedra>();
  }
  return MeshCellSearch(this->Isosurfaces, this->Tree, this->Prepared->Differences(), *recent)
    .Search(rays, cells, hits);
}

void MeshTracer::FindNext(const RayBatch& rays, HitBatch& hits) const
{
  const HitRules rules(this->Isosurfaces, false);
  RayBatch::Array<MetSurface> last;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    last[ray] = LastOn(rules, rays.Begin[ray], ray, hits);
  }
  hits.Clear(rays.Count);
  for (const MetInCell& met : this->FindAll(rays, RaysWithWalk(rays), hits.CellsRead))
  {
    if (IsInFront(last[met.Ray], met.Surface))
    {
      KeepNearest(met, this->Isosurfaces.Isovalues, hits);
    }
  }
}

/// All surfaces of some rays, ray by ray, each from front to back.
/// \throws std::bad_alloc
std::vector<MetInCell> MeshTracer::FindAll(
  const RayBatch& rays, std::uint64_t wanted, std::int64_t& cellsRead) const
{
  std::vector<MetInCell> all;
  if (wanted == 0)
  {
    return all;
  }
  const MeshTile tile(rays, this->Tree, this->Leaves, this->LimitsOfRays());
  if (this->IsSolid())
  {
    this->FindSolids(tile, wanted, cellsRead, all);
  }
  else
  {
    this->FindCrossings(tile, wanted, cellsRead, all);
  }
  std::sort(all.begin(), all.end(),
    [](const MetInCell& a, const MetInCell& b)
    {
      if (a.Ray != b.Ray)
      {
        return a.Ray < b.Ray;
      }
      return IsInFront(a.Surface, b.Surface) ||
        (!IsInFront(b.Surface, a.Surface) && a.Cell < b.Cell);
    });
  return all;
}

void MeshTracer::FindCrossings(const MeshTile& tile, std::uint64_t wanted, std::int64_t& cellsRead,
  std::vector<MetInCell>& all) const
{
  cellsRead += VisitCells(tile, this->Leaves, *this->Prepared, wanted, tile.Rays.WalkEnd,
    [&](std::size_t surface, const PreparedCells& cells, std::size_t at, std::uint64_t which)
    {
      this->Search(
        surface, cells, at, tile, which, [&](const MetInCell& met) { all.push_back(met); });
    });
}

/// Find where rays enter solids. Merges parts in touching cells.
void MeshTracer::FindSolids(const MeshTile& tile, std::uint64_t wanted, std::int64_t& cellsRead,
  std::vector<MetInCell>& all) const
{
  std::vector<std::vector<SolidPart>> ofSurfaces(this->Isosurfaces.Isovalues.size());
  cellsRead += VisitCells(tile, this->Leaves, *this->Prepared, wanted, tile.Rays.WalkEnd,
    [&](std::size_t surface, const PreparedCells& cells, std::size_t at, std::uint64_t which)
    {
      const SolidCell cell = cells.SolidAt(at);
      AppendSolidParts(cell.Cell, cell.Differences, cells.Numbers[at], tile.Rays, tile.InMesh,
        which, ofSurfaces[surface]);
    });
  for (std::size_t surface = 0; surface < ofSurfaces.size(); ++surface)
  {
    std::vector<SolidPart>& parts = ofSurfaces[surface];
    std::sort(parts.begin(), parts.end(),
      [](const SolidPart& a, const SolidPart& b)
      {
        return a.Ray != b.Ray ? a.Ray < b.Ray
          : a.From != b.From  ? a.From < b.From
          : a.Kind != b.Kind  ? a.Kind == HitKind::Cap
                              : a.Cell < b.Cell;
      });
    double end = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const SolidPart& part = parts[i];
      const bool isNew =
        i == 0 || part.Ray != parts[i - 1].Ray || part.From - end > TouchingPlaces * std::abs(end);
      if (isNew)
      {
        all.push_back({ { part.From, part.Kind, this->IsovalueOf(surface) },
          static_cast<SurfaceIndex>(surface), part.Ray, part.Cell });
      }
      end = isNew ? part.To : std::max(end, part.To);
    }
  }
}

namespace
{

/// True if two cells found one surface, within rounding: a ray cannot enter twice without leaving.
bool AreOne(const MetSurface& a, const MetSurface& b)
{
  constexpr double share = 0x1p-40;
  return a.Kind == b.Kind && a.Isovalue == b.Isovalue &&
    b.Distance - a.Distance <= share * b.Distance;
}

}

void MeshTracer::FindLayers(const RayBatch& rays, LayerBatch& layers) const
{
  const HitRules rules(this->Isosurfaces, false);
  const std::uint64_t open = layers.Open;
  const std::vector<MetInCell> all =
    this->FindAll(rays, open & RaysWithWalk(rays), layers.CellsRead);
  for (auto met = all.begin(); met != all.end();)
  {
    const std::size_t ray = met->Ray;
    MetSurface last = LastOn(rules, rays.Begin[ray], ray, layers);
    for (; met != all.end() && met->Ray == ray; ++met)
    {
      if (layers.IsOpen(ray) && IsInFront(last, met->Surface) && !AreOne(last, met->Surface))
      {
        layers.Append(ray, met->Surface.Distance, met->Surface.Kind, met->Isovalue, met->Cell);
        last = met->Surface;
      }
    }
  }
  layers.Open = 0;
}

}
