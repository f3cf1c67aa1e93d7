// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ActiveCells_h
#define TemporalCoherence_ActiveCells_h

#include "Acceleration/ValueRangePyramid.h"
#include "Scene/Field.h"
#include "Scene/HiddenCells.h"
#include "Scene/LabelIndex.h"
#include "Scene/LabelSets.h"
#include "Scene/Surfaces.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The cells that a set of isovalues, or a band of isovalues, can pass through, as a tree of bits.
/// Or the cells that hold visible values.
///
/// A cell is *active* if some of its eight samples are inside an isovalue and some are not: only
/// such a cell can hold a surface. For a band, a sample must reach the lowest isovalue and another
/// sample must lie below the highest. Hidden cells are never active. With THRESHOLD their
/// neighbours are active unless they are outside, because solids are capped there.
///
/// If samples are labels, a cell is active where its samples have different labels, or beside
/// hidden cells, in a leaf with a label that is drawn.
///
/// Each node of the pyramid has a 64-bit word for its active leaves, and each active leaf one for
/// its active cells. A ray skips 16 or 4 cells in one step where a word is empty, and tests a cell
/// without reading samples. The words of nodes are built from the pyramid alone. The word of a leaf
/// is computed when a ray first asks for it, so that leaves no ray reaches cost nothing. No word
/// depends on the view. Those of labels' leaves do not depend on which labels are drawn, either.
class ActiveCells
{
public:
  static constexpr int LeafBits = ValueRangePyramid::LeafBits;
  static constexpr int NodeBits = ValueRangePyramid::NodeBits;
  static constexpr int LeafSize = ValueRangePyramid::LeafSize;
  static constexpr int NodeSize = ValueRangePyramid::NodeSize;

  /// Find the active leaves.
  /// \throws std::bad_alloc; no cell is active then
  /// \param last cells of another set of labels of this field, whose words are shared; may be null
  void Build(const Field& field, const ValueRangePyramid& pyramid, const Surfaces& surfaces,
    const ActiveCells* last = nullptr);
  void Build(const Field& field, const ValueRangePyramid& pyramid, const ValueBand& band,
    SurfaceMode mode = SurfaceMode::Crossing);

  /// Build from ranges of visible values.
  /// \param bands ascending; the upper end is not visible
  void BuildVisible(
    const Field& field, const ValueRangePyramid& pyramid, const std::vector<ValueBand>& bands);

  /// The visible values of a field.
  struct SeenValues
  {
    Field Samples;
    const ValueRangePyramid* Pyramid;
    std::vector<ValueBand> Bands; ///< ascending; the upper end is not visible
    /// Labels of samples, if Bands count for some labels only; else null.
    std::shared_ptr<const LabelSets> Labels;
    std::shared_ptr<const LabelIndex> CountFor; ///< these labels
  };

  /// Build from several fields that differ only in values: cells with a visible value of any field.
  /// \param fields later calls, such as CellsOf, must get the first one, whose bands count for all
  ///               labels
  void BuildVisible(const std::vector<SeenValues>& fields);

  void Release();

  const glm::ivec3& NodeDimensions() const { return this->Dimensions; }

  /// Position of the node of cell (i, j, k) in the list of nodes.
  std::int64_t NodeOf(const glm::ivec3& cell) const
  {
    return (cell.x >> NodeBits) +
      static_cast<std::int64_t>(this->Dimensions.x) *
      ((cell.y >> NodeBits) + static_cast<std::int64_t>(this->Dimensions.y) * (cell.z >> NodeBits));
  }

  /// Position of a leaf within its node, and of a cell within its leaf: x + 4 y + 16 z.
  static int LeafOf(const glm::ivec3& cell)
  {
    return ((cell.x >> LeafBits) & 3) | ((cell.y >> LeafBits) & 3) << 2 |
      ((cell.z >> LeafBits) & 3) << 4;
  }
  static int BitOf(const glm::ivec3& cell)
  {
    return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4;
  }

  /// One bit for each active leaf of a node.
  std::uint64_t LeavesOf(std::int64_t node) const
  {
    return this->NodeWords[static_cast<std::size_t>(2 * node)];
  }

