// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/LatticeValues.h"

#include "Shade/KernelsGradients.h"
#include "Shade/KernelsRectilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{
namespace
{

using GradientKernels::CellPoints;

/// Share of a cell by which a point of nearest interpolation is moved along its ray, from the face
/// between two samples into the box of the sample that the ray enters.
constexpr double IntoNextBox = 1e-2;

/// Interpolates the samples at the corners of cells.
template <typename T>
void Interpolate(
  const TypedField<T>& samples, const CellPoints<double>& points, RayBatch::Array<double>& values)
{
  const std::int64_t x = samples.Strides.x, y = samples.Strides.y, z = samples.Strides.z;
  // Rows of samples lie far apart: prefetch all before reading the first.
  std::array<const T*, RayBatch::Capacity> first;
  for (std::size_t i = 0; i < points.Count; ++i)
  {
    first[i] = samples.At(points.Cell[0][i], points.Cell[1][i], points.Cell[2][i]);
    for (const std::int64_t toRow : { std::int64_t(0), y, z, y + z })
    {
      hwy::Prefetch(first[i] + toRow);
    }
  }
  for (std::size_t i = 0; i < points.Count; ++i)
  {
    const double u = points.At[0][i], v = points.At[1][i], w = points.At[2][i];
    const auto along = [&](std::int64_t edge)
    {
      return static_cast<double>(first[i][edge]) * (1.0 - u) +
        static_cast<double>(first[i][edge + x]) * u;
    };
    const double low = along(0) * (1.0 - v) + along(y) * v;
    const double high = along(z) * (1.0 - v) + along(y + z) * v;
    values[i] = low * (1.0 - w) + high * w;
  }
}

class LatticeValues final : public ArrayValues
{
public:
  explicit LatticeValues(const LatticeArray& array)
    : Array(array)
    , Points(array.Components.front().Dimensions + (array.IsOfCells ? 1 : 0))
  {
  }

  bool IsSame(const ArrayValues& other) const override
  {
    const auto* const same = dynamic_cast<const LatticeValues*>(&other);
    return same && same->Array.Components == this->Array.Components &&
      same->Array.IsOfCells == this->Array.IsOfCells &&
      same->Array.Transform == this->Array.Transform &&
      (same->Array.Grid == this->Array.Grid ||
        (same->Array.Grid && this->Array.Grid &&
          same->Array.Grid->Along == this->Array.Grid->Along));
  }

  void Find(const HitRays& rays, const RayBatch::Array<CellNumber>&,
    RayBatch::Array<double>& values) const override
  {
    CellPoints<double> points;
    this->FindCells(rays, points);
    const std::vector<Field>& components = this->Array.Components;
    this->FindComponent(components.front(), points, values);
    if (components.size() == 1)
    {
      return;
    }
    for (std::size_t i = 0; i < rays.Count; ++i)
    {
      values[i] *= values[i];
    }
    RayBatch::Array<double> along;
    for (std::size_t c = 1; c < components.size(); ++c)
    {
      this->FindComponent(components[c], points, along);
      for (std::size_t i = 0; i < rays.Count; ++i)
      {
        values[i] += along[i] * along[i];
      }
    }
    for (std::size_t i = 0; i < rays.Count; ++i)
    {
      values[i] = std::sqrt(values[i]);
    }
  }

private:
  /// Find the cells of hits. With nearest interpolation, points are moved to samples.
  void FindCells(const HitRays& rays, CellPoints<double>& points) const
  {
    const bool isNearest =
      !this->Array.IsOfCells && this->Array.Components.front().Between == Interpolation::Nearest;
    points.Count = rays.Count;
    const glm::dmat4& toIndex = this->Array.Transform.IndexFromWorld;
    if (!this->Array.Grid)
    {
      GradientKernels::FindCells({ toIndex, this->Points, isNearest }, rays, points);
    }
    else
    {
      GradientKernels::FindGridCells(*this->Array.Grid, toIndex, rays, points);
      for (std::size_t i = 0; i < points.Count && isNearest; ++i)
      {
        this->MoveToSample(glm::dmat3(toIndex) * rays.DirectionAt(i), i, points);
      }
    }
    for (std::size_t i = 0; i < points.Count && this->Array.IsOfCells; ++i)
    {
      this->EnterCell(glm::dmat3(toIndex) * rays.DirectionAt(i), i, points);
    }
  }

  /// Move a point on a face of cells into the cell that its ray enters.
  void EnterCell(const glm::dvec3& direction, std::size_t i, CellPoints<double>& points) const
  {
    constexpr double onFace = 1e-6;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      std::int32_t& cell = points.Cell[a][i];
      const bool isBefore = points.At[a][i] > 1.0 - onFace && direction[axis] > 0.0;
      const bool isBehind = points.At[a][i] < onFace && direction[axis] < 0.0;
      cell = std::min(std::max(cell + isBefore - isBehind, 0), this->Points[axis] - 2);
    }
  }

  void MoveToSample(glm::dvec3 direction, std::size_t i, CellPoints<double>& points) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      const int cell = points.Cell[a][i];
      direction[axis] /= this->Array.Grid->At(axis, cell + 1) - this->Array.Grid->At(axis, cell);
    }
    direction = glm::normalize(direction);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double moved = points.At[a][i] + IntoNextBox * direction[static_cast<int>(a)];
      points.At[a][i] = moved < 0.5 ? 0.0 : 1.0;
    }
  }

  void FindComponent(
    const Field& field, const CellPoints<double>& points, RayBatch::Array<double>& values) const
  {
    DispatchScalarType(field.Type,
      [&](auto type)
      {
        const TypedField<decltype(type)> samples(field);
        for (std::size_t i = 0; i < points.Count && this->Array.IsOfCells; ++i)
        {
          values[i] = static_cast<double>(
            *samples.At(points.Cell[0][i], points.Cell[1][i], points.Cell[2][i]));
        }
        if (!this->Array.IsOfCells)
        {
          Interpolate(samples, points, values);
        }
      });
  }

  LatticeArray Array;
  glm::ivec3 Points; ///< along each axis
};

}

std::shared_ptr<const ArrayValues> MakeLatticeValues(const LatticeArray& array)
{
  return std::make_shared<const LatticeValues>(array);
}

}
