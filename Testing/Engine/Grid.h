// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Grid_h
#define Testing_Grid_h

#include "Scene/Field.h"
#include "Scene/View.h"

#include <glm/gtc/matrix_transform.hpp>

#include <random>
#include <vector>

/// Samples in memory, and their field.
template <typename T>
struct Grid
{
  explicit Grid(const glm::ivec3& dimensions, int components = 1, int component = 0)
    : Samples(static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y) *
        static_cast<std::size_t>(dimensions.z) * static_cast<std::size_t>(components))
  {
    const std::int64_t step = components;
    this->Field.Samples = this->Samples.data() + component;
    this->Field.Type = Type();
    this->Field.Dimensions = dimensions;
    this->Field.Strides = { step, step * dimensions.x,
      step * dimensions.x * static_cast<std::int64_t>(dimensions.y) };
    this->Field.Stamp = 1;
  }

  T& At(int i, int j, int k)
  {
    return const_cast<T&>(*TemporalCoherence::TypedField<T>(this->Field).At(i, j, k));
  }

  template <typename Formula>
  void Fill(const Formula& formula)
  {
    const glm::ivec3& n = this->Field.Dimensions;
    for (int k = 0; k < n.z; ++k)
    {
      for (int j = 0; j < n.y; ++j)
      {
        for (int i = 0; i < n.x; ++i)
        {
          this->At(i, j, k) = static_cast<T>(formula(i, j, k));
        }
      }
    }
  }

  void FillRandomly(double low, double high, unsigned int seed)
  {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> value(low, high);
    this->Fill([&](int, int, int) { return value(engine); });
  }

  static TemporalCoherence::ScalarType Type()
  {
    using TemporalCoherence::ScalarType;
    for (int t = 0; t <= static_cast<int>(ScalarType::Float64); ++t)
    {
      const auto type = static_cast<ScalarType>(t);
      if (TemporalCoherence::DispatchScalarType(
            type, [](auto sample) { return std::is_same_v<decltype(sample), T>; }))
      {
        return type;
      }
    }
    return ScalarType::Float64;
  }

  std::vector<T> Samples;
  TemporalCoherence::Field Field;
};

/// A perspective view of a grid in index space as world, from a direction.
inline TemporalCoherence::View LookAt(const glm::ivec3& dimensions, const glm::dvec3& direction,
  const glm::ivec2& size, bool parallel = false)
{
  const glm::dvec3 centre = 0.5 * glm::dvec3(dimensions - 1);
  const double radius = glm::length(centre);
  const glm::dvec3 eye = centre + 3.0 * radius * glm::normalize(direction);
  const glm::dvec3 up = std::abs(direction.z) > 0.9 * glm::length(direction)
    ? glm::dvec3(0.0, 1.0, 0.0)
    : glm::dvec3(0.0, 0.0, 1.0);
  const double near = 1.5 * radius, far = 4.5 * radius;
  const glm::dmat4 projection = parallel
    ? glm::ortho(-radius, radius, -radius, radius, near, far)
    : glm::perspective(2.0 * std::asin(1.0 / 3.0), static_cast<double>(size.x) / size.y, near, far);
  TemporalCoherence::View view;
  TemporalCoherence::MakeView(glm::lookAt(eye, centre, up), projection, { near, far }, size, view);
  return view;
}

#endif
