// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelsShading.h"

#include <algorithm>
#include <cmath>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine. The
// loops are plain: the compiler turns them into vectors.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "KernelsShading.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ShadingKernels
{
namespace HWY_NAMESPACE
{

template <typename Real>
HWY_INLINE Real Mix(Real a, Real b, Real weightOfB)
{
  return (Real(1) - weightOfB) * a + weightOfB * b;
}

/// One component of the gradients: differences along an axis on the four edges of the cell that run
/// along it, interpolated along the axis and then across it.
template <std::size_t Axis, typename Real>
HWY_INLINE void InterpolateAlong(GradientBatch<Real>& batch)
{
  constexpr std::size_t Step = std::size_t(1) << Axis; // from a corner to the next along the axis
  constexpr std::size_t U = Axis == 0 ? 1 : 0;
  constexpr std::size_t V = Axis == 2 ? 1 : 2;
  constexpr std::size_t StepU = std::size_t(1) << U;
  constexpr std::size_t StepV = std::size_t(1) << V;
  const Real* const at = batch.At[Axis].data();
  const Real* const atU = batch.At[U].data();
  const Real* const atV = batch.At[V].data();
  const Real* const scaleFirst = batch.ScaleFirst[Axis].data();
  const Real* const scaleSecond = batch.ScaleSecond[Axis].data();
  double* const out = batch.Gradient[Axis].data();
  const auto& corner = batch.Corner;
  const auto& before = batch.Before[Axis];
  const auto& behind = batch.Behind[Axis];
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    const auto onEdge = [&](std::size_t edge, std::size_t first)
    {
      const Real atFirst = scaleFirst[i] * (corner[first + Step][i] - before[edge][i]);
      const Real atSecond = scaleSecond[i] * (behind[edge][i] - corner[first][i]);
      return Mix(atFirst, atSecond, at[i]);
    };
    const Real low = Mix(onEdge(0, 0), onEdge(1, StepU), atU[i]);
    const Real high = Mix(onEdge(2, StepV), onEdge(3, StepU + StepV), atU[i]);
    out[i] = static_cast<double>(Mix(low, high, atV[i]));
  }
}

void GradientsFloat(GradientBatch<float>& batch)
{
  InterpolateAlong<0>(batch);
  InterpolateAlong<1>(batch);
  InterpolateAlong<2>(batch);
}

void GradientsDouble(GradientBatch<double>& batch)
{
  InterpolateAlong<0>(batch);
  InterpolateAlong<1>(batch);
  InterpolateAlong<2>(batch);
}

void RayPointsOf(RayPoints& points)
{
  const std::size_t count = points.Count;
  const double *const x = points.X.data(), *const y = points.Y.data(), *const t = points.T.data();
  Array<double> square;
  std::fill_n(square.begin(), count, 0.0);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<int>(a);
    const double centre = points.LinearDirection[0][axis];
    const double perX = points.LinearDirection[1][axis], perY = points.LinearDirection[2][axis];
    double* const direction = points.Direction[a].data();
    for (std::size_t i = 0; i < count; ++i)
    {
      direction[i] = centre + x[i] * perX + y[i] * perY;
      square[i] += direction[i] * direction[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    square[i] = 1.0 / std::sqrt(square[i]);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<int>(a);
    const double centre = points.LinearOrigin[0][axis];
    const double perX = points.LinearOrigin[1][axis], perY = points.LinearOrigin[2][axis];
    double* const direction = points.Direction[a].data();
    double* const point = points.Point[a].data();
    for (std::size_t i = 0; i < count; ++i)
    {
      direction[i] *= square[i];
      point[i] = centre + x[i] * perX + y[i] * perY + t[i] * direction[i];
    }
  }
}

void FacingNormalsOf(FacingNormals& normals)
{
  const glm::dmat3& m = normals.WorldFromGradient;
  const double m00 = m[0][0], m10 = m[1][0], m20 = m[2][0];
  const double m01 = m[0][1], m11 = m[1][1], m21 = m[2][1];
  const double m02 = m[0][2], m12 = m[1][2], m22 = m[2][2];
  const double* const gx = normals.Gradient[0].data();
  const double* const gy = normals.Gradient[1].data();
  const double* const gz = normals.Gradient[2].data();
  const double* const rx = normals.Ray[0].data();
  const double* const ry = normals.Ray[1].data();
  const double* const rz = normals.Ray[2].data();
  float* const nx = normals.Normal[0].data();
  float* const ny = normals.Normal[1].data();
  float* const nz = normals.Normal[2].data();
  for (std::size_t i = 0; i < normals.Count; ++i)
  {
    // Scaled first: squares of very small or large components would leave the range of numbers.
    const double largest = std::max(std::abs(gx[i]), std::max(std::abs(gy[i]), std::abs(gz[i])));
    const bool isFlat = !(largest >= std::numeric_limits<double>::min());
    const double scale = 1.0 / (isFlat ? 1.0 : largest);
    const double x = gx[i] * scale, y = gy[i] * scale, z = gz[i] * scale;
    const double wx = isFlat ? rx[i] : m00 * x + m10 * y + m20 * z;
    const double wy = isFlat ? ry[i] : m01 * x + m11 * y + m21 * z;
    const double wz = isFlat ? rz[i] : m02 * x + m12 * y + m22 * z;
    const double along = wx * rx[i] + wy * ry[i] + wz * rz[i];
    const double perLength = 1.0 / std::sqrt(wx * wx + wy * wy + wz * wz);
    const double facing = along > 0.0 ? -perLength : perLength;
    nx[i] = static_cast<float>(facing * wx);
    ny[i] = static_cast<float>(facing * wy);
    nz[i] = static_cast<float>(facing * wz);
  }
}

/// Raise numbers in [0, 1] to a power; what is 0 stays 0.
HWY_INLINE void Raise(double power, std::size_t count, float* values)
{
  constexpr double LargestWhole = 1024.0;
  if (power != std::floor(power) || power < 1.0 || power > LargestWhole)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = values[i] > 0.0f ? std::pow(values[i], static_cast<float>(power)) : 0.0f;
    }
    return;
  }
  Array<float> result;
  std::fill_n(result.begin(), count, 1.0f);
  for (int whole = static_cast<int>(power); whole > 0; whole >>= 1)
  {
    const bool isOdd = (whole & 1) != 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      result[i] *= isOdd ? values[i] : 1.0f;
      values[i] *= values[i];
    }
  }
  std::copy_n(result.begin(), count, values);
}

