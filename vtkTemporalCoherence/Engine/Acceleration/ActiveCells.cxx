// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/ActiveCells.h"

#include "Acceleration/ValuesInBand.h"
#include "Scene/CellBox.h"
#include "Scene/LabelSets.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// True if an isovalue of one of the ascending bands passes between samples of the range. False for
/// an empty range, as of leaves outside the field.
template <typename T>
bool IsActive(const ValueRangePyramid::Range<T>& range, const std::vector<ValueBand>& bands)
{
  const double min = static_cast<double>(range.Min);
  const double max = static_cast<double>(range.Max);
  for (const ValueBand& band : bands)
  {
    if (band.Low > max || min > max)
    {
      return false;
    }
    if (ReachInto(band, min, max))
    {
      return true;
    }
  }
  return false;
}

/// One bit for each leaf of a node through which an isovalue of the bands passes. The node's range
/// is looked at first: of most nodes it tells enough, and it is 1/64 of the memory.
template <typename T>
std::uint64_t LeavesBetween(
  const ValueRangePyramid& pyramid, std::int64_t node, const std::vector<ValueBand>& bands)
{
  std::uint64_t leaves = 0;
  const bool isActive = IsActive(pyramid.NodeAt<T>(node), bands);
  const ValueRangePyramid::Range<T>* const ranges = pyramid.LeavesOf<T>(node);
  for (int i = 0; isActive && i < ValueRangePyramid::LeavesPerNode; ++i)
  {
    leaves |= static_cast<std::uint64_t>(IsActive(ranges[i], bands)) << i;
  }
  return leaves;
}

/// The high end of an isovalue's band: an active cell has a value below it. Solids in meshes are
/// capped where rays enter them, so cells wholly inside are active, too.
double HighestActive(const Field& field, double isovalue, SurfaceMode mode)
{
  return mode == SurfaceMode::Threshold && field.Shape->Abilities().IsMesh
    ? std::numeric_limits<double>::infinity()
    : isovalue;
}

/// Words that are 0. The system gives memory only for those that are written.
std::shared_ptr<std::atomic<std::uint64_t>[]> EmptyWords(std::size_t count)
{
  void* const words = std::calloc(std::max(count, std::size_t(1)), sizeof(std::uint64_t));
  if (!words)
  {
    throw std::bad_alloc();
  }
  return { static_cast<std::atomic<std::uint64_t>*>(words), std::free };
}

}

std::uint64_t ActiveCells::CellsIn(const FieldShape& shape, const glm::ivec3& firstCell) const
{
  return shape.CellsIn({ firstCell, glm::ivec3(LeafSize) }, this->Bands);
}

/// One bit for each leaf of a node in which the bands of some values count.
std::uint64_t ActiveCells::LeavesThatCount(const SeenValues& values, std::int64_t node)
{
  return values.Labels ? values.Labels->LeavesWith(*values.CountFor, node) : ~std::uint64_t(0);
}

/// One bit for each leaf of a node that has several labels, some of which are drawn.
std::uint64_t ActiveCells::LeavesWithLabels(const LabelIndex& drawn, std::int64_t node) const
{
  const std::uint64_t mixed = this->Labels->MixedLeaves(node);
  return mixed == 0 ? 0 : mixed & this->Labels->LeavesWith(drawn, node);
}

void ActiveCells::Build(const Field& field, const ValueRangePyramid& pyramid,
  const Surfaces& surfaces, const ActiveCells* last)
{
  this->Release();
  for (const double isovalue : surfaces.Isovalues)
  {
    this->Bands.push_back({ isovalue, HighestActive(field, isovalue, surfaces.Mode) });
  }
  std::sort(this->Bands.begin(), this->Bands.end(),
    [](const ValueBand& a, const ValueBand& b) { return a.Low < b.Low; });
  this->IsCapped = field.Hidden && surfaces.Mode == SurfaceMode::Threshold;
  this->Labels = field.Labels;
  if (this->Labels)
  {
    const LabelIndex drawn(surfaces.Isovalues);
    this->FindLeaves(field, pyramid, &drawn, {}, last);
  }
  else
  {
    this->FindLeaves(field, pyramid);
  }
}

void ActiveCells::Build(
  const Field& field, const ValueRangePyramid& pyramid, const ValueBand& band, SurfaceMode mode)
{
  this->Release();
  this->Bands = { { band.Low, HighestActive(field, band.High, mode) } };
  this->IsCapped = field.Hidden && mode == SurfaceMode::Threshold;
  this->FindLeaves(field, pyramid);
}

void ActiveCells::BuildVisible(
  const Field& field, const ValueRangePyramid& pyramid, const std::vector<ValueBand>& bands)
{
  this->Release();
  this->Bands = bands;
  this->FindLeaves(field, pyramid);
}

void ActiveCells::BuildVisible(const std::vector<SeenValues>& fields)
{
  this->Release();
  const SeenValues& first = fields.front();
  this->Bands = first.Bands;
  this->Others.assign(fields.begin() + 1, fields.end());
  this->FindLeaves(first.Samples, *first.Pyramid, nullptr, this->Others);
}

