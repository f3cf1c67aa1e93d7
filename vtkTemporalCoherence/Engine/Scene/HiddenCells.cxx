// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/HiddenCells.h"

#include "Scene/Field.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include <hwy/base.h>

namespace TemporalCoherence
{
namespace
{

constexpr int LeafSize = CellBlocks::LeafSize;

/// Bits of a row of flags, lowest first: 1 where a flag has any bit of the mask.
std::uint32_t BitsOfRow(const std::uint8_t* flags, int count, std::uint8_t mask)
{
  std::uint32_t bits = 0;
  for (int i = 0; i < count; ++i)
  {
    bits |= static_cast<std::uint32_t>((flags[i] & mask) != 0) << i;
  }
  return bits;
}

/// Address of a flag in an array with `count` flags along each axis.
const std::uint8_t* At(const std::uint8_t* flags, const glm::ivec3& place, const glm::ivec3& count)
{
  return flags + place.x +
    static_cast<std::int64_t>(count.x) * (place.y + static_cast<std::int64_t>(count.y) * place.z);
}

/// The cells of a leaf that their own flags hide.
std::uint64_t HiddenByCells(
  const HidingFlags& flags, const glm::ivec3& firstCell, const glm::ivec3& cells)
{
  const glm::ivec3 count = glm::min(cells - firstCell, glm::ivec3(LeafSize));
  std::uint64_t hidden = 0;
  for (int k = 0; k < count.z; ++k)
  {
    for (int j = 0; j < count.y; ++j)
    {
      const std::uint8_t* row = At(flags.OfCells, firstCell + glm::ivec3(0, j, k), cells);
      const std::uint64_t bits = BitsOfRow(row, count.x, flags.CellMask);
      hidden |= bits << (4 * j + 16 * k);
    }
  }
  return hidden;
}

/// The cells of a leaf with a corner sample of some property.
/// \param bitsOfRow bitsOfRow(first, count) gives one bit for each sample of a row, set if it has
///                  the property
template <typename BitsOf>
std::uint64_t CellsAround(
  const glm::ivec3& firstCell, const glm::ivec3& samples, const BitsOf& bitsOfRow)
{
  const glm::ivec3 count = glm::min(samples - firstCell, glm::ivec3(LeafSize + 1));
  const std::uint32_t cellsInRow = (1u << (count.x - 1)) - 1u;
  std::uint64_t around = 0;
  for (int k = 0; k < count.z; ++k)
  {
    for (int j = 0; j < count.y; ++j)
    {
      const std::uint32_t bits = bitsOfRow(firstCell + glm::ivec3(0, j, k), count.x);
      const std::uint64_t alongX = (bits | bits >> 1) & cellsInRow;
      // Cells before and behind the row have corners in it, along y and z.
      for (int z = std::max(k - 1, 0); z <= std::min(k, count.z - 2); ++z)
      {
        for (int y = std::max(j - 1, 0); y <= std::min(j, count.y - 2); ++y)
        {
          around |= alongX << (4 * y + 16 * z);
        }
      }
    }
  }
  return around;
}

/// The cells of a leaf with a corner whose flag has any bit of the mask.
std::uint64_t CellsAround(const std::uint8_t* flags, std::uint8_t mask, const glm::ivec3& firstCell,
  const glm::ivec3& samples)
{
  return CellsAround(firstCell, samples,
    [&](const glm::ivec3& first, int count)
    { return BitsOfRow(At(flags, first, samples), count, mask); });
}

/// The cells of a leaf with a NaN sample.
template <typename T>
std::uint64_t CellsWithNaN(const TypedField<T>& field, const glm::ivec3& firstCell)
{
  return CellsAround(firstCell, field.Dimensions,
    [&](const glm::ivec3& first, int count)
    {
      std::uint32_t bits = 0;
      for (int i = 0; i < count; ++i)
      {
        const auto value = static_cast<double>(*field.At(first + glm::ivec3(i, 0, 0)));
        bits |= static_cast<std::uint32_t>(std::isnan(value)) << i;
      }
      return bits;
    });
}

/// The first cell of a leaf of a node.
glm::ivec3 FirstCellOf(std::int64_t node, const glm::ivec3& nodes, int leaf)
{
  const glm::ivec3 place(node % nodes.x, node / nodes.x % nodes.y, node / nodes.x / nodes.y);
  return CellBlocks::NodeSize * place + LeafSize * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4);
}

/// The cells of a leaf inside the field's box.
std::uint64_t CellsInField(const glm::ivec3& firstCell, const glm::ivec3& cells)
{
  const glm::ivec3 count = glm::min(cells - firstCell, glm::ivec3(LeafSize));
  std::uint64_t all = 0;
  for (int k = 0; k < count.z; ++k)
  {
    for (int j = 0; j < count.y; ++j)
    {
      all |= ((std::uint64_t(1) << count.x) - 1u) << (4 * j + 16 * k);
    }
  }
  return all;
}

}

