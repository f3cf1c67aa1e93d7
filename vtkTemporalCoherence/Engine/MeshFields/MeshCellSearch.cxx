// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshCellSearch.h"

#include "Mesh/KernelsKnownTetrahedra.h"
#include "MeshFields/DistinctKeys.h"
#include "MeshTiles/MeshTile.h"
#include "Trace/HitRules.h"

#include <array>

namespace TemporalCoherence
{

void KeepNearest(const MetInCell& met, const std::vector<double>& isovalues, HitBatch& hits)
{
  const std::int16_t hit = hits.Surface[met.Ray];
  if (hit != Frame::NoSurface)
  {
    const MetSurface known{ hits.Depth[met.Ray], hits.Kind[met.Ray],
      isovalues[static_cast<std::size_t>(hit)] };
    const bool isOne = !IsInFront(met.Surface, known) && !IsInFront(known, met.Surface);
    if (isOne ? met.Cell >= hits.Cell[met.Ray] : !IsInFront(met.Surface, known))
    {
      return;
    }
  }
  hits.Depth[met.Ray] = met.Surface.Distance;
  hits.Kind[met.Ray] = met.Surface.Kind;
  hits.Surface[met.Ray] = met.Isovalue;
  hits.Cell[met.Ray] = met.Cell;
}

namespace
{

/// The cells that rays are to be searched in: all rays of one cell are searched together.
struct KnownCells
{
  static constexpr std::size_t Most = DistinctKeys::Most;

  std::size_t Count;
  std::array<CellNumber, Most> Numbers;
  std::array<std::uint64_t, Most> Rays{}; ///< of each cell, one bit each
  RayBatch::Array<CellNumber> OfRay;

  KnownCells(const RayCells& cells, const MeshTree& tree)
  {
    constexpr int bits = 21; // of a coordinate in a key
    DistinctKeys places;
    std::array<std::uint8_t, RayBatch::Capacity> placeOf;
    ForEachRay(cells.Rays,
      [&](std::size_t ray)
      {
        const auto part = [&](std::size_t a)
        { return static_cast<std::uint64_t>(cells.Cell[a][ray]); };
        const std::size_t at = places.Add(part(0) | part(1) << bits | part(2) << 2 * bits);
        this->Rays[at] |= std::uint64_t(1) << ray;
        placeOf[ray] = static_cast<std::uint8_t>(at);
      });
    this->Count = places.Count();
    std::array<std::int64_t, Most> ranks;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const auto part = [&](int a)
      { return static_cast<int>(places[i] >> a * bits & ((1u << bits) - 1)); };
      ranks[i] = MeshTree::RankOf({ part(0), part(1), part(2) });
      tree.PrefetchCellAt(ranks[i]);
    }
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Numbers[i] = tree.CellAt(ranks[i]);
    }
    ForEachRay(
      cells.Rays, [&](std::size_t ray) { this->OfRay[ray] = this->Numbers[placeOf[ray]]; });
  }
};

}

std::uint64_t MeshCellSearch::Search(
  const RayBatch& rays, const RayCells& cells, HitBatch& hits) const
{
  const KnownCells known(cells, this->Tree);
  std::array<MeshCell, KnownCells::Most> read;
  this->Tree.Reader().ReadAll(known.Numbers, known.Count, read);
  hits.CellsRead += static_cast<std::int64_t>(known.Count);

  const bool isSolid = this->Isosurfaces.Mode == SurfaceMode::Threshold;
  MeshKernels::MeshRays inMesh;
  SetUpMeshRays(rays, this->Tree, isSolid ? RayLimits::None : RayLimits::BeginToEnd, inMesh);
  MeshKernels::KnownTetrahedra tetrahedra;
  std::vector<SolidPart> parts;
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < known.Count; ++i)
  {
    const MeshCell& cell = read[i];
    MeshKernels::CellDifferences differences;
    const bool isCrossed = this->Differences[cells.Surface].Of(cell, differences);
    if (isSolid && (isCrossed || differences[0] >= 0.0))
    {
      AppendSolidParts(cell, differences, known.Numbers[i], rays, inMesh, known.Rays[i], parts);
    }
    else if (isCrossed && cell.Shape == MeshCellShape::Tetrahedron)
    {
      tetrahedra.Add(MeshKernels::TetrahedronPoints(cell, differences), known.Rays[i]);
    }
    else if (isCrossed)
    {
      MeshKernels::Crossings found;
      MeshKernels::CellCrossings(cell, differences, inMesh, known.Rays[i], found);
      met |= this->Keep(found, cells.Surface, known.OfRay, hits);
    }
  }
  if (tetrahedra.Rays != 0)
  {
    MeshKernels::Crossings found;
    MeshKernels::KnownTetrahedronCrossings(tetrahedra, inMesh, found);
    met |= this->Keep(found, cells.Surface, known.OfRay, hits);
  }
  return cells.Rays & ~(met | this->KeepSolid(parts, cells.Surface, hits));
}

/// Keep the nearest surface of each ray.
/// \param cells in which rays were searched
/// \return one bit for each ray that meets any
std::uint64_t MeshCellSearch::Keep(const MeshKernels::Crossings& found, std::size_t surface,
  const RayBatch::Array<CellNumber>& cells, HitBatch& hits) const
{
  const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < found.Count; ++i)
  {
    const std::size_t ray = found.Ray[i];
    met |= std::uint64_t(1) << ray;
    KeepNearest({ { found.T[i], HitRules::KindOf(!found.Rises[i]), isovalues[surface] },
                  static_cast<std::int16_t>(surface), found.Ray[i], cells[ray] },
      isovalues, hits);
  }
  return met;
}

/// The same for parts of rays in a solid.
std::uint64_t MeshCellSearch::KeepSolid(
  const std::vector<SolidPart>& parts, std::size_t surface, HitBatch& hits) const
{
  const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
  std::uint64_t met = 0;
  for (const SolidPart& part : parts)
  {
    met |= std::uint64_t(1) << part.Ray;
    KeepNearest({ { part.From, part.Kind, isovalues[surface] }, static_cast<std::int16_t>(surface),
                  part.Ray, part.Cell },
      isovalues, hits);
  }
  return met;
}

}
