// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTiles/LeafCells.h"

#include "Scene/LayerBatch.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{

LeafCells::LeafCells(const MeshTree& tree, const ActiveLeaves& leaves)
  : Tree(tree)
  , Leaves(leaves)
  , Kept(new std::atomic<const Leaf*>[static_cast<std::size_t>(tree.NumberOfLeaves())]())
{
}

LeafCells::~LeafCells()
{
  for (std::int64_t leaf = 0; leaf < this->Tree.NumberOfLeaves(); ++leaf)
  {
    delete this->Kept[static_cast<std::size_t>(leaf)].load(std::memory_order_relaxed);
  }
}

const LeafCells::Leaf& LeafCells::Of(std::int64_t leaf, Leaf& spare) const
{
  std::atomic<const Leaf*>& kept = this->Kept[static_cast<std::size_t>(leaf)];
  if (const Leaf* const known = kept.load(std::memory_order_acquire))
  {
    return *known;
  }
  if (this->Bytes.load(std::memory_order_relaxed) > MostBytes)
  {
    this->Read(leaf, spare);
    return spare;
  }
  auto made = std::make_unique<Leaf>();
  this->Read(leaf, *made);
  const auto bytes =
    static_cast<std::int64_t>(sizeof(Leaf) + made->Cells.size() * sizeof(ActiveCell));
  const Leaf* known = nullptr;
  if (kept.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel))
  {
    this->Bytes += bytes;
    return *made.release();
  }
  return *known; // another thread was faster
}

void LeafCells::Read(std::int64_t leaf, Leaf& read) const
{
  const std::uint64_t word = this->Leaves.CellsOf(leaf);
  read.Cells.resize(hwy::PopCount(word));
  read.Boxes = NoBoxes();
  std::size_t lane = 0;
  ForEachRay(word,
    [&](std::size_t bit)
    {
      ActiveCell& cell = read.Cells[lane];
      cell.Rank = MeshLattice::SizeOfBlock * leaf + static_cast<std::int64_t>(bit);
      cell.Number = this->Tree.CellAt(cell.Rank);
      this->Tree.Reader().Read(cell.Number, cell.Cell);
      const auto count = static_cast<std::size_t>(cell.Cell.NumberOfPoints());
      glm::dvec3 low = cell.Cell.Points[0], high = low;
      for (std::size_t i = 0; i < 8; ++i)
      {
        const glm::dvec3& point = cell.Cell.Points[std::min(i, count - 1)];
        low = glm::min(low, point);
        high = glm::max(high, point);
        cell.Points[0][i] = point.x;
        cell.Points[1][i] = point.y;
        cell.Points[2][i] = point.z;
      }
      if (cell.Cell.Shape == MeshCellShape::Hexahedron)
      {
        std::array<glm::dvec3, 8> index;
        for (std::size_t i = 0; i < 8; ++i)
        {
          index[i] = (cell.Cell.Points[i] - this->Tree.Low()) / this->Tree.Scale();
        }
        cell.Values = NearlyLinearOf(index, cell.Cell.Values);
      }
      read.Boxes.Set(lane, (low - this->Tree.Low()) / this->Tree.Scale(),
        (high - this->Tree.Low()) / this->Tree.Scale());
      cell.Box = read.Boxes.BoxAt(lane++);
    });
}

}
