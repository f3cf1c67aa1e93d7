// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshRanges_h
#define TemporalCoherence_MeshRanges_h

#include "Mesh/Tree/MeshLattice.h"
#include "Mesh/Tree/MeshReader.h"
#include "Scene/Surfaces.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Value ranges of cells, in 253 steps of their leaf's range. These two bytes a cell exclude most
/// cells that an isovalue does not pass, before they are read. Leaves are added as their ranges are
/// read. Thread-safe.
class MeshRanges
{
public:
  static constexpr std::size_t CellsInLeaf = MeshLattice::SizeOfBlock;
  using OfCells = std::array<CellRange, CellsInLeaf>;

  /// Begins without the ranges of any leaf.
  /// \throws std::bad_alloc
  explicit MeshRanges(std::int64_t leaves);

  /// Keep the ranges of a leaf's first cells. All calls for one leaf have to pass equal ranges.
  void Keep(std::int64_t leaf, const OfCells& ranges, std::size_t count);

  /// Find the cells of a leaf that an isovalue of some bands may pass, one bit each. The isovalues
  /// pass no other cell.
  /// \param bands ascending
  /// \return false if the leaf's ranges are unknown
  bool FindCells(
    std::int64_t leaf, const std::vector<ValueBand>& bands, std::uint64_t& cells) const;

  std::size_t MemoryInBytes() const;

private:
  static constexpr std::size_t CellsInWord = sizeof(std::uint64_t);
  static constexpr std::size_t WordsInLeaf = CellsInLeaf / CellsInWord;

  /// Bytes of finite values are 1 to 1 + Steps.
  static constexpr int Steps = 253;
  static constexpr std::uint8_t Infinite = 255;

  /// Maps values to bytes, monotonically.
  struct Scale
  {
    std::uint8_t ByteOf(double value) const;
    double Low = 0.0, PerValue = 0.0;
  };

  struct Leaf
  {
    std::atomic<bool> IsKnown;
    std::atomic<double> Low, PerValue; ///< of the scale
    std::atomic<std::uint8_t> Count;
    std::array<std::atomic<std::uint64_t>, WordsInLeaf> Least, Most; ///< bytes by cell
  };

  std::int64_t NumberOfLeaves;
  std::unique_ptr<Leaf[]> Leaves;
};

}

#endif
