// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsWalk_h
#define TemporalCoherence_KernelsWalk_h

#include "Acceleration/ActiveCells.h"
#include "Scene/RayBatch.h"

namespace TemporalCoherence
{

/// Tells the active cells of leaves that no ray has asked for before.
class LeafSource
{
public:
  virtual ~LeafSource() = default;

  /// One bit for each active cell of the active leaf that holds `cell`.
  virtual std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const = 0;
};

/// What walks go through.
struct WalkScene
{
  const ActiveCells& Active;
  const LeafSource& Leaves;
  glm::ivec3 Cells; ///< number of cells along each axis
};

/// Rays on their way from active cell to active cell, as arrays; those whose walk ends are dropped.
struct RayWalks
{
  /// Begin the walks of some rays of a batch.
  RayWalks(const RayBatch& rays, std::uint64_t which);

  /// Those on their way, in order; PerDepth, WalkBegin and Pixel are of use only before the first
  /// is dropped.
  RayBatch Rays;
  RayBatch::Array<std::int64_t> From;          ///< place in the batch that each comes from
  std::array<RayBatch::Array<double>, 3> Cell; ///< where each stands
  /// t of what each has found there, or infinity: to be told before they go on.
  RayBatch::Array<double> Distance;
  bool HasBegun = false;
};

/// Take every ray that has found nothing to the next active cell; the first time it may stay in the
/// cell where its walk begins. The others, and rays whose walk ends before, are dropped. Each ray
/// visits the cells that CellWalk visits, in vectors of any kind.
void FindActiveCells(const WalkScene& scene, RayWalks& walks);

}

#endif
