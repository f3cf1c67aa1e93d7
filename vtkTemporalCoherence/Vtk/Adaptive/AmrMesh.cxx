// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Adaptive/AmrMesh.h"

#include "Adaptive/AmrLeaves.h"
#include "Mesh/Cells/MeshCell.h"
#include "Shapes/MadeCells.h"
#include "Shapes/PointReader.h"

#include <vtkDataArray.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{
namespace
{

/// Cells or vertices of a block at one height: the work of one task.
struct Slice
{
  std::size_t Block;
  std::int64_t Z; ///< on the lattice of the block's level
};

std::vector<Slice> SlicesOf(const AmrBlocks& blocks, int more)
{
  std::vector<Slice> slices;
  for (std::size_t b = 0; b < blocks.Blocks.size(); ++b)
  {
    const AmrBox& cells = blocks.Blocks[b].Cells;
    for (std::int64_t z = cells.First.z; z < cells.End.z + more; ++z)
    {
      slices.push_back({ b, z });
    }
  }
  return slices;
}

template <typename Action>
void InParallel(const std::vector<Slice>& slices, const Action& action)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(slices.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
      {
        action(s);
      }
    });
}

/// Make a point for each leaf.
void MakePoints(
  const AmrBlocks& blocks, const AmrLeaves& leaves, int component, std::vector<PointValue>& points)
{
  points.resize(static_cast<std::size_t>(leaves.Count()));
  const std::vector<Slice> slices = SlicesOf(blocks, 0);
  InParallel(slices,
    [&](std::size_t s)
    {
      const AmrBlock& block = blocks.Blocks[slices[s].Block];
      const glm::dvec3 spacing = blocks.Levels[block.Level].Spacing;
      for (std::int64_t y = block.Cells.First.y; y < block.Cells.End.y; ++y)
      {
        for (std::int64_t x = block.Cells.First.x; x < block.Cells.End.x; ++x)
        {
          const glm::i64vec3 cell(x, y, slices[s].Z);
          const std::int32_t leaf = leaves.NumberOf(slices[s].Block, block.NumberOf(cell));
          if (leaf >= 0)
          {
            const glm::dvec3 at = blocks.Origin + (glm::dvec3(cell) + 0.5) * spacing;
            points[static_cast<std::size_t>(leaf)] = { at.x, at.y, at.z,
              ValueOf(block.Array, block.IndexOf(cell), component) };
          }
        }
      }
    });
}

/// A leaf, by its block and its number.
struct AmrLeaf
{
  std::size_t Block;
  std::int32_t Number; ///< -1: there is none
};

/// Finds leaves around vertices of a block. Remembers where it found the last ones.
class LeafSearch
{
public:
  LeafSearch(const AmrBlocks& blocks, const AmrLeaves& leaves, std::size_t block);

  /// Find the leaves in the eight octants around a vertex of the block's level. The leaf towards
  /// (x, y, z) has the position x + 2 y + 4 z.
  /// \return false if an octant has no leaf, or the leaf of an earlier block
  bool FindAround(const glm::i64vec3& vertex, std::array<std::int32_t, 8>& numbers);

private:
  AmrLeaf LeafIn(std::size_t block, const glm::i64vec3& finest) const;
  AmrLeaf FindLeaf(const glm::i64vec3& finest, std::size_t& last) const;

  const AmrBlocks& Blocks;
  const AmrLeaves& Leaves;
  std::size_t Block;
  std::array<std::size_t, 8> Last; ///< for each octant
};

LeafSearch::LeafSearch(const AmrBlocks& blocks, const AmrLeaves& leaves, std::size_t block)
  : Blocks(blocks)
  , Leaves(leaves)
  , Block(block)
{
  this->Last.fill(block);
}

AmrLeaf LeafSearch::LeafIn(std::size_t number, const glm::i64vec3& finest) const
{
  const AmrBlock& block = this->Blocks.Blocks[number];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (finest[axis] < block.Finest.First[axis] || finest[axis] >= block.Finest.End[axis])
    {
      return { number, -1 };
    }
  }
  const glm::i64vec3 at =
    (finest - block.Finest.First) / this->Blocks.Levels[block.Level].Ratio + block.Cells.First;
  return { number, this->Leaves.NumberOf(number, block.NumberOf(at)) };
}

AmrLeaf LeafSearch::FindLeaf(const glm::i64vec3& finest, std::size_t& last) const
{
  // Leaves do not overlap, so the first match ends the search.
  AmrLeaf leaf = this->LeafIn(last, finest);
  if (leaf.Number < 0 && last != this->Block)
  {
    leaf = this->LeafIn(this->Block, finest);
  }
  const std::vector<std::size_t>& neighbours = this->Blocks.Neighbours[this->Block];
  for (std::size_t n = 0; n < neighbours.size() && leaf.Number < 0; ++n)
  {
    leaf = this->LeafIn(neighbours[n], finest);
  }
  last = leaf.Number < 0 ? this->Block : leaf.Block;
  return leaf;
}

bool LeafSearch::FindAround(const glm::i64vec3& vertex, std::array<std::int32_t, 8>& numbers)
{
  const AmrBlock& block = this->Blocks.Blocks[this->Block];
  const glm::i64vec3 corner = vertex * this->Blocks.Levels[block.Level].Ratio;
  for (std::size_t octant = 0; octant < 8; ++octant)
  {
    const glm::i64vec3 finest(corner.x - (octant & 1u ? 0 : 1), corner.y - (octant & 2u ? 0 : 1),
      corner.z - (octant & 4u ? 0 : 1));
    const AmrLeaf leaf = this->FindLeaf(finest, this->Last[octant]);
    if (leaf.Number < 0 || leaf.Block < this->Block)
    {
      return false;
    }
    numbers[octant] = leaf.Number;
  }
  return true;
}

