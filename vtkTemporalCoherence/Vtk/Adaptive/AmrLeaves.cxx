// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Adaptive/AmrLeaves.h"

#include <vtkDataSetAttributes.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

bool HasFlag(const AmrBlock& block, const glm::i64vec3& cell, int flag)
{
  return block.Ghosts && (block.Ghosts[block.IndexOf(cell)] & flag) != 0;
}

/// Call action(cell) for each cell of a block that overlaps a box of the finest lattice.
template <typename Action>
void ForCellsIn(
  const AmrBlocks& blocks, const AmrBlock& block, const AmrBox& finest, const Action& action)
{
  const glm::i64vec3 ratio = blocks.Levels[block.Level].Ratio;
  const glm::i64vec3 first = (finest.First - block.Finest.First) / ratio + block.Cells.First;
  const glm::i64vec3 end =
    (finest.End - block.Finest.First + ratio - std::int64_t(1)) / ratio + block.Cells.First;
  for (std::int64_t z = first.z; z < end.z; ++z)
  {
    for (std::int64_t y = first.y; y < end.y; ++y)
    {
      for (std::int64_t x = first.x; x < end.x; ++x)
      {
        action(glm::i64vec3(x, y, z));
      }
    }
  }
}

/// Mark the leaves of a block with 0 and its other cells with -1.
void MarkLeaves(const AmrBlocks& blocks, std::size_t number, std::vector<std::int32_t>& marks)
{
  const AmrBlock& block = blocks.Blocks[number];
  const glm::i64vec3 size = block.Cells.Size();
  marks.assign(static_cast<std::size_t>(size.x * size.y * size.z), 0);
  constexpr int hiding = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  if (block.Ghosts)
  {
    ForCellsIn(blocks, block, block.Finest,
      [&](const glm::i64vec3& cell) {
        marks[static_cast<std::size_t>(block.NumberOf(cell))] =
          HasFlag(block, cell, hiding) ? -1 : 0;
      });
  }
  for (const std::size_t neighbour : blocks.Neighbours[number])
  {
    const AmrBlock& other = blocks.Blocks[neighbour];
    const AmrBox both = Common(block.Finest, other.Finest);
    if (neighbour > number || IsEmpty(both))
    {
      continue;
    }
    const bool isFiner = other.Level != block.Level;
    ForCellsIn(blocks, block, both,
      [&](const glm::i64vec3& cell)
      {
        if (isFiner || !HasFlag(other, cell, vtkDataSetAttributes::HIDDENCELL))
        {
          marks[static_cast<std::size_t>(block.NumberOf(cell))] = -1;
        }
      });
  }
}

}

bool AmrLeaves::Find(const AmrBlocks& blocks)
{
  const std::size_t count = blocks.Blocks.size();
  this->Numbers.assign(count, {});
  std::vector<std::int64_t> counts(count);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto b = static_cast<std::size_t>(begin); b < static_cast<std::size_t>(end); ++b)
      {
        std::vector<std::int32_t>& marks = this->Numbers[b];
        MarkLeaves(blocks, b, marks);
        counts[b] = std::count(marks.begin(), marks.end(), 0);
      }
    });
  std::int64_t total = 0;
  for (std::int64_t& ofBlock : counts)
  {
    total += ofBlock;
    ofBlock = total - ofBlock; // the number of its first leaf
  }
  if (total > std::numeric_limits<std::int32_t>::max())
  {
    return false;
  }
  this->Total = static_cast<std::int32_t>(total);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto b = static_cast<std::size_t>(begin); b < static_cast<std::size_t>(end); ++b)
      {
        auto next = static_cast<std::int32_t>(counts[b]);
        for (std::int32_t& number : this->Numbers[b])
        {
          number = number < 0 ? -1 : next++;
        }
      }
    });
  return true;
}

}
