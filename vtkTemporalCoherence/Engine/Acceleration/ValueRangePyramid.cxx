// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/ValueRangePyramid.h"

#include "Acceleration/KernelsPyramid.h"
#include "Scene/CellBox.h"
#include "Scene/LabelSets.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr int LeafSize = ValueRangePyramid::LeafSize, NodeSize = ValueRangePyramid::NodeSize;

template <typename T>
using Range = ValueRangePyramid::Range<T>;

template <typename T>
Range<T> Union(const Range<T>& a, const Range<T>& b)
{
  return { std::min(a.Min, b.Min), std::max(a.Max, b.Max) };
}

/// The cells of a leaf of a node. Their size is not positive beyond the end of the field.
CellBox CellsOfLeaf(const Field& field, const glm::ivec3& node, int leaf)
{
  const glm::ivec3 first =
    NodeSize * node + LeafSize * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4);
  return { first, glm::min(field.Dimensions - 1 - first, glm::ivec3(LeafSize)) };
}

template <typename T>
bool IsFinite(const Range<T>& range)
{
  return std::isfinite(static_cast<double>(range.Min)) &&
    std::isfinite(static_cast<double>(range.Max));
}

/// The range of all samples of nodes.
template <typename T>
glm::dvec2 WholeRangeOf(const Range<T>* nodes, std::int64_t count)
{
  Range<T> all = ValueRangePyramid::Empty<T>();
  for (std::int64_t node = 0; node < count; ++node)
  {
    all.Min = std::min(all.Min, nodes[node].Min);
    all.Max = std::max(all.Max, nodes[node].Max);
  }
  return { static_cast<double>(all.Min), static_cast<double>(all.Max) };
}

/// The result of scanning a leaf's samples one by one.
template <typename T>
struct LeafLook
{
  Range<T> All = ValueRangePyramid::Empty<T>();    ///< of the samples that are numbers
  Range<T> Finite = ValueRangePyramid::Empty<T>(); ///< of the finite ones
  bool HasNaN = false;
};

template <typename T>
LeafLook<T> LookAt(const TypedField<T>& field, const CellBox& cells)
{
  LeafLook<T> look;
  const glm::ivec3 last = cells.First + cells.Size;
  for (int k = cells.First.z; k <= last.z; ++k)
  {
    for (int j = cells.First.y; j <= last.y; ++j)
    {
      for (int i = cells.First.x; i <= last.x; ++i)
      {
        const T value = *field.At(i, j, k);
        const Range<T> one{ value, value };
        if (std::isnan(static_cast<double>(value)))
        {
          look.HasNaN = true;
          continue;
        }
        look.All = Union(look.All, one);
        look.Finite = IsFinite(one) ? Union(look.Finite, one) : look.Finite;
      }
    }
  }
  return look;
}

/// Look again at the leaves of a node whose samples are not all finite: kernels take NaN for
/// -infinity.
/// \param leaves, node their ranges are corrected
/// \param finite is widened by the finite samples
/// \return one bit for each leaf with a sample that is not a number
template <typename T>
std::uint64_t LookAgain(
  const Field& field, const glm::ivec3& place, Range<T>* leaves, Range<T>& node, Range<T>& finite)
{
  std::uint64_t withNaN = 0;
  node = ValueRangePyramid::Empty<T>();
  for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
  {
    const CellBox cells = CellsOfLeaf(field, place, leaf);
    if (glm::any(glm::lessThan(cells.Size, glm::ivec3(1))))
    {
      continue;
    }
    if (IsFinite(leaves[leaf]))
    {
      node = Union(node, leaves[leaf]);
      finite = Union(finite, leaves[leaf]);
      continue;
    }
    const LeafLook<T> look = LookAt(TypedField<T>(field), cells);
    leaves[leaf] = look.All;
    node = Union(node, look.All);
    finite = Union(finite, look.Finite);
    withNaN |= static_cast<std::uint64_t>(look.HasNaN) << leaf;
  }
  return withNaN;
}

/// Get the ranges of a node and its leaves from the kind of field. Empty beyond the end of the
/// field.
/// \param finite is widened by the finite values
void AskKind(const Field& field, const glm::ivec3& place, Range<double>* leaves,
  Range<double>& node, Range<double>& finite)
{
  node = ValueRangePyramid::Empty<double>();
  for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
  {
    leaves[leaf] = ValueRangePyramid::Empty<double>();
    const CellBox cells = CellsOfLeaf(field, place, leaf);
    if (glm::any(glm::lessThan(cells.Size, glm::ivec3(1))))
    {
      continue;
    }
    const glm::dvec2 range = field.Shape->RangeIn(cells);
    leaves[leaf] = { range.x, range.y };
    node.Min = std::min(node.Min, range.x);
    node.Max = std::max(node.Max, range.y);
    const bool isKnown = IsFinite(leaves[leaf]) || range.x > range.y;
    const glm::dvec2 known = isKnown ? range : field.Shape->FiniteRangeIn(cells);
    finite.Min = std::isfinite(known.x) ? std::min(finite.Min, known.x) : finite.Min;
    finite.Max = std::isfinite(known.y) ? std::max(finite.Max, known.y) : finite.Max;
  }
}

/// The ranges of leaves and of nodes, to be filled.
template <typename T>
struct RangesToFill
{
  /// Make room in `bytes`.
  template <typename Room>
  RangesToFill(std::int64_t nodes, Room& bytes)
  {
    constexpr std::int64_t ofNode = ValueRangePyramid::LeavesPerNode + 1;
    bytes.resize(static_cast<std::size_t>(nodes * ofNode) * sizeof(Range<T>));
    this->OfLeaves = reinterpret_cast<Range<T>*>(bytes.data());
    this->OfNodes = this->OfLeaves + nodes * ValueRangePyramid::LeavesPerNode;
  }

