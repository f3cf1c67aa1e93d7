// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/RangeScan.h"

#include "Acceleration/KernelsPyramid.h"
#include "Acceleration/NodeRanges.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr int LeavesPerNode = ValueRangePyramid::LeavesPerNode;

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

}

std::size_t RangeScan::BytesFor(ScalarType type, const glm::ivec3& dimensions)
{
  const std::int64_t ranges = CountOf(CellBlocks::NodesFor(dimensions)) * (LeavesPerNode + 1);
  return 2 * SizeOf(type) * static_cast<std::size_t>(ranges);
}

RangeScan::RangeScan(ScalarType type, const glm::ivec3& dimensions, std::shared_ptr<std::byte> room)
  : Type(type)
  , Nodes(CellBlocks::NodesFor(dimensions))
  , Room(std::move(room))
  , Finite(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity())
{
  if (type == ScalarType::Float32 || type == ScalarType::Float64)
  {
    this->WithNaN.resize(static_cast<std::size_t>(CountOf(this->Nodes)));
  }
}

void RangeScan::Scan(const Field& field, const glm::ivec2& first, const glm::ivec2& count)
{
  DispatchScalarType(this->Type,
    [&](auto type)
    {
      using T = decltype(type);
      const NodeRanges<T> ranges(CountOf(this->Nodes), this->Room.get());
      std::mutex guard;
      const int groups = (count.x + MostNodeRows - 1) / MostNodeRows;
      ParallelFor(static_cast<std::int64_t>(groups) * count.y, 1,
        [&](std::int64_t group)
        {
          const glm::ivec2 yz = first + glm::ivec2(group % groups * MostNodeRows, group / groups);
          const int rows = std::min(MostNodeRows, first.x + count.x - yz.x);
          const std::int64_t begin =
            (yz.x + static_cast<std::int64_t>(this->Nodes.y) * yz.y) * this->Nodes.x;
          FindRangesOfNodes(
            field, yz, rows, ranges.OfNodes + begin, ranges.OfLeaves + begin * LeavesPerNode);
          Range<T> inRows = ValueRangePyramid::Empty<T>();
          for (std::int64_t i = begin; i < begin + static_cast<std::int64_t>(rows) * this->Nodes.x;
               ++i)
          {
            if (IsFinite(ranges.OfNodes[i]))
            {
              inRows = Union(inRows, ranges.OfNodes[i]);
              continue;
            }
            const glm::ivec3 place(i % this->Nodes.x, i / this->Nodes.x % this->Nodes.y, yz.y);
            this->WithNaN[static_cast<std::size_t>(i)] = LookAgain(
              field, place, ranges.OfLeaves + i * LeavesPerNode, ranges.OfNodes[i], inRows);
          }
          if (inRows.Min <= inRows.Max)
          {
            const std::lock_guard<std::mutex> lock(guard);
            this->Finite.x = std::min(this->Finite.x, static_cast<double>(inRows.Min));
            this->Finite.y = std::max(this->Finite.y, static_cast<double>(inRows.Max));
          }
        });
    });
}

KnownRanges RangeScan::Finish()
{
  KnownRanges known;
  known.HasFinite = this->Finite.x <= this->Finite.y;
  known.Finite = known.HasFinite ? this->Finite : glm::dvec2(0.0);
  known.Whole = DispatchScalarType(this->Type,
    [&](auto type)
    {
      const NodeRanges<decltype(type)> ranges(CountOf(this->Nodes), this->Room.get());
      return WholeRangeOf(ranges.OfNodes, CountOf(this->Nodes));
    });
  if (std::any_of(
        this->WithNaN.begin(), this->WithNaN.end(), [](std::uint64_t leaves) { return leaves; }))
  {
    known.LeavesWithNaN = std::move(this->WithNaN);
  }
  known.Bytes = this->Room;
  return known;
}

}
