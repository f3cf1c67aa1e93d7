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

void SetDirection(const glm::dvec3& direction, std::size_t i, RayBatch& rays)
{
  const glm::dvec3 size = glm::abs(direction);
  const double smallest = SmallestShare * std::max(size.x, std::max(size.y, size.z));
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const double component =
      size[axis] < smallest ? std::copysign(smallest, direction[axis]) : direction[axis];
    rays.Direction[a][i] = component;
    rays.Inverse[a][i] = 1.0 / component;
  }
}

/// Clip ray i to the box [0, dimensions - 1]; the planes are the faces of its first and last cells.
void ClipToBox(const glm::ivec3& dimensions, std::size_t i, RayBatch& rays)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double last = dimensions[static_cast<int>(a)] - 1;
    const bool forward = rays.Direction[a][i] > 0.0;
    const double origin = rays.Origin[a][i];
    const double inverse = rays.Inverse[a][i];
    const double enter = ((forward ? 0.0 : last) - origin) * inverse;
    const double leave = ((forward ? last : 0.0) - origin) * inverse;
    rays.Begin[i] = std::max(rays.Begin[i], enter);
    rays.End[i] = std::min(rays.End[i], leave);
  }
}

}

void SetUpRays(const View& view, const Placement& placement, const glm::ivec3& dimensions,
  const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays)
{
  const glm::dmat4& toIndex = placement.IndexFromWorld;
  const glm::dmat3 toIndexDirection(toIndex);
  std::size_t i = 0;
  for (int y = first.y; y < first.y + size.y; ++y)
  {
    for (int x = first.x; x < first.x + size.x; ++x, ++i)
    {
      const Ray ray = view.RayThrough(x, y);
      const glm::dvec3 origin(toIndex * glm::dvec4(ray.Origin, 1.0));
      for (std::size_t a = 0; a < 3; ++a)
      {
        rays.Origin[a][i] = origin[static_cast<int>(a)];
      }
      SetDirection(toIndexDirection * ray.Direction, i, rays);

      const double perDepth = 1.0 / glm::dot(ray.Direction, view.Forward);
      rays.Begin[i] = view.Near * perDepth;
      rays.End[i] = view.Far * perDepth;
      ClipToBox(dimensions, i, rays);
      rays.WalkBegin[i] = rays.Begin[i];
      rays.WalkEnd[i] = rays.End[i];
      rays.Pixel[i] = y * view.Size.x + x;
    }
  }
  rays.Count = static_cast<int>(i);
}

}
