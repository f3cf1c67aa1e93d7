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

#include "Lattice/KernelsPower-inl.h"
#include "Scene/RayBatch.h"
#include "Volumes/Medium/KernelsVectors-inl.h"
#include "Volumes/Medium/VolumeLights.h"

#include <glm/glm.hpp>
#include <hwy/highway.h>

#include <algorithm>
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

/// Normalize vectors. Vectors that are tiny, huge or NaN become 0.
template <class V>
HWY_INLINE void MakeUnit(V vector[3])
{
  const hn::DFromV<V> d;
  const V square = Dot(vector, vector);
  // False for vectors that are tiny, huge or NaN.
  const auto isLong =
    hn::And(hn::Gt(square, hn::Set(d, 1e-30f)), hn::Lt(square, hn::Set(d, 1e30f)));
  const V perLength = InverseRoot(square);
  for (int a = 0; a < 3; ++a)
  {
    vector[a] = hn::IfThenElseZero(isLong, hn::Mul(vector[a], perLength));
  }
}

/// Transform gradients to world vectors towards lower values.
template <class V>
HWY_INLINE void Transform(const glm::mat3& worldFromGradient, const V gradient[3], V made[3])
{
  const hn::DFromV<V> d;
  for (int a = 0; a < 3; ++a)
  {
    const V row[3] = { hn::Set(d, -worldFromGradient[0][a]), hn::Set(d, -worldFromGradient[1][a]),
      hn::Set(d, -worldFromGradient[2][a]) };
    made[a] = Dot(row, gradient);
  }
}

