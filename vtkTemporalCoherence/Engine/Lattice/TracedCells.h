// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TracedCells_h
#define TemporalCoherence_TracedCells_h

#include "Lattice/CellRoot.h"
#include "Lattice/CellSamples.h"
#include "Lattice/CellWalk.h"
#include "Lattice/HitRules.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/Difference.h"
#include "Scene/HiddenCells.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// The result of searching one segment for one isovalue.
struct CellHit
{
  bool FromInside; ///< the ray is inside where it enters the cell
  double Distance; ///< t of the first crossing; infinity if there is none
};

/// The cells of a field with samples at their corners, prepared for tracing.
///
/// \tparam Geometry the geometry of cells: RayOf(rays, ray), for CellWalk, and Segment(ray, cell),
///         the segment of a ray in a cell. Value is the type of samples in differences from
///         isovalues, Real the type of computed crossings. HasKernels: kernels for SegmentBatch
///         make and search segments
template <typename T, typename Geometry, Interpolation Between>
struct TracedCells
{
  using Real = typename Geometry::Real;
  using Value = typename Geometry::Value;
  using Segment = typename Geometry::Segment;

  TracedCells(const TraceScene& scene, const Geometry& shape)
    : Scene(scene)
    , Shape(shape)
    , Samples(scene.Samples)
    , Count(scene.Samples.Dimensions - 1)
    , Hidden(scene.Samples.Hidden.get())
    , Rules(scene.Isosurfaces, scene.Samples.Hidden != nullptr)
  {
    for (const double isovalue : scene.Isosurfaces.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
  }

  bool IsHidden(const glm::ivec3& cell) const
  {
    return this->Hidden && this->Hidden->IsHidden(cell);
  }

  /// Take a walk to the next cell that may hold a surface.
  /// \return false if the walk ends first
  template <typename WalkingRay>
  HWY_INLINE bool GoOn(const WalkingRay& ray, CellWalk& walk) const
  {
    return this->Scene.Active ? walk.FindActive(ray, *this->Scene.Active, this->Samples.All())
                              : walk.FindAny(ray, this->Count);
  }

  /// Differences of a cell's samples from an isovalue.
  Corners<Real> Differ(const std::array<T, 8>& samples, std::size_t surface) const
  {
    Corners<Real> corners;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->Differences[surface](static_cast<Value>(samples[i]));
    }
    return corners;
  }

  /// True if a cell can hold a surface, or a cap where the ray enters it.
  bool CanHold(const Corners<Real>& corners) const
  {
    int inside = 0;
    for (const Real corner : corners)
    {
      inside += IsInside(corner);
    }
    return inside != 0 && (inside != 8 || this->Rules.AreCappedBehindHidden());
  }

  /// Difference from the isovalue where a ray enters a cell.
  static Real AtEntry(const Corners<Real>& corners, const Segment& segment)
  {
    return Between == Interpolation::Linear ? CubicAlong(corners, segment.Path())[0]
                                            : corners[NearestCorner(segment.Path().Begin)];
  }

  CellHit SearchFor(const Segment& segment, const Corners<Real>& corners) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if constexpr (Between == Interpolation::Nearest)
    {
      double share = 0.0;
      const bool isFound =
        segment.HasLength() && FirstNearestCrossing(corners, segment.Nearest(), share);
      return { IsInside(AtEntry(corners, segment)),
        isFound ? segment.DistanceAt(share) : infinity };
    }
    else
    {
      const Cubic<Real> cubic = CubicAlong(corners, segment.Path());
      Real share = Real(0);
      // A walk may begin inside a solid whose surface it has to find.
      const bool begins = this->Rules.IsSolid() && IsInside(cubic[0]);
      const bool isFound = begins || FirstCrossing(cubic, share);
      return { IsInside(cubic[0]),
        isFound ? segment.DistanceAt(static_cast<double>(share)) : infinity };
    }
  }

  /// Make a found surface its ray's hit if it lies in front of the present hit.
  void Keep(const Segment& segment, const CellHit& found, SurfaceIndex surface, std::size_t ray,
    HitBatch& hits) const
  {
    this->Rules.KeepFirst(found.Distance, found.FromInside, surface, ray, hits);
    if (this->Rules.AreCappedBehindHidden() && found.FromInside)
    {
      this->Rules.CapBehindHidden(
        segment.Enter(), surface, ray, [&] { return segment.ComesFrom(*this->Hidden); }, hits);
    }
  }

  TraceScene Scene;
  Geometry Shape;
  CellSamples<T> Samples;
  std::vector<Difference<Value>> Differences; ///< from each isovalue
  glm::ivec3 Count;                           ///< of cells along each axis
  const HiddenCells* Hidden;                  ///< null for none
  HitRules Rules;
};

}

#endif
