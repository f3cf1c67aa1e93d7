// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshGradients.h"

#include "Mesh/CellPoints.h"
#include "Mesh/KernelsCellGradients.h"
#include "MeshFields/CellFaces.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// The cells of some hits, each once, and the hits in the order of their cells.
struct HitCells
{
  static constexpr std::size_t Most = 64;

  std::size_t Count = 0;
  std::array<CellNumber, Most> Numbers;
  std::array<std::uint8_t, Most> Hits; ///< by their places among the points that are searched

  /// \return where it is in the list
  std::size_t Add(CellNumber number)
  {
    std::size_t place = 0;
    while (place < this->Count && this->Numbers[place] != number)
    {
      ++place;
    }
    if (place == this->Count)
    {
      this->Numbers[this->Count++] = number;
    }
    return place;
  }
};

/// The cells that hits lie in, and these points, cell by cell. Hits without a cell are left out.
void Gather(const MeshTree& tree, const GradientQuery& query, const GradientTile& tile,
  HitCells& cells, MeshKernels::PointsInCells& points)
{
  constexpr std::uint8_t none = HitCells::Most;
  std::array<std::uint8_t, HitCells::Most> cellOf;
  std::array<glm::dvec3, HitCells::Most> at;
  std::array<std::uint8_t, HitCells::Most + 1> next{};
  for (std::size_t i = 0; i < tile.Rays.Count; ++i)
  {
    const glm::dvec3 index(query.IndexFromWorld * glm::dvec4(tile.Rays.PointAt(i), 1.0));
    at[i] = tree.Low() + tree.Scale() * index;
    const CellNumber number = tile.Cells ? (*tile.Cells)[i] : FindCellAt(tree, at[i]);
    cellOf[i] = number == NoCell ? none : static_cast<std::uint8_t>(cells.Add(number));
    if (cellOf[i] != none)
    {
      ++next[cellOf[i] + std::size_t(1)];
    }
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  points.Count = next[cells.Count];
  for (std::size_t i = 0; i < tile.Rays.Count; ++i)
  {
    if (cellOf[i] != none)
    {
      const std::size_t place = next[cellOf[i]]++;
      cells.Hits[place] = static_cast<std::uint8_t>(i);
      points.Set(place, cellOf[i], at[i]);
    }
  }
}

/// Replace gradients by the means of those at the points of cells.
void TakeAveraged(const MeshTree& tree, const PointGradients& averaged, const HitCells& cells,
  const MeshCell* read, MeshKernels::PointsInCells& points)
{
  std::size_t last = HitCells::Most, part = 0;
  MeshCellPoints ids;
  for (std::size_t i = 0; i < points.Count; ++i)
  {
    const std::size_t cell = points.Cell[i];
    if (cell != last)
    {
      std::int64_t inPart;
      tree.Reader().Locate(cells.Numbers[cell], part, inPart);
      ids = MeshReader::FindPoints(tree.Reader().PartAt(part), inPart);
      last = cell;
    }
    const std::array<double, 8> weights =
      WeightsAt(read[cell], { points.At[0][i], points.At[1][i], points.At[2][i] });
    glm::dvec3 gradient(0.0);
    for (std::size_t p = 0; p < static_cast<std::size_t>(read[cell].NumberOfPoints()); ++p)
    {
      gradient +=
        weights[p] * glm::dvec3(averaged.Parts[part][static_cast<std::size_t>(ids.Ids[p])]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      points.Gradient[a][i] = gradient[static_cast<int>(a)];
    }
  }
}

/// Call visit(cell number, cell) for each cell of a leaf whose box holds a point, until it returns
/// true.
template <typename Visit>
void VisitCellsAt(const MeshTree& tree, const glm::dvec3& point, double margin, const Visit& visit)
{
  struct Block
  {
    std::size_t Level;
    std::int64_t Number;
  };
  if (tree.NumberOfCells() == 0)
  {
    return;
  }
  const glm::dvec3 index = (point - tree.Low()) / tree.Scale();
  const auto holds = [&](const FloatBox& box)
  {
    return glm::all(glm::greaterThanEqual(index + margin, glm::dvec3(box.Low))) &&
      glm::all(glm::lessThanEqual(index - margin, glm::dvec3(box.High)));
  };
  const auto blocksOf = [&](std::size_t level)
  {
    std::int64_t blocks = tree.NumberOfCells();
    for (std::size_t i = 0; i <= level; ++i)
    {
      blocks = (blocks + MeshLattice::SizeOfBlock - 1) / MeshLattice::SizeOfBlock;
    }
    return blocks;
  };
  constexpr std::size_t mostLevels = 12;
  std::array<Block, mostLevels * MeshLattice::SizeOfBlock> open;
  std::size_t count = 0;
  open[count++] = { tree.NumberOfLevels() - 1, 0 };
  MeshCell cell;
  while (count > 0)
  {
    const Block block = open[--count];
    if (!holds(tree.BlockBox(block.Level, block.Number)))
    {
      continue;
    }
    const std::int64_t first = MeshLattice::SizeOfBlock * block.Number;
    const std::int64_t all = block.Level > 0 ? blocksOf(block.Level - 1) : tree.NumberOfCells();
    const std::int64_t end = std::min(first + MeshLattice::SizeOfBlock, all);
    for (std::int64_t child = first; child < end; ++child)
    {
      if (block.Level > 0)
      {
        open[count++] = { block.Level - 1, child };
        continue;
      }
      const CellNumber number = tree.CellAt(child);
      tree.Reader().Read(number, cell);
      visit(number, cell);
    }
  }
}

/// How far outside of a cell a point on its face may seem to be, in its own coordinates.
constexpr double OnFace = 1e-7;

}

CellNumber FindCellAt(const MeshTree& tree, const glm::dvec3& point)
{
  CellNumber found = NoCell;
  VisitCellsAt(tree, point, 0.0,
    [&](CellNumber number, const MeshCell& cell)
    {
      if (number < found && MeshKernels::FindPoint(cell, point, OnFace).IsIn)
      {
        found = number;
      }
    });
  return found;
}

glm::dvec3 MeshFaceNormal(
  const MeshTree& tree, const glm::dvec3& point, const glm::dvec3& direction, double& nearest)
{
  glm::dvec3 normal(0.0);
  const glm::dvec3 inMesh = tree.Low() + tree.Scale() * point;
  VisitCellsAt(tree, inMesh, nearest,
    [&](CellNumber, const MeshCell& cell)
    {
      constexpr double beside = 1e-3;
      const MeshKernels::PointInCell at = MeshKernels::FindPoint(cell, inMesh, beside);
      const NearestFace face = FindNearestFace(cell, at.At);
      if (at.IsIn && face.Distance < tree.Scale() * nearest &&
        glm::dot(face.Normal, direction) < 0.0)
      {
        nearest = face.Distance / tree.Scale();
        normal = face.Normal;
      }
    });
  return normal;
}

void FindMeshGradients(const MeshTree& tree, const PointGradients* averaged,
  const GradientQuery& query, const GradientTile& tile)
{
  HitCells cells;
  MeshKernels::PointsInCells points;
  Gather(tree, query, tile, cells, points);
  std::array<MeshCell, HitCells::Most> read;
  for (std::size_t i = 0; i < cells.Count; ++i)
  {
    tree.Reader().Read(cells.Numbers[i], read[i]);
  }
  points.HasPlaces = averaged != nullptr;
  FindCellGradients(read.data(), cells.Count, points);
  if (averaged)
  {
    TakeAveraged(tree, *averaged, cells, read.data(), points);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    std::fill_n(tile.Gradients[a].begin(), tile.Rays.Count, 0.0);
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      // Values that are not finite have no gradient.
      const double gradient = tree.Scale() * points.Gradient[a][i];
      tile.Gradients[a][cells.Hits[i]] = std::isfinite(gradient) ? gradient : 0.0;
    }
  }
  for (std::size_t i = tile.Rays.Count; i < WholeVectors(tile.Rays.Count); ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      tile.Gradients[a][i] = tile.Gradients[a][tile.Rays.Count - 1];
    }
  }
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
  MeshCell cell;
  for (std::int64_t rank = 0; rank < tree.NumberOfCells(); ++rank)
  {
    const CellNumber number = tree.CellAt(rank);
    std::size_t part;
    std::int64_t inPart;
    tree.Reader().Locate(number, part, inPart);
    const MeshCellPoints points = MeshReader::FindPoints(tree.Reader().PartAt(part), inPart);
    tree.Reader().Read(number, cell);
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
