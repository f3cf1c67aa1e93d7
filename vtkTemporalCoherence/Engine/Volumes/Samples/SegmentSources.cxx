// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/SegmentSources.h"

#include "Lattice/CellRoot.h"
#include "Lattice/CellSamples.h"
#include "Lattice/CellWalk.h"
#include "Lattice/RectilinearCells.h"
#include "Lattice/UniformCells.h"
#include "Scene/Field.h"
#include "Scene/HiddenCells.h"
#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Samples/LabelledSegments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Walks rays from cell to cell, with the samples of all components, for any geometry of cells
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
    for (const Field& other : scene.Key.Blended().Others)
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
    const Steps steps(*this, samples, cell);
    const T* const origin = samples.At(cell);
    for (std::size_t corner = 0; corner < gradients.size(); ++corner)
    {
      gradients[corner] = steps.GradientAt(origin, corner);
    }
  }

  glm::dvec3 GradientAt(
    std::size_t component, const glm::ivec3& cell, std::size_t corner) const override
  {
    const TypedField<T>& samples = this->Components[component].All();
    return Steps(*this, samples, cell).GradientAt(samples.At(cell), corner);
  }

private:
  /// Offsets of the samples on both sides of the corners of a cell.
  class Steps
  {
  public:
    Steps(const ComponentWalk& walk, const TypedField<T>& samples, const glm::ivec3& cell)
      : Walk(walk)
      , Cell(cell)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        this->Stride[a] = samples.Strides[axis];
        for (int side = 0; side < 2; ++side)
        {
          const auto s = static_cast<std::size_t>(side);
          const int at = cell[axis] + side;
          const int low = std::max(at - 1, 0), high = std::min(at + 1, walk.Count[axis]);
          this->Low[a][s] = (low - at) * samples.Strides[axis];
          this->High[a][s] = (high - at) * samples.Strides[axis];
          this->PerLength[a][s] = 1.0 / walk.LengthBetween(axis, low, high);
        }
      }
    }

    /// \param origin the first corner
    glm::dvec3 GradientAt(const T* origin, std::size_t corner) const
    {
      const std::size_t sides[3] = { corner & 1u, corner >> 1 & 1u, corner >> 2 };
      for (std::size_t a = 0; a < 3; ++a)
      {
        origin += sides[a] != 0 ? this->Stride[a] : 0;
      }
      glm::dvec3 gradient;
      for (std::size_t a = 0; a < 3; ++a)
      {
        const std::size_t side = sides[a];
        const auto low = static_cast<double>(origin[this->Low[a][side]]);
        const auto high = static_cast<double>(origin[this->High[a][side]]);
        gradient[static_cast<int>(a)] = std::isfinite(low) && std::isfinite(high)
          ? this->PerLength[a][side] * (high - low)
          : this->AlongEdge(origin, static_cast<int>(a), side != 0);
      }
      return gradient;
    }

  private:
    /// The gradient along the edge of the cell alone, where a sample beside it is not finite.
    double AlongEdge(const T* corner, int axis, bool isBehind) const
    {
      const std::int64_t stride = this->Stride[static_cast<std::size_t>(axis)];
      const T* const low = corner - (isBehind ? stride : 0);
      const int at = this->Cell[axis];
      return (static_cast<double>(low[stride]) - static_cast<double>(*low)) /
        this->Walk.LengthBetween(axis, at, at + 1);
    }

    const ComponentWalk& Walk;
    glm::ivec3 Cell;
    std::array<std::int64_t, 3> Stride;
    std::array<std::array<std::int64_t, 2>, 3> Low, High; ///< by axis and side of the cell
    std::array<std::array<double, 2>, 3> PerLength;
  };

  double LengthBetween(int axis, int low, int high) const
  {
    return this->Grid ? this->Grid->At(axis, high) - this->Grid->At(axis, low)
                      : static_cast<double>(high - low);
  }

  /// \return false if a cell is hidden, or has a sample that is not finite
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

  Geometry Shape;
  const GridCoordinates* Grid; ///< null: samples lie at integers
  glm::ivec3 Count;            ///< of cells along each axis
  bool IsNearest;
  const HiddenCells* Hidden;
  const ActiveCells* Visible; ///< null: all
  std::vector<CellSamples<T>> Components;
};

std::unique_ptr<const SegmentSource> MakeWalk(const BlendScene& scene, const GridCoordinates* grid)
{
  return DispatchScalarType(scene.Key.Samples.Type,
    [&](auto type) -> std::unique_ptr<const SegmentSource>
    {
      using T = decltype(type);
      if (grid)
      {
        using Cells = RectilinearCells<T>;
        return std::make_unique<ComponentWalk<T, Cells>>(scene, Cells(*grid), grid);
      }
      return std::make_unique<ComponentWalk<T, UniformCells<T>>>(scene, UniformCells<T>(), grid);
    });
}

}

std::unique_ptr<const SegmentSource> MakeSegmentSource(
  const BlendScene& scene, const GridCoordinates* grid)
{
  std::unique_ptr<const SegmentSource> walk = MakeWalk(scene, grid);
  const auto& labels = scene.Key.Blended().Labels;
  return labels ? MakeLabelledSegments(*labels, std::move(walk)) : std::move(walk);
}

}