  Range<T>* OfLeaves;
  Range<T>* OfNodes;
};

}

void ValueRangePyramid::Build(const Field& field)
{
  this->Release();
  if (!field.Shape->Abilities().Samples)
  {
    this->BuildFromKind(field);
    return;
  }
  const glm::ivec3 nodes = NodesFor(field.Dimensions);
  const std::int64_t count = static_cast<std::int64_t>(nodes.x) * nodes.y * nodes.z;
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      if (field.Labels)
      {
        this->BuildFromLabels<T>(field);
        return;
      }
      const RangesToFill<T> ranges(count, this->Bytes);
      Range<T>*const leaves = ranges.OfLeaves, *const ofNodes = ranges.OfNodes;
      this->Nodes = nodes;
      std::vector<std::uint64_t> withNaN(
        std::is_floating_point_v<T> ? static_cast<std::size_t>(count) : 0);
      Range<T> finite = Empty<T>();
      std::mutex guard;
      const int groups = (nodes.y + MostNodeRows - 1) / MostNodeRows;
      ParallelFor(static_cast<std::int64_t>(groups) * nodes.z, 1,
        [&](std::int64_t group)
        {
          const glm::ivec2 yz(group % groups * MostNodeRows, group / groups);
          const int rows = std::min(MostNodeRows, nodes.y - yz.x);
          const std::int64_t first = (yz.x + static_cast<std::int64_t>(nodes.y) * yz.y) * nodes.x;
          FindRangesOfNodes(field, yz, rows, ofNodes + first, leaves + first * LeavesPerNode);
          Range<T> inRows = Empty<T>();
          for (std::int64_t i = first; i < first + static_cast<std::int64_t>(rows) * nodes.x; ++i)
          {
            if (IsFinite(ofNodes[i]))
            {
              inRows = Union(inRows, ofNodes[i]);
              continue;
            }
            const glm::ivec3 place(i % nodes.x, i / nodes.x % nodes.y, yz.y);
            withNaN[static_cast<std::size_t>(i)] =
              LookAgain(field, place, leaves + i * LeavesPerNode, ofNodes[i], inRows);
          }
          const std::lock_guard<std::mutex> lock(guard);
          finite = Union(finite, inRows);
        });
      this->HasFinite = finite.Min <= finite.Max;
      this->Finite = this->HasFinite
        ? glm::dvec2(static_cast<double>(finite.Min), static_cast<double>(finite.Max))
        : glm::dvec2(0.0);
      this->Whole = WholeRangeOf(ofNodes, count);
      if (std::any_of(withNaN.begin(), withNaN.end(), [](std::uint64_t leaves) { return leaves; }))
      {
        this->WithNaN = std::move(withNaN);
      }
    });
}

/// Build the ranges of labels from those of nodes.
template <typename T>
void ValueRangePyramid::BuildFromLabels(const Field& field)
{
  this->Nodes = NodesFor(field.Dimensions);
  const std::int64_t count = this->NumberOfNodes();
  const RangesToFill<T> ranges(count, this->Bytes);
  Range<T>*const leaves = ranges.OfLeaves, *const ofNodes = ranges.OfNodes;
  ParallelFor(count, 64,
    [&](std::int64_t node)
    {
      const glm::ivec3 place(node % this->Nodes.x, node / this->Nodes.x % this->Nodes.y,
        node / this->Nodes.x / this->Nodes.y);
      ofNodes[node] = Empty<T>();
      for (const std::int64_t label : field.Labels->LabelsOf(node))
      {
        const auto value = static_cast<T>(label);
        ofNodes[node] = Union(ofNodes[node], { value, value });
      }
      for (int leaf = 0; leaf < LeavesPerNode; ++leaf)
      {
        const bool hasCells =
          glm::all(glm::greaterThan(CellsOfLeaf(field, place, leaf).Size, glm::ivec3(0)));
        leaves[node * LeavesPerNode + leaf] = hasCells ? ofNodes[node] : Empty<T>();
      }
    });
  this->Whole = WholeRangeOf(ofNodes, count);
  this->Finite = this->Whole;
  this->HasFinite = true;
}

/// Build the ranges of a field without samples from its kind.
void ValueRangePyramid::BuildFromKind(const Field& field)
{
  assert(field.Type == ScalarType::Float64);
  this->Nodes = NodesFor(field.Dimensions);
  const std::int64_t count = this->NumberOfNodes();
  const RangesToFill<double> ranges(count, this->Bytes);
  Range<double>*const leaves = ranges.OfLeaves, *const ofNodes = ranges.OfNodes;
  Range<double> finite = Empty<double>();
  std::mutex guard;
  ParallelFor(count, 1,
    [&](std::int64_t node)
    {
      const glm::ivec3 place(node % this->Nodes.x, node / this->Nodes.x % this->Nodes.y,
        node / this->Nodes.x / this->Nodes.y);
      Range<double> inNode = Empty<double>();
      AskKind(field, place, leaves + node * LeavesPerNode, ofNodes[node], inNode);
      const std::lock_guard<std::mutex> lock(guard);
      finite.Min = std::min(finite.Min, inNode.Min);
      finite.Max = std::max(finite.Max, inNode.Max);
    });
  this->Whole = WholeRangeOf(ofNodes, count);
  this->HasFinite = finite.Min <= finite.Max;
  this->Finite = this->HasFinite ? glm::dvec2(finite.Min, finite.Max) : glm::dvec2(0.0);
}

void ValueRangePyramid::Release()
{
  Room().swap(this->Bytes);
  this->Nodes = glm::ivec3(0);
  this->Finite = this->Whole = glm::dvec2(0.0);
  this->HasFinite = false;
  this->WithNaN = {};
}

}