std::shared_ptr<const HiddenCells> HiddenCells::Make(
  const glm::ivec3& samples, const HidingFlags& flags)
{
  const std::shared_ptr<HiddenCells> made(new HiddenCells);
  const glm::ivec3 cells = samples - 1;
  const glm::ivec3 nodes = CellBlocks::NodesFor(samples);
  const std::int64_t count = static_cast<std::int64_t>(nodes.x) * nodes.y * nodes.z;
  made->Nodes = nodes;
  made->Words.resize(static_cast<std::size_t>(count * CellBlocks::LeavesPerNode));
  std::atomic<bool> isAnyHidden{ false };
  ParallelFor(count, 16,
    [&](std::int64_t node)
    {
      std::uint64_t all = 0;
      for (int leaf = 0; leaf < CellBlocks::LeavesPerNode; ++leaf)
      {
        const glm::ivec3 first = FirstCellOf(node, nodes, leaf);
        if (glm::any(glm::greaterThanEqual(first, cells)))
        {
          continue;
        }
        std::uint64_t hidden = flags.OfCells ? HiddenByCells(flags, first, cells) : 0;
        hidden |=
          flags.OfSamples ? CellsAround(flags.OfSamples, flags.SampleMask, first, samples) : 0;
        if (flags.Shown)
        {
          hidden |= CellsInField(first, cells) & ~CellsAround(flags.Shown, 0xff, first, samples);
        }
        made->Words[static_cast<std::size_t>(node * CellBlocks::LeavesPerNode + leaf)] = hidden;
        all |= hidden;
      }
      if (all != 0)
      {
        isAnyHidden.store(true, std::memory_order_relaxed);
      }
    });
  return isAnyHidden ? made : nullptr;
}

std::shared_ptr<const HiddenCells> HiddenCells::WithoutNaN(
  const Field& field, const std::vector<std::uint64_t>& leavesWithNaN)
{
  if (leavesWithNaN.empty())
  {
    return field.Flagged;
  }
  const std::shared_ptr<HiddenCells> made(
    field.Flagged ? new HiddenCells(*field.Flagged) : new HiddenCells);
  made->Nodes = CellBlocks::NodesFor(field.Dimensions);
  made->Words.resize(leavesWithNaN.size() * CellBlocks::LeavesPerNode);
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      const TypedField<decltype(type)> samples(field);
      ParallelFor(static_cast<std::int64_t>(leavesWithNaN.size()), 16,
        [&](std::int64_t node)
        {
          for (int leaf = 0; leaf < CellBlocks::LeavesPerNode; ++leaf)
          {
            if (leavesWithNaN[static_cast<std::size_t>(node)] >> leaf & 1u)
            {
              made->Words[static_cast<std::size_t>(node * CellBlocks::LeavesPerNode + leaf)] |=
                CellsWithNaN(samples, FirstCellOf(node, made->Nodes, leaf));
            }
          }
        });
    });
  return made;
}

std::int64_t HiddenCells::Count() const
{
  std::int64_t count = 0;
  for (const std::uint64_t word : this->Words)
  {
    count += static_cast<std::int64_t>(hwy::PopCount(word));
  }
  return count;
}

std::uint64_t HiddenCells::Around(const glm::ivec3& firstCell) const
{
  std::array<std::uint64_t, 27> leaves;
  std::uint64_t any = 0;
  for (int i = 0; i < 27; ++i)
  {
    const glm::ivec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    leaves[static_cast<std::size_t>(i)] = this->LeafAt(firstCell + LeafSize * step);
    any |= leaves[static_cast<std::size_t>(i)];
  }
  if (any == 0)
  {
    return 0;
  }
  // Rows of six cells, one more at each end, are folded along x, then six rows along y and six
  // slices along z.
  std::array<std::uint64_t, 6> slices{};
  for (int k = -1; k <= LeafSize; ++k)
  {
    std::array<std::uint64_t, 6> rows{};
    for (int j = -1; j <= LeafSize; ++j)
    {
      const int shift = 4 * (j & 3) + 16 * (k & 3);
      const auto leaf =
        static_cast<std::size_t>(3 * ((j + LeafSize) / LeafSize) + 9 * ((k + LeafSize) / LeafSize));
      const std::uint64_t row = (leaves[leaf] >> shift >> 3 & 1u) |
        (leaves[leaf + 1] >> shift & 15u) << 1 | (leaves[leaf + 2] >> shift & 1u) << 5;
      rows[static_cast<std::size_t>(j + 1)] = (row | row >> 1 | row >> 2) & 15u;
    }
    for (std::size_t j = 0; j < 4; ++j)
    {
      slices[static_cast<std::size_t>(k + 1)] |= (rows[j] | rows[j + 1] | rows[j + 2]) << 4 * j;
    }
  }
  std::uint64_t around = 0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    around |= (slices[k] | slices[k + 1] | slices[k + 2]) << 16 * k;
  }
  return around;
}

}
