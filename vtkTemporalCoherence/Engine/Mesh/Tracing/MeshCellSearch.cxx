// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshCellSearch.h"

#include "Lattice/HitRules.h"
#include "Mesh/Cells/KernelsCellGradients.h"
#include "Mesh/Cells/KernelsKnownTetrahedra.h"
#include "Mesh/Tiles/MeshTile.h"
#include "Mesh/Tracing/KernelsDistinct.h"
#include "Mesh/Tracing/KernelsSortedTetrahedra.h"
#include "Mesh/Tracing/MeshGradients.h"
#include "Mesh/Tracing/MeshSolids.h"

#include <array>
#include <cmath>

#include <hwy/base.h>

namespace TemporalCoherence
{

bool KeepNearest(const MetInCell& met, const std::vector<double>& isovalues, HitBatch& hits)
{
  const SurfaceIndex hit = hits.Surface[met.Ray];
  if (hit != Frame::NoSurface)
  {
    const MetSurface known{ hits.Depth[met.Ray], hits.Kind[met.Ray],
      isovalues[static_cast<std::size_t>(hit)] };
    const bool isOne = !IsInFront(met.Surface, known) && !IsInFront(known, met.Surface);
    if (isOne ? met.Cell >= hits.Cell[met.Ray] : !IsInFront(met.Surface, known))
    {
      return false;
    }
  }
  hits.Depth[met.Ray] = met.Surface.Distance;
  hits.Kind[met.Ray] = met.Surface.Kind;
  hits.Surface[met.Ray] = met.Isovalue;
  hits.Cell[met.Ray] = met.Cell;
  hits.Gradients.Forget(met.Ray);
  return true;
}

namespace
{

/// One bit for each searched ray, by its place in `rays`, that crosses at its exit from the cell,
/// within rounding. A ray without any span in the cell counts, too.
std::uint64_t CrossingsAtEnds(const RecentHexahedron& cell, const MeshKernels::MeshRays& rays,
  const MeshKernels::Crossings& found)
{
  std::uint64_t which = 0, atEnds = 0;
  for (std::size_t k = 0; k < found.Count; ++k)
  {
    which |= std::uint64_t(1) << found.Ray[k];
  }
  if (which == 0)
  {
    return 0;
  }
  MeshKernels::CellSpans spans;
  MeshKernels::HexahedronSpans(cell.Cell, cell.Differences, rays, which, spans);
  for (std::size_t k = 0; k < found.Count; ++k)
  {
    const std::size_t ray = found.Ray[k], count = spans.Count[ray];
    const double out = count > 0 ? spans.Spans[ray][count - 1].Out : found.T[k];
    const bool isAtEnd = found.T[k] >= out - TouchingPlaces * std::abs(out);
    atEnds |= static_cast<std::uint64_t>(isAtEnd) << ray;
  }
  return atEnds;
}

}

/// The cells to search, with the rays of each cell, which are searched together.
struct MeshCellSearch::KnownCells
{
  std::size_t Count;
  RayBatch::Array<std::uint64_t> Rays; ///< of each cell, one bit each
  RayBatch::Array<CellNumber> Numbers;
  RayBatch::Array<const MeshCell*> Cells;
  RayBatch::Array<RecentHexahedron*> Hexahedra; ///< null: the cell is no hexahedron

  KnownCells(const RayCells& cells, const MeshTree& tree, RecentHexahedra& recent)
  {
    RayBatch::Array<std::uint32_t> ranks;
    FindRanks(cells, ranks);
    DistinctCells distinct;
    FindDistinct(ranks, cells.Rays, distinct);
    this->Count = distinct.Count;
    this->Rays = distinct.Rays;
    recent.Begin();
    std::array<std::uint8_t, RayBatch::Capacity> missing;
    std::size_t missed = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Hexahedra[i] = recent.Find(distinct.Numbers[i]);
      if (this->Hexahedra[i])
      {
        this->Numbers[i] = this->Hexahedra[i]->Number;
        this->Cells[i] = &this->Hexahedra[i]->Cell;
        continue;
      }
      missing[missed++] = static_cast<std::uint8_t>(i);
      tree.PrefetchCellAt(distinct.Numbers[i]);
    }
    this->ReadMissing(tree, distinct, missing.data(), missed, recent);
  }

private:
  void ReadMissing(const MeshTree& tree, const DistinctCells& distinct, const std::uint8_t* missing,
    std::size_t count, RecentHexahedra& recent)
  {
    MeshReader::Together<CellNumber> numbers{};
    for (std::size_t k = 0; k < count; ++k)
    {
      numbers[k] = tree.CellAt(distinct.Numbers[missing[k]]);
    }
    tree.Reader().ReadAll(numbers, count, this->Read);
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::size_t i = missing[k];
      this->Numbers[i] = numbers[k];
      this->Cells[i] = &this->Read[k];
      if (this->Read[k].Shape == MeshCellShape::Hexahedron)
      {
        this->Hexahedra[i] = &recent.Add(distinct.Numbers[i], numbers[k], this->Read[k]);
      }
    }
  }

  MeshReader::Together<MeshCell> Read;
};

