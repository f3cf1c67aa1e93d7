// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/SurfaceNormal.h"

#include "Lattice/CellSamples.h"
#include "Scene/Difference.h"
#include "Scene/Surfaces.h"
#include "Shade/KernelsGradients.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

/// How many points ahead samples are prefetched. Measured by `Benchmark --scenarios routes`,
/// shading.
constexpr std::size_t Ahead = 6;

/// Gathers the rows of samples for central differences around points.
template <typename T>
class RowGatherer
{
public:
  using Stored = GradientKernels::StoredAs<T>;
  using Rows = GradientKernels::RowBatch<Stored>;
  using Points = GradientKernels::CellPoints<RealOf<T>>;

  explicit RowGatherer(const Field& field)
    : Samples(field)
    , IsLarge(field.IsLarge())
  {
  }

  void Gather(const Points& points, Rows& rows) const
  {
    ClearLastVector(points.Count, rows);
    // A local copy: stores of a character type may alias anything that is not local.
    const TypedField<T> samples = this->Samples;
    const bool isLarge = this->IsLarge;
    const bool isPacked = std::is_same_v<T, Stored> && samples.Strides.x == 1;
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      if (isLarge)
      {
        PrefetchAround(samples, CellOf(points, std::min(i + Ahead, points.Count - 1)));
      }
      const glm::ivec3 cell = CellOf(points, i);
      if (isPacked && IsInner(cell, samples.Dimensions))
      {
        CopyRows(samples.At(cell), samples.Strides.y, samples.Strides.z, i, rows);
      }
      else
      {
        KeepSamples(samples, cell, i, rows);
      }
    }
  }

private:
  static glm::ivec3 CellOf(const Points& points, std::size_t i)
  {
    return { points.Cell[0][i], points.Cell[1][i], points.Cell[2][i] };
  }

  /// Fill the last vector, so that no lane is uninitialised.
  static void ClearLastVector(std::size_t count, Rows& rows)
  {
    const auto begin = static_cast<std::ptrdiff_t>(WholeVectors(count) - WidestVector);
    for (auto& along : rows.Along)
    {
      std::fill_n(along.begin() + begin, WidestVector, std::array<Stored, 4>());
    }
    for (auto& beside : rows.Beside)
    {
      std::fill_n(beside.begin() + begin, WidestVector, std::array<Stored, 2>());
    }
  }

  /// True if a cell has neighbouring samples on both sides along every axis.
  static bool IsInner(const glm::ivec3& cell, const glm::ivec3& samples)
  {
    return cell.x > 0 && cell.x + 2 < samples.x && cell.y > 0 && cell.y + 2 < samples.y &&
      cell.z > 0 && cell.z + 2 < samples.z;
  }

  /// Store the samples around an inner cell whose rows are contiguous in memory.
  static void CopyRows(const T* origin, std::int64_t y, std::int64_t z, std::size_t i, Rows& rows)
  {
    const auto copyFour = [i, &rows](std::size_t row, const T* from)
    { std::memcpy(&rows.Along[row][i], from - 1, 4 * sizeof(T)); };
    const auto copyTwo = [i, &rows](std::size_t row, const T* from)
    { std::memcpy(&rows.Beside[row][i], from, 2 * sizeof(T)); };
    copyFour(0, origin);
    copyFour(1, origin + y);
    copyFour(2, origin + z);
    copyFour(3, origin + y + z);
    copyTwo(0, origin - y);
    copyTwo(1, origin - y + z);
    copyTwo(2, origin + 2 * y);
    copyTwo(3, origin + 2 * y + z);
    copyTwo(4, origin - z);
    copyTwo(5, origin + y - z);
    copyTwo(6, origin + 2 * z);
    copyTwo(7, origin + y + 2 * z);
  }

  /// Store the samples around a cell at any place, sample by sample. Repeats samples of the
  /// boundary beyond the boundary, which makes differences one-sided.
  static void KeepSamples(
    const TypedField<T>& samples, const glm::ivec3& cell, std::size_t i, Rows& rows)
  {
    const T* const origin = samples.At(cell);
    const std::int64_t x = samples.Strides.x, y = samples.Strides.y, z = samples.Strides.z;
    glm::i64vec3 before, behind;
    for (int a = 0; a < 3; ++a)
    {
      before[a] = cell[a] > 0 ? -samples.Strides[a] : 0;
      behind[a] = (cell[a] + 2 < samples.Dimensions[a] ? 2 : 1) * samples.Strides[a];
    }
    const auto keepFour = [&](std::size_t row, const T* from)
    {
      rows.Along[row][i] = { static_cast<Stored>(from[before.x]), static_cast<Stored>(from[0]),
        static_cast<Stored>(from[x]), static_cast<Stored>(from[behind.x]) };
    };
    const auto keepTwo = [&](std::size_t row, const T* from) {
      rows.Beside[row][i] = { static_cast<Stored>(from[0]), static_cast<Stored>(from[x]) };
    };
    for (std::size_t edge = 0; edge < 4; ++edge)
    {
      keepFour(edge, origin + (edge & 1u ? y : 0) + (edge & 2u ? z : 0));
    }
    for (std::size_t side = 0; side < 2; ++side)
    {
      keepTwo(side, origin + before.y + (side ? z : 0));
      keepTwo(2 + side, origin + behind.y + (side ? z : 0));
      keepTwo(4 + side, origin + before.z + (side ? y : 0));
      keepTwo(6 + side, origin + behind.z + (side ? y : 0));
    }
  }

  TypedField<T> Samples;
  bool IsLarge;
};

