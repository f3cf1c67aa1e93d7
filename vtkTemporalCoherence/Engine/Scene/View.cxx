// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/View.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}

bool MakeView(const glm::dmat4& viewFromWorld, const glm::dmat4& clipFromView,
  const glm::dvec2& range, const glm::ivec2& size, View& view)
{
  view = View();
  view.Size = size;
  view.ClipFromWorld = clipFromView * viewFromWorld;
  const glm::dvec3 backward(RowOf(viewFromWorld, 2));
  if (!IsFinite(backward) || !(glm::length(backward) > 0.0))
  {
    return false;
  }
  view.Forward = -glm::normalize(backward);

  // A point p is seen at (x, y) where it lies on two planes: (X - x W) p = 0 and (Y - y W) p = 0,
  // X, Y, W being rows of the matrix. The ray is where they meet. Its direction is the cross
  // product of their normals, (X - x W) x (Y - y W) = X x Y - x W x Y - y X x W, linear in x and y.
  const glm::dvec4 rowX = RowOf(view.ClipFromWorld, 0);
  const glm::dvec4 rowY = RowOf(view.ClipFromWorld, 1);
  const glm::dvec4 rowW = RowOf(view.ClipFromWorld, 3);
  const glm::dvec3 X(rowX), Y(rowY), W(rowW);
  // Rays meet in an eye if the divisor of the projection changes from point to point.
  view.Parallel = W == glm::dvec3(0.0);
  // Camera coordinates may be scaled; a perspective has nothing behind the eye.
  const glm::dvec2 distances = range / glm::length(backward);
  view.Near = view.Parallel ? distances.x : std::max(distances.x, 0.0);
  view.Far = distances.y;
  view.Direction = glm::cross(X, Y);
  view.DirectionX = -glm::cross(W, Y);
  view.DirectionY = -glm::cross(X, W);

  // The rays run forward.
  const double along = glm::dot(view.Direction, view.Forward);
  if (!(std::abs(along) > 0.0) || !IsFinite(view.Direction))
  {
    return false;
  }
  view.Direction /= along;
  view.DirectionX /= along;
  view.DirectionY /= along;

  // Where rays begin: three planes meet in a point. For a perspective these are X = Y = W = 0, for
  // a parallel view X = x W, Y = y W (W being constant) and the plane through the camera.
  const glm::dvec3 third = view.Parallel ? backward : W;
  const double volume = glm::dot(X, glm::cross(Y, third));
  if (!(std::abs(volume) > 0.0))
  {
    return false;
  }
  const glm::dvec3 perX = glm::cross(Y, third) / volume;
  const glm::dvec3 perY = glm::cross(third, X) / volume;
  const glm::dvec3 perThird = glm::cross(X, Y) / volume;
  const double thirdOffset = view.Parallel ? viewFromWorld[3][2] : rowW.w;
  view.Origin = -(rowX.w * perX + rowY.w * perY + thirdOffset * perThird);
  view.Position = view.Origin;
  if (view.Parallel)
  {
    view.OriginX = rowW.w * perX;
    view.OriginY = rowW.w * perY;
    view.DirectionX = view.DirectionY = glm::dvec3(0.0);
  }
  return IsFinite(view.Origin) && IsFinite(view.OriginX) && IsFinite(view.OriginY) &&
    IsFinite(view.DirectionX) && IsFinite(view.DirectionY) && std::isfinite(view.Near) &&
    std::isfinite(view.Far) && view.Near < view.Far;
}

bool operator==(const View& a, const View& b)
{
  return a.Size == b.Size && a.Parallel == b.Parallel && a.ClipFromWorld == b.ClipFromWorld &&
    a.Position == b.Position && a.Near == b.Near && a.Far == b.Far;
}

}
