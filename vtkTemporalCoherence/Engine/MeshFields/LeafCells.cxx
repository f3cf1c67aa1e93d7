// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/LeafCells.h"

#include "Scene/LayerBatch.h"

#include <algorithm>

namespace TemporalCoherence
{

LeafCells::LeafCells(const MeshTree& tree, const ActiveLeaves& leaves)
  : Tree(tree)
  , Leaves(leaves)
  , Kept(new std::atomic<const Cells*>[static_cast<std::size_t>(tree.NumberOfLeaves())]())
{
}

LeafCells::~LeafCells()
{
  for (std::int64_t leaf = 0; leaf < this->Tree.NumberOfLeaves(); ++leaf)
  {
    delete this->Kept[static_cast<std::size_t>(leaf)].load(std::memory_order_relaxed);
  }
}

const LeafCells::Cells& LeafCells::Of(std::int64_t leaf, Cells& spare) const
{
  std::atomic<const Cells*>& kept = this->Kept[static_cast<std::size_t>(leaf)];
  if (const Cells* const known = kept.load(std::memory_order_acquire))
  {
    return *known;
  }
  if (this->Bytes.load(std::memory_order_relaxed) > MostBytes)
  {
    this->Read(leaf, spare);
    return spare;
  }
  auto made = std::make_unique<Cells>();
  this->Read(leaf, *made);
  const auto bytes = static_cast<std::int64_t>(made->size() * sizeof(ActiveCell));
  const Cells* known = nullptr;
  if (kept.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel))
  {
    this->Bytes += bytes;
    return *made.release();
  }
  return *known; // another thread was faster
}

void LeafCells::Read(std::int64_t leaf, Cells& cells) const
{
  const std::uint64_t word = this->Leaves.CellsOf(leaf);
  cells.resize(hwy::PopCount(word));
  auto next = cells.begin();
  ForEachRay(word,
    [&](std::size_t bit)
    {
      ActiveCell& cell = *next++;
      cell.Rank = MeshLattice::SizeOfBlock * leaf + static_cast<std::int64_t>(bit);
      cell.Number = this->Tree.CellAt(cell.Rank);
      this->Tree.Reader().Read(cell.Number, cell.Cell);
      const auto count = static_cast<std::size_t>(cell.Cell.NumberOfPoints());
      for (std::size_t i = 0; i < 8; ++i)
      {
        const glm::dvec3& point = cell.Cell.Points[std::min(i, count - 1)];
        cell.Points[0][i] = point.x;
        cell.Points[1][i] = point.y;
        cell.Points[2][i] = point.z;
      }
    });
}

}