void AddLightTo(PhongSums& sums)
{
  const std::size_t count = sums.Count;
  const float *const nx = sums.Normal[0].data(), *const ny = sums.Normal[1].data(),
                     *const nz = sums.Normal[2].data();
  const float *const lx = sums.ToLight[0].data(), *const ly = sums.ToLight[1].data(),
                     *const lz = sums.ToLight[2].data();
  const float *const rx = sums.Ray[0].data(), *const ry = sums.Ray[1].data(),
                     *const rz = sums.Ray[2].data();
  const float* const share = sums.Share.data();
  Array<float> cosine, mirrored;
  for (std::size_t i = 0; i < count; ++i)
  {
    const float c = nx[i] * lx[i] + ny[i] * ly[i] + nz[i] * lz[i];
    const float m = (lx[i] - 2.0f * c * nx[i]) * rx[i] + (ly[i] - 2.0f * c * ny[i]) * ry[i] +
      (lz[i] - 2.0f * c * nz[i]) * rz[i];
    cosine[i] = c > 0.0f ? c : 0.0f;
    const float shining = m > 0.0f ? m : 0.0f;
    mirrored[i] = c > 0.0f ? (shining < 1.0f ? shining : 1.0f) : 0.0f;
  }
  Raise(sums.Power, count, mirrored.data());
  for (std::size_t c = 0; c < 3; ++c)
  {
    const float diffuse = sums.Diffuse[c], specular = sums.Specular[c];
    const float* const color = sums.Color[c].data();
    float* const sum = sums.Sum[c].data();
    for (std::size_t i = 0; i < count; ++i)
    {
      sum[i] += share[i] * (diffuse * cosine[i] * color[i] + specular * mirrored[i]);
    }
  }
}

void BytesOf(const PhongSums& sums, std::array<Array<std::uint8_t>, 3>& bytes)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    const float* const sum = sums.Sum[c].data();
    std::uint8_t* const out = bytes[c].data();
    for (std::size_t i = 0; i < sums.Count; ++i)
    {
      const float raised = sum[i] > 0.0f ? sum[i] : 0.0f;
      const float clamped = raised < 1.0f ? raised : 1.0f;
      out[i] = static_cast<std::uint8_t>(static_cast<int>(clamped * 255.0f + 0.5f));
    }
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace ShadingKernels
{

HWY_EXPORT(GradientsFloat);
HWY_EXPORT(GradientsDouble);
HWY_EXPORT(RayPointsOf);
HWY_EXPORT(FacingNormalsOf);
HWY_EXPORT(AddLightTo);
HWY_EXPORT(BytesOf);

void InterpolateGradients(GradientBatch<float>& batch)
{
  HWY_DYNAMIC_DISPATCH(GradientsFloat)(batch);
}

void InterpolateGradients(GradientBatch<double>& batch)
{
  HWY_DYNAMIC_DISPATCH(GradientsDouble)(batch);
}

void FindRayPoints(RayPoints& points)
{
  HWY_DYNAMIC_DISPATCH(RayPointsOf)(points);
}

void FindFacingNormals(FacingNormals& normals)
{
  HWY_DYNAMIC_DISPATCH(FacingNormalsOf)(normals);
}

void AddLight(PhongSums& sums)
{
  HWY_DYNAMIC_DISPATCH(AddLightTo)(sums);
}

void RoundColors(const PhongSums& sums, std::array<Array<std::uint8_t>, 3>& bytes)
{
  HWY_DYNAMIC_DISPATCH(BytesOf)(sums, bytes);
}

}
}
#endif
