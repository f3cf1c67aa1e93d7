// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Light that falls on points of a volume, in vectors. Kernels include this file once for each kind
// of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLight_inl_h
#undef TemporalCoherence_KernelsLight_inl_h
#else
#define TemporalCoherence_KernelsLight_inl_h
#endif

#include "Scene/Appearance.h"
#include "Scene/Blending.h"
#include "Scene/RayBatch.h"
#include "Shade/KernelsPower-inl.h"

#include <glm/glm.hpp>
#include <hwy/highway.h>

#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A vector of lit points.
struct LitPoints
{
  using V = hn::Vec<hn::CappedTag<float, WidestVector>>;
  const V* Normal;    ///< of unit length, towards lower values; or 0
  const V* Direction; ///< of the ray, of unit length
  const V* Point;     ///< in the world
};

template <class V>
HWY_INLINE V Dot(const V a[3], const V b[3])
{
  return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}

/// Make normals of gradients: unit vectors in the world towards lower values, or 0.
template <class V>
HWY_INLINE void FindNormals(const glm::mat3& worldFromGradient, const V gradient[3], V normal[3])
{
  const hn::DFromV<V> d;
  for (int a = 0; a < 3; ++a)
  {
    const V row[3] = { hn::Set(d, -worldFromGradient[0][a]), hn::Set(d, -worldFromGradient[1][a]),
      hn::Set(d, -worldFromGradient[2][a]) };
    normal[a] = Dot(row, gradient);
  }
  const V square = Dot(normal, normal);
  // So short that it tells no direction, too long, or no number.
  const auto isNormal =
    hn::And(hn::Gt(square, hn::Set(d, 1e-30f)), hn::Lt(square, hn::Set(d, 1e30f)));
  const V perLength = hn::IfThenElseZero(isNormal,
    hn::Div(hn::Set(d, 1.0f), hn::Sqrt(hn::IfThenElse(isNormal, square, hn::Set(d, 1.0f)))));
  for (int a = 0; a < 3; ++a)
  {
    normal[a] = hn::IfThenElseZero(isNormal, hn::Mul(normal[a], perLength));
  }
}

/// The share of a positional light that arrives at points, and unit vectors towards it.
template <class V>
HWY_INLINE V ShareAt(const Light& light, const V point[3], V toward[3])
{
  const hn::DFromV<V> d;
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<float>(value)); };
  for (int a = 0; a < 3; ++a)
  {
    toward[a] = hn::Sub(set(light.Position[a]), point[a]);
  }
  const V square = Dot(toward, toward);
  const auto isAway = hn::Gt(square, hn::Zero(d));
  const V distance = hn::Sqrt(square);
  const V perLength = hn::Div(set(1.0), hn::IfThenElse(isAway, distance, set(1.0)));
  for (int a = 0; a < 3; ++a)
  {
    toward[a] = hn::Mul(toward[a], perLength);
  }
  const V fall = hn::Add(set(light.Attenuation.x),
    hn::Mul(
      distance, hn::Add(set(light.Attenuation.y), hn::Mul(distance, set(light.Attenuation.z)))));
  const auto fades = hn::And(isAway, hn::Gt(fall, hn::Zero(d)));
  V share = hn::IfThenElseZero(isAway, hn::Div(set(1.0), hn::IfThenElse(fades, fall, set(1.0))));
  if (light.ConeAngle < 90.0)
  {
    constexpr double pi = 3.14159265358979323846;
    const V axis[3] = { set(-light.Direction.x), set(-light.Direction.y), set(-light.Direction.z) };
    const V cosine = Dot(axis, toward);
    const auto isInside = hn::Ge(cosine, set(std::cos(light.ConeAngle * pi / 180.0)));
    const Powers::HWY_NAMESPACE::Raiser raise(light.Exponent);
    const V spot = raise(hn::Min(hn::Max(cosine, hn::Zero(d)), set(1.0)));
    share = hn::IfThenElseZero(isInside, hn::Mul(share, spot));
  }
  return share;
}

/// Light colours, which lie in [0, 1] afterwards.
template <class V>
HWY_INLINE void LightColors(
  const Appearance& appearance, const Material& material, const LitPoints& at, V color[3])
{
  const hn::DFromV<V> d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<float>(value)); };
  const Powers::HWY_NAMESPACE::Raiser raise(material.SpecularPower);
  V matt[3], shine[3];
  for (int a = 0; a < 3; ++a)
  {
    matt[a] = set(material.Ambient);
    shine[a] = zero;
  }
  const V rise = Dot(at.Normal, at.Direction);
  for (const Light& light : appearance.Lights)
  {
    V toward[3] = { set(-light.Direction.x), set(-light.Direction.y), set(-light.Direction.z) };
    const V share = light.Positional ? ShareAt(light, at.Point, toward) : one;
    const V cosine = Dot(at.Normal, toward);
    const V lit = appearance.TwoSided ? hn::Abs(cosine) : hn::Max(cosine, zero);
    const V diffuse = hn::Mul(hn::Mul(share, lit), set(material.Diffuse));
    // The light that the surface mirrors, along the way back to the viewer.
    const V mirrored = hn::Sub(Dot(toward, at.Direction), hn::Mul(hn::Add(cosine, cosine), rise));
    const auto isMirrored = hn::And(hn::Gt(lit, zero), hn::Gt(mirrored, zero));
    const V highlight = material.Specular == 0.0
      ? zero
      : hn::Mul(hn::Mul(share, raise(hn::Min(hn::IfThenElseZero(isMirrored, mirrored), one))),
          set(material.Specular));
    for (int a = 0; a < 3; ++a)
    {
      matt[a] = hn::Add(matt[a], hn::Mul(diffuse, set(light.Diffuse[a])));
      shine[a] = hn::Add(shine[a], hn::Mul(highlight, set(light.Specular[a])));
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    const V lit = hn::Add(hn::Mul(color[a], matt[a]), shine[a]);
    color[a] = hn::Min(hn::Max(lit, zero), one);
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
