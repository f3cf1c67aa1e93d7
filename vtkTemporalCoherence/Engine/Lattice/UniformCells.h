// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformCells_h
#define TemporalCoherence_UniformCells_h

#include "Lattice/CellSegment.h"
#include "Lattice/CellWalk.h"
#include "Lattice/SegmentBatch.h"
#include "Scene/Field.h"
#include "Scene/HiddenCells.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// True if the ray of a segment comes from a hidden cell and does more than touch this one.
/// \param enter t where it enters the cell
template <typename Real>
bool ComesFromHidden(
  const SegmentBatch<Real>& segments, std::size_t i, double enter, const HiddenCells& hidden)
{
  // Through an edge or a corner the ray comes from the opposite cell.
  double leave = segments.EndOf()[i];
  glm::ivec3 before;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const bool isAhead = segments.DirectionOf(a)[i] > 0.0;
    const double cell = segments.Cell[a][i];
    const auto pass = [&](double plane)
    { return (plane - segments.OriginOf(a)[i]) * segments.InverseOf(a)[i]; };
    const bool isEntry = pass(isAhead ? cell : cell + 1.0) == enter;
    leave = std::min(leave, pass(isAhead ? cell + 1.0 : cell));
    before[static_cast<int>(a)] = static_cast<int>(cell) + (isEntry ? (isAhead ? -1 : 1) : 0);
  }
  return enter < leave && hidden.IsHidden(before);
}

/// The geometry of the cells of an image, for CellTracer.
template <typename T>
struct UniformCells
{
  using Value = T;
  using Real = RealOf<T>;
  static constexpr bool HasKernels = true; ///< many segments are searched at once, in vectors

  BatchRay RayOf(const RayBatch& rays, std::size_t ray) const { return { rays, ray }; }

  /// The segment of a ray in one cell.
  struct Segment
  {
    Segment(const BatchRay& ray, const glm::ivec3& cell)
      : Batch(BatchOf(ray, cell))
      , Inner(this->Batch, 0)
    {
    }

    bool HasLength() const { return this->Inner.Enter < this->Inner.Leave; }
    double Enter() const { return this->Inner.Enter; }
    double Leave() const { return this->Inner.Leave; }
    double DistanceAt(double share) const { return this->Inner.DistanceAt(share); }
    const CellPath<Real>& Path() const { return this->Inner.Path; }
    NearestPath Nearest() const { return this->Inner.Nearest(this->Batch, 0); }
    bool ComesFrom(const HiddenCells& hidden) const
    {
      return ComesFromHidden(this->Batch, 0, this->Inner.Enter, hidden);
    }

  private:
    static SegmentBatch<Real> BatchOf(const BatchRay& ray, const glm::ivec3& cell)
    {
      SegmentBatch<Real> segments;
      AppendSegment(ray.Rays, ray.Ray, cell, Corners<Real>(), segments);
      return segments;
    }

    SegmentBatch<Real> Batch;
    CellSegment<Real> Inner;
  };
};

}

#endif
