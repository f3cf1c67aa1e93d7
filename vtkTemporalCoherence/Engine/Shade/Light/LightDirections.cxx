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
  add(place.Patch + 64 * place.Side);
  add(place.Level + 4096 * place.Surface);
  x *= 0xbf58476d1ce4e5b9ull;
  return x ^ x >> 32;
}

}

glm::dvec3 LightDirection(const glm::dvec3& normal, const PatchPlace& place, std::uint32_t number)
{
  static const Circle circle;
  const EvenPoint point(number, SeedOf(place));
  // A basis around the normal (Duff et al. 2017).
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z), b = normal.x * normal.y * a;
  const glm::dvec3 x(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const glm::dvec3 y(b, sign + normal.y * normal.y * a, -normal.y);
  const double square = (point.X + 0.5) * 0x1p-32;
  const glm::dvec2 onDisk = std::sqrt(square) * circle.At(point.Y);
  return onDisk.x * x + onDisk.y * y + std::sqrt(1.0 - square) * normal;
}

}
