// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceNormal.h"

#include "KernelsShading.h"
#include "Surfaces.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

/// Points by which samples are sent for in advance.
constexpr std::size_t Ahead = 6;

/// Gathers what central differences around points need.
template <typename T>
class SampleGatherer
{
public:
  using Real = RealOf<T>;
  using Batch = ShadingKernels::GradientBatch<Real>;

  SampleGatherer(const Field& field, const glm::dvec2& finiteRange, double isovalue)
    : Samples(field)
    , IsNearest(field.Between == Interpolation::Nearest)
    , FromIsovalue(isovalue, finiteRange)
    , Steps{ field.Strides.x, field.Strides.y, field.Strides.z }
  {
  }

  /// Send for the samples around a point.
  void Prefetch(const glm::dvec3& point) const
  {
    const glm::ivec3 last = this->Samples.Dimensions - 1;
    const glm::ivec3 cell = glm::clamp(glm::ivec3(point), glm::ivec3(0), last);
    for (int k = std::max(cell.z - 1, 0); k <= std::min(cell.z + 2, last.z); ++k)
    {
      for (int j = std::max(cell.y - 1, 0); j <= std::min(cell.y + 2, last.y); ++j)
      {
        hwy::Prefetch(this->Samples.At(cell.x, j, k));
      }
    }
  }

  /// Gather for point i of the batch, after those before it.
  void Gather(const glm::dvec3& point, std::size_t i, Batch& batch)
  {
    // Rounding towards 0 is rounding down, but below 0, where there is no cell.
    const glm::ivec3 cell =
      glm::clamp(glm::ivec3(point), glm::ivec3(0), this->Samples.Dimensions - 2);
    const glm::dvec3 in = glm::clamp(point - glm::dvec3(cell), 0.0, 1.0);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double at = in[static_cast<int>(a)];
      batch.At[a][i] = static_cast<Real>(this->IsNearest ? std::floor(at + 0.5) : at);
    }
    if (i > 0 && cell == this->LastCell)
    {
      Repeat(i, batch);
      return;
    }
    this->LastCell = cell;
    this->GatherCell(cell, i, batch);
  }

private:
  /// What was gathered for the point before: neighbouring pixels often see the same cell.
  static void Repeat(std::size_t i, Batch& batch)
  {
    const auto repeat = [i](auto& array) { array[i] = array[i - 1]; };
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      repeat(batch.Corner[corner]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::size_t edge = 0; edge < 4; ++edge)
      {
        repeat(batch.Before[a][edge]);
        repeat(batch.Behind[a][edge]);
      }
      repeat(batch.ScaleFirst[a]);
      repeat(batch.ScaleSecond[a]);
    }
  }

  void GatherCell(const glm::ivec3& cell, std::size_t i, Batch& batch) const
  {
    const glm::ivec3& n = this->Samples.Dimensions;
    const T* const origin = this->Samples.At(cell);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      batch.Corner[corner][i] = this->Value(origin + (corner & 1u ? this->Steps[0] : 0) +
        (corner & 2u ? this->Steps[1] : 0) + (corner & 4u ? this->Steps[2] : 0));
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      // One-sided at the ends of the field.
      const bool hasBefore = cell[axis] > 0;
      const bool hasBehind = cell[axis] + 2 < n[axis];
      const T* const before = origin - (hasBefore ? this->Steps[a] : 0);
      const T* const behind = origin + (hasBehind ? 2 : 1) * this->Steps[a];
      const std::int64_t u = this->Steps[a == 0 ? 1 : 0];
      const std::int64_t v = this->Steps[a == 2 ? 1 : 2];
      const std::int64_t edges[4] = { 0, u, v, u + v };
      for (std::size_t edge = 0; edge < 4; ++edge)
      {
        batch.Before[a][edge][i] = this->Value(before + edges[edge]);
        batch.Behind[a][edge][i] = this->Value(behind + edges[edge]);
      }
      batch.ScaleFirst[a][i] = hasBefore ? Real(0.5) : Real(1);
      batch.ScaleSecond[a][i] = hasBehind ? Real(0.5) : Real(1);
    }
  }

  /// A sample as a number whose differences are exact enough, and finite whatever the sample is.
  Real Value(const T* sample) const
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      return this->FromIsovalue(*sample);
    }
    else
    {
      return static_cast<Real>(*sample);
    }
  }

  TypedField<T> Samples;
  bool IsNearest;
  Difference<T> FromIsovalue;
  std::array<std::int64_t, 3> Steps;
  glm::ivec3 LastCell{ 0 };
};

}

void IndexGradients(const Field& field, const glm::dvec2& finiteRange, double isovalue, int count,
  const std::array<RayBatch::Array<double>, 3>& points,
  std::array<RayBatch::Array<double>, 3>& gradients)
{
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      SampleGatherer<T> gatherer(field, finiteRange, isovalue);
      typename SampleGatherer<T>::Batch batch;
      batch.Count = static_cast<std::size_t>(count);
      for (std::size_t i = 0; i < batch.Count; ++i)
      {
        if (field.IsLarge())
        {
          const std::size_t later = std::min(i + Ahead, batch.Count - 1);
          gatherer.Prefetch({ points[0][later], points[1][later], points[2][later] });
        }
        gatherer.Gather({ points[0][i], points[1][i], points[2][i] }, i, batch);
      }
      ShadingKernels::InterpolateGradients(batch);
      for (std::size_t a = 0; a < 3; ++a)
      {
        std::copy_n(batch.Gradient[a].begin(), batch.Count, gradients[a].begin());
      }
    });
}

glm::dvec3 BoxFaceNormal(const glm::dvec3& point, const glm::ivec3& dimensions)
{
  constexpr double Tolerance = 1e-3; // cells: what remains of a depth in single precision
  glm::dvec3 normal(0.0);
  double nearest = Tolerance;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double toLow = std::abs(point[axis]);
    const double toHigh = std::abs(point[axis] - (dimensions[axis] - 1));
    const double distance = std::min(toLow, toHigh);
    if (distance < nearest)
    {
      nearest = distance;
      normal = glm::dvec3(0.0);
      normal[axis] = toLow < toHigh ? -1.0 : 1.0;
    }
  }
  return normal;
}

}
