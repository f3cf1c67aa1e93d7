// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/KernelsPyramid.h"

#include "Acceleration/ValueRangePyramid.h"

#include <algorithm>
#include <array>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Acceleration/KernelsPyramid.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

template <typename T>
using Range = ValueRangePyramid::Range<T>;

/// Load samples. NaN counts as -infinity, so that it is found in the ranges.
template <class D, typename T>
HWY_INLINE hn::Vec<D> LoadSamples(D d, const T* samples)
{
  const hn::Vec<D> loaded = hn::LoadU(d, samples);
  if constexpr (std::is_floating_point_v<T>)
  {
    return hn::IfThenElse(
      hn::Eq(loaded, loaded), loaded, hn::Set(d, ValueRangePyramid::Empty<T>().Max));
  }
  return loaded;
}

/// The value ranges of columns of samples. The five rows of a leaf are folded into one, then its
/// five slices, for all x at the same time.
template <typename T>
class ColumnRanges
{
public:
  /// Cells at a time: whole nodes, few enough to keep rows and columns in the caches.
  static constexpr int MostCells = static_cast<int>(2048 / sizeof(T));

  using Rows = std::array<const T*, ValueRangePyramid::LeafSize + 1>;

  /// Widen the columns by the samples of some rows.
  /// \param begins overwrite the columns instead of widening them
  HWY_INLINE void Widen(const Rows& rows, int columns, bool begins)
  {
    const hn::ScalableTag<T> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    if (columns < lanes)
    {
      for (int i = 0; i < columns; ++i)
      {
        this->WidenAt(hn::CappedTag<T, 1>(), rows, i, begins);
      }
      return;
    }
    for (int i = 0; i < columns - lanes; i += lanes)
    {
      this->WidenAt(d, rows, i, begins);
    }
    // Widening twice by the same samples changes nothing.
    this->WidenAt(d, rows, columns - lanes, begins);
  }

  /// Fold these columns into the ranges of their leaves.
  /// \param leaves of the first node, in this row and slice; leaves beyond the last cell are empty
  HWY_INLINE void Fold(int columns, int nodes, Range<T>* leaves)
  {
    const hn::CappedTag<T, MostLanes> d;
    constexpr Range<T> empty = ValueRangePyramid::Empty<T>();
    const int known = (columns - 1 + LeafSize - 1) / LeafSize;
    std::array<T, MostLeaves> min, max;
    std::fill(min.begin() + known, min.begin() + 4 * nodes, empty.Min);
    std::fill(max.begin() + known, max.begin() + 4 * nodes, empty.Max);
    const auto lower = [](auto a, auto b) HWY_ATTR { return hn::Min(a, b); };
    const auto higher = [](auto a, auto b) HWY_ATTR { return hn::Max(a, b); };
    FoldColumns(columns, known, empty.Min, lower, this->Min, min);
    FoldColumns(columns, known, empty.Max, higher, this->Max, max);
    std::array<Range<T>, MostLeaves> ranges;
    for (int i = 0; i < 4 * nodes; i += static_cast<int>(hn::Lanes(d)))
    {
      hn::StoreInterleaved2(hn::LoadU(d, min.data() + i), hn::LoadU(d, max.data() + i), d,
        &ranges[static_cast<std::size_t>(i)].Min);
    }
    for (int node = 0; node < nodes; ++node)
    {
      std::copy_n(ranges.data() + 4 * node, 4, leaves + node * ValueRangePyramid::LeavesPerNode);
    }
  }

private:
  static constexpr int LeafSize = ValueRangePyramid::LeafSize;
  /// Interleaving wider vectors would cost more than it saves.
  static constexpr std::size_t MostLanes = 32 / sizeof(T);
  static constexpr std::size_t MostLeaves = MostCells / LeafSize + MostLanes;
  using Columns = std::array<T, LeafSize*(MostLeaves + 1)>;

