// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ValueRangePyramid.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr int LeafSize = ValueRangePyramid::LeafSize;
constexpr int NodeSize = ValueRangePyramid::NodeSize;

template <typename T>
using Range = ValueRangePyramid::Range<T>;

/// What no sample has widened yet.
template <typename T>
constexpr Range<T> EmptyRange()
{
  if constexpr (std::is_floating_point_v<T>)
  {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    return { infinity, -infinity };
  }
  else
  {
    return { std::numeric_limits<T>::max(), std::numeric_limits<T>::lowest() };
  }
}

/// Finds the ranges of leaves strip by strip: a strip is one leaf high and deep and `StripLeaves`
/// long, so that its columns of 5 x 5 samples fit the first-level cache.
///
/// The loops over columns have no branches, so that compilers turn them into vector instructions.
template <typename T>
class StripScanner
{
public:
  static constexpr int StripNodes = 4;
  static constexpr int StripLeaves = StripNodes * NodeSize / LeafSize;

  explicit StripScanner(const TypedField<T>& field)
    : Samples(field)
  {
  }

  /// Leaves of the strip that begins at sample (x, y, z), in order along x.
  void Scan(int x, int y, int z, std::array<Range<T>, StripLeaves>& leaves)
  {
    leaves.fill(EmptyRange<T>());
    const glm::ivec3& size = this->Samples.Dimensions;
    if (y >= size.y - 1 || z >= size.z - 1)
    {
      return;
    }
    this->Columns = std::min(StripLeaves * LeafSize + 1, size.x - x);
    this->Min.fill(EmptyRange<T>().Min);
    this->Max.fill(EmptyRange<T>().Max);
    for (int k = z; k <= std::min(z + LeafSize, size.z - 1); ++k)
    {
      for (int j = y; j <= std::min(y + LeafSize, size.y - 1); ++j)
      {
        this->Widen(this->Row(x, j, k));
      }
    }
    for (int first = 0; first < this->Columns - 1; first += LeafSize)
    {
      Range<T>& leaf = leaves[static_cast<std::size_t>(first / LeafSize)];
      for (int i = first; i <= std::min(first + LeafSize, this->Columns - 1); ++i)
      {
        leaf.Min = std::min(leaf.Min, this->Min[static_cast<std::size_t>(i)]);
        leaf.Max = std::max(leaf.Max, this->Max[static_cast<std::size_t>(i)]);
      }
    }
  }

private:
  const T* Row(int x, int j, int k)
  {
    const T* row = this->Samples.At(x, j, k);
    const std::int64_t stride = this->Samples.Strides.x;
    if (stride == 1)
    {
      return row;
    }
    for (int i = 0; i < this->Columns; ++i)
    {
      this->Gathered[static_cast<std::size_t>(i)] = row[i * stride];
    }
    return this->Gathered.data();
  }

  void Widen(const T* row)
  {
    T* min = this->Min.data();
    T* max = this->Max.data();
    const int columns = this->Columns; // a store of bytes might change the member
    for (int i = 0; i < columns; ++i)
    {
      min[i] = row[i] < min[i] ? row[i] : min[i];
      max[i] = row[i] > max[i] ? row[i] : max[i];
    }
    if constexpr (std::is_floating_point_v<T>)
    {
      this->WidenByNotANumbers(row);
    }
  }

  // Comparisons with a NaN are false, so the loop above passed it over.
  void WidenByNotANumbers(const T* row)
  {
    const int columns = this->Columns;
    int found = 0;
    for (int i = 0; i < columns; ++i)
    {
      found |= row[i] != row[i];
    }
    for (int i = 0; found && i < columns; ++i)
    {
      if (std::isnan(row[i]))
      {
        this->Min[static_cast<std::size_t>(i)] = -std::numeric_limits<T>::infinity();
      }
    }
  }

  using Column = std::array<T, StripLeaves * LeafSize + 1>;
  TypedField<T> Samples;
  int Columns = 0;
  Column Min, Max, Gathered;
};

