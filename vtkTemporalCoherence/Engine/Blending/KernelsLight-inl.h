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

#include "Blending/KernelsVectors-inl.h"
#include "Blending/VolumeLights.h"
#include "Scene/RayBatch.h"
#include "Shade/KernelsPower-inl.h"

#include <glm/glm.hpp>
#include <hwy/highway.h>

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

/// 1 / sqrt(x) to 5 digits, for lengths that are neither tiny nor huge: faster than both
/// operations.
template <class V>
HWY_INLINE V InverseRoot(V x)
{
  const hn::DFromV<V> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const V half = hn::Mul(hn::Set(d, 0.5f), x);
  // Half the exponent and a first guess of the digits; then two steps of Newton.
  const auto bits = hn::Sub(hn::Set(di, 0x5F375A86), hn::ShiftRight<1>(hn::BitCast(di, x)));
  V root = hn::BitCast(d, bits);
  for (int step = 0; step < 2; ++step)
  {
    root = hn::Mul(root, hn::Sub(hn::Set(d, 1.5f), hn::Mul(hn::Mul(half, root), root)));
  }
  return root;
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
  const V perLength = InverseRoot(square);
  for (int a = 0; a < 3; ++a)
  {
    normal[a] = hn::IfThenElseZero(isNormal, hn::Mul(normal[a], perLength));
  }
}

/// The share of a positional light that arrives at points, and unit vectors towards it.
template <class V>
HWY_INLINE V ShareAt(const VolumeLight& light, const V point[3], V toward[3])
{
  const hn::DFromV<V> d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  for (int a = 0; a < 3; ++a)
  {
    toward[a] = hn::Sub(hn::Set(d, light.Position[a]), point[a]);
  }
  const V square = Dot(toward, toward);
  const auto isAway = hn::Gt(square, zero);
  const V distance = hn::Sqrt(square);
  const V perLength = hn::Div(one, hn::IfThenElse(isAway, distance, one));
  for (int a = 0; a < 3; ++a)
  {
    toward[a] = hn::Mul(toward[a], perLength);
  }
  const V linear =
    hn::Add(hn::Set(d, light.Attenuation.y), hn::Mul(distance, hn::Set(d, light.Attenuation.z)));
  const V fall = hn::Add(hn::Set(d, light.Attenuation.x), hn::Mul(distance, linear));
  const auto fades = hn::And(isAway, hn::Gt(fall, zero));
  V share = hn::IfThenElseZero(isAway, hn::Div(one, hn::IfThenElse(fades, fall, one)));
  if (light.IsSpot)
  {
    const V axis[3] = { hn::Set(d, light.Toward.x), hn::Set(d, light.Toward.y),
      hn::Set(d, light.Toward.z) };
    const V cosine = Dot(axis, toward);
    const auto isInside = hn::Ge(cosine, hn::Set(d, light.CosineOfCone));
    const Powers::HWY_NAMESPACE::Raiser raise(light.Exponent);
    const V spot = raise(hn::Min(hn::Max(cosine, zero), one));
    share = hn::IfThenElseZero(isInside, hn::Mul(share, spot));
  }
  return share;
}

/// What points reflect of the lights: shares of their own colour, and what is added to any colour.
/// \tparam Colors 1 where all lights are white, else 3
template <class V, std::size_t Colors>
struct ReflectedLight
{
  V Matt[Colors], Shine[Colors];
};

template <std::size_t Colors, class V>
HWY_INLINE ReflectedLight<V, Colors> Reflect(const VolumeLights& lights, const LitPoints& at)
{
  const hn::DFromV<V> d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const Powers::HWY_NAMESPACE::Raiser raise(lights.SpecularPower);
  ReflectedLight<V, Colors> sum;
  for (std::size_t a = 0; a < Colors; ++a)
  {
    sum.Matt[a] = hn::Set(d, lights.Ambient);
    sum.Shine[a] = hn::Set(d, lights.Glow[static_cast<int>(a)]);
  }
  const V rise = Dot(at.Normal, at.Direction);
  for (const VolumeLight& light : lights.All)
  {
    V toward[3] = { hn::Set(d, light.Toward.x), hn::Set(d, light.Toward.y),
      hn::Set(d, light.Toward.z) };
    const V share = light.IsPositional ? ShareAt(light, at.Point, toward) : one;
    const V cosine = Dot(at.Normal, toward);
    const V lit = lights.AreTwoSided ? hn::Abs(cosine) : hn::Max(cosine, zero);
    const V diffuse = hn::Mul(share, lit);
    V highlight = zero;
    if (lights.AreShiny)
    {
      // The light that the surface mirrors, along the way back to the viewer.
      const V mirrored = hn::Sub(Dot(toward, at.Direction), hn::Mul(hn::Add(cosine, cosine), rise));
      const auto isMirrored = hn::And(hn::Gt(lit, zero), hn::Gt(mirrored, zero));
      highlight = hn::Mul(share, raise(hn::Min(hn::IfThenElseZero(isMirrored, mirrored), one)));
    }
    for (std::size_t a = 0; a < Colors; ++a)
    {
      const int channel = static_cast<int>(a);
      sum.Matt[a] = hn::Add(sum.Matt[a], hn::Mul(diffuse, hn::Set(d, light.Diffuse[channel])));
      sum.Shine[a] = hn::Add(sum.Shine[a], hn::Mul(highlight, hn::Set(d, light.Specular[channel])));
    }
  }
  return sum;
}

/// Light along a vector of segments, as parabolas through three places.
template <std::size_t Colors>
class LightParabola
{
public:
  using Light = ReflectedLight<V, Colors>;

  HWY_INLINE LightParabola(const Light& begin, const Light& middle, const Light& end)
    : First(begin)
  {
    this->Off = hn::Zero(Floats());
    for (std::size_t a = 0; a < Colors; ++a)
    {
      this->Fit(
        begin.Matt[a], middle.Matt[a], end.Matt[a], this->Slope.Matt[a], this->Bend.Matt[a]);
      this->Fit(
        begin.Shine[a], middle.Shine[a], end.Shine[a], this->Slope.Shine[a], this->Bend.Shine[a]);
    }
  }

  /// The mean light around a place.
  /// \param spread the mean square of the distance from it
  HWY_INLINE Light At(V share, V spread) const
  {
    const V square = hn::Add(hn::Mul(share, share), spread);
    const auto at = [&](V first, V slope, V bend) HWY_ATTR
    { return hn::Add(first, hn::Add(hn::Mul(share, slope), hn::Mul(square, bend))); };
    Light light;
    for (std::size_t a = 0; a < Colors; ++a)
    {
      light.Matt[a] = at(this->First.Matt[a], this->Slope.Matt[a], this->Bend.Matt[a]);
      light.Shine[a] = at(this->First.Shine[a], this->Slope.Shine[a], this->Bend.Shine[a]);
    }
    return light;
  }

  /// How far light is off a straight line. Where it only seems straight, its slope counts a little.
  V Off;

private:
  HWY_INLINE void Fit(V begin, V middle, V end, V& slope, V& bend)
  {
    const Floats d;
    const V rise = hn::Sub(end, begin), up = hn::Sub(middle, begin);
    bend = hn::Sub(hn::Add(rise, rise), hn::Mul(hn::Set(d, 4.0f), up));
    slope = hn::Sub(rise, bend);
    const V off =
      hn::Add(hn::Mul(hn::Set(d, 0.5f), hn::Abs(bend)), hn::Mul(hn::Set(d, 0.05f), hn::Abs(rise)));
    this->Off = hn::Max(this->Off, off);
  }

  Light First, Slope, Bend;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
