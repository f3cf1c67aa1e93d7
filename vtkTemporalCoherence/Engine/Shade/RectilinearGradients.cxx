// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/RectilinearGradients.h"

#include "Scene/Difference.h"
#include "Shade/KernelsRectilinear.h"
#include "Shade/Shader.h"

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

/// Limit of gradients: sums of a few gradients do not overflow.
constexpr double LargestGradient = std::numeric_limits<double>::max() / 8.0;

double Bounded(double gradient)
{
  return std::min(std::max(gradient, -LargestGradient), LargestGradient);
}

Difference<double> DifferenceFor(const GradientQuery& query, SurfaceIndex surface)
{
  const double isovalue = (*query.Isovalues)[static_cast<std::size_t>(surface)];
  return { isovalue, query.FiniteRange };
}

/// Finds gradients with linear interpolation. Corner gradients are computed once for all points in
/// a cell.
template <typename T>
class InterpolatedGradients
{
public:
  InterpolatedGradients(
    const GridCoordinates& grid, const GradientQuery& query, const GradientTile& tile)
    : Samples(query.Samples)
    , Grid(grid)
    , Query(query)
    , Tile(tile)
  {
  }

  void Find()
  {
    GradientKernels::CellPoints<double> points;
    points.Count = this->Tile.Rays.Count;
    GradientKernels::FindGridCells(this->Grid, this->Query.IndexFromWorld, this->Tile.Rays, points);
    RayBatch::Array<std::int32_t> cells;
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      const glm::ivec3 place(points.Cell[0][i], points.Cell[1][i], points.Cell[2][i]);
      cells[i] = this->NumberOf(place, this->Tile.Surfaces[i]);
    }
    // Fill the last vector, so that no lane is uninitialised.
    std::fill(cells.begin() + static_cast<std::ptrdiff_t>(points.Count),
      cells.begin() + static_cast<std::ptrdiff_t>(WholeVectors(points.Count)), 0);
    GradientKernels::InterpolateInGrid(
      this->Cells, cells, points, LargestGradient, this->Tile.Gradients);
  }

private:
  /// The number of a cell together with an isovalue. Reads the samples around new cells.
  std::int32_t NumberOf(const glm::ivec3& place, SurfaceIndex surface)
  {
    // A hash table with two places for each possible cell. Neighbours get different places.
    constexpr std::uint32_t mask = 2 * RayBatch::Capacity - 1;
    const glm::uvec3 p(place);
    std::uint32_t at = (p.x + 5u * p.y + 25u * p.z + 61u * static_cast<std::uint32_t>(surface));
    for (at &= mask; this->Places[at] != 0; at = (at + 1) & mask)
    {
      const auto known = static_cast<std::size_t>(this->Places[at] - 1);
      if (this->Cell[known] == place && this->Surface[known] == surface)
      {
        return this->Places[at] - 1;
      }
    }
    const std::size_t number = this->Cells.Count++;
    this->Places[at] = static_cast<std::int32_t>(number + 1);
    this->Cell[number] = place;
    this->Surface[number] = surface;
    this->ReadAround(place, number);
    if (number == 0 || this->Surface[number - 1] != surface)
    {
      this->FromIsovalue = DifferenceFor(this->Query, surface).InDouble();
    }
    this->Cells.FromIsovalue[number] = this->FromIsovalue;
    if (std::is_floating_point_v<T> && this->Query.Samples.Hidden)
    {
      this->MakeOneSided(place, number);
    }
    return static_cast<std::int32_t>(number);
  }

  /// Read the samples around a cell. At the boundary of the field differences are one-sided.
  void ReadAround(const glm::ivec3& cell, std::size_t number)
  {
    const TypedField<T>& samples = this->Samples;
    const T* const first = samples.At(cell);
    for (int a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<std::size_t>(a);
      const int b = a == 0 ? 1 : 0, c = a == 2 ? 1 : 2;
      const bool isFirst = cell[a] == 0, isLast = cell[a] + 2 == samples.Dimensions[a];
      const std::int64_t step = samples.Strides[a];
      const std::array<std::int64_t, 4> places = { isFirst ? 0 : -step, 0, step,
        isLast ? step : 2 * step };
      const std::array<std::int64_t, 4> edges = { 0, samples.Strides[b], samples.Strides[c],
        samples.Strides[b] + samples.Strides[c] };
      for (std::size_t place = 0; place < 4; ++place)
      {
        for (std::size_t edge = 0; edge < 4; ++edge)
        {
          this->Cells.Around[number][axis][place][edge] =
            static_cast<double>(first[places[place] + edges[edge]]);
        }
      }
      const double* const at = this->Grid.Of(a).data() + cell[a];
      this->Cells.Between[number][axis] = { at[1] - at[isFirst ? 0 : -1],
        at[isLast ? 1 : 2] - at[0] };
    }
  }

  /// Replace NaN samples beside a cell so that differences become one-sided. The new differences
  /// may exceed the limit of finite samples, which is widened.
  void MakeOneSided(const glm::ivec3& cell, std::size_t number)
  {
    constexpr double most = std::numeric_limits<double>::max() / 4.0;
    double widest = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      auto& around = this->Cells.Around[number][axis];
      const auto a = static_cast<int>(axis);
      const double step = this->Grid.At(a, cell[a] + 1) - this->Grid.At(a, cell[a]);
      for (std::size_t edge = 0; edge < 4; ++edge)
      {
        const double rise = around[2][edge] - around[1][edge];
        const std::array<double, 2> steps = { this->Cells.Between[number][axis][0] / step,
          this->Cells.Between[number][axis][1] / step };
        if (std::isnan(around[0][edge]))
        {
          around[0][edge] = around[2][edge] - rise * steps[0];
          widest = std::max(widest, 1.0 + 2.0 * steps[0]);
        }
        if (std::isnan(around[3][edge]))
        {
          around[3][edge] = around[1][edge] + rise * steps[1];
          widest = std::max(widest, 1.0 + 2.0 * steps[1]);
        }
      }
    }
    double& limit = this->Cells.FromIsovalue[number].Limit;
    limit = std::min(widest * limit, std::max(most, limit));
  }

  TypedField<T> Samples;
  const GridCoordinates& Grid;
  const GradientQuery& Query;
  const GradientTile& Tile;
  DifferenceInDouble FromIsovalue{}; ///< of the last cell
  GradientKernels::GridCells Cells;
  std::array<glm::ivec3, RayBatch::Capacity> Cell;
  std::array<SurfaceIndex, RayBatch::Capacity> Surface;
  std::array<std::int32_t, 2 * RayBatch::Capacity> Places{}; ///< cell numbers + 1, by hash
};

