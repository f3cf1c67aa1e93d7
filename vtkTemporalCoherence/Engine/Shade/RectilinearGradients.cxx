// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/RectilinearGradients.h"

#include "Scene/Difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Share of a cell by which a hit of nearest interpolation is moved along the ray, from the face
/// between two samples into the box of the sample that the ray enters.
constexpr double IntoNextBox = 1e-2;

/// Gradients are clamped to this, so that sums of a few of them do not overflow.
double Bounded(double gradient)
{
  constexpr double largest = std::numeric_limits<double>::max() / 8.0;
  return std::min(std::max(gradient, -largest), largest);
}

/// A point and its cell.
struct CellPoint
{
  glm::ivec3 Cell{ 0 };
  glm::dvec3 At{ 0.0 }; ///< in the cell's own coordinates [0, 1]^3
};

/// \param point, direction in index space
CellPoint FindCell(const GridCoordinates& grid, Interpolation between, const glm::dvec3& point,
  const glm::dvec3& direction)
{
  CellPoint found;
  glm::dvec3 along(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cell = found.Cell[axis] = grid.CellOf(axis, point[axis]);
    const double low = grid.At(axis, cell);
    const double size = grid.At(axis, cell + 1) - low;
    found.At[axis] = std::min(std::max((point[axis] - low) / size, 0.0), 1.0);
    along[axis] = direction[axis] / size;
  }
  if (between == Interpolation::Nearest)
  {
    const glm::dvec3 moved = found.At + IntoNextBox * glm::normalize(along);
    found.At = glm::clamp(glm::floor(moved + 0.5), glm::dvec3(0.0), glm::dvec3(1.0));
  }
  return found;
}

/// Computes gradients of the difference from one isovalue.
template <typename T>
class GradientFinder
{
public:
  GradientFinder(
    const Field& field, const GridCoordinates& grid, const Difference<double>& difference)
    : Samples(field)
    , Grid(grid)
    , FromIsovalue(difference)
  {
  }

  void SetDifference(const Difference<double>& difference)
  {
    this->FromIsovalue = difference;
    this->CellOfCorners = glm::ivec3(-1);
  }

  double Unscaled(double difference) const
  {
    return Bounded(this->FromIsovalue.Unscaled(difference));
  }

  /// Per unit of index space, interpolated between the corners of the cell. Those are kept for the
  /// next point, which often lies in the same cell.
  glm::dvec3 At(const CellPoint& point)
  {
    if (point.Cell != this->CellOfCorners)
    {
      this->Corners = this->AtCorners(point.Cell);
      this->CellOfCorners = point.Cell;
    }
    const CornerGradients& gradients = this->Corners;
    glm::dvec3 sum(0.0);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const bool x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
      const double weight = (x ? point.At.x : 1.0 - point.At.x) *
        (y ? point.At.y : 1.0 - point.At.y) * (z ? point.At.z : 1.0 - point.At.z);
      for (int axis = 0; axis < 3 && weight > 0.0; ++axis) // not 0 times a hole
      {
        sum[axis] += weight * gradients[static_cast<std::size_t>(axis)][corner];
      }
    }
    return sum;
  }

  /// The same at a sample, which is a corner of the point's cell.
  glm::dvec3 AtSampleOf(const CellPoint& point) const
  {
    return this->AtSample(point.Cell + glm::ivec3(point.At));
  }