  /// One bit for each active cell of the active leaf that holds `cell`. Thread-safe: the first
  /// caller computes the word, and simultaneous callers compute the same one.
  template <typename T>
  std::uint64_t CellsOf(const TypedField<T>& field, std::int64_t node, const glm::ivec3& cell) const
  {
    std::atomic<std::uint64_t>& word = this->WordOf(node, cell);
    std::uint64_t cells = word.load(std::memory_order_relaxed);
    if (cells == 0)
    {
      // An active leaf has an active cell, so that 0 can mean "not yet known". One with several
      // labels may have none: a superfluous active cell does no harm.
      cells = std::max(this->FindCells(field, cell & ~3), std::uint64_t(1));
      if (field.Bricks && SampleUse::HasMissed())
      {
        return cells; // made from samples that stand for others
      }
      word.store(cells, std::memory_order_relaxed);
    }
    return cells;
  }

  /// CellsOf for a field without samples.
  std::uint64_t CellsOf(const FieldShape& shape, std::int64_t node, const glm::ivec3& cell) const
  {
    std::atomic<std::uint64_t>& word = this->WordOf(node, cell);
    std::uint64_t cells = word.load(std::memory_order_relaxed);
    if (cells == 0)
    {
      // A leaf's range may contain values outside the ranges of its cells. A superfluous active
      // cell does no harm.
      cells = std::max(this->CellsIn(shape, cell & ~3), std::uint64_t(1));
      word.store(cells, std::memory_order_relaxed);
    }
    return cells;
  }

  /// The words in the form that kernels read. For each node: the word of its leaves, and where the
  /// words of these leaves begin in the second list. In that list 0 means "not yet known", and
  /// other threads may be writing.
  const std::uint64_t* Nodes() const { return this->NodeWords.data(); }
  const std::atomic<std::uint64_t>* Cells() const { return this->LeafWords.get(); }

  /// A level of blocks above the nodes. A block has 4^3 children: nodes, or blocks of the level
  /// below. Its word has one bit for each child that holds active leaves.
  struct Level
  {
    std::uint64_t WordOf(const glm::ivec3& block) const
    {
      return this->Words[static_cast<std::size_t>(block.x +
        static_cast<std::int64_t>(this->Dimensions.x) *
          (block.y + static_cast<std::int64_t>(this->Dimensions.y) * block.z))];
    }

    glm::ivec3 Dimensions; ///< in blocks
    std::vector<std::uint64_t> Words;
  };

  /// The levels above the nodes, from the lowest; the last one is a single block.
  const std::vector<Level>& LevelsAbove() const { return this->Above; }

  std::size_t MemoryInBytes() const;

private:
  std::atomic<std::uint64_t>& WordOf(std::int64_t node, const glm::ivec3& cell) const
  {
    return this->LeafWords[this->NodeWords[static_cast<std::size_t>(2 * node + 1)] +
      static_cast<std::size_t>(LeafOf(cell))];
  }

  std::uint64_t CellsIn(const FieldShape& shape, const glm::ivec3& firstCell) const;
  static std::uint64_t LeavesThatCount(const SeenValues& values, std::int64_t node);
  std::uint64_t LeavesWithLabels(const LabelIndex& drawn, std::int64_t node) const;
  bool HasWords(std::int64_t node) const;
  void FindLeaves(const Field& field, const ValueRangePyramid& pyramid,
    const LabelIndex* drawn = nullptr, const std::vector<SeenValues>& others = {},
    const ActiveCells* last = nullptr);
  void FindLevelsAbove(const glm::ivec3& nodes);

  template <typename T>
  std::uint64_t FindVisibleLeaves(const TypedField<T>& field, const glm::ivec3& firstCell,
    const ValueRangePyramid::Range<T>* ranges, std::uint64_t leaves) const;

  template <typename T>
  std::uint64_t FindCells(const TypedField<T>& field, const glm::ivec3& firstCell) const;