/// The tetrahedra among the cells.
struct MeshCellSearch::ReadTetrahedra
{
  MeshKernels::TetrahedronLanes Cells;
  RayBatch::Array<std::uint64_t> Rays;
  RayBatch::Array<CellNumber> Numbers;

  explicit ReadTetrahedra(const KnownCells& known)
  {
    for (std::size_t i = 0; i < known.Count; ++i)
    {
      const MeshCell& cell = *known.Cells[i];
      if (cell.Shape == MeshCellShape::Tetrahedron)
      {
        this->Rays[this->Cells.Count] = known.Rays[i];
        this->Numbers[this->Cells.Count] = known.Numbers[i];
        this->Cells.Append(cell);
      }
    }
    this->Cells.FillUp();
  }
};

/// Rays, sorted by cell. Each cell begins a new vector, so no vector mixes cells.
struct MeshCellSearch::RaysInOrder
{
  static constexpr std::size_t Lanes = WidestVector / 2;

  MeshKernels::MeshRays InMesh;
  RayBatch::Array<std::uint8_t> Ray; ///< number of the ray at each place

  explicit RaysInOrder(const MeshKernels::MeshRays& rays)
    : Rays(rays)
  {
    this->InMesh.Along = {};
  }

  /// Append the rays of a cell. Without enough room, removes all previous rays.
  /// \return one bit for each place of the new rays
  std::uint64_t Take(std::uint64_t which)
  {
    const std::size_t count = hwy::PopCount(which);
    std::size_t first = (this->InMesh.Count + Lanes - 1) / Lanes * Lanes;
    if (first + count > MeshKernels::MeshRays::Capacity)
    {
      this->InMesh.Along = {};
      first = 0;
    }
    this->InMesh.Count = first;
    ForEachRay(which,
      [&](std::size_t ray)
      {
        const std::size_t at = this->InMesh.Count++;
        this->Ray[at] = static_cast<std::uint8_t>(ray);
        this->InMesh.Take(this->Rays, ray, at);
      });
    this->FillVector();
    return ~std::uint64_t(0) >> (RayBatch::Capacity - count) << first;
  }

private:
  /// Repeat the last ray up to the end of the vector, so that no lane is uninitialised.
  void FillVector()
  {
    const std::size_t last = this->InMesh.Count - 1;
    for (std::size_t at = this->InMesh.Count; at % Lanes != 0; ++at)
    {
      this->InMesh.Take(this->InMesh, last, at);
    }
  }

  const MeshKernels::MeshRays& Rays;
};

SearchedCells MeshCellSearch::Search(
  const RayBatch& rays, const RayCells& cells, HitBatch& hits) const
{
  const KnownCells known(cells, this->Tree, this->Recent);
  hits.CellsRead += static_cast<std::int64_t>(known.Count);
  const FoundInCells found = this->Isosurfaces.Mode == SurfaceMode::Threshold
    ? this->SearchSolid(known, cells.Surface, rays, hits)
    : this->SearchCrossings(known, cells.Surface, rays, hits);
  return { cells.Rays & ~found.Met, found.AtEnds };
}

MeshCellSearch::FoundInCells MeshCellSearch::SearchCrossings(
  const KnownCells& known, std::size_t surface, const RayBatch& rays, HitBatch& hits) const
{
  MeshKernels::MeshRays inMesh;
  SetUpMeshRays(rays, this->Tree, RayLimits::BeginToEnd, inMesh);
  const ReadTetrahedra tetrahedra(known);
  FoundInCells found, others;
  if (tetrahedra.Cells.Count > 0)
  {
    found = this->SearchTetrahedra(tetrahedra, surface, inMesh, hits);
  }
  if (tetrahedra.Cells.Count < known.Count)
  {
    others = this->SearchHexahedra(known, surface, inMesh, hits);
  }
  return { found.Met | others.Met, found.AtEnds | others.AtEnds };
}