/// Call action(corners) for each hexahedron around a vertex of a slice.
template <typename Action>
void ForHexahedra(
  const AmrBlocks& blocks, const AmrLeaves& leaves, const Slice& slice, const Action& action)
{
  const AmrBlock& block = blocks.Blocks[slice.Block];
  const glm::i64vec3 size = block.Cells.Size();
  const std::int32_t* numbers = leaves.NumbersOf(slice.Block);
  LeafSearch search(blocks, leaves, slice.Block);
  const glm::i64vec3 first = block.Cells.First, end = block.Cells.End;
  for (std::int64_t y = first.y; y <= end.y; ++y)
  {
    const bool isRowInside = y > first.y && y < end.y && slice.Z > first.z && slice.Z < end.z;
    const std::int64_t row = size.x * (y - first.y - 1 + size.y * (slice.Z - first.z - 1));
    for (std::int64_t x = first.x; x <= end.x; ++x)
    {
      std::array<std::int32_t, 8> corners;
      if (isRowInside && x > first.x && x < end.x)
      {
        const std::int32_t* at = numbers + row + (x - first.x - 1);
        const std::int64_t up = size.x * size.y;
        corners = { at[0], at[1], at[size.x], at[size.x + 1], at[up], at[up + 1], at[up + size.x],
          at[up + size.x + 1] };
        if (*std::min_element(corners.begin(), corners.end()) >= 0)
        {
          action(corners);
          continue;
        }
      }
      if (search.FindAround({ x, y, slice.Z }, corners))
      {
        action(corners);
      }
    }
  }
}

/// Make the hexahedra, in the order of the slices.
/// \return false if there are too many, or too many for the budget
bool MakeHexahedra(
  const AmrBlocks& blocks, const AmrLeaves& leaves, MakingBudget& budget, MadeCells& made)
{
  const std::vector<Slice> slices = SlicesOf(blocks, 1);
  std::vector<std::int64_t> counts(slices.size());
  InParallel(slices,
    [&](std::size_t s)
    {
      std::int64_t count = 0;
      ForHexahedra(blocks, leaves, slices[s], [&](const auto&) { ++count; });
      counts[s] = count;
    });
  std::int64_t total = 0;
  for (std::int64_t& ofSlice : counts)
  {
    total += ofSlice;
    ofSlice = total - ofSlice; // the number of its first hexahedron
  }
  const std::size_t bytes = static_cast<std::size_t>(9 * total) * sizeof(std::int32_t) +
    static_cast<std::size_t>(leaves.Count()) * sizeof(PointValue);
  if (8 * total > MostMadeIds || !budget.Allows(bytes, total))
  {
    return false;
  }
  made.Connectivity.resize(static_cast<std::size_t>(8 * total));
  InParallel(slices,
    [&](std::size_t s)
    {
      std::int32_t* next = made.Connectivity.data() + 8 * counts[s];
      ForHexahedra(blocks, leaves, slices[s],
        [&](const std::array<std::int32_t, 8>& corners)
        {
          for (const std::uint8_t corner : HexahedronCorners)
          {
            *next++ = corners[corner];
          }
        });
    });
  made.Offsets.resize(static_cast<std::size_t>(total + 1));
  for (std::size_t c = 0; c < made.Offsets.size(); ++c)
  {
    made.Offsets[c] = static_cast<std::int32_t>(8 * c);
  }
  return true;
}

/// Bytes of one number for each cell.
std::size_t MemoryOfNumbers(const AmrBlocks& blocks)
{
  std::size_t cells = 0;
  for (const AmrBlock& block : blocks.Blocks)
  {
    const glm::i64vec3 size = block.Cells.Size();
    cells += static_cast<std::size_t>(size.x * size.y * size.z);
  }
  return cells * sizeof(std::int32_t);
}

}

bool HasOneLevel(AdaptiveGrid* amr)
{
  unsigned int lowest = ~0u, highest = 0;
  ForEachGrid(amr,
    [&](unsigned int level, vtkImageData*)
    {
      lowest = std::min(lowest, level);
      highest = std::max(highest, level);
    });
  return lowest >= highest;
}

vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(AdaptiveGrid* amr)
{
  const auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  ForEachGrid(amr,
    [&](unsigned int, vtkImageData* grid) { blocks->SetBlock(blocks->GetNumberOfBlocks(), grid); });
  return blocks;
}

bool AppendAmrMesh(AdaptiveGrid* amr, const ScalarChoice& choice, int component,
  std::vector<MeshPart>& parts, std::string& error, MakingBudget* budget)
{
  MakingBudget unlimited;
  MakingBudget& limits = budget ? *budget : unlimited;
  AmrBlocks blocks;
  if (!FindAmrBlocks(amr, choice, blocks, error))
  {
    return false;
  }
  if (!limits.Allows(MemoryOfNumbers(blocks), 0) || !limits.GoesOn(0.0))
  {
    return false;
  }
  AmrLeaves leaves;
  const auto made = std::make_shared<MadeCells>();
  if (!leaves.Find(blocks) || !MakeHexahedra(blocks, leaves, limits, *made))
  {
    if (limits.IsTooSmall())
    {
      return false;
    }
    error = "The adaptive grid has more than " + std::to_string(MostMadeIds / 8) +
      " cells; draw fewer levels of it, for example with vtkExtractLevel.";
    return false;
  }
  if (!limits.GoesOn(0.7))
  {
    return false;
  }
  MakePoints(blocks, leaves, component, made->Points);
  parts.push_back(PartOf(made));
  return true;
}

}