  template <typename T>
  static std::uint64_t CellsWithin(
    const TypedField<T>& field, const std::vector<ValueBand>& bands, const glm::ivec3& firstCell);

  template <typename T>
  std::uint64_t MixedCells(const TypedField<T>& field, const glm::ivec3& firstCell) const;

  template <typename T>
  std::uint64_t WithoutHidden(
    const TypedField<T>& field, const glm::ivec3& firstCell, std::uint64_t active) const;

  /// One bit for each sample of a row, set if it is inside.
  template <typename T>
  static std::uint32_t InsideOf(const T* row, std::int64_t stride, int count, double isovalue)
  {
    std::uint32_t inside = 0;
    for (int i = 0; i < count; ++i)
    {
      const bool isInside = static_cast<double>(row[i * stride]) >= isovalue;
      inside |= static_cast<std::uint32_t>(isInside) << i;
    }
    return inside;
  }

  glm::ivec3 Dimensions{ 0 };           ///< in nodes
  std::vector<ValueBand> Bands;         ///< ascending
  std::vector<SeenValues> Others;       ///< of other fields; their pyramids may be gone
  std::vector<std::uint64_t> NodeWords; ///< leaves of a node, and where their words begin
  std::shared_ptr<std::atomic<std::uint64_t>[]> LeafWords;
  std::size_t NumberOfLeafWords = 0;
  std::vector<Level> Above;
  std::shared_ptr<const HiddenCells> Hidden; ///< null for none
  bool IsCapped = false;                     ///< THRESHOLD solids are capped at hidden cells
  std::shared_ptr<const LabelSets> Labels;   ///< of the samples; null: they are no labels
};

template <typename T>
std::uint64_t ActiveCells::FindCells(const TypedField<T>& field, const glm::ivec3& firstCell) const
{
  if (this->Labels)
  {
    return this->MixedCells(field, firstCell);
  }
  std::uint64_t active = CellsWithin(field, this->Bands, firstCell);
  for (const SeenValues& other : this->Others)
  {
    if (LeavesThatCount(other, this->NodeOf(firstCell)) >> LeafOf(firstCell) & 1u)
    {
      active |= CellsWithin(TypedField<T>(other.Samples), other.Bands, firstCell);
    }
  }
  return this->Hidden ? this->WithoutHidden(field, firstCell, active) : active;
}

/// The cells of a leaf that are active if no cell is hidden.
template <typename T>
std::uint64_t ActiveCells::CellsWithin(
  const TypedField<T>& field, const std::vector<ValueBand>& bands, const glm::ivec3& firstCell)
{
  const glm::ivec3 samples = glm::min(field.Dimensions - firstCell, glm::ivec3(5));
  std::uint64_t active = 0;
  for (const ValueBand& band : bands)
  {
    // Fold the bits of the lowest and of the highest isovalue along x, then y, then z: 4 bits a
    // row, 16 a slice. A cell is active if any sample is inside the lowest and not all are inside
    // the highest.
    const bool isPoint = band.Low == band.High;
    std::uint32_t anyBelow = 0, allBelow = 0;
    for (int k = 0; k < samples.z; ++k)
    {
      std::uint32_t anySlice = 0, allSlice = 0, anyRow = 0, allRow = 0;
      for (int j = 0; j < samples.y; ++j)
      {
        const T* row = field.At(firstCell + glm::ivec3(0, j, k));
        const std::uint32_t inLow = InsideOf(row, field.Strides.x, samples.x, band.Low);
        const std::uint32_t inHigh =
          isPoint ? inLow : InsideOf(row, field.Strides.x, samples.x, band.High);
        const std::uint32_t any = inLow | inLow >> 1;
        const std::uint32_t all = inHigh & inHigh >> 1;
        if (j > 0)
        {
          anySlice |= ((any | anyRow) & 15u) << 4 * (j - 1);
          allSlice |= (all & allRow & 15u) << 4 * (j - 1);
        }
        anyRow = any;
        allRow = all;
      }
      if (k > 0)
      {
        const std::uint64_t mixed = (anySlice | anyBelow) & ~(allSlice & allBelow) & 0xffffu;
        active |= mixed << 16 * (k - 1);
      }
      anyBelow = anySlice;
      allBelow = allSlice;
    }
  }
  // Rows of fewer than five samples have fewer than four cells.
  const std::uint64_t cellsInRow = (1u << (samples.x - 1)) - 1u;
  return active & (cellsInRow * 0x1111111111111111u);
}