/// Make normals of gradients: unit vectors in the world towards lower values, or 0.
template <class V>
HWY_INLINE void FindNormals(const glm::mat3& worldFromGradient, const V gradient[3], V normal[3])
{
  Transform(worldFromGradient, gradient, normal);
  MakeUnit(normal);
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

/// Reflected light of points: Matt scales their own colour, Shine is added to it.
/// \tparam Colors 1 where all lights are white, else 3
template <class V, std::size_t Colors>
struct ReflectedLight
{
  /// Show the own colour alone.
  HWY_INLINE void SetUnlit()
  {
    const hn::DFromV<V> d;
    std::fill_n(this->Matt, Colors, hn::Set(d, 1.0f));
    std::fill_n(this->Shine, Colors, hn::Zero(d));
  }

  V Matt[Colors], Shine[Colors];
};

/// Two points on a path, by Gauss and Legendre: quadrature is exact for cubics.
struct PlacePair
{
  /// Shares of the path, and the distance of both points from the middle.
  static constexpr float First = 0.21132487f, Second = 0.78867513f, FromMiddle = 0.28867513f;
  /// Distance from a point to the end next to it, in distances between the points.
  static constexpr float ToEnd = 0.36602540f;
};

/// 1 - a cosine between vectors that InverseRoot has normalized; 0 within its rounding error.
template <class V>
HWY_INLINE V OneMinus(V cosine)
{
  const hn::DFromV<V> d;
  return hn::Max(hn::Sub(hn::Set(d, 1.0f - 1e-5f), cosine), hn::Zero(d));
}

/// The cosine of the angle between normals; 1 if both are 0.
template <class V>
HWY_INLINE V CosineBetween(const V a[3], const V b[3])
{
  const hn::DFromV<V> d;
  const auto areNone = hn::Eq(hn::Max(Dot(a, a), Dot(b, b)), hn::Zero(d));
  return hn::IfThenElse(areNone, hn::Set(d, 1.0f), Dot(a, b));
}

/// Turn of normals between the places of a pair: 1 - the cosine of the angle. To count turns near
/// the ends, it is at least a third of the turn from end to end, the ratio for an even turn.
/// \param cosine, ofEnds of the angles between the places, and between the ends
template <class V>
HWY_INLINE V TurnOf(V cosine, V ofEnds)
{
  const hn::DFromV<V> d;
  return hn::Max(OneMinus(cosine), hn::Mul(hn::Set(d, 1.0f / 3.0f), OneMinus(ofEnds)));
}

/// The cosine of the angle between the vectors at the ends of a path on which they change linearly;
/// 0 if a vector has no direction, 1 if both are 0.
/// \param a, b vectors at the places of a pair
template <class V>
HWY_INLINE V CosineOfEnds(const V a[3], const V b[3])
{
  const hn::DFromV<V> d;
  V begin[3], end[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const V beyond = hn::Mul(hn::Set(d, PlacePair::ToEnd), hn::Sub(b[axis], a[axis]));
    begin[axis] = hn::Sub(a[axis], beyond);
    end[axis] = hn::Add(b[axis], beyond);
  }
  const V atBegin = Dot(begin, begin), atEnd = Dot(end, end), squares = hn::Mul(atBegin, atEnd);
  const auto areNone = hn::Eq(hn::Max(atBegin, atEnd), hn::Zero(d));
  const auto isLong =
    hn::And(hn::Gt(squares, hn::Set(d, 1e-30f)), hn::Lt(squares, hn::Set(d, 1e30f)));
  const V cosine = hn::IfThenElseZero(isLong, hn::Mul(Dot(begin, end), InverseRoot(squares)));
  return hn::IfThenElse(areNone, hn::Set(d, 1.0f), cosine);
}

/// Find the diffuse factor of a light at both places of a pair, by the cosines there. If the normal
/// turns away from the light on the path, both places get the mean of the path.
/// \return change of light between the places that this mean hides
template <class V>
HWY_INLINE V FindLit(bool isTwoSided, const V cosine[2], V lit[2])
{
  const hn::DFromV<V> d;
  const V zero = hn::Zero(d), rise = hn::Sub(cosine[1], cosine[0]);
  const V beyond = hn::Mul(rise, hn::Set(d, PlacePair::ToEnd));
  const V begin = hn::Sub(cosine[0], beyond), end = hn::Add(cosine[1], beyond);
  const V above = hn::Max(begin, end), below = hn::Min(begin, end);
  // Leave out normals that turn round abruptly.
  const auto isSlow = hn::Lt(hn::Abs(rise), hn::Set(d, 0.9f));
  const auto isEdge = hn::And(isSlow, hn::And(hn::Gt(above, zero), hn::Lt(below, zero)));
  for (int place = 0; place < 2; ++place)
  {
    lit[place] = isTwoSided ? hn::Abs(cosine[place]) : hn::Max(cosine[place], zero);
  }
  if (hn::AllFalse(d, isEdge))
  {
    return zero;
  }
  const V squareAbove = hn::Mul(above, above);
  const V square = isTwoSided ? hn::Add(squareAbove, hn::Mul(below, below)) : squareAbove;
  const V width = hn::Max(hn::Sub(above, below), hn::Set(d, 1e-20f));
  const V mean = hn::Div(hn::Mul(hn::Set(d, 0.5f), square), width);
  for (int place = 0; place < 2; ++place)
  {
    lit[place] = hn::IfThenElse(isEdge, mean, lit[place]);
  }
  return hn::IfThenElseZero(isEdge, hn::Abs(rise));
}

/// The specular factor of a light.
/// \param rise dot product of normal and ray direction
template <class V>
HWY_INLINE V HighlightOf(const VolumeLights& lights, const LitPoints& at, const V toward[3],
  V cosine, V rise, const Powers::HWY_NAMESPACE::Raiser& raise)
{
  const hn::DFromV<V> d;
  const V zero = hn::Zero(d);
  // The cosine of the angle between mirrored light and the way to the viewer.
  const V mirrored = hn::Sub(Dot(toward, at.Direction), hn::Mul(hn::Add(cosine, cosine), rise));
  const auto isLit = lights.AreTwoSided ? hn::Ne(cosine, zero) : hn::Gt(cosine, zero);
  const auto isMirrored = hn::And(isLit, hn::Gt(mirrored, zero));
  return raise(hn::Min(hn::IfThenElseZero(isMirrored, mirrored), hn::Set(d, 1.0f)));
}

/// Four times the change of light between the places of a pair with one clamped place; else 0.
template <std::size_t Colors, class V>
HWY_INLINE V ClampedIn(const ReflectedLight<V, Colors> light[2])
{
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1.0f);
  V most = hn::Zero(d);
  for (std::size_t a = 0; a < Colors; ++a)
  {
    const V first = hn::Add(light[0].Matt[a], light[0].Shine[a]);
    const V second = hn::Add(light[1].Matt[a], light[1].Shine[a]);
    const auto isEdge =
      hn::And(hn::Gt(hn::Max(first, second), one), hn::Lt(hn::Min(first, second), one));
    const V change = hn::Mul(hn::Set(d, 4.0f), hn::Abs(hn::Sub(first, second)));
    most = hn::Max(most, hn::IfThenElseZero(isEdge, change));
  }
  return most;
}

