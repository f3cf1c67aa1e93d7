// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshGradients.h"

#include "Mesh/CellPoints.h"
#include "MeshFields/CellFaces.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

/// The gradient at a point of a cell.
glm::dvec3 GradientIn(const MeshTree& tree, const PointGradients* averaged, CellNumber number,
  const MeshCell& cell, const glm::dvec3& point)
{
  const bool isConstant = !averaged && cell.Shape == MeshCellShape::Tetrahedron;
  const glm::dvec3 at = isConstant ? glm::dvec3(0.25) : MeshKernels::FindPoint(cell, point).At;
  if (!averaged)
  {
    return MeshKernels::GradientAt(cell, at);
  }
  std::size_t part;
  std::int64_t inPart;
  tree.Reader().Locate(number, part, inPart);
  const MeshCellPoints points = MeshReader::FindPoints(tree.Reader().PartAt(part), inPart);
  const std::array<double, 8> weights = WeightsAt(cell, at);
  glm::dvec3 gradient(0.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(cell.NumberOfPoints()); ++i)
  {
    gradient +=
      weights[i] * glm::dvec3(averaged->Parts[part][static_cast<std::size_t>(points.Ids[i])]);
  }
  return gradient;
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
  MeshCell cell;
  CellNumber last = NoCell;
  for (std::size_t i = 0; i < tile.Rays.Count; ++i)
  {
    const glm::dvec3 index(query.IndexFromWorld * glm::dvec4(tile.Rays.PointAt(i), 1.0));
    const glm::dvec3 point = tree.Low() + tree.Scale() * index;
    const CellNumber number = tile.Cells ? (*tile.Cells)[i] : FindCellAt(tree, point);
    glm::dvec3 gradient(0.0);
    if (number != NoCell)
    {
      if (number != last)
      {
        tree.Reader().Read(number, cell);
        last = number;
      }
      gradient = tree.Scale() * GradientIn(tree, averaged, number, cell, point);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      tile.Gradients[a][i] = gradient[static_cast<int>(a)];
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
      made->Parts[part][id] +=
        glm::vec3(MeshKernels::GradientAt(cell, MeshKernels::FindPoint(cell, cell.Points[i]).At));
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
