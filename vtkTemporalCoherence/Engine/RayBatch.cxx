// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayBatch.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// A direction component smaller than this share of the largest one is replaced by it, with its
/// sign, so that its inverse is finite. Over the 1e4 cells of a large volume the ray then strays by
/// 1e-11 cells.
constexpr double SmallestShare = 1e-15;

/// A vector that is linear in normalised device coordinates.
struct LinearVector
{
  double At(int axis, double x, double y) const
  {
    return this->Centre[axis] + x * this->PerX[axis] + y * this->PerY[axis];
  }

  glm::dvec3 Centre, PerX, PerY;
};

/// Rays of unit length in the world, seen from index space; loops over rays are simple, so that
/// the compiler can make several at a time.
class RaySetUp
{
public:
  RaySetUp(const View& view, const Placement& placement)
    : World{ view.Direction, view.DirectionX, view.DirectionY }
  {
    const glm::dmat4& toIndex = placement.IndexFromWorld;
    const glm::dmat3 turn(toIndex);
    this->Direction = { turn * view.Direction, turn * view.DirectionX, turn * view.DirectionY };
    this->Origin = { glm::dvec3(toIndex * glm::dvec4(view.Origin, 1.0)), turn * view.OriginX,
      turn * view.OriginY };
    this->Forward = { glm::dot(view.Direction, view.Forward),
      glm::dot(view.DirectionX, view.Forward), glm::dot(view.DirectionY, view.Forward) };
  }

  /// One row of rays into the arrays from `at` on.
  void SetRow(const View& view, int firstColumn, int row, int count, int at, RayBatch& rays) const
  {
    for (int i = 0; i < count; ++i)
    {
      const auto ray = static_cast<std::size_t>(at + i);
      const glm::dvec2 p = view.PixelCentre(firstColumn + i, row);
      const double x = this->World.At(0, p.x, p.y);
      const double y = this->World.At(1, p.x, p.y);
      const double z = this->World.At(2, p.x, p.y);
      const double length = std::sqrt(x * x + y * y + z * z);
      const double perLength = 1.0 / length;
      double direction[3], size[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        rays.Origin[static_cast<std::size_t>(axis)][ray] = this->Origin.At(axis, p.x, p.y);
        direction[axis] = this->Direction.At(axis, p.x, p.y) * perLength;
        size[axis] = std::abs(direction[axis]);
      }
      const double smallest = SmallestShare * std::max(size[0], std::max(size[1], size[2]));
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        const double component =
          size[axis] < smallest ? std::copysign(smallest, direction[axis]) : direction[axis];
        rays.Direction[a][ray] = component;
        rays.Inverse[a][ray] = 1.0 / component;
      }
      const double forward = this->Forward.x + p.x * this->Forward.y + p.y * this->Forward.z;
      const double perDepth = length / forward;
      rays.Begin[ray] = view.Near * perDepth;
      rays.End[ray] = view.Far * perDepth;
      rays.Pixel[ray] = row * view.Size.x + firstColumn + i;
    }
  }

private:
  LinearVector World, Direction, Origin;
  glm::dvec3 Forward; ///< the same for the component along the optical axis
};

/// Clip rays to the box [0, dimensions - 1]; the planes are the faces of its first and last cells.
void ClipToBox(const glm::ivec3& dimensions, RayBatch& rays)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double last = dimensions[static_cast<int>(a)] - 1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const double toFirst = (0.0 - rays.Origin[a][i]) * rays.Inverse[a][i];
      const double toLast = (last - rays.Origin[a][i]) * rays.Inverse[a][i];
      rays.Begin[i] = std::max(rays.Begin[i], std::min(toFirst, toLast));
      rays.End[i] = std::min(rays.End[i], std::max(toFirst, toLast));
    }
  }
}

}

void SetUpRays(const View& view, const Placement& placement, const glm::ivec3& dimensions,
  const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays)
{
  const RaySetUp setUp(view, placement);
  for (int row = 0; row < size.y; ++row)
  {
    setUp.SetRow(view, first.x, first.y + row, size.x, row * size.x, rays);
  }
  rays.Count = size.x * size.y;
  ClipToBox(dimensions, rays);
  rays.WalkBegin = rays.Begin;
  rays.WalkEnd = rays.End;
}

}
