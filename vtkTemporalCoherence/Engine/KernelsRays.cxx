// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelsRays.h"

#include <algorithm>
#include <cmath>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine. The
// loops are plain: the compiler turns them into vectors.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "KernelsRays.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

/// A direction component smaller than this share of the largest one is replaced by it, with its
/// sign, so that its inverse is finite. Over the 1e4 cells of a large volume the ray then strays by
/// 1e-11 cells.
constexpr double SmallestShare = 1e-15;

/// Normalised device coordinates of the pixels, row by row, and their places in the frame.
inline void SetPixels(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size,
  double* x, double* y, RayBatch& rays)
{
  for (int row = 0; row < size.y; ++row)
  {
    const double atRow = (2.0 * (first.y + row) + 1.0) / source.Size.y - 1.0;
    for (int column = 0; column < size.x; ++column)
    {
      const auto i = static_cast<std::size_t>(row * size.x + column);
      x[i] = (2.0 * (first.x + column) + 1.0) / source.Size.x - 1.0;
      y[i] = atRow;
      rays.Pixel[i] = (first.y + row) * source.Size.x + first.x + column;
    }
  }
}

inline void Interpolate(const RaySource::LinearVector& vector, int axis, std::size_t count,
  const double* x, const double* y, double* out)
{
  const double centre = vector[0][axis], perX = vector[1][axis], perY = vector[2][axis];
  for (std::size_t i = 0; i < count; ++i)
  {
    out[i] = centre + x[i] * perX + y[i] * perY;
  }
}

inline void SetDirections(const double* length, std::size_t count, RayBatch& rays)
{
  double *const dx = rays.Direction[0].data(), *const dy = rays.Direction[1].data(),
                *const dz = rays.Direction[2].data();
  RayBatch::Array<double> smallest;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double perLength = 1.0 / length[i];
    dx[i] *= perLength;
    dy[i] *= perLength;
    dz[i] *= perLength;
    smallest[i] =
      SmallestShare * std::max(std::abs(dx[i]), std::max(std::abs(dy[i]), std::abs(dz[i])));
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    double* const direction = rays.Direction[a].data();
    double* const inverse = rays.Inverse[a].data();
    for (std::size_t i = 0; i < count; ++i)
    {
      const double least = std::copysign(smallest[i], direction[i]);
      direction[i] = std::abs(direction[i]) < smallest[i] ? least : direction[i];
      inverse[i] = 1.0 / direction[i];
    }
  }
}

/// Clip rays to the box; the planes are the faces of its first and last cells.
inline void ClipToBox(const glm::dvec3& corner, std::size_t count, RayBatch& rays)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double last = corner[static_cast<int>(a)];
    const double* const origin = rays.Origin[a].data();
    const double* const inverse = rays.Inverse[a].data();
    for (std::size_t i = 0; i < count; ++i)
    {
      const double toFirst = (0.0 - origin[i]) * inverse[i];
      const double toLast = (last - origin[i]) * inverse[i];
      rays.Begin[i] = std::max(rays.Begin[i], std::min(toFirst, toLast));
      rays.End[i] = std::min(rays.End[i], std::max(toFirst, toLast));
    }
  }
}

void SetUp(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays)
{
  const auto count = static_cast<std::size_t>(size.x * size.y);
  rays.Count = static_cast<int>(count);
  RayBatch::Array<double> x, y, wx, wy, wz, length;
  SetPixels(source, first, size, x.data(), y.data(), rays);
  Interpolate(source.World, 0, count, x.data(), y.data(), wx.data());
  Interpolate(source.World, 1, count, x.data(), y.data(), wy.data());
  Interpolate(source.World, 2, count, x.data(), y.data(), wz.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    Interpolate(source.Origin, axis, count, x.data(), y.data(), rays.Origin[a].data());
    Interpolate(source.Direction, axis, count, x.data(), y.data(), rays.Direction[a].data());
  }
  const double forward = source.Forward.x, forwardX = source.Forward.y, forwardY = source.Forward.z;
  for (std::size_t i = 0; i < count; ++i)
  {
    length[i] = std::sqrt(wx[i] * wx[i] + wy[i] * wy[i] + wz[i] * wz[i]);
    rays.PerDepth[i] = length[i] / (forward + x[i] * forwardX + y[i] * forwardY);
    rays.Begin[i] = source.Near * rays.PerDepth[i];
    rays.End[i] = source.Far * rays.PerDepth[i];
  }
  SetDirections(length.data(), count, rays);
  ClipToBox(source.Last, count, rays);
  rays.WalkBegin = rays.Begin;
  rays.WalkEnd = rays.End;
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(SetUp);

void SetUpRays(
  const RaySource& source, const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays)
{
  HWY_DYNAMIC_DISPATCH(SetUp)(source, first, size, rays);
}

}
#endif