template <typename T>
void BuildLeaves(const TypedField<T>& field, const glm::ivec3& nodes, Range<T>* leaves)
{
  using Scanner = StripScanner<T>;
  ParallelFor(static_cast<std::int64_t>(nodes.y) * nodes.z, 1,
    [&](std::int64_t row)
    {
      const int nodeY = static_cast<int>(row % nodes.y);
      const int nodeZ = static_cast<int>(row / nodes.y);
      Scanner scanner(field);
      std::array<Range<T>, Scanner::StripLeaves> strip;
      for (int nodeX = 0; nodeX < nodes.x; nodeX += Scanner::StripNodes)
      {
        const int leavesInStrip = 4 * std::min(Scanner::StripNodes, nodes.x - nodeX);
        for (int leafYZ = 0; leafYZ < 16; ++leafYZ)
        {
          const int y = nodeY * NodeSize + (leafYZ % 4) * LeafSize;
          const int z = nodeZ * NodeSize + (leafYZ / 4) * LeafSize;
          scanner.Scan(nodeX * NodeSize, y, z, strip);
          for (int i = 0; i < leavesInStrip; ++i)
          {
            const std::int64_t node = row * nodes.x + nodeX + i / 4;
            leaves[node * ValueRangePyramid::LeavesPerNode + 4 * leafYZ + i % 4] =
              strip[static_cast<std::size_t>(i)];
          }
        }
      }
    });
}

/// The range of everything in `count` ranges, of which some may be empty.
template <typename T>
Range<T> RangeOf(const Range<T>* ranges, std::int64_t count)
{
  Range<T> all = EmptyRange<T>();
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (ranges[i].Min <= ranges[i].Max)
    {
      all.Min = std::min(all.Min, ranges[i].Min);
      all.Max = std::max(all.Max, ranges[i].Max);
    }
  }
  return all;
}

/// Smallest and largest finite sample, read from the nodes; where nodes hold what is not finite,
/// from all samples.
template <typename T>
glm::dvec2 FindFiniteRange(const TypedField<T>& field, const Range<T>* nodes, std::int64_t count)
{
  Range<T> range = RangeOf(nodes, count);
  bool finite = true;
  if constexpr (std::is_floating_point_v<T>)
  {
    finite = std::isfinite(range.Min) && std::isfinite(range.Max);
  }
  if (!finite)
  {
    range = EmptyRange<T>();
    const glm::ivec3& size = field.Dimensions;
    for (int k = 0; k < size.z; ++k)
    {
      for (int j = 0; j < size.y; ++j)
      {
        for (int i = 0; i < size.x; ++i)
        {
          const T value = *field.At(i, j, k);
          if (std::isfinite(static_cast<double>(value)))
          {
            range.Min = std::min(range.Min, value);
            range.Max = std::max(range.Max, value);
          }
        }
      }
    }
  }
  return range.Min <= range.Max
    ? glm::dvec2(static_cast<double>(range.Min), static_cast<double>(range.Max))
    : glm::dvec2(0.0);
}

}

void ValueRangePyramid::Build(const Field& field)
{
  this->Release();
  const glm::ivec3 nodes = (field.Dimensions - 1 + (NodeSize - 1)) / NodeSize;
  const std::int64_t count = static_cast<std::int64_t>(nodes.x) * nodes.y * nodes.z;
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      this->Bytes.resize(static_cast<std::size_t>(count * (LeavesPerNode + 1)) * sizeof(Range<T>));
      this->Nodes = nodes;
      auto* ranges = reinterpret_cast<Range<T>*>(this->Bytes.data());
      const TypedField<T> samples(field);
      BuildLeaves(samples, nodes, ranges);
      Range<T>* const ofNodes = ranges + count * LeavesPerNode;
      ParallelFor(count, 256,
        [&](std::int64_t node)
        { ofNodes[node] = RangeOf(ranges + node * LeavesPerNode, LeavesPerNode); });
      this->Finite = FindFiniteRange(samples, ofNodes, count);
    });
}

void ValueRangePyramid::Release()
{
  this->Bytes = std::vector<std::byte>();
  this->Nodes = glm::ivec3(0);
  this->Finite = glm::dvec2(0.0);
}

}