/// Replace an outer NaN sample so that the difference over two steps is twice the inner step's
/// difference, and so one-sided.
/// \param limit of differences; is widened, as the new sample may exceed all others
template <typename Stored>
void Mirror(Stored inner, Stored next, Stored& outer, double& limit)
{
  if (std::isnan(outer))
  {
    constexpr double most = std::numeric_limits<double>::max() / 4.0;
    outer = inner + (inner - next);
    limit = std::min(3.0 * limit, most);
  }
}

/// Make differences one-sided beside a NaN sample. The corners of cells with hits are never NaN.
template <typename Rows>
void MakeOneSided(std::size_t count, Rows& rows)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double limit = rows.Limit[i];
    double widest = limit;
    const auto mirror = [&](auto inner, auto next, auto& outer)
    {
      double wider = limit;
      Mirror(inner, next, outer, wider);
      widest = std::max(widest, wider);
    };
    for (auto& row : rows.Along)
    {
      mirror(row[i][1], row[i][2], row[i][0]);
      mirror(row[i][2], row[i][1], row[i][3]);
    }
    for (std::size_t side = 0; side < 2; ++side)
    {
      for (std::size_t x = 0; x < 2; ++x)
      {
        // Corners of the cell at z = side, and at y = side.
        const auto low = rows.Along[2 * side][i][1 + x], high = rows.Along[2 * side + 1][i][1 + x];
        const auto near = rows.Along[side][i][1 + x], far = rows.Along[2 + side][i][1 + x];
        mirror(low, high, rows.Beside[side][i][x]);
        mirror(high, low, rows.Beside[2 + side][i][x]);
        mirror(near, far, rows.Beside[4 + side][i][x]);
        mirror(far, near, rows.Beside[6 + side][i][x]);
      }
    }
    rows.Limit[i] = widest;
  }
}

/// Prefetch the samples around points if they do not fit into the caches.
template <typename T>
void PrefetchSamples(const Field& field, const GradientKernels::CellPoints<RealOf<T>>& points)
{
  const TypedField<T> samples(field);
  for (std::size_t i = 0; i < points.Count && field.IsLarge(); ++i)
  {
    PrefetchAround(samples, { points.Cell[0][i], points.Cell[1][i], points.Cell[2][i] });
  }
}

/// Differences from the isovalues. Integers are finite: their differences are taken from 0.
template <typename T, typename Rows>
void SetIsovalues(const GradientQuery& query, std::size_t count,
  const RayBatch::Array<SurfaceIndex>& surfaces, Rows& rows)
{
  std::array<double, 3> parts = { 0.0, 0.0, std::numeric_limits<double>::max() };
  for (std::size_t i = 0; i < WholeVectors(count); ++i)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      if (i < count && (i == 0 || surfaces[i] != surfaces[i - 1]))
      {
        const double isovalue = (*query.Isovalues)[static_cast<std::size_t>(surfaces[i])];
        parts = Difference<T>(isovalue, query.FiniteRange).Parts();
      }
    }
    rows.High[i] = parts[0];
    rows.Low[i] = parts[1];
    rows.Limit[i] = parts[2];
  }
}

}

void UniformGradients(const GradientQuery& query, const GradientTile& tile)
{
  const Field& field = query.Samples;
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      typename RowGatherer<T>::Points inCells;
      inCells.Count = tile.Rays.Count;
      const bool areInner = GradientKernels::FindCells(
        { query.IndexFromWorld, field.Dimensions, field.Between == Interpolation::Nearest },
        tile.Rays, inCells);
      if constexpr (sizeof(T) <= 2)
      {
        if (areInner && NarrowSamples<T>::Are(field))
        {
          PrefetchSamples<T>(field, inCells);
          GradientKernels::GatherGradients(NarrowSamples<T>(field), inCells, tile.Gradients);
          return;
        }
      }
      typename RowGatherer<T>::Rows rows;
      RowGatherer<T>(field).Gather(inCells, rows);
      if constexpr (sizeof(T) > 2)
      {
        SetIsovalues<T>(query, tile.Rays.Count, tile.Surfaces, rows);
      }
      if constexpr (std::is_floating_point_v<T>)
      {
        if (field.Hidden)
        {
          MakeOneSided(tile.Rays.Count, rows);
        }
      }
      GradientKernels::InterpolateGradients(field.Dimensions, inCells, rows, tile.Gradients);
    });
}

}