/// The active leaves of a node with hidden cells. There the value range of a leaf does not tell
/// whether it has an active cell.
/// \param firstCell of the node
/// \param ranges    of its leaves
/// \param leaves    active leaves if no cell were hidden
template <typename T>
std::uint64_t ActiveCells::FindVisibleLeaves(const TypedField<T>& field,
  const glm::ivec3& firstCell, const ValueRangePyramid::Range<T>* ranges,
  std::uint64_t leaves) const
{
  for (int i = 0; i < ValueRangePyramid::LeavesPerNode; ++i)
  {
    const glm::ivec3 first = firstCell + LeafSize * glm::ivec3(i & 3, i >> 2 & 3, i >> 4);
    const std::uint64_t leaf = std::uint64_t(1) << i;
    const bool isActive = (leaves & leaf) != 0;
    const bool canBeCapped = this->IsCapped && !this->Bands.empty() &&
      static_cast<double>(ranges[i].Max) >= this->Bands.front().Low;
    // Most leaves are far from hidden cells.
    const bool isPlain = isActive ? this->Hidden->LeafAt(first) == 0
                                  : !canBeCapped || this->Hidden->Around(first) == 0;
    if (isPlain || glm::any(glm::greaterThanEqual(first, field.Dimensions - 1)))
    {
      continue;
    }
    leaves = this->FindCells(field, first) != 0 ? leaves | leaf : leaves & ~leaf;
  }
  return leaves;
}

/// True if the leaves of a node have words. Those of labels serve other sets of labels, too.
bool ActiveCells::HasWords(std::int64_t node) const
{
  return this->Labels ? this->Hidden || this->Labels->LabelsOf(node).size() > 1
                      : this->LeavesOf(node) != 0;
}

/// \param drawn labels that are drawn; null: samples are no labels
/// \param last  see Build
void ActiveCells::FindLeaves(const Field& field, const ValueRangePyramid& pyramid,
  const LabelIndex* drawn, const std::vector<SeenValues>& others, const ActiveCells* last)
{
  const std::int64_t nodes = pyramid.NumberOfNodes();
  const glm::ivec3& along = pyramid.NodeDimensions();
  this->NodeWords.resize(static_cast<std::size_t>(2 * nodes));
  this->Hidden = field.Hidden;
  this->Dimensions = along;

  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      ParallelFor(nodes, 64,
        [&](std::int64_t node)
        {
          const auto* ranges = pyramid.LeavesOf<T>(node);
          std::uint64_t leaves = drawn ? this->LeavesWithLabels(*drawn, node)
                                       : LeavesBetween<T>(pyramid, node, this->Bands);
          for (const SeenValues& other : others)
          {
            leaves |=
              LeavesBetween<T>(*other.Pyramid, node, other.Bands) & LeavesThatCount(other, node);
          }
          if (this->Hidden)
          {
            const glm::ivec3 place(
              node % along.x, node / along.x % along.y, node / along.x / along.y);
            leaves =
              this->FindVisibleLeaves(TypedField<T>(field), NodeSize * place, ranges, leaves);
          }
          this->NodeWords[static_cast<std::size_t>(2 * node)] = leaves;
        });
    });

  std::uint64_t words = 0;
  for (std::int64_t node = 0; node < nodes; ++node)
  {
    this->NodeWords[static_cast<std::size_t>(2 * node + 1)] = words;
    words += this->HasWords(node) ? ValueRangePyramid::LeavesPerNode : 0;
  }
  this->LeafWords = last ? last->LeafWords : EmptyWords(static_cast<std::size_t>(words));
  this->NumberOfLeafWords = words;
  this->FindLevelsAbove(pyramid.NodeDimensions());
}

void ActiveCells::FindLevelsAbove(const glm::ivec3& nodes)
{
  glm::ivec3 below = nodes;
  const auto isActive = [&](const glm::ivec3& child)
  {
    if (this->Above.size() > 1)
    {
      return this->Above[this->Above.size() - 2].WordOf(child) != 0;
    }
    const std::int64_t row = child.y + static_cast<std::int64_t>(nodes.y) * child.z;
    return this->LeavesOf(child.x + nodes.x * row) != 0;
  };
  do
  {
    const glm::ivec3 blocks = (below + 3) / 4;
    this->Above.push_back({ blocks, {} });
    std::vector<std::uint64_t> words(static_cast<std::size_t>(blocks.x) *
      static_cast<std::size_t>(blocks.y) * static_cast<std::size_t>(blocks.z));
    for (int z = 0; z < below.z; ++z)
    {
      for (int y = 0; y < below.y; ++y)
      {
        const std::size_t row = static_cast<std::size_t>(blocks.x) *
          (static_cast<std::size_t>(y / 4) +
            static_cast<std::size_t>(blocks.y) * static_cast<std::size_t>(z / 4));
        for (int x = 0; x < below.x; ++x)
        {
          const int child = (x & 3) | (y & 3) << 2 | (z & 3) << 4;
          words[row + static_cast<std::size_t>(x / 4)] |=
            static_cast<std::uint64_t>(isActive({ x, y, z })) << child;
        }
      }
    }
    this->Above.back().Words = std::move(words);
    below = blocks;
  } while (glm::any(glm::greaterThan(below, glm::ivec3(1))));
}

void ActiveCells::Release()
{
  this->Dimensions = glm::ivec3(0);
  this->Bands.clear();
  this->Others.clear();
  std::vector<std::uint64_t>().swap(this->NodeWords);
  this->LeafWords.reset();
  this->NumberOfLeafWords = 0;
  this->Above.clear();
  this->Hidden.reset();
  this->IsCapped = false;
  this->Labels.reset();
}

std::size_t ActiveCells::MemoryInBytes() const
{
  std::size_t words = this->NodeWords.capacity() + this->NumberOfLeafWords;
  for (const Level& level : this->Above)
  {
    words += level.Words.capacity();
  }
  return sizeof(std::uint64_t) * words;
}

}
