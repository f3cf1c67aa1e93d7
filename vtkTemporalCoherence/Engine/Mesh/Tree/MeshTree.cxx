// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshTree.h"

#include "Acceleration/ValuesInBand.h"

#include <cmath>

namespace TemporalCoherence
{

std::shared_ptr<const MeshTree> MeshTree::Build(const std::shared_ptr<const Mesh>& mesh,
  const ReportProgress& progress, std::size_t memoryLimit, MeshProblem& problem)
{
  // Shares of the time that the steps take.
  constexpr double Checked = 0.2, Ordered = 0.7;
  problem = {};
  const std::shared_ptr<MeshTree> tree(new MeshTree(mesh));
  const std::vector<CellChunk> chunks = CheckMesh(*mesh, PartOf(progress, 0.0, Checked), problem);
  if (problem.Defect != MeshDefect::None)
  {
    return nullptr;
  }
  std::int64_t cells = 0;
  for (const CellChunk& chunk : chunks)
  {
    cells += chunk.NumberOfCells;
  }
  if (MemoryToBuild(cells) > memoryLimit)
  {
    problem.Defect = MeshDefect::NoMemory;
    return nullptr;
  }
  bool isStopped = false;
  tree->Order = std::make_shared<const CellNumbers>(
    OrderCells(tree->Cells, chunks, PartOf(progress, Checked, Ordered), isStopped));
  if (isStopped)
  {
    problem.Defect = MeshDefect::Stopped;
    return nullptr;
  }
  return tree->Refit(mesh, PartOf(progress, Ordered, 1.0), problem);
}

std::size_t MeshTree::MemoryToBuild(std::int64_t cells)
{
  // Building the boxes takes less memory than sorting.
  return MemoryToOrder(cells);
}

std::shared_ptr<const MeshTree> MeshTree::Refit(const std::shared_ptr<const Mesh>& mesh,
  const ReportProgress& progress, MeshProblem& problem) const
{
  problem = {};
  const std::shared_ptr<MeshTree> tree(new MeshTree(mesh));
  tree->Order = this->Order;
  const auto boxes = std::make_shared<MeshBoxes>();
  if (!boxes->Build(tree->Cells, *tree->Order, progress, problem))
  {
    return nullptr;
  }
  tree->Boxes = boxes;
  tree->Ranges = std::make_unique<MeshRanges>(tree->NumberOfLeaves());
  return tree;
}

std::shared_ptr<const MeshTree> MeshTree::WithValuesOf(
  const std::shared_ptr<const Mesh>& mesh) const
{
  const std::shared_ptr<MeshTree> tree(new MeshTree(mesh));
  tree->Order = this->Order;
  tree->Boxes = this->Boxes;
  tree->Ranges = std::make_unique<MeshRanges>(tree->NumberOfLeaves());
  return tree;
}

CellRange MeshTree::RangeOfLeaf(std::int64_t leaf, CellRange* finite) const
{
  CellRange range;
  MeshRanges::OfCells ofCells, finiteOfCells;
  std::uint64_t withNaN = 0;
  const std::int64_t first = 64 * leaf, end = this->EndOfLeaf(leaf);
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(end - first, 0));
  this->Cells.ReadValuesOfAll(this->Order->data() + first, count,
    [&](std::size_t cell, double value)
    {
      ofCells[cell].Widen(value);
      withNaN |= static_cast<std::uint64_t>(std::isnan(value)) << cell;
      if (finite && std::isfinite(value))
      {
        finiteOfCells[cell].Widen(value);
      }
    });
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    if ((withNaN >> cell & 1u) != 0)
    {
      ofCells[cell] = CellRange();
      continue;
    }
    range.Widen(ofCells[cell]);
    if (finite)
    {
      finite->Widen(finiteOfCells[cell]);
    }
  }
  if (count > 0)
  {
    this->Ranges->Keep(leaf, ofCells, count);
  }
  return range;
}

std::uint64_t MeshTree::CellsIn(std::int64_t leaf, const std::vector<ValueBand>& bands) const
{
  std::uint64_t active = 0;
  const std::int64_t first = 64 * leaf, end = this->EndOfLeaf(leaf);
  if (first >= end || this->Ranges->FindCells(leaf, bands, active))
  {
    return active;
  }
  for (std::int64_t rank = first; rank < end; ++rank)
  {
    const CellRange range = this->Cells.ReadRange(this->CellAt(rank));
    const bool isActive = std::any_of(bands.begin(), bands.end(),
      [&](const ValueBand& band) { return ReachInto(band, range.Min, range.Max); });
    active |= static_cast<std::uint64_t>(isActive) << (rank - first);
  }
  return active;
}

std::size_t MeshTree::MemoryInBytes() const
{
  return this->Order->capacity() * sizeof(std::uint32_t) + this->Boxes->MemoryInBytes() +
    this->Ranges->MemoryInBytes();
}

}
