// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsWalk_h
#define TemporalCoherence_KernelsWalk_h

#include "Acceleration/ActiveCells.h"
#include "Scene/RayBatch.h"

namespace TemporalCoherence
{

/// Computes the active cells of leaves on demand.
class LeafSource
{
public:
  virtual ~LeafSource() = default;

  /// One bit for each active cell of the active leaf that holds `cell`.
  virtual std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const = 0;
};

/// The scene of vector walks.
struct WalkScene
{
  const ActiveCells& Active;
  const LeafSource& Leaves;
  glm::ivec3 Cells; ///< number of cells along each axis
};

/// Rays that walk from active cell to active cell, as arrays. Rays whose walk ends are dropped.
struct RayWalks
{
  /// Begin the walks of some rays of a batch.
  RayWalks(const RayBatch& rays, std::uint64_t which);

  /// The walking rays, in order. PerDepth, WalkBegin and Pixel are valid only until the first ray
  /// is dropped.
  RayBatch Rays;
  RayBatch::Array<std::int64_t> From;          ///< position of each ray in its batch
  std::array<RayBatch::Array<double>, 3> Cell; ///< the present cell of each ray
  /// t of the hit in the present cell, or infinity. To be set before the rays go on.
  RayBatch::Array<double> Distance;
  bool HasBegun = false;
};

/// Take every ray without a hit to its next active cell; the first time it may stay in the cell
/// where its walk begins. Rays with a hit, and rays whose walk ends first, are dropped. With any
/// kind of vectors, each ray visits the same cells as CellWalk.
void FindActiveCells(const WalkScene& scene, RayWalks& walks);

/// The next active cells of walking rays, in order.
struct NextCells
{
  static constexpr int Most = 8;
  RayBatch::Array<std::int32_t> Count{}; ///< of cells, by ray; less than Most where a walk ends
  /// By place in the list, axis and ray. Places behind the end of a list hold arbitrary cells of
  /// the field.
  std::array<std::array<RayBatch::Array<double>, 3>, Most> Cell{};
};

/// List the next active cells of every ray, and take the ray past them. The first list may begin
/// with the cell where the walk begins. With any kind of vectors, each ray visits the same cells as
/// CellWalk. No ray is dropped: call KeepRays for that.
void ListActiveCells(const WalkScene& scene, RayWalks& walks, NextCells& next);

/// Drop rays whose walk ends, and let the others close up.
/// \param which one bit for each ray that goes on
void KeepRays(std::uint64_t which, RayWalks& walks);

}

#endif