/// Finds gradients with nearest interpolation.
template <typename T>
class NearestGradients
{
public:
  NearestGradients(
    const GridCoordinates& grid, const GradientQuery& query, const GradientTile& tile)
    : Samples(query.Samples)
    , Grid(grid)
    , Query(query)
    , Tile(tile)
  {
  }

  void Find() const
  {
    const std::size_t count = this->Tile.Rays.Count;
    const glm::dmat3 turn(this->Query.IndexFromWorld);
    SurfaceIndex surface = this->Tile.Surfaces[0];
    Difference<double> difference = DifferenceFor(this->Query, surface);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->Tile.Surfaces[i] != surface)
      {
        surface = this->Tile.Surfaces[i];
        difference = DifferenceFor(this->Query, surface);
      }
      const glm::dvec3 point(
        this->Query.IndexFromWorld * glm::dvec4(this->Tile.Rays.PointAt(i), 1.0));
      const glm::dvec3 gradient =
        this->AtSample(this->SampleAt(point, turn * this->Tile.Rays.DirectionAt(i)), difference);
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Tile.Gradients[a][i] = Bounded(difference.Unscaled(gradient[static_cast<int>(a)]));
      }
    }
    for (RayBatch::Array<double>& along : this->Tile.Gradients)
    {
      FillLastVector(count, along);
    }
  }

private:
  /// The sample nearest to a point that is first moved along the ray.
  glm::ivec3 SampleAt(const glm::dvec3& point, const glm::dvec3& direction) const
  {
    glm::ivec3 cell(0);
    glm::dvec3 in(0.0), along(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = this->Grid.CellOf(axis, point[axis]);
      const double low = this->Grid.At(axis, cell[axis]);
      const double size = this->Grid.At(axis, cell[axis] + 1) - low;
      in[axis] = std::min(std::max((point[axis] - low) / size, 0.0), 1.0);
      along[axis] = direction[axis] / size;
    }
    const glm::dvec3 moved = in + IntoNextBox * glm::normalize(along);
    return cell + glm::ivec3(glm::clamp(glm::floor(moved + 0.5), glm::dvec3(0.0), glm::dvec3(1.0)));
  }

  /// Central differences, one-sided at the boundary and beside a sample that is not a number.
  glm::dvec3 AtSample(const glm::ivec3& sample, const Difference<double>& difference) const
  {
    const auto valueAt = [&](const glm::ivec3& place)
    { return difference(static_cast<double>(*this->Samples.At(place))); };
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 before = sample, behind = sample;
      before[axis] = std::max(sample[axis] - 1, 0);
      behind[axis] = std::min(sample[axis] + 1, this->Samples.Dimensions[axis] - 1);
      before = this->IsNumber(before) ? before : sample;
      behind = this->IsNumber(behind) ? behind : sample;
      const double distance = this->Grid.At(axis, behind[axis]) - this->Grid.At(axis, before[axis]);
      gradient[axis] = Bounded((valueAt(behind) - valueAt(before)) / distance);
    }
    return gradient;
  }

  bool IsNumber(const glm::ivec3& place) const
  {
    return !std::isnan(static_cast<double>(*this->Samples.At(place)));
  }

  TypedField<T> Samples;
  const GridCoordinates& Grid;
  const GradientQuery& Query;
  const GradientTile& Tile;
};

}

void RectilinearGradients(
  const GridCoordinates& grid, const GradientQuery& query, const GradientTile& tile)
{
  DispatchScalarType(query.Samples.Type,
    [&](auto type)
    {
      if (query.Samples.Between == Interpolation::Nearest)
      {
        NearestGradients<decltype(type)>(grid, query, tile).Find();
      }
      else
      {
        InterpolatedGradients<decltype(type)>(grid, query, tile).Find();
      }
    });
}

}
