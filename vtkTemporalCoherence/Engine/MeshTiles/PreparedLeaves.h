// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PreparedLeaves_h
#define TemporalCoherence_PreparedLeaves_h

#include "MeshTiles/MeshDifference.h"
#include "MeshTiles/PreparedCells.h"
#include "Scene/Surfaces.h"
#include "Trees/MeshTree.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace TemporalCoherence
{

/// The cells that surfaces pass, by leaf and surface. The first tile that asks for those of a leaf
/// prepares them; they are kept for other tiles, and for other views. Thread-safe.
class PreparedLeaves
{
public:
  /// \param tree outlives this
  PreparedLeaves(const MeshTree& tree, const Surfaces& surfaces, const glm::dvec2& finiteRange);
  ~PreparedLeaves();
  PreparedLeaves(const PreparedLeaves&) = delete;
  PreparedLeaves& operator=(const PreparedLeaves&) = delete;

  bool AreOf(const Surfaces& surfaces, const glm::dvec2& finiteRange) const;

  std::size_t NumberOfSurfaces() const { return this->Differences.size(); }

  /// The cells of a leaf that a surface passes.
  /// \param active one bit for each cell of the leaf that any of the surfaces may pass
  /// \param spare  holds them, if there is no room to keep them
  /// \throws std::bad_alloc
  const PreparedCells& Of(
    std::int64_t leaf, std::size_t surface, std::uint64_t active, PreparedCells& spare) const;

private:
  /// What is kept at most. Measured: the surfaces of 10 million tetrahedra take 100 MB.
  static constexpr std::int64_t MostBytes = 256 << 20;

  using Slot = std::atomic<const PreparedCells*>;

  Slot& SlotOf(std::int64_t leaf, std::size_t surface) const;
  void Prepare(
    std::int64_t leaf, std::size_t surface, std::uint64_t active, PreparedCells& cells) const;

  const MeshTree& Tree;
  Surfaces Isosurfaces;
  glm::dvec2 FiniteRange;
  std::vector<MeshDifference> Differences; ///< from each isovalue
  mutable std::once_flag IsAsked;
  mutable std::unique_ptr<Slot[]> Kept; ///< by surface and leaf; null: none was asked for
  mutable std::atomic<std::int64_t> Bytes{ 0 };
};

}

#endif
