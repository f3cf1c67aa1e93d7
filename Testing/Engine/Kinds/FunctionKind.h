// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_FunctionKind_h
#define Testing_FunctionKind_h

#include "Kinds/FieldKind.h"
#include "Lattice/BlockWalk.h"
#include "Lattice/HitRules.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/CellBox.h"
#include "Scene/Field.h"
#include "Shade/SurfaceNormal.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

// A kind of field that has no samples: a function of the point in index space. What a new kind of
// field costs (Documentation/Extending.md).

namespace TemporalCoherence
{

/// A smooth function of index space.
struct SmoothFunction
{
  std::function<double(const glm::dvec3&)> Value;
  std::function<glm::dvec3(const glm::dvec3&)> Gradient;
  double LargestGradient; ///< no gradient is longer
};

/// Finds where rays pass isovalues of a function, block by block.
class FunctionTracer final : public SurfaceTracer
{
public:
  FunctionTracer(const SmoothFunction& function, const TraceScene& scene)
    : Function(function)
    , Scene(scene)
    , Rules(scene.Isosurfaces, false)
  {
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    this->Find(rays, true, hits);
  }

  void FindNext(const RayBatch& rays, HitBatch& hits) const override
  {
    this->Find(rays, false, hits);
  }

private:
  void Find(const RayBatch& rays, bool isFirst, HitBatch& hits) const
  {
    const auto isovalues = static_cast<SurfaceIndex>(this->Scene.Isosurfaces.Isovalues.size());
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      NextHit next(this->Rules, LastOn(this->Rules, rays.Begin[ray], ray, hits));
      for (SurfaceIndex i = 0; i < isovalues && this->Rules.IsSolid(); ++i)
      {
        if (rays.Begin[ray] < rays.End[ray] && this->IsInsideAt(rays, ray, rays.Begin[ray], i))
        {
          next.Consider(rays.Begin[ray], HitKind::Cap, i);
        }
      }
      BlockWalk walk(rays, ray, this->Scene.Samples.Dimensions - 1, this->Scene.Active);
      while (rays.HasWalk(ray) && !next.IsFound() && walk.Next())
      {
        for (SurfaceIndex i = 0; i < isovalues; ++i)
        {
          if (isFirst)
          {
            this->Enter(rays, ray, walk.Enter(), i, next);
          }
          this->FindCrossings(rays, ray, { walk.Enter(), walk.Leave() }, i, next);
        }
      }
      next.Store(ray, hits);
    }
  }

  /// A ray enters an active block, where nothing is found yet.
  void Enter(
    const RayBatch& rays, std::size_t ray, double enter, SurfaceIndex surface, NextHit& next) const
  {
    if (this->Rules.IsSolid() && this->IsInsideAt(rays, ray, enter, surface))
    {
      next.Consider(enter, HitKind::Exit, surface); // the walk began within it
    }
  }

  double DifferenceAt(const RayBatch& rays, std::size_t ray, double t, SurfaceIndex surface) const
  {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      point[axis] = rays.Origin[a][ray] + t * rays.Direction[a][ray];
    }
    return this->Function.Value(point) - this->Rules.IsovalueOf(surface);
  }

  bool IsInsideAt(const RayBatch& rays, std::size_t ray, double t, SurfaceIndex surface) const
  {
    return IsInside(this->DifferenceAt(rays, ray, t, surface));
  }

  /// Find where a part of a ray passes an isovalue, by steps that are too short for the function to
  /// get there and back.
  void FindCrossings(const RayBatch& rays, std::size_t ray, const glm::dvec2& part,
    SurfaceIndex surface, NextHit& next) const
  {
    constexpr double Shortest = 1e-3; // of a voxel
    const double perT = glm::length(
      glm::dvec3(rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray]));
    double t = part.x, difference = this->DifferenceAt(rays, ray, t, surface);
    while (t < part.y)
    {
      const double step = std::max(std::abs(difference) / this->Function.LargestGradient, Shortest);
      const double end = std::min(t + step / perT, part.y);
      const double ahead = this->DifferenceAt(rays, ray, end, surface);
      const bool isInside = IsInside(difference);
      if (IsInside(ahead) != isInside)
      {
        double before = t, behind = end;
        for (int halving = 0; halving < 60; ++halving)
        {
          const double middle = 0.5 * (before + behind);
          (this->IsInsideAt(rays, ray, middle, surface) == isInside ? before : behind) = middle;
        }
        if (!isInside || !this->Rules.IsSolid())
        {
          next.Consider(behind, HitRules::KindOf(isInside), surface);
        }
      }
      t = end;
      difference = ahead;
    }
  }

  const SmoothFunction& Function;
  TraceScene Scene;
  HitRules Rules;
};

/// What frames ask of a function.
class FunctionKind final : public FieldKind
{
public:
  explicit FunctionKind(SmoothFunction function)
    : Function(std::move(function))
  {
  }

  glm::dvec2 RangeIn(const CellBox& cells) const override
  {
    const glm::dvec3 half = 0.5 * glm::dvec3(cells.Size);
    const double middle = this->Function.Value(glm::dvec3(cells.First) + half);
    const double reach = this->Function.LargestGradient * glm::length(half) * (1.0 + 1e-9);
    return { middle - reach, middle + reach };
  }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    return std::make_shared<FunctionTracer>(this->Function, scene);
  }

  void FindGradients(const GradientQuery& query, const GradientTile& tile) const override
  {
    for (std::size_t i = 0; i < WholeVectors(tile.Rays.Count); ++i)
    {
      const std::size_t from = std::min(i, tile.Rays.Count - 1);
      const glm::dvec4 world(tile.Rays.PointAt(from), 1.0);
      const glm::dvec3 gradient = this->Function.Gradient(glm::dvec3(query.IndexFromWorld * world));
      for (std::size_t a = 0; a < 3; ++a)
      {
        tile.Gradients[a][i] = gradient[static_cast<int>(a)];
      }
    }
  }

private:
  SmoothFunction Function;
};

}

#endif
