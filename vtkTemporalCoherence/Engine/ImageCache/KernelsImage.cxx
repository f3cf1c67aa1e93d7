// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/KernelsImage.h"

#include <algorithm>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time. The loops are plain: the compiler vectorises them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ImageCache/KernelsImage.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

/// Value of an affine function at both ends of the walks.
inline void AtEnds(const glm::dvec4& row, const RayBatch& rays, double* begin, double* end)
{
  const double x = row.x, y = row.y, z = row.z, w = row.w;
  const double *const ox = rays.Origin[0].data(), *const oy = rays.Origin[1].data(),
                      *const oz = rays.Origin[2].data();
  const double *const dx = rays.Direction[0].data(), *const dy = rays.Direction[1].data(),
                      *const dz = rays.Direction[2].data();
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const double origin = x * ox[i] + y * oy[i] + z * oz[i] + w;
    const double per = x * dx[i] + y * dy[i] + z * dz[i];
    begin[i] = origin + rays.WalkBegin[i] * per;
    end[i] = origin + rays.WalkEnd[i] * per;
  }
}

void Project(const ImageProjection& image, const RayBatch& rays, PathBatch& paths)
{
  const auto count = static_cast<std::size_t>(rays.Count);
  RayBatch::Array<double> z0, z1, u0, u1, v0, v1, isClipped;
  AtEnds(image.RowZ, rays, z0.data(), z1.data());
  AtEnds(image.RowU, rays, u0.data(), u1.data());
  AtEnds(image.RowV, rays, v0.data(), v1.data());

  // Clip at the clipping planes.
  const double near = image.Near, far = image.Far;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double last = std::min(std::max(z1[i], near), far);
    const double length = z1[i] - z0[i];
    const double share = (last - z0[i]) / (length != 0.0 ? length : 1.0);
    const bool clips = last != z1[i];
    const double kept = clips ? share : 1.0;
    paths.T0[i] = rays.WalkBegin[i];
    paths.T1[i] =
      clips ? rays.WalkBegin[i] + kept * (rays.WalkEnd[i] - rays.WalkBegin[i]) : rays.WalkEnd[i];
    u1[i] = clips ? u0[i] + kept * (u1[i] - u0[i]) : u1[i];
    v1[i] = clips ? v0[i] + kept * (v1[i] - v0[i]) : v1[i];
    z1[i] = last;
    isClipped[i] = clips ? 1.0 : 0.0;
  }

  const bool isParallel = image.IsParallel;
  const double width = image.Size.x, height = image.Size.y;
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isSeen = z0[i] >= near && z0[i] <= far && (isParallel || z0[i] > 0.0);
    const double depth0 = isSeen ? z0[i] : 1.0;
    const double depth1 = isParallel || z1[i] > 0.0 ? z1[i] : 1.0;
    const double scale0 = isParallel ? 1.0 : 1.0 / depth0;
    const double scale1 = isParallel ? 1.0 : 1.0 / depth1;
    paths.Q0[i] = isParallel ? -depth0 : scale0;
    paths.Q1[i] = isParallel ? -depth1 : scale1;
    const double u = u0[i] * scale0, v = v0[i] * scale0;
    const double perU = u1[i] * scale1 - u, perV = v1[i] * scale1 - v;
    paths.U[i] = u;
    paths.V[i] = v;
    paths.PerU[i] = perU;
    paths.PerV[i] = perV;

    // Clip at the border of the image.
    const double leaveU = ((perU > 0.0 ? width : 0.0) - u) / (perU != 0.0 ? perU : 1.0);
    const double leaveV = ((perV > 0.0 ? height : 0.0) - v) / (perV != 0.0 ? perV : 1.0);
    const double endU = perU != 0.0 ? std::min(leaveU, 1.0) : 1.0;
    const double endV = perV != 0.0 ? std::min(leaveV, 1.0) : 1.0;
    const double end = std::min(endU, endV);
    const bool isInside = isSeen && u >= 0.0 && u < width && v >= 0.0 && v < height;
    paths.End[i] = end;
    z0[i] = isInside ? (end < 1.0 || isClipped[i] > 0.0 ? 1.0 : 2.0) : 0.0;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    paths.Kind[i] = static_cast<PathKind>(static_cast<int>(z0[i]));
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(Project);

void ProjectWalks(const ImageProjection& image, const RayBatch& rays, PathBatch& paths)
{
  HWY_DYNAMIC_DISPATCH(Project)(image, rays, paths);
}

}
#endif