  template <class D>
  HWY_INLINE void WidenAt(D d, const Rows& rows, int i, bool begins)
  {
    const auto first = LoadSamples(d, rows[0] + i);
    auto min = first, max = first;
    for (std::size_t row = 1; row < rows.size(); ++row)
    {
      const auto samples = LoadSamples(d, rows[row] + i);
      min = hn::Min(min, samples);
      max = hn::Max(max, samples);
    }
    T* const minAt = this->Min.data() + i;
    T* const maxAt = this->Max.data() + i;
    if (!begins)
    {
      min = hn::Min(min, hn::LoadU(d, minAt));
      max = hn::Max(max, hn::LoadU(d, maxAt));
    }
    hn::StoreU(min, d, minAt);
    hn::StoreU(max, d, maxAt);
  }

  /// Fold the five columns of each leaf into one.
  /// \param neutral value that leaves a fold unchanged
  template <typename Operation>
  static HWY_INLINE void FoldColumns(int count, int known, T neutral, const Operation& fold,
    Columns& columns, std::array<T, MostLeaves>& leaves)
  {
    const hn::CappedTag<T, MostLanes> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const int whole = (known + lanes - 1) / lanes * lanes;
    std::fill(columns.begin() + count, columns.begin() + 4 * whole + 1, neutral);
    std::array<T, MostLeaves + 1> first;
    std::array<T, MostLeaves> folded;
    for (int i = 0; i < whole; i += lanes)
    {
      hn::Vec<decltype(d)> a, b, c, e;
      hn::LoadInterleaved4(d, columns.data() + 4 * i, a, b, c, e);
      hn::StoreU(a, d, first.data() + i);
      hn::StoreU(fold(fold(a, b), fold(c, e)), d, folded.data() + i);
    }
    first[static_cast<std::size_t>(whole)] = columns[static_cast<std::size_t>(4 * whole)];
    for (int i = 0; i < whole; i += lanes)
    {
      const auto next = hn::LoadU(d, first.data() + i + 1);
      hn::StoreU(fold(hn::LoadU(d, folded.data() + i), next), d, folded.data() + i);
    }
    std::copy_n(folded.begin(), known, leaves.begin());
  }

  Columns Min, Max;
};

/// Finds ranges from rows of samples that lie side by side.
template <typename T>
class LeafScanner
{
public:
  HWY_INLINE explicit LeafScanner(const Field& field)
    : Samples(field)
  {
  }

  /// Find the ranges of the leaves of some rows of nodes.
  /// \param first  samples at which the first node begins
  /// \param nodes  along x and y
  /// \param leaves of the first node; leaves of the next row of nodes are `perRow` farther on
  HWY_INLINE void Scan(
    const glm::ivec3& first, const glm::ivec2& nodes, std::int64_t perRow, Range<T>* leaves)
  {
    const int columns =
      std::min(nodes.x * ValueRangePyramid::NodeSize + 1, this->Samples.Dimensions.x - first.x);
    for (int slice = 0; slice < 4; ++slice)
    {
      const glm::ivec3 begin = first + glm::ivec3(0, 0, slice * LeafSize);
      const int rows = this->Widen(begin, columns, 4 * nodes.y);
      for (int row = 0; row < 4 * nodes.y; ++row)
      {
        this->Folded[static_cast<std::size_t>(row)].Fold(row < rows ? columns : 1, nodes.x,
          leaves + row / 4 * perRow + 4 * (row % 4) + 16 * slice);
      }
    }
  }

private:
  static constexpr int LeafSize = ValueRangePyramid::LeafSize;

