// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ComponentWalk_h
#define TemporalCoherence_ComponentWalk_h

#include "Acceleration/HiddenCells.h"
#include "Blending/BlendTracer.h"
#include "Sampling/ComponentSegment.h"
#include "Scene/Field.h"
#include "Trace/CellRoot.h"
#include "Trace/CellSamples.h"
#include "Trace/CellWalk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Takes rays from cell to cell, with the samples of all components, for any geometry of cells
/// (TracedCells.h).
template <typename T, typename Geometry>
class ComponentWalk final : public SegmentSource
{
public:
  /// \param grid where samples lie; null: at integers
  ComponentWalk(const BlendScene& scene, const Geometry& shape, const GridCoordinates* grid)
    : Shape(shape)
    , Grid(grid)
    , Count(scene.Key.Samples.Dimensions - 1)
    , IsNearest(scene.Key.Samples.Between == Interpolation::Nearest)
    , Hidden(scene.Key.Samples.Hidden.get())
    , Visible(scene.Visible)
  {
    this->Components.emplace_back(scene.Key.Samples);
    for (const Field& other : scene.Key.Volume.Others)
    {
      this->Components.emplace_back(other);
    }
  }

  std::int64_t Visit(
    const RayBatch& rays, std::size_t ray, const SegmentVisitor& visit) const override
  {
    const auto line = this->Shape.RayOf(rays, ray);
    std::int64_t cells = 0;
    CellWalk walk;
    walk.Begin(line, this->Count);
    ComponentSegment segment;
    while (this->Visible ? walk.FindActive(line, *this->Visible, this->Components.front().All())
                         : walk.FindAny(line, this->Count))
    {
      ++cells;
      if (this->Read(walk.Here(), segment) && this->Pass(line, walk.Here(), segment) &&
        !visit(segment))
      {
        break;
      }
    }
    return cells;
  }

  void FindGradients(
    std::size_t component, const glm::ivec3& cell, CornerGradients& gradients) const override
  {
    const TypedField<T>& samples = this->Components[component].All();
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 at = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
      for (int axis = 0; axis < 3; ++axis)
      {
        gradients[static_cast<std::size_t>(corner)][axis] = this->SlopeAt(samples, at, axis);
      }
    }
  }

private:
  /// \return false if a cell holds nothing
  bool Read(const glm::ivec3& cell, ComponentSegment& segment) const
  {
    bool areFinite = !(this->Hidden && this->Hidden->IsHidden(cell));
    segment.Cell = cell;
    for (std::size_t c = 0; areFinite && c < this->Components.size(); ++c)
    {
      const std::array<T, 8> samples = this->Components[c].Read(cell);
      for (std::size_t i = 0; i < 8; ++i)
      {
        segment.Samples[c][i] = static_cast<double>(samples[i]);
        areFinite = areFinite && std::isfinite(segment.Samples[c][i]);
      }
    }
    return areFinite;
  }

  /// \return false if a ray only touches a cell
  template <typename WalkingRay>
  bool Pass(const WalkingRay& line, const glm::ivec3& cell, ComponentSegment& segment) const
  {
    const typename Geometry::Segment passed(line, cell);
    if (!passed.HasLength())
    {
      return false;
    }
    segment.Enter = passed.Enter();
    segment.Leave = passed.Leave();
    for (std::size_t a = 0; a < 3; ++a)
    {
      segment.Path.Begin[a] = static_cast<double>(passed.Path().Begin[a]);
      segment.Path.End[a] = static_cast<double>(passed.Path().End[a]);
    }
    segment.IsNearest = this->IsNearest;
    if (this->IsNearest)
    {
      segment.Nearest = passed.Nearest();
    }
    else
    {
      for (std::size_t c = 0; c < this->Components.size(); ++c)
      {
        segment.Cubics[c] = CubicAlong(segment.Samples[c], segment.Path);
      }
    }
    return true;
  }

  /// The gradient at a sample along an axis.
  double SlopeAt(const TypedField<T>& samples, const glm::ivec3& at, int axis) const
  {
    glm::ivec3 low = at, high = at;
    low[axis] = std::max(at[axis] - 1, 0);
    high[axis] = std::min(at[axis] + 1, this->Count[axis]);
    const double rise =
      static_cast<double>(*samples.At(high)) - static_cast<double>(*samples.At(low));
    return rise /
      (this->Grid ? this->Grid->At(axis, high[axis]) - this->Grid->At(axis, low[axis])
                  : static_cast<double>(high[axis] - low[axis]));
  }

  Geometry Shape;
  const GridCoordinates* Grid; ///< null: samples lie at integers
  glm::ivec3 Count;            ///< of cells along each axis
  bool IsNearest;
  const HiddenCells* Hidden;
  const ActiveCells* Visible; ///< null: all
  std::vector<CellSamples<T>> Components;
};

}

#endif
