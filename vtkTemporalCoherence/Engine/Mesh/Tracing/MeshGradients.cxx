// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshGradients.h"

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/KernelsCellGradients.h"
#include "Mesh/Tracing/HitCells.h"
#include "Mesh/Tracing/KernelsHitPlaces.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{
namespace
{

bool AreTetrahedra(const HitCells& cells)
{
  return std::all_of(cells.Cells.begin(),
    cells.Cells.begin() + static_cast<std::ptrdiff_t>(cells.Count),
    [](const MeshCell& cell) { return cell.Shape == MeshCellShape::Tetrahedron; });
}

/// Replace gradients by interpolated gradients of the cells' points.
void TakeAveraged(const MeshTree& tree, const PointGradients& averaged, const HitCells& cells,
  MeshKernels::PointsInCells& points)
{
  cells.ForEachHit(tree, points,
    [&](std::size_t hit, std::size_t part, std::int64_t, const MeshCellPoints& ids,
      const std::array<double, 8>& weights)
    {
      glm::dvec3 gradient(0.0);
      for (std::size_t p = 0; p < static_cast<std::size_t>(NumberOfPointsIn(ids.Shape)); ++p)
      {
        gradient +=
          weights[p] * glm::dvec3(averaged.Parts[part][static_cast<std::size_t>(ids.Ids[p])]);
      }
      for (std::size_t a = 0; a < 3; ++a)
      {
        points.Gradient[a][hit] = gradient[static_cast<int>(a)];
      }
    });
}

/// Repeat the last gradient up to the end of the last vector.
void FillUp(const GradientTile& tile)
{
  for (std::size_t i = tile.Rays.Count; i < WholeVectors(tile.Rays.Count); ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      tile.Gradients[a][i] = tile.Gradients[a][tile.Rays.Count - 1];
    }
  }
}

/// Take gradients that the search found.
/// \return false if one is missing
bool TakeKnown(const GradientTile& tile)
{
  if (!tile.Known || !tile.Cells)
  {
    return false;
  }
  std::uint64_t inCells = 0;
  for (std::size_t i = 0; i < tile.Rays.Count; ++i)
  {
    inCells |= static_cast<std::uint64_t>((*tile.Cells)[i] != NoCell) << i;
  }
  if ((inCells & ~tile.Known->Rays) != 0)
  {
    return false;
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t i = 0; i < tile.Rays.Count; ++i)
    {
      const double known = tile.Known->Gradient[a][i];
      tile.Gradients[a][i] = (inCells >> i & 1u) != 0 ? known : 0.0;
    }
  }
  FillUp(tile);
  return true;
}

/// Find the gradients of hits in tetrahedra, which are constant in each cell.
void FindConstant(const MeshTree& tree, const HitCells& cells, const GradientTile& tile)
{
  MeshKernels::TetrahedronLanes tetrahedra;
  for (std::size_t cell = 0; cell < cells.Count; ++cell)
  {
    tetrahedra.Append(cells.Cells[cell]);
  }
  tetrahedra.FillUp();
  MeshKernels::PointsInCells::Vectors ofCells;
  MeshKernels::FindTetrahedronGradients(tetrahedra, ofCells);
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t cell = 0; cell < cells.Count; ++cell)
    {
      ofCells[a][cell] = GradientInIndexSpace(tree, ofCells[a][cell]);
    }
    for (std::size_t i = 0; i < tile.Rays.Count; ++i)
    {
      const std::size_t cell = cells.OfHit[i];
      tile.Gradients[a][i] = cell == HitCells::None ? 0.0 : ofCells[a][cell];
    }
  }
}

/// Set the known values of hits: the isovalue of a surface, NaN for caps.
void TellValues(
  const GradientQuery& query, const GradientTile& tile, MeshKernels::PointsInCells& points)
{
  points.HasValues = tile.Kinds && query.Isovalues;
  for (std::size_t i = 0; points.HasValues && i < points.Count; ++i)
  {
    const HitKind kind = (*tile.Kinds)[i];
    const bool isSurface = kind == HitKind::Entry || kind == HitKind::Exit;
    points.Value[i] = isSurface ? (*query.Isovalues)[static_cast<std::size_t>(tile.Surfaces[i])]
                                : std::numeric_limits<double>::quiet_NaN();
  }
}