MeshCellSearch::FoundInCells MeshCellSearch::SearchTetrahedra(const ReadTetrahedra& cells,
  std::size_t surface, const MeshKernels::MeshRays& inMesh, HitBatch& hits) const
{
  MeshKernels::SortedTetrahedra sorted;
  const std::uint64_t passed = SortTetrahedra(cells.Cells, this->Differences[surface], sorted);
  RayBatch::Array<std::uint64_t> rays;
  for (std::size_t i = 0; i < cells.Cells.Count; ++i)
  {
    rays[i] = (passed >> i & 1u) != 0 ? cells.Rays[i] : 0;
  }
  MeshKernels::KnownCrossings found;
  MeshKernels::FindKnownCrossings(sorted, rays, cells.Cells.Count, inMesh, found);
  MeshKernels::PointsInCells::Vectors gradients;
  MeshKernels::FindTetrahedronGradients(cells.Cells, gradients);
  const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
  for (std::size_t i = 0; i < cells.Cells.Count; ++i)
  {
    std::array<double, 3> gradient;
    for (std::size_t a = 0; a < 3; ++a)
    {
      gradient[a] = GradientInIndexSpace(this->Tree, gradients[a][i]);
    }
    ForEachRay(rays[i] & found.Met,
      [&](std::size_t ray)
      {
        const bool isKept = KeepNearest(
          { { found.T[ray], HitRules::KindOf((found.Rising >> ray & 1u) == 0), isovalues[surface] },
            static_cast<SurfaceIndex>(surface), static_cast<std::uint8_t>(ray), cells.Numbers[i] },
          isovalues, hits);
        if (isKept)
        {
          hits.Gradients.Set(ray, gradient);
        }
      });
  }
  return { found.Met, found.AtEnds };
}

MeshCellSearch::FoundInCells MeshCellSearch::SearchHexahedra(const KnownCells& known,
  std::size_t surface, const MeshKernels::MeshRays& inMesh, HitBatch& hits) const
{
  RaysInOrder inOrder(inMesh);
  const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
  FoundInCells all;
  for (std::size_t i = 0; i < known.Count; ++i)
  {
    RecentHexahedron* const each = known.Hexahedra[i];
    if (!each || !each->PrepareFor(surface, this->Differences[surface]))
    {
      continue;
    }
    const std::uint64_t places = inOrder.Take(known.Rays[i]);
    MeshKernels::Crossings found;
    MeshKernels::HexahedronCrossings(
      each->Functions, each->Cell, each->Differences, inOrder.InMesh, places, found);
    const std::uint64_t atEnds = CrossingsAtEnds(*each, inOrder.InMesh, found);
    for (std::size_t k = 0; k < found.Count; ++k)
    {
      const std::uint8_t ray = inOrder.Ray[found.Ray[k]];
      all.Met |= std::uint64_t(1) << ray;
      all.AtEnds |= (atEnds >> found.Ray[k] & 1u) << ray;
      KeepNearest({ { found.T[k], HitRules::KindOf(!found.Rises[k]), isovalues[surface] },
                    static_cast<SurfaceIndex>(surface), ray, each->Number },
        isovalues, hits);
    }
  }
  return all;
}

/// Search the cells for the surface of a solid.
MeshCellSearch::FoundInCells MeshCellSearch::SearchSolid(
  const KnownCells& known, std::size_t surface, const RayBatch& rays, HitBatch& hits) const
{
  MeshKernels::MeshRays inMesh;
  SetUpMeshRays(rays, this->Tree, RayLimits::None, inMesh);
  std::vector<SolidPart> parts;
  for (std::size_t i = 0; i < known.Count; ++i)
  {
    const MeshCell& cell = *known.Cells[i];
    MeshKernels::CellDifferences differences;
    if (cell.NumberOfPoints() > 0 &&
      (this->Differences[surface].Of(cell, differences) || differences[0] >= 0.0))
    {
      AppendSolidParts(cell, differences, known.Numbers[i], rays, inMesh, known.Rays[i], parts);
    }
  }
  const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
  FoundInCells found;
  for (const SolidPart& part : parts)
  {
    found.Met |= std::uint64_t(1) << part.Ray;
    found.AtEnds |= static_cast<std::uint64_t>(part.IsAtEnd) << part.Ray;
    KeepNearest({ { part.From, part.Kind, isovalues[surface] }, static_cast<SurfaceIndex>(surface),
                  part.Ray, part.Cell },
      isovalues, hits);
  }
  return found;
}

}
