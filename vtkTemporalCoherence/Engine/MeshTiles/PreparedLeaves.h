// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PreparedLeaves_h
#define TemporalCoherence_PreparedLeaves_h

#include "MeshTiles/MeshDifference.h"
#include "MeshTiles/PreparedCells.h"
#include "Trees/MeshTree.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace TemporalCoherence
{

/// The cells that count for isovalues, by leaf and isovalue. The first tile that asks for those of
/// a leaf prepares them; they are kept for other tiles, and for other views. Thread-safe.
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

  /// From each isovalue.
  const std::vector<MeshDifference>& Differences() const { return this->FromIsovalues; }

  /// The cells of a leaf that count for an isovalue.
  /// \param isovalue its position in the list
  /// \param active   one bit for each cell of the leaf that any of the isovalues may pass
  /// \param spare    holds them, if there is no room to keep them
  /// \throws std::bad_alloc
  const PreparedCells& Of(
    std::int64_t leaf, std::size_t isovalue, std::uint64_t active, PreparedCells& spare) const;

  /// The same cells, or null if they are not kept, or not yet.
  const PreparedCells* Known(std::int64_t leaf, std::size_t isovalue) const;

  /// No other cells have this number.
  std::int64_t KeyOf(std::int64_t leaf, std::size_t isovalue) const
  {
    return leaf * static_cast<std::int64_t>(this->Isovalues.size()) +
      static_cast<std::int64_t>(isovalue);
  }

private:
  /// What is kept at most, with a slot for each leaf and isovalue. Measured: the surfaces of 10
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
  mutable std::unique_ptr<Slot[]> Kept;    ///< by isovalue and leaf; null: none was asked for
  mutable std::atomic<std::int64_t> Bytes; ///< of what is kept, with slots
};

}

#endif