private:
  using CornerGradients = std::array<std::array<double, 8>, 3>;

  /// AtSample of all corners of a cell.
  CornerGradients AtCorners(const glm::ivec3& cell) const
  {
    const TypedField<T>& samples = this->Samples;
    const T* const first = samples.At(cell);
    CornerGradients gradients;
    for (int a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<std::size_t>(a);
      const int b = a == 0 ? 1 : 0, c = a == 2 ? 1 : 2;
      const bool isFirst = cell[a] == 0, isLast = cell[a] + 2 == samples.Dimensions[a];
      const std::int64_t step = samples.Strides[a];
      // The samples before the cell, of its two faces, and behind it.
      const std::array<std::int64_t, 4> places = { isFirst ? 0 : -step, 0, step,
        isLast ? step : 2 * step };
      const double* const at = this->Grid.Of(a).data() + cell[a];
      const std::array<double, 2> distances = { at[1] - at[isFirst ? 0 : -1],
        at[isLast ? 1 : 2] - at[0] };
      for (std::size_t row = 0; row < 4; ++row)
      {
        const std::size_t onB = row & 1, onC = row >> 1;
        const T* const sample =
          first + (onB ? samples.Strides[b] : 0) + (onC ? samples.Strides[c] : 0);
        std::array<double, 4> values;
        for (std::size_t i = 0; i < 4; ++i)
        {
          values[i] = this->FromIsovalue(static_cast<double>(sample[places[i]]));
        }
        const std::size_t corner = (onB << b) + (onC << c);
        for (std::size_t side = 0; side < 2; ++side)
        {
          gradients[axis][corner + (side << axis)] =
            Bounded((values[side + 2] - values[side]) / distances[side]);
        }
      }
    }
    return gradients;
  }

  /// Central differences, one-sided at the boundary.
  glm::dvec3 AtSample(const glm::ivec3& sample) const
  {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 before = sample, behind = sample;
      before[axis] = std::max(sample[axis] - 1, 0);
      behind[axis] = std::min(sample[axis] + 1, this->Samples.Dimensions[axis] - 1);
      const double distance = this->Grid.At(axis, behind[axis]) - this->Grid.At(axis, before[axis]);
      gradient[axis] = Bounded((this->ValueAt(behind) - this->ValueAt(before)) / distance);
    }
    return gradient;
  }

  double ValueAt(const glm::ivec3& sample) const
  {
    return this->FromIsovalue(static_cast<double>(*this->Samples.At(sample)));
  }

  TypedField<T> Samples;
  const GridCoordinates& Grid;
  Difference<double> FromIsovalue;
  CornerGradients Corners{}; ///< those of a cell
  glm::ivec3 CellOfCorners{ -1 };
};

}

void RectilinearGradients(
  const GridCoordinates& grid, const GradientQuery& query, const GradientTile& tile)
{
  const std::size_t count = tile.Rays.Count;
  const glm::dmat3 turn(query.IndexFromWorld);
  DispatchScalarType(query.Samples.Type,
    [&](auto type)
    {
      const auto differenceFor = [&](std::int16_t surface)
      {
        const double isovalue = (*query.Isovalues)[static_cast<std::size_t>(surface)];
        return Difference<double>(isovalue, query.FiniteRange);
      };
      std::int16_t surface = tile.Surfaces[0];
      GradientFinder<decltype(type)> finder(query.Samples, grid, differenceFor(surface));
      for (std::size_t i = 0; i < count; ++i)
      {
        if (tile.Surfaces[i] != surface)
        {
          surface = tile.Surfaces[i];
          finder.SetDifference(differenceFor(surface));
        }
        const glm::dvec3 point(query.IndexFromWorld * glm::dvec4(tile.Rays.PointAt(i), 1.0));
        const CellPoint found =
          FindCell(grid, query.Samples.Between, point, turn * tile.Rays.DirectionAt(i));
        const glm::dvec3 gradient = query.Samples.Between == Interpolation::Nearest
          ? finder.AtSampleOf(found)
          : finder.At(found);
        for (std::size_t a = 0; a < 3; ++a)
        {
          tile.Gradients[a][i] = finder.Unscaled(gradient[static_cast<int>(a)]);
        }
      }
    });
  for (RayBatch::Array<double>& along : tile.Gradients)
  {
    // So that no lane of the last vector is uninitialised.
    std::fill(along.begin() + static_cast<std::ptrdiff_t>(count),
      along.begin() + static_cast<std::ptrdiff_t>(WholeVectors(count)), along[count - 1]);
  }
}

}
