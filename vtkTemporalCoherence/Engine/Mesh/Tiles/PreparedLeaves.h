// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PreparedLeaves_h
#define TemporalCoherence_PreparedLeaves_h

#include "Mesh/Tiles/MeshDifference.h"
#include "Mesh/Tiles/PreparedCells.h"
#include "Mesh/Tree/MeshTree.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace TemporalCoherence
{

/// Cache of prepared cells, by leaf and isovalue. The first tile that asks for a leaf prepares its
/// cells; other tiles and later views reuse them. Thread-safe.
class PreparedLeaves
{
public:
  /// \param tree        outlives this
  /// \param finiteRange smallest and largest finite value of the mesh
  /// \param width       of bands above isovalues, as for PrepareCells
  PreparedLeaves(const MeshTree& tree, const std::vector<double>& isovalues,
    const glm::dvec2& finiteRange, CellPurpose purpose, double width = 0.0);
  ~PreparedLeaves();
  PreparedLeaves(const PreparedLeaves&) = delete;
  PreparedLeaves& operator=(const PreparedLeaves&) = delete;

  std::size_t NumberOfIsovalues() const { return this->Isovalues.size(); }

  /// Differences from each isovalue.
  const std::vector<MeshDifference>& Differences() const { return this->FromIsovalues; }

  /// The cells of a leaf that count for an isovalue.
  /// \param isovalue its position in the list
  /// \param active   one bit for each cell of the leaf that any of the isovalues may pass
  /// \param spare    holds the cells if the cache is full
  /// \throws std::bad_alloc
  const PreparedCells& Of(
    std::int64_t leaf, std::size_t isovalue, std::uint64_t active, PreparedCells& spare) const;

  /// The prepared cells of a leaf, or null if the cache lacks them.
  const PreparedCells* Known(std::int64_t leaf, std::size_t isovalue) const;

  /// Unique for each leaf and isovalue.
  std::int64_t KeyOf(std::int64_t leaf, std::size_t isovalue) const
  {
    return leaf * static_cast<std::int64_t>(this->Isovalues.size()) +
      static_cast<std::int64_t>(isovalue);
  }

private:
  /// Limit of the cache, including a slot for each leaf and isovalue. Measured: the surfaces of 10
  /// million tetrahedra take 100 MB.
  static constexpr std::size_t MostBytes = 256 << 20;

  using Slot = std::atomic<const PreparedCells*>;

  bool IsRoomForSlots() const { return this->NumberOfSlots * sizeof(Slot) <= MostBytes; }
  Slot& SlotOf(std::int64_t leaf, std::size_t isovalue) const;
  void Prepare(
    std::int64_t leaf, std::size_t isovalue, std::uint64_t active, PreparedCells& cells) const;

  const MeshTree& Tree;
  std::size_t NumberOfSlots;
  std::vector<double> Isovalues;
  std::vector<MeshDifference> FromIsovalues;
  CellPurpose Purpose;
  double Width;
  mutable std::once_flag IsAsked;
  mutable std::unique_ptr<Slot[]> Kept;    ///< by isovalue and leaf; null before the first request
  mutable std::atomic<std::int64_t> Bytes; ///< size of the cache, with slots
};

}

#endif