/// A light that arrives at points.
template <class V>
struct ArrivingLight
{
  HWY_INLINE ArrivingLight(const VolumeLight& light, const LitPoints& at)
  {
    const hn::DFromV<V> d;
    for (int a = 0; a < 3; ++a)
    {
      this->Toward[a] = hn::Set(d, light.Toward[a]);
    }
    this->Share = light.IsPositional ? ShareAt(light, at.Point, this->Toward) : hn::Set(d, 1.0f);
    this->Cosine = Dot(at.Normal, this->Toward);
  }

  /// The diffuse factor, without Share.
  HWY_INLINE V Lit(bool isTwoSided) const
  {
    return isTwoSided ? hn::Abs(this->Cosine) : hn::Max(this->Cosine, hn::Zero(hn::DFromV<V>()));
  }

  V Toward[3]; ///< of unit length
  V Share;     ///< of the light that arrives
  V Cosine;    ///< of the angle with the normal
};

template <std::size_t Colors, class V>
HWY_INLINE ReflectedLight<V, Colors> AmbientLight(const VolumeLights& lights)
{
  const hn::DFromV<V> d;
  ReflectedLight<V, Colors> sum;
  for (std::size_t a = 0; a < Colors; ++a)
  {
    sum.Matt[a] = hn::Set(d, lights.Ambient);
    sum.Shine[a] = hn::Set(d, lights.Glow[static_cast<int>(a)]);
  }
  return sum;
}

/// Sums up the reflected light of points, one light after the other.
template <std::size_t Colors, class V>
class LightSum
{
public:
  HWY_INLINE explicit LightSum(const VolumeLights& lights)
    : Lights(lights)
    , Raise(lights.SpecularPower)
  {
  }

  /// \param lit the diffuse factor, without the share of the light that arrives
  HWY_INLINE void Add(const VolumeLight& light, const ArrivingLight<V>& arriving,
    const LitPoints& at, V lit, ReflectedLight<V, Colors>& sum) const
  {
    const hn::DFromV<V> d;
    const V diffuse = hn::Mul(arriving.Share, lit);
    V highlight = hn::Zero(d);
    if (this->Lights.AreShiny)
    {
      const V rise = Dot(at.Normal, at.Direction);
      highlight = hn::Mul(arriving.Share,
        HighlightOf(this->Lights, at, arriving.Toward, arriving.Cosine, rise, this->Raise));
    }
    for (std::size_t a = 0; a < Colors; ++a)
    {
      const int channel = static_cast<int>(a);
      sum.Matt[a] = hn::Add(sum.Matt[a], hn::Mul(diffuse, hn::Set(d, light.Diffuse[channel])));
      sum.Shine[a] = hn::Add(sum.Shine[a], hn::Mul(highlight, hn::Set(d, light.Specular[channel])));
    }
  }

private:
  const VolumeLights& Lights;
  Powers::HWY_NAMESPACE::Raiser Raise;
};

/// The reflected light of points.
template <std::size_t Colors, class V>
HWY_INLINE ReflectedLight<V, Colors> Reflect(const VolumeLights& lights, const LitPoints& at)
{
  const LightSum<Colors, V> add(lights);
  auto sum = AmbientLight<Colors, V>(lights);
  for (const VolumeLight& light : lights.All)
  {
    const ArrivingLight<V> arriving(light, at);
    add.Add(light, arriving, at, arriving.Lit(lights.AreTwoSided), sum);
  }
  return sum;
}

