// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ValueRangePyramid_h
#define TemporalCoherence_ValueRangePyramid_h

#include "Scene/CellBlocks.h"
#include "Scene/Field.h"
#include "Scene/KnownRanges.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

namespace TemporalCoherence
{

/// Smallest and largest sample of the field in blocks of cells. Independent of the isovalue.
///
/// There are two levels: leaves, with their 5 x 5 x 5 samples, and nodes (CellBlocks). Leaves are
/// stored node by node. NaN samples are ignored. A leaf without other samples, for example beyond
/// the end of the field, has Min > Max.
class ValueRangePyramid : public CellBlocks
{
public:
  template <typename T>
  struct Range
  {
    T Min, Max;
  };

  /// An empty range, to be widened by samples.
  template <typename T>
  static constexpr Range<T> Empty()
  {
    using Limits = std::numeric_limits<T>;
    if constexpr (std::is_floating_point_v<T>)
    {
      return { Limits::infinity(), -Limits::infinity() };
    }
    else
    {
      return { Limits::max(), Limits::lowest() };
    }
  }

  /// Read the whole field once, in parallel, unless its ranges are known (Field::Known). For a
  /// field without samples, its kind provides the ranges. Those of labels come from LabelSets:
  /// leaves have the range of their node. \pre field.HasCells() \throws std::bad_alloc; the pyramid
  /// is then empty
  void Build(const Field& field);

  void Release();

  bool IsEmpty() const { return !this->Ranges.Bytes; }

  /// Nodes along each axis.
  const glm::ivec3& NodeDimensions() const { return this->Nodes; }
  std::int64_t NumberOfNodes() const
  {
    return static_cast<std::int64_t>(this->Nodes.x) * this->Nodes.y * this->Nodes.z;
  }

  /// Range of leaf `leaf` (x + 4 y + 16 z within the node) of node `node` (x fastest).
  /// `T` is the type of the field's samples.
  template <typename T>
  const Range<T>* LeavesOf(std::int64_t node) const
  {
    return reinterpret_cast<const Range<T>*>(this->Ranges.Bytes.get()) + node * LeavesPerNode;
  }

  /// Range of all leaves of a node.
  template <typename T>
  const Range<T>& NodeAt(std::int64_t node) const
  {
    return *(this->LeavesOf<T>(this->NumberOfNodes()) + node);
  }

  /// Smallest and largest finite sample of the whole field; {0, 0} if there is none.
  const glm::dvec2& FiniteRange() const { return this->Ranges.Finite; }

  /// True if some sample is finite.
  bool HasFiniteSamples() const { return this->Ranges.HasFinite; }

  /// Smallest and largest of all samples, including infinities. The first is larger than the second
  /// if no sample is a number. {0, 0} before ranges are built.
  const glm::dvec2& WholeRange() const { return this->Ranges.Whole; }

  /// For each node, a word with one bit for each leaf that has NaN samples. Empty if no sample is
  /// NaN, and for a field without samples.
  const std::vector<std::uint64_t>& LeavesWithNaN() const { return this->Ranges.LeavesWithNaN; }

  /// True if every sample is a finite number.
  bool AreSamplesFinite() const
  {
    return this->Ranges.LeavesWithNaN.empty() && std::isfinite(this->Ranges.Whole.x) &&
      std::isfinite(this->Ranges.Whole.y);
  }

  /// Bytes of memory; those of a mapped file do not count.
  std::size_t MemoryInBytes() const
  {
    return this->OwnBytes + sizeof(std::uint64_t) * this->Ranges.LeavesWithNaN.capacity();
  }

private:
  void BuildFromKind(const Field& field);
  template <typename T>
  void BuildFromLabels(const Field& field);

  std::shared_ptr<std::byte> MakeRoom(std::size_t bytes);
  void Take(KnownRanges known, const glm::ivec3& nodes);

  glm::ivec3 Nodes{ 0 };
  KnownRanges Ranges;
  std::size_t OwnBytes = 0; ///< of the ranges, unless the field brought them
};

}

#endif
