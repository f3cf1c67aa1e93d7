// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformCells_h
#define TemporalCoherence_UniformCells_h

#include "Scene/Field.h"
#include "Trace/CellWalk.h"
#include "Trace/HiddenPassage.h"
#include "Trace/Passage.h"

namespace TemporalCoherence
{

/// How rays go through the cells of an image, for CellTracer.
template <typename T>
struct UniformCells
{
  using Value = T;
  using Real = RealOf<T>;
  static constexpr bool HasKernels = true; ///< many cells are searched at once, in vectors

  BatchRay RayOf(const RayBatch& rays, std::size_t ray) const { return { rays, ray }; }

  /// The part of a ray in one cell.
  struct Part
  {
    Part(const BatchRay& ray, const glm::ivec3& cell)
      : Passages(BatchOf(ray, cell))
      , Passed(this->Passages, 0)
    {
    }

    bool HasLength() const { return this->Passed.Enter < this->Passed.Leave; }
    double Enter() const { return this->Passed.Enter; }
    double Leave() const { return this->Passed.Leave; }
    double DistanceAt(double share) const { return this->Passed.DistanceAt(share); }
    const CellPath<Real>& Path() const { return this->Passed.Path; }
    NearestPath Nearest() const { return this->Passed.Nearest(this->Passages, 0); }
    bool ComesFrom(const HiddenCells& hidden) const
    {
      return ComesFromHidden(this->Passages, 0, this->Passed.Enter, hidden);
    }

  private:
    static PassageBatch<Real> BatchOf(const BatchRay& ray, const glm::ivec3& cell)
    {
      PassageBatch<Real> passages;
      AppendPassage(ray.Rays, ray.Ray, cell, Corners<Real>(), passages);
      return passages;
    }

    PassageBatch<Real> Passages;
    Passage<Real> Passed;
  };
};

}

#endif
