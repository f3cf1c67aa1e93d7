// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshCellSearch.h"

#include "MeshFields/MeshSolids.h"
#include "MeshFields/MeshTile.h"
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

/// A cell, and the rays that are to be searched in it, one bit each.
struct MeshCellSearch::Group
{
  glm::ivec3 Place;
  std::uint64_t Rays;
};

namespace
{

/// The cells that rays are to be searched in: all rays of one cell are searched together.
template <typename Group>
class CellGroups
{
public:
  explicit CellGroups(const RayCells& cells)
  {
    ForEachRay(cells.Rays,
      [&](std::size_t ray)
      {
        const glm::ivec3 place = cells.At(ray);
        // Rays beside each other are mostly in one cell, and else in one of the last.
        std::size_t group = this->Count;
        while (group > 0 && this->All[group - 1].Place != place)
        {
          --group;
        }
        if (group == 0)
        {
          this->All[this->Count++] = { place, 0 };
          group = this->Count;
        }
        this->All[group - 1].Rays |= std::uint64_t(1) << ray;
      });
  }

  const Group* begin() const { return this->All.data(); }
  const Group* end() const { return this->All.data() + this->Count; }

private:
  std::array<Group, RayBatch::Capacity> All;
  std::size_t Count = 0;
};

}

std::uint64_t MeshCellSearch::Search(
  const RayBatch& rays, const RayCells& cells, HitBatch& hits) const
{
  const bool isSolid = this->Isosurfaces.Mode == SurfaceMode::Threshold;
  MeshKernels::MeshRays inMesh;
  SetUpMeshRays(rays, this->Tree, isSolid ? RayLimits::None : RayLimits::BeginToEnd, inMesh);
  std::uint64_t missing = 0;
  for (const Group& group : CellGroups<Group>(cells))
  {
    missing |= group.Rays & ~this->SearchGroup(group, cells.Surface, rays, inMesh, hits);
    ++hits.CellsRead;
  }
  return missing;
}

/// \return one bit for each ray that meets the surface
std::uint64_t MeshCellSearch::SearchGroup(const Group& group, std::size_t surface,
  const RayBatch& rays, const MeshKernels::MeshRays& inMesh, HitBatch& hits) const
{
  const CellNumber number = this->Tree.CellAt(MeshTree::RankOf(group.Place));
  MeshCell cell;
  this->Tree.Reader().Read(number, cell);
  MeshKernels::CellDifferences differences;
  const bool isCrossed = this->Differences[surface].Of(cell, differences);
  std::uint64_t met = 0;
  const auto keep = [&](double distance, HitKind kind, std::size_t ray)
  {
    met |= std::uint64_t(1) << ray;
    const std::vector<double>& isovalues = this->Isosurfaces.Isovalues;
    KeepNearest({ { distance, kind, isovalues[surface] }, static_cast<std::int16_t>(surface),
                  static_cast<std::uint8_t>(ray), number },
      isovalues, hits);
  };
  if (this->Isosurfaces.Mode == SurfaceMode::Threshold)
  {
    std::vector<SolidPart> parts;
    AppendSolidParts(cell, differences, number, rays, inMesh, group.Rays, parts);
    for (const SolidPart& part : parts)
    {
      keep(part.From, part.Kind, part.Ray);
    }
  }
  else if (isCrossed)
  {
    MeshKernels::Crossings found;
    MeshKernels::CellCrossings(cell, differences, inMesh, group.Rays, found);
    for (std::size_t i = 0; i < found.Count; ++i)
    {
      keep(found.T[i], HitRules::KindOf(!found.Rises[i]), found.Ray[i]);
    }
  }
  return met;
}

}