/// Change of a spot light between the places of a pair across the sharp rim of its cone.
template <class V>
HWY_INLINE V ChangeAtRim(const VolumeLight& light, V first, V second)
{
  const hn::DFromV<V> d;
  const V zero = hn::Zero(d), larger = hn::Max(first, second);
  const auto isRim = hn::And(hn::Gt(larger, zero), hn::Eq(hn::Min(first, second), zero));
  return light.IsSpot ? hn::IfThenElseZero(isRim, larger) : zero;
}

/// The reflected light at both places of a pair.
/// \return change of light between the places across kinks: normals that turn away, clamping, or
///   the rim of a cone
template <std::size_t Colors, class V>
HWY_INLINE V ReflectBoth(
  const VolumeLights& lights, const LitPoints at[2], ReflectedLight<V, Colors> sum[2])
{
  const hn::DFromV<V> d;
  const LightSum<Colors, V> add(lights);
  sum[0] = sum[1] = AmbientLight<Colors, V>(lights);
  V hidden = hn::Zero(d);
  for (const VolumeLight& light : lights.All)
  {
    const ArrivingLight<V> arriving[2] = { { light, at[0] }, { light, at[1] } };
    const V cosine[2] = { arriving[0].Cosine, arriving[1].Cosine };
    V lit[2];
    V change = FindLit(lights.AreTwoSided, cosine, lit);
    change = hn::Add(change, ChangeAtRim(light, arriving[0].Share, arriving[1].Share));
    const float most = std::max({ light.Diffuse.x, light.Diffuse.y, light.Diffuse.z });
    hidden = hn::Add(hidden, hn::Mul(change, hn::Set(d, most)));
    for (std::size_t place = 0; place < 2; ++place)
    {
      add.Add(light, arriving[place], at[place], lit[place], sum[place]);
    }
  }
  return hn::Max(hidden, ClampedIn<Colors, V>(sum));
}

/// Light along a vector of segments: linear, through the places of a pair.
template <std::size_t Colors>
struct LightLine
{
  using Light = ReflectedLight<V, Colors>;

  HWY_INLINE void SetUnlit()
  {
    this->At[0].SetUnlit();
    this->At[1].SetUnlit();
  }

  HWY_INLINE Light Of(V share) const
  {
    const Floats d;
    constexpr float perShare = 0.5f / PlacePair::FromMiddle;
    const V of = hn::Mul(hn::Sub(share, hn::Set(d, PlacePair::First)), hn::Set(d, perShare));
    const auto between = [&](V first, V second) HWY_ATTR
    { return hn::Add(first, hn::Mul(of, hn::Sub(second, first))); };
    Light light;
    for (std::size_t a = 0; a < Colors; ++a)
    {
      light.Matt[a] = between(this->At[0].Matt[a], this->At[1].Matt[a]);
      light.Shine[a] = between(this->At[0].Shine[a], this->At[1].Shine[a]);
    }
    return light;
  }

  /// The largest change between both places.
  HWY_INLINE V Slope() const
  {
    V most = hn::Zero(Floats());
    for (std::size_t a = 0; a < Colors; ++a)
    {
      const V matt = hn::Abs(hn::Sub(this->At[1].Matt[a], this->At[0].Matt[a]));
      const V shine = hn::Abs(hn::Sub(this->At[1].Shine[a], this->At[0].Shine[a]));
      most = hn::Max(most, hn::Max(matt, shine));
    }
    return most;
  }

  /// Call visit for each number of a segment.
  template <class Visitor>
  HWY_INLINE void EachColumn(const Visitor& visit)
  {
    for (Light& light : this->At)
    {
      for (std::size_t a = 0; a < Colors; ++a)
      {
        visit(light.Matt[a]);
        visit(light.Shine[a]);
      }
    }
  }
  static constexpr std::size_t Columns = 2 * 2 * Colors;

  Light At[2];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