/// The active cells of a leaf of labels.
template <typename T>
std::uint64_t ActiveCells::MixedCells(const TypedField<T>& field, const glm::ivec3& firstCell) const
{
  const glm::ivec3 samples = glm::min(field.Dimensions - firstCell, glm::ivec3(5));
  const std::uint32_t cellsInRow = (1u << (samples.x - 1)) - 1u;
  std::uint64_t mixed = 0;
  for (int k = 0; k < samples.z; ++k)
  {
    for (int j = 0; j < samples.y; ++j)
    {
      // Bits of a row: samples that differ from the next one along each axis.
      std::array<std::uint32_t, 3> differs{};
      const T* const row = field.At(firstCell + glm::ivec3(0, j, k));
      for (int i = 0; i < samples.x; ++i)
      {
        const T* const sample = row + i * field.Strides.x;
        const auto isOther = [&](bool hasNext, std::int64_t stride)
        { return static_cast<std::uint32_t>(hasNext && sample[0] != sample[stride]) << i; };
        differs[0] |= isOther(i + 1 < samples.x, field.Strides.x);
        differs[1] |= isOther(j + 1 < samples.y, field.Strides.y);
        differs[2] |= isOther(k + 1 < samples.z, field.Strides.z);
      }
      // Neighbouring cells share edges.
      const auto besideX = [&](std::uint32_t bits) -> std::uint64_t
      { return (bits | bits >> 1) & cellsInRow; };
      for (int z = k > 0 ? k - 1 : 0; z <= k && z < samples.z - 1; ++z)
      {
        for (int y = j > 0 ? j - 1 : 0; y <= j && y < samples.y - 1; ++y)
        {
          const int at = 4 * y + 16 * z;
          mixed |= static_cast<std::uint64_t>(differs[0]) << at;
          mixed |= (y == j ? besideX(differs[1]) : 0) << at;
          mixed |= (z == k ? besideX(differs[2]) : 0) << at;
        }
      }
    }
  }
  return this->Hidden ? (mixed | this->Hidden->Around(firstCell)) & ~this->Hidden->LeafAt(firstCell)
                      : mixed;
}

/// The active cells of a leaf, given the cells that would be active without hidden cells.
template <typename T>
std::uint64_t ActiveCells::WithoutHidden(
  const TypedField<T>& field, const glm::ivec3& firstCell, std::uint64_t active) const
{
  const std::uint64_t hidden = this->Hidden->LeafAt(firstCell);
  const std::uint64_t beside = this->IsCapped ? this->Hidden->Around(firstCell) & ~hidden : 0;
  if (beside == 0)
  {
    return active & ~hidden;
  }
  // Cells with a sample inside the lowest isovalue.
  const glm::ivec3 samples = glm::min(field.Dimensions - firstCell, glm::ivec3(5));
  const std::uint32_t cellsInRow = (1u << (samples.x - 1)) - 1u;
  std::uint64_t inside = 0;
  for (int k = 0; k < samples.z; ++k)
  {
    for (int j = 0; j < samples.y; ++j)
    {
      const T* row = field.At(firstCell + glm::ivec3(0, j, k));
      const std::uint32_t bits = InsideOf(row, field.Strides.x, samples.x, this->Bands.front().Low);
      const std::uint64_t alongX = (bits | bits >> 1) & cellsInRow;
      for (int z = k > 0 ? k - 1 : 0; z <= k && z < samples.z - 1; ++z)
      {
        for (int y = j > 0 ? j - 1 : 0; y <= j && y < samples.y - 1; ++y)
        {
          inside |= alongX << (4 * y + 16 * z);
        }
      }
    }
  }
  return (active & ~hidden) | (inside & beside);
}

}

#endif
