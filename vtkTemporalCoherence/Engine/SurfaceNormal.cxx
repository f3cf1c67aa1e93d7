// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceNormal.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Central differences along one axis at the two samples of a cell's edge, one-sided at the ends of
/// the field: offsets of the samples to subtract, from the first of the two, and what to multiply
/// by.
struct EdgeDifferences
{
  EdgeDifferences(int sample, int samples, std::int64_t step)
    : Before(sample > 0 ? -step : 0)
    , Step(step)
    , Behind(sample + 2 < samples ? 2 * step : step)
    , ScaleFirst(sample > 0 ? 0.5 : 1.0)
    , ScaleSecond(sample + 2 < samples ? 0.5 : 1.0)
  {
  }

  std::int64_t Before, Step, Behind;
  double ScaleFirst, ScaleSecond;
};

/// How far one sample is above another.
template <typename T>
double Rise(T from, T to, const Difference<T>& difference)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return difference(to) - difference(from); // finite, whatever the samples are
  }
  else
  {
    return static_cast<double>(static_cast<RealOf<T>>(to) - static_cast<RealOf<T>>(from));
  }
}

double Interpolate(double a, double b, double weightOfB)
{
  return (1.0 - weightOfB) * a + weightOfB * b;
}

/// One component of the gradient: differences along an axis on the four edges of the cell that run
/// along it, interpolated along the axis and then across it.
template <typename T>
double GradientAlong(const T* origin, const EdgeDifferences& along, double at, std::int64_t stepU,
  double atU, std::int64_t stepV, double atV, const Difference<T>& difference)
{
  const auto onEdge = [&](const T* first)
  {
    const double atFirst =
      along.ScaleFirst * Rise(first[along.Before], first[along.Step], difference);
    const double atSecond = along.ScaleSecond * Rise(first[0], first[along.Behind], difference);
    return Interpolate(atFirst, atSecond, at);
  };
  const double low = Interpolate(onEdge(origin), onEdge(origin + stepU), atU);
  const double high = Interpolate(onEdge(origin + stepV), onEdge(origin + stepU + stepV), atU);
  return Interpolate(low, high, atV);
}

template <typename T>
glm::dvec3 GradientAt(const TypedField<T>& field, const Difference<T>& difference,
  Interpolation between, const glm::dvec3& point)
{
  const glm::ivec3& n = field.Dimensions;
  const glm::i64vec3& step = field.Strides;
  const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(point)), glm::ivec3(0), n - 2);
  glm::dvec3 at = glm::clamp(point - glm::dvec3(cell), 0.0, 1.0);
  if (between == Interpolation::Nearest)
  {
    at = glm::floor(at + 0.5);
  }
  const T* origin = field.At(cell);
  return { GradientAlong(origin, EdgeDifferences(cell.x, n.x, step.x), at.x, step.y, at.y, step.z,
             at.z, difference),
    GradientAlong(
      origin, EdgeDifferences(cell.y, n.y, step.y), at.y, step.x, at.x, step.z, at.z, difference),
    GradientAlong(
      origin, EdgeDifferences(cell.z, n.z, step.z), at.z, step.x, at.x, step.y, at.y, difference) };
}

}

void IndexGradients(const Field& field, const glm::dvec2& finiteRange, double isovalue, int count,
  const glm::dvec3* points, glm::dvec3* gradients)
{
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      const TypedField<T> samples(field);
      const Difference<T> difference(isovalue, finiteRange);
      for (int i = 0; i < count; ++i)
      {
        gradients[i] = GradientAt(samples, difference, field.Between, points[i]);
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
