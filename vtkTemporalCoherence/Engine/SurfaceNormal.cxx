// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceNormal.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Central differences along one axis at two neighbouring samples: which samples to subtract, as
/// offsets from the first of the two, and by what to multiply.
struct AxisDifferences
{
  AxisDifferences(int sample, int samples, std::int64_t stride)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int at = sample + side;
      const int low = std::max(at - 1, 0);
      const int high = std::min(at + 1, samples - 1);
      const auto i = static_cast<std::size_t>(side);
      this->Low[i] = (low - sample) * stride;
      this->High[i] = (high - sample) * stride;
      this->Scale[i] = 1.0 / (high - low);
    }
  }

  std::array<std::int64_t, 2> Low, High;
  std::array<double, 2> Scale;
};

template <typename T>
glm::dvec3 GradientAt(const TypedField<T>& field, const Difference<T>& difference,
  Interpolation between, const glm::dvec3& point)
{
  const glm::ivec3 cell =
    glm::clamp(glm::ivec3(glm::floor(point)), glm::ivec3(0), field.Dimensions - 2);
  glm::dvec3 at = glm::clamp(point - glm::dvec3(cell), 0.0, 1.0);
  if (between == Interpolation::Nearest)
  {
    at = glm::floor(at + 0.5);
  }
  const T* origin = field.At(cell);
  const glm::i64vec3& stride = field.Strides;
  const AxisDifferences axes[3] = { { cell.x, field.Dimensions.x, stride.x },
    { cell.y, field.Dimensions.y, stride.y }, { cell.z, field.Dimensions.z, stride.z } };

  glm::dvec3 gradient(0.0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::size_t x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    const double weight =
      (x ? at.x : 1.0 - at.x) * (y ? at.y : 1.0 - at.y) * (z ? at.z : 1.0 - at.z);
    const std::int64_t toX = x ? stride.x : 0, toY = y ? stride.y : 0, toZ = z ? stride.z : 0;
    const std::array<std::int64_t, 3> others = { toY + toZ, toX + toZ, toX + toY };
    const std::array<std::size_t, 3> sides = { x, y, z };
    for (int axis = 0; axis < 3; ++axis)
    {
      const AxisDifferences& along = axes[axis];
      const std::size_t side = sides[static_cast<std::size_t>(axis)];
      const T* row = origin + others[static_cast<std::size_t>(axis)];
      const auto rise = difference(row[along.High[side]]) - difference(row[along.Low[side]]);
      gradient[axis] += weight * along.Scale[side] * static_cast<double>(rise);
    }
  }
  return gradient;
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