/// Find gradients at the places of hits in cells of any shape.
void FindAtPoints(const MeshTree& tree, const PointGradients* averaged, const HitCells& cells,
  const GradientQuery& query, const GradientTile& tile)
{
  MeshKernels::PointsInCells points;
  points.Count = tile.Rays.Count;
  points.Cell = cells.OfHit;
  points.HasPlaces = averaged != nullptr;
  FindHitPlaces(tile.Rays, query.IndexFromWorld, tree.Low(), tree.Scale(), points.Point);
  TellValues(query, tile, points);
  MeshKernels::FindCellGradients(cells.Cells.data(), cells.Count, points);
  if (averaged)
  {
    TakeAveraged(tree, *averaged, cells, points);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      const bool isKnown = points.Cell[i] != HitCells::None;
      tile.Gradients[a][i] = isKnown ? GradientInIndexSpace(tree, points.Gradient[a][i]) : 0.0;
    }
  }
}

}

void FindMeshGradients(const MeshTree& tree, const PointGradients* averaged,
  const GradientQuery& query, const GradientTile& tile)
{
  if (!averaged && TakeKnown(tile))
  {
    return;
  }
  const auto placeOf = [&](std::size_t hit)
  {
    const glm::dvec3 index(query.IndexFromWorld * glm::dvec4(tile.Rays.PointAt(hit), 1.0));
    return tree.ToMesh(index);
  };
  const HitCells cells(tree, tile.Rays.Count, tile.Cells, placeOf);
  if (!averaged && AreTetrahedra(cells))
  {
    FindConstant(tree, cells, tile);
  }
  else
  {
    FindAtPoints(tree, averaged, cells, query, tile);
  }
  FillUp(tile);
}

std::shared_ptr<const PointGradients> PointGradients::Make(const MeshTree& tree)
{
  const auto made = std::make_shared<PointGradients>();
  const Mesh& mesh = tree.TheMesh();
  std::vector<std::vector<std::uint32_t>> counts;
  for (const MeshPart& part : mesh.Parts)
  {
    made->Parts.emplace_back(static_cast<std::size_t>(part.NumberOfPoints), glm::vec3(0.0f));
    counts.emplace_back(static_cast<std::size_t>(part.NumberOfPoints), 0u);
  }
  // Add in the order of cell numbers: trees made for other points order cells differently, and the
  // sums must not depend on the tree.
  MeshCell cell;
  for (std::int64_t number = 0; number < tree.Reader().NumberOfCells(); ++number)
  {
    std::size_t part;
    std::int64_t inPart;
    tree.Reader().Locate(number, part, inPart);
    const MeshCellPoints points = MeshReader::FindPoints(tree.Reader().PartAt(part), inPart);
    tree.Reader().Read(number, cell); // hidden cells have no points
    for (std::size_t i = 0; i < static_cast<std::size_t>(cell.NumberOfPoints()); ++i)
    {
      const auto id = static_cast<std::size_t>(points.Ids[i]);
      const glm::dvec3 corner(i & 1u, i >> 1 & 1u, i >> 2 & 1u);
      made->Parts[part][id] += glm::vec3(MeshKernels::GradientAt(cell, corner));
      ++counts[part][id];
    }
  }
  for (std::size_t part = 0; part < made->Parts.size(); ++part)
  {
    for (std::size_t id = 0; id < made->Parts[part].size(); ++id)
    {
      made->Parts[part][id] /= static_cast<float>(std::max(counts[part][id], 1u));
    }
  }
  return made;
}

std::size_t PointGradients::MemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const std::vector<glm::vec3>& part : this->Parts)
  {
    bytes += part.capacity() * sizeof(glm::vec3);
  }
  return bytes;
}

}
