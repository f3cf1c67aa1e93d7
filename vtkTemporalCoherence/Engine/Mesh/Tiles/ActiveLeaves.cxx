// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/ActiveLeaves.h"

#include "Mesh/Tiles/KernelsBoxes.h"
#include "Mesh/Tree/MeshLattice.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t Children = MeshLattice::SizeOfBlock;

}

std::uint64_t ActiveLeaves::NewStamp()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

double ActiveLeaves::MarginOf(const RayBatch& rays, const MeshTree& tree)
{
  const glm::ivec3& size = tree.Dimensions();
  double farthest = size.x + size.y + size.z;
  for (std::size_t a = 0; a < 3; ++a)
  {
    farthest += std::abs(rays.Origin[a][0]);
  }
  return 0x1p-40 * farthest;
}

/// One bit for each active child of a block of a level above the leaves.
std::uint64_t ActiveLeaves::WordOf(std::size_t level, std::int64_t block) const
{
  if (!this->Active)
  {
    return this->Tree.ChildrenOf(level, block);
  }
  const glm::ivec3 place = MeshLattice::PlaceOf(block);
  return level == 1 ? this->Active->LeavesOf(this->Active->NodeOf(ActiveCells::NodeSize * place))
                    : this->Active->LevelsAbove()[level - 2].WordOf(place);
}

/// Sort leaves from front to back.
void ActiveLeaves::SortLeaves(std::vector<Leaf>& leaves)
{
  std::sort(leaves.begin(), leaves.end(),
    [](const Leaf& a, const Leaf& b)
    { return a.Depth != b.Depth ? a.Depth < b.Depth : a.Number < b.Number; });
}

/// The active leaves along a row of tiles, from front to back. A thread works through the tiles of
/// the row, and descends the tree only once.
struct ActiveLeaves::Row
{
  using Leaf = ActiveLeaves::Leaf;
  static constexpr int Columns = 8 * TileSize; ///< pixels that a thread takes at a time

  void Append(const Leaf& leaf, const FloatBox& box)
  {
    const std::size_t lane = this->Leaves.size() % static_cast<std::size_t>(Children);
    if (lane == 0)
    {
      this->Boxes.push_back(NoBoxes());
    }
    this->Boxes.back().Set(lane, glm::dvec3(box.Low), glm::dvec3(box.High));
    this->Leaves.push_back(leaf);
  }

  /// True if the row holds all leaves that a tile may pass, in the tile's order.
  bool HasTile(std::uint64_t stamp, const RayBatch& rays, const TileGrid& grid) const
  {
    return this->Stamp == stamp && grid.HasDepthsOf(this->Grid) &&
      grid.IsWithin(this->Around, rays);
  }

  std::uint64_t Stamp = 0; ///< of the ActiveLeaves that found it; 0: of none
  TileGrid Grid;           ///< of the first tile
  TilePlanes Around;
  std::vector<Leaf> Leaves;    ///< from front to back
  std::vector<BoxLanes> Boxes; ///< of the leaves, 64 at a time
};

void ActiveLeaves::FindRow(const TileGrid& grid, Row& row) const
{
  row.Stamp = 0;
  row.Leaves.clear();
  row.Boxes.clear();
  row.Around = grid.PlanesAlong(Row::Columns);
  thread_local std::vector<Leaf> found;
  found.clear();
  this->Tree.VisitLeaves(
    [&](std::size_t level, std::int64_t block)
    {
      return this->WordOf(level, block) &
        BoxesWithin(row.Around, this->Boxes.ChildrenOf(level, block));
    },
    [&](std::int64_t leaf) {
      found.push_back({ grid.NearestDepth(this->Tree.LeafBox(leaf)), leaf });
    });
  SortLeaves(found);
  for (const Leaf& leaf : found)
  {
    row.Append(leaf, this->Tree.LeafBox(leaf.Number));
  }
  row.Grid = grid;
  row.Stamp = this->Stamp;
}

void ActiveLeaves::Find(const RayBatch& rays, const TileGrid& grid, std::vector<Leaf>& leaves) const
{
  leaves.clear();
  if (this->Tree.NumberOfCells() == 0)
  {
    return;
  }
  if (grid.IsGrid())
  {
    thread_local Row row;
    if (!row.HasTile(this->Stamp, rays, grid))
    {
      this->FindRow(grid, row);
    }
    for (std::size_t i = 0; i < row.Boxes.size(); ++i)
    {
      ForEachRay(BoxesWithin(grid.Planes(), row.Boxes[i]),
        [&](std::size_t lane)
        { leaves.push_back(row.Leaves[i * static_cast<std::size_t>(Children) + lane]); });
    }
  }
  else
  {
    const double margin = MarginOf(rays, this->Tree);
    const auto mayMeet = [&](const FloatBox& box)
    { return RaysThrough(rays, rays.WalkEnd, box, margin) != 0; };
    this->Tree.VisitLeaves(
      [&](std::size_t level, std::int64_t block)
      {
        std::uint64_t met = 0;
        ForEachRay(this->WordOf(level, block),
          [&](std::size_t bit)
          {
            const std::int64_t child = Children * block + static_cast<std::int64_t>(bit);
            met |= std::uint64_t(mayMeet(this->Tree.BlockBox(level - 1, child))) << bit;
          });
        return met;
      },
      [&](std::int64_t leaf) {
        leaves.push_back({ grid.NearestDepth(this->Tree.LeafBox(leaf)), leaf });
      });
    SortLeaves(leaves);
  }
}

std::uint64_t ActiveLeaves::CellsOf(std::int64_t leaf) const
{
  if (!this->Active)
  {
    return this->Tree.ChildrenOf(0, leaf);
  }
  const glm::ivec3 cell = ActiveCells::LeafSize * MeshLattice::PlaceOf(leaf);
  return this->Active->CellsOf(this->Shape, this->Active->NodeOf(cell), cell);
}

}