  /// Widen the columns of a slice of rows of leaves.
  /// \return the rows that have cells
  HWY_INLINE int Widen(const glm::ivec3& first, int columns, int rows)
  {
    const glm::ivec3 last = this->Samples.Dimensions - 1;
    if (first.z >= last.z)
    {
      return 0;
    }
    const int rowsWithCells = std::min(rows, (last.y - first.y + LeafSize - 1) / LeafSize);
    for (int k = first.z; k <= std::min(first.z + LeafSize, last.z); ++k)
    {
      for (int row = 0; row < rowsWithCells; ++row)
      {
        this->Folded[static_cast<std::size_t>(row)].Widen(
          this->RowsFrom({ first.x, first.y + row * LeafSize, k }, columns), columns, k == first.z);
      }
    }
    return rowsWithCells;
  }

  /// The rows of samples that a row of leaves needs of one slice of samples.
  HWY_INLINE typename ColumnRanges<T>::Rows RowsFrom(const glm::ivec3& first, int columns)
  {
    const glm::ivec3 last = this->Samples.Dimensions - 1;
    typename ColumnRanges<T>::Rows rows;
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      // Using the last row twice changes nothing.
      const int j = std::min(first.y + static_cast<int>(row), last.y);
      rows[row] = this->RowAt({ first.x, j, first.z }, columns, row);
    }
    return rows;
  }

  /// A row of contiguous samples, gathered if the field's samples are not.
  HWY_INLINE const T* RowAt(const glm::ivec3& first, int columns, std::size_t row)
  {
    const T* const samples = this->Samples.At(first);
    const std::int64_t stride = this->Samples.Strides.x;
    if (stride == 1)
    {
      return samples;
    }
    for (int i = 0; i < columns; ++i)
    {
      this->Gathered[row][static_cast<std::size_t>(i)] = samples[i * stride];
    }
    return this->Gathered[row].data();
  }

  TypedField<T> Samples;
  std::array<ColumnRanges<T>, 4 * MostNodeRows> Folded; ///< of each row of leaves
  std::array<std::array<T, ColumnRanges<T>::MostCells + 1>, ValueRangePyramid::LeafSize + 1>
    Gathered;
};

/// The range over the leaves of a node. Leaves without cells change nothing.
template <typename T>
HWY_INLINE Range<T> RangeOfNode(const Range<T>* leaves)
{
  Range<T> all = leaves[0];
  for (int leaf = 1; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
  {
    all.Min = leaves[leaf].Min < all.Min ? leaves[leaf].Min : all.Min;
    all.Max = leaves[leaf].Max > all.Max ? leaves[leaf].Max : all.Max;
  }
  return all;
}

template <typename T>
HWY_NOINLINE void ScanRows(
  const Field& field, const glm::ivec2& first, int rows, Range<T>* nodes, Range<T>* leaves)
{
  constexpr int most = ColumnRanges<T>::MostCells / ValueRangePyramid::NodeSize;
  constexpr std::int64_t leavesPerNode = ValueRangePyramid::LeavesPerNode;
  const int inRow = ValueRangePyramid::NodesFor(field.Dimensions).x;
  LeafScanner<T> scanner(field);
  for (int x = 0; x < inRow; x += most)
  {
    scanner.Scan(ValueRangePyramid::NodeSize * glm::ivec3(x, first.x, first.y),
      { std::min(most, inRow - x), rows }, inRow * leavesPerNode, leaves + x * leavesPerNode);
  }
  for (std::int64_t node = 0; node < static_cast<std::int64_t>(inRow) * rows; ++node)
  {
    nodes[node] = RangeOfNode(leaves + node * leavesPerNode);
  }
}

void Scan(const Field& field, const glm::ivec2& first, int rows, void* nodes, void* leaves)
{
  DispatchScalarType(field.Type,
    [&](auto type) HWY_ATTR
    {
      using T = decltype(type);
      ScanRows(field, first, rows, static_cast<Range<T>*>(nodes), static_cast<Range<T>*>(leaves));
    });
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(Scan);

void FindRangesOfNodes(
  const Field& field, const glm::ivec2& first, int rows, void* nodes, void* leaves)
{
  HWY_DYNAMIC_DISPATCH(Scan)(field, first, rows, nodes, leaves);
}

}
#endif
