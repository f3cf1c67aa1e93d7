// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/LightDirections.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Unit vectors of a circle.
class Circle
{
public:
  static constexpr std::size_t Steps = 4096;

  Circle()
  {
    constexpr double step = 6.28318530717958647692 / Steps;
    for (std::size_t i = 0; i < Steps; ++i)
    {
      this->Points[i] = { std::cos(step * (static_cast<double>(i) + 0.5)),
        std::sin(step * (static_cast<double>(i) + 0.5)) };
    }
  }

  /// \param turn share of the circle, times 2^32
  const glm::dvec2& At(std::uint32_t turn) const { return this->Points[turn >> 20]; }

private:
  std::array<glm::dvec2, Steps> Points;
};

/// Two numbers of a sequence that fills the square evenly (Roberts' R2 sequence), times 2^32.
struct EvenPoint
{
  EvenPoint(std::uint32_t number, std::uint64_t seed)
    : X(static_cast<std::uint32_t>(seed) + number * 3242174889u)
    , Y(static_cast<std::uint32_t>(seed >> 32) + number * 2447445414u)
  {
  }

  std::uint32_t X, Y;
};

/// Where the sequence of a patch begins.
std::uint64_t SeedOf(const PatchPlace& place)
{
  std::uint64_t x = static_cast<std::uint32_t>(place.Block.x);
  const auto add = [&x](std::int64_t value)
  {
    x = (x ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ull;
    x ^= x >> 29;
  };
  add(place.Block.y);
  add(place.Block.z);
  add(place.Patch + 64 * place.Side + 65536 * std::int64_t(place.Source));
  add(place.Level + 4096 * place.Surface);
  x *= 0xbf58476d1ce4e5b9ull;
  return x ^ x >> 32;
}

/// A point in the disk of radius 1.
struct DiskPoint
{
  DiskPoint(const PatchPlace& place, std::uint32_t number)
  {
    static const Circle circle;
    const EvenPoint point(number, SeedOf(place));
    this->Square = (point.X + 0.5) * 0x1p-32;
    this->At = std::sqrt(this->Square) * circle.At(point.Y);
  }

  /// The point in the plane that is perpendicular to an axis (Duff et al. 2017).
  glm::dvec3 Across(const glm::dvec3& axis) const
  {
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1.0 / (sign + axis.z), b = axis.x * axis.y * a;
    const glm::dvec3 x(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    const glm::dvec3 y(b, sign + axis.y * axis.y * a, -axis.y);
    return this->At.x * x + this->At.y * y;
  }

  glm::dvec2 At;
  double Square; ///< of its distance from the middle
};

}

glm::dvec3 DirectionAround(const glm::dvec3& normal, const PatchPlace& place, std::uint32_t number)
{
  const DiskPoint point(place, number);
  return point.Across(normal) + std::sqrt(1.0 - point.Square) * normal;
}

glm::dvec3 PointOnDisk(const glm::dvec3& axis, const PatchPlace& place, std::uint32_t number)
{
  return DiskPoint(place, number).Across(axis);
}

}
