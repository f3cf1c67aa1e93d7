// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshCellSearch.h"

#include "Mesh/KernelsKnownTetrahedra.h"
#include "MeshFields/DistinctKeys.h"
#include "MeshFields/MeshSolids.h"
#include "MeshTiles/MeshTile.h"
#include "Trace/HitRules.h"

#include <algorithm>
#include <array>
#include <optional>

#include <hwy/base.h>

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

/// The cells that rays are to be searched in: all rays of one cell are searched together.
struct MeshCellSearch::KnownCells
{
  static constexpr std::size_t Most = DistinctKeys::Most;

  std::size_t Count;
  std::array<CellNumber, Most> Numbers;
  std::array<std::uint64_t, Most> Rays{}; ///< of each cell, one bit each

  KnownCells(const RayCells& cells, const MeshTree& tree)
  {
    constexpr int bits = 21; // of a coordinate in a key
    DistinctKeys places;
    ForEachRay(cells.Rays,
      [&](std::size_t ray)
      {
        const auto part = [&](std::size_t a)
        { return static_cast<std::uint64_t>(cells.Cell[a][ray]); };
        const std::size_t at = places.Add(part(0) | part(1) << bits | part(2) << 2 * bits);
        this->Rays[at] |= std::uint64_t(1) << ray;
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
  }
};

/// Rays in the coordinates of the mesh, cell by cell, so that vectors of them are full.
struct MeshCellSearch::RaysInOrder
{
  MeshKernels::MeshRays InMesh;
  std::array<std::uint8_t, RayBatch::Capacity> Ray; ///< which ray each of them is

  RaysInOrder(const KnownCells& known, const RayBatch& rays, const MeshTree& tree)
  {
    std::size_t& count = this->InMesh.Count;
    for (std::size_t i = 0; i < known.Count; ++i)
    {
      ForEachRay(known.Rays[i],
        [&](std::size_t ray)
        {
          SetMeshRay(rays, ray, tree, this->InMesh, count);
          this->Ray[count++] = static_cast<std::uint8_t>(ray);
        });
    }
    this->InMesh.Prepare();
  }
};

std::uint64_t MeshCellSearch::Search(
  const RayBatch& rays, const RayCells& cells, HitBatch& hits) const
{
  const KnownCells known(cells, this->Tree);
  hits.CellsRead += static_cast<std::int64_t>(known.Count);
  return cells.Rays &
    ~(this->Isosurfaces.Mode == SurfaceMode::Threshold
        ? this->SearchSolid(known, cells.Surface, rays, hits)
        : this->SearchCrossings(known, cells.Surface, rays, hits));
}

/// \return one bit for each ray that meets the surface
std::uint64_t MeshCellSearch::SearchCrossings(
  const KnownCells& known, std::size_t surface, const RayBatch& rays, HitBatch& hits) const
{
  std::array<MeshCell, KnownCells::Most> read;
  this->Tree.Reader().ReadAll(known.Numbers, known.Count, read);
  const RaysInOrder inOrder(known, rays, this->Tree);
  std::optional<MeshKernels::KnownTetrahedra> tetrahedra; // large
  RayBatch::Array<CellNumber> numbers;                    // of the cells of the rays in order
  std::uint64_t met = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < known.Count; ++i)
  {
    const std::size_t count = hwy::PopCount(known.Rays[i]);
    const std::uint64_t which = ~std::uint64_t(0) >> (RayBatch::Capacity - count) << first;
    std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), count, known.Numbers[i]);
    first += count;
    MeshKernels::CellDifferences differences;
    if (!this->Differences[surface].Of(read[i], differences))
    {
      continue;
    }
    if (read[i].Shape == MeshCellShape::Tetrahedron)
    {
      if (!tetrahedra)
      {
        tetrahedra.emplace();
      }
      tetrahedra->Add(MeshKernels::TetrahedronPoints(read[i], differences), which);
      continue;
    }
    MeshKernels::Crossings found;
    MeshKernels::CellCrossings(read[i], differences, inOrder.InMesh, which, found);
    met |= this->Keep(found, surface, inOrder.Ray, numbers, hits);
  }
  if (tetrahedra)
  {
    MeshKernels::Crossings found;
    MeshKernels::KnownTetrahedronCrossings(*tetrahedra, inOrder.InMesh, found);
    met |= this->Keep(found, surface, inOrder.Ray, numbers, hits);
  }
  return met;
}

/// The same for a solid.
std::uint64_t MeshCellSearch::SearchSolid(
  const KnownCells& known, std::size_t surface, const RayBatch& rays, HitBatch& hits) const
{
  MeshKernels::MeshRays inMesh;
  SetUpMeshRays(rays, this->Tree, RayLimits::None, inMesh);
  std::array<MeshCell, KnownCells::Most> read;
  this->Tree.Reader().ReadAll(known.Numbers, known.Count, read);
  std::vector<SolidPart> parts;
  for (std::size_t i = 0; i < known.Count; ++i)
  {
    MeshKernels::CellDifferences differences;
    if (this->Differences[surface].Of(read[i], differences) || differences[0] >= 0.0)
    {
      AppendSolidParts(read[i], differences, known.Numbers[i], rays, inMesh, known.Rays[i], parts);
    }
  }
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

/// Keep the nearest surface of each ray.
/// \param order, cells which ray each of those in `found` is, and the cell it was searched in
/// \return one bit for each ray that meets any
std::uint64_t MeshCellSearch::Keep(const MeshKernels::Crossings& found, std::size_t surface,
  const std::array<std::uint8_t, RayBatch::Capacity>& order,
  const RayBatch::Array<CellNumber>& cells, HitBatch& hits) const
{
  const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < found.Count; ++i)
  {
    const std::uint8_t ray = order[found.Ray[i]];
    met |= std::uint64_t(1) << ray;
    KeepNearest({ { found.T[i], HitRules::KindOf(!found.Rises[i]), isovalues[surface] },
                  static_cast<std::int16_t>(surface), ray, cells[found.Ray[i]] },
      isovalues, hits);
  }
  return met;
}

}
