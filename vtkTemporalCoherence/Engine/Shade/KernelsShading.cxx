// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KernelsShading.h"

#include "Scene/LayerBatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Shade/KernelsShading.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsPower-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ShadingKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The squares of shorter vectors may underflow.
constexpr double TooShortToSquare = 1e-140;

/// Gradients between these lengths are not scaled: after multiplication by a matrix of numbers of
/// about 1, they can be squared.
constexpr double ShortEnough = 1e-100, LongEnough = 1e100;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using Floats = hn::CappedTag<float, WidestVector>;
using HalfOfFloats = hn::Rebind<float, Doubles>;
using Raiser = Powers::HWY_NAMESPACE::Raiser;

template <class V>
HWY_INLINE V Dot(V ax, V ay, V az, V bx, V by, V bz)
{
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

/// One bit for each lane.
HWY_INLINE std::uint64_t BitsOf(hn::Mask<Floats> mask)
{
  std::array<std::uint8_t, 8> bits{};
  hn::StoreMaskBits(Floats(), mask, bits.data());
  return static_cast<std::uint64_t>(bits[0]) | static_cast<std::uint64_t>(bits[1]) << 8;
}

/// Doubles as a vector of floats.
HWY_INLINE hn::Vec<Floats> LoadAsFloats(const double* from)
{
  const Doubles d;
  const HalfOfFloats df;
#if HWY_TARGET == HWY_SCALAR
  return hn::DemoteTo(df, hn::LoadU(d, from));
#else
  const auto low = hn::DemoteTo(df, hn::LoadU(d, from));
  return hn::Combine(Floats(), hn::DemoteTo(df, hn::LoadU(d, from + hn::Lanes(d))), low);
#endif
}

void RaysOf(const View& view, const Array<double>& x, const Array<double>& y, HitRays& rays)
{
  const Doubles d;
  using V = hn::Vec<Doubles>;
  const V one = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < WholeVectors(rays.Count); i += hn::Lanes(d))
  {
    const V atX = hn::LoadU(d, &x[i]), atY = hn::LoadU(d, &y[i]);
    const auto at = [&](int axis, const glm::dvec3& centre, const glm::dvec3& perX,
                      const glm::dvec3& perY) HWY_ATTR
    {
      const V inX = hn::Add(hn::Set(d, centre[axis]), hn::Mul(atX, hn::Set(d, perX[axis])));
      return hn::Add(inX, hn::Mul(atY, hn::Set(d, perY[axis])));
    };
    V along[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      along[axis] = at(axis, view.Direction, view.DirectionX, view.DirectionY);
    }
    const V square = Dot(along[0], along[1], along[2], along[0], along[1], along[2]);
    const V perLength = hn::Div(one, hn::Sqrt(square));
    for (std::size_t a = 0; a < 3; ++a)
    {
      hn::StoreU(hn::Mul(along[a], perLength), d, &rays.Own[a][i]);
      if (view.Parallel)
      {
        const auto axis = static_cast<int>(a);
        hn::StoreU(at(axis, view.Origin, view.OriginX, view.OriginY), d, &rays.Begin[a][i]);
      }
    }
  }
}

/// One bit for each finite distance.
std::uint64_t FiniteOf(const Array<double>& distances)
{
  const Doubles d;
  const auto infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  std::uint64_t finite = 0;
  for (std::size_t i = 0; i < distances.size(); i += hn::Lanes(d))
  {
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(d, hn::Lt(hn::LoadU(d, &distances[i]), infinity), bits.data());
    finite |= static_cast<std::uint64_t>(bits[0]) << i;
  }
  return finite;
}

std::uint64_t TakeFiniteOf(const Array<double>& distances, Array<double>& finite)
{
  const Doubles d;
  const std::uint64_t which = FiniteOf(distances);
  if (which == 0)
  {
    return 0;
  }
  const auto infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  const auto first = hn::Set(d, distances[hwy::Num0BitsBelowLS1Bit_Nonzero64(which)]);
  for (std::size_t i = 0; i < distances.size(); i += hn::Lanes(d))
  {
    const auto distance = hn::LoadU(d, &distances[i]);
    hn::StoreU(hn::IfThenElse(hn::Lt(distance, infinity), distance, first), d, &finite[i]);
  }
  return which;
}

void FacingNormalsOf(const HitRays& rays, const glm::dmat3& m, const HitRays::Vectors& gradients,
  Array<std::array<float, 3>>& normals)
{
  const Doubles d;
  const HalfOfFloats df;
  const HitRays::Vectors& directions = *rays.Direction;
  using V = hn::Vec<Doubles>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const V smallest = hn::Set(d, std::numeric_limits<double>::min());
  for (std::size_t i = 0; i < rays.Count; i += hn::Lanes(d))
  {
    const V gx = hn::LoadU(d, &gradients[0][i]), gy = hn::LoadU(d, &gradients[1][i]),
            gz = hn::LoadU(d, &gradients[2][i]);
    const V rx = hn::LoadU(d, &directions[0][i]), ry = hn::LoadU(d, &directions[1][i]),
            rz = hn::LoadU(d, &directions[2][i]);
    // Scale very small or large components first: their squares would underflow or overflow.
    const V largest = hn::Max(hn::Abs(gx), hn::Max(hn::Abs(gy), hn::Abs(gz)));
    const auto hasGradient = hn::Ge(largest, smallest);
    const auto isFar = hn::And(hasGradient,
      hn::Or(hn::Lt(largest, hn::Set(d, ShortEnough)), hn::Gt(largest, hn::Set(d, LongEnough))));
    V scale = one;
    if (!hn::AllFalse(d, isFar))
    {
      scale = hn::Div(one, hn::IfThenElse(isFar, largest, one));
    }
    const V x = hn::Mul(gx, scale), y = hn::Mul(gy, scale), z = hn::Mul(gz, scale);
    const auto inWorld = [&](int axis) HWY_ATTR {
      return Dot(hn::Set(d, m[0][axis]), hn::Set(d, m[1][axis]), hn::Set(d, m[2][axis]), x, y, z);
    };
    const V nx = inWorld(0), ny = inWorld(1), nz = inWorld(2);
    // Scale once more, but only where necessary: the others keep all of their digits.
    const V longest = hn::Max(hn::Abs(nx), hn::Max(hn::Abs(ny), hn::Abs(nz)));
    const auto hasNormal = hn::And(hasGradient, hn::Ge(longest, smallest));
    const auto isFarFromOne = hn::And(hasNormal, hn::Lt(longest, hn::Set(d, TooShortToSquare)));
    V closer = one;
    if (!hn::AllFalse(d, isFarFromOne))
    {
      closer = hn::Div(one, hn::IfThenElse(isFarFromOne, longest, one));
    }
    const V wx = hn::IfThenElse(hasNormal, hn::Mul(nx, closer), rx);
    const V wy = hn::IfThenElse(hasNormal, hn::Mul(ny, closer), ry);
    const V wz = hn::IfThenElse(hasNormal, hn::Mul(nz, closer), rz);
    const V perLength = hn::Div(one, hn::Sqrt(Dot(wx, wy, wz, wx, wy, wz)));
    const auto isAway = hn::Gt(Dot(wx, wy, wz, rx, ry, rz), zero);
    const V facing = hn::IfThenElse(isAway, hn::Neg(perLength), perLength);
    hn::StoreInterleaved3(hn::DemoteTo(df, hn::Mul(facing, wx)),
      hn::DemoteTo(df, hn::Mul(facing, wy)), hn::DemoteTo(df, hn::Mul(facing, wz)), df,
      normals[i].data());
  }
}

/// Shares of a directional light that a surface reflects: diffuse and specular.
struct Reflection
{
  hn::Vec<Floats> Cosine, Shine;
};

/// \param n, light, ray unit vectors: the normal, to the light, and to the surface
HWY_INLINE Reflection Reflect(const hn::Vec<Floats> n[3], const hn::Vec<Floats> light[3],
  const hn::Vec<Floats> ray[3], bool isShiny, const Raiser& raise)
{
  const Floats d;
  using V = hn::Vec<Floats>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  const V c = Dot(n[0], n[1], n[2], light[0], light[1], light[2]);
  const auto isLit = hn::Gt(c, zero);
  Reflection reflection{ hn::IfThenElseZero(isLit, c), zero };
  if (isShiny)
  {
    const V twice = hn::Mul(two, c);
    const V m =
      Dot(hn::Sub(light[0], hn::Mul(twice, n[0])), hn::Sub(light[1], hn::Mul(twice, n[1])),
        hn::Sub(light[2], hn::Mul(twice, n[2])), ray[0], ray[1], ray[2]);
    const auto isMirrored = hn::And(isLit, hn::Gt(m, zero));
    reflection.Shine = raise(hn::Min(hn::IfThenElseZero(isMirrored, m), one));
  }
  return reflection;
}

HWY_INLINE bool IsShiny(const std::array<float, 3>& specular)
{
  return specular[0] != 0.0f || specular[1] != 0.0f || specular[2] != 0.0f;
}

/// NaN becomes 0.
HWY_INLINE hn::Vec<Floats> ClampToOne(hn::Vec<Floats> value)
{
  const Floats d;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto raised = hn::IfThenElse(hn::Gt(value, zero), value, zero);
  return hn::IfThenElse(hn::Lt(raised, one), raised, one);
}

HWY_INLINE hn::Vec<hn::Rebind<std::uint8_t, Floats>> BytesOf(hn::Vec<Floats> sum)
{
  const Floats d;
  const hn::Rebind<std::int32_t, Floats> di;
  const hn::Rebind<std::uint8_t, Floats> db;
  const auto scaled = hn::Add(hn::Mul(ClampToOne(sum), hn::Set(d, 255.0f)), hn::Set(d, 0.5f));
  return hn::DemoteTo(db, hn::ConvertTo(di, scaled));
}

void AddLightTo(const HitRays& rays, PhongSums& sums)
{
  const Floats d;
  using V = hn::Vec<Floats>;
  const Raiser raise(sums.Power);
  const bool isShiny = IsShiny(sums.Specular);
  for (std::size_t i = 0; i < sums.Count; i += hn::Lanes(d))
  {
    V n[3], light[3], ray[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      light[a] = sums.IsPositional ? hn::LoadU(d, &sums.ToLight[a][i]) : hn::Set(d, sums.Toward[a]);
      ray[a] = isShiny ? LoadAsFloats(&(*rays.Direction)[a][i]) : hn::Zero(d);
    }
    hn::LoadInterleaved3(d, sums.Normal[i].data(), n[0], n[1], n[2]);
    const V share = sums.HasShares ? hn::LoadU(d, &sums.Share[i]) : hn::Set(d, 1.0f);
    const Reflection reflection = Reflect(n, light, ray, isShiny, raise);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V diffuse = hn::Mul(
        hn::Mul(hn::Set(d, sums.Diffuse[a]), reflection.Cosine), hn::LoadU(d, &sums.Color[a][i]));
      const V sum = hn::Add(diffuse, hn::Mul(hn::Set(d, sums.Specular[a]), reflection.Shine));
      hn::StoreU(hn::Add(hn::LoadU(d, &sums.Sum[a][i]), hn::Mul(share, sum)), d, &sums.Sum[a][i]);
    }
  }
}

void ColorsOf(const PhongSums& sums, Array<std::array<std::uint8_t, 4>>& colors)
{
  const Floats d;
  const hn::Rebind<std::uint8_t, Floats> db;
  for (std::size_t i = 0; i < sums.Count; i += hn::Lanes(d))
  {
    const auto bytes = [&](std::size_t a) HWY_ATTR
    { return BytesOf(hn::LoadU(d, &sums.Sum[a][i])); };
    hn::StoreInterleaved4(
      bytes(0), bytes(1), bytes(2), hn::Set(db, std::uint8_t(255)), db, colors[i].data());
  }
}

/// The values of LayerColor.
HWY_INLINE hn::Vec<hn::Rebind<std::uint16_t, Floats>> ValuesOf(hn::Vec<Floats> sum)
{
  const Floats d;
  const hn::Rebind<std::int32_t, Floats> di;
  const auto steps = hn::Set(d, static_cast<float>(LayerColor::Steps));
  const auto half = hn::Set(d, static_cast<float>(LayerColor::Half));
  const auto scaled = hn::Add(hn::Mul(ClampToOne(sum), steps), half);
  return hn::DemoteTo(hn::Rebind<std::uint16_t, Floats>(), hn::ConvertTo(di, scaled));
}

void CompositeRoundOf(const LayerRound& round, CompositedPixels& pixels)
{
  const Floats d;
  using V = hn::Vec<Floats>;
  constexpr std::uint64_t lanes = (std::uint64_t(1) << hn::MaxLanes(d)) - 1;
  const V one = hn::Set(d, 1.0f), none = hn::Set(d, NoLight);
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
  {
    if ((round.Which >> i & lanes) == 0)
    {
      continue;
    }
    const V passed = hn::LoadU(d, &pixels.Passed[i]), alpha = hn::LoadU(d, &round.Alpha[i]);
    const V share = hn::Mul(passed, alpha);
    V color[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      const V added = hn::Mul(share, ClampToOne(hn::LoadU(d, &round.Color[c][i])));
      color[c] = hn::Add(hn::LoadU(d, &pixels.Sum[c][i]), added);
      hn::StoreU(color[c], d, &pixels.Sum[c][i]);
    }
    const V behind = hn::Mul(passed, hn::Sub(one, alpha));
    const V passes = hn::IfThenZeroElse(hn::Le(behind, none), behind);
    hn::StoreU(passes, d, &pixels.Passed[i]);
    pixels.Passing &= ~(BitsOf(hn::Eq(passes, hn::Zero(d))) << i);
    hn::StoreInterleaved4(ValuesOf(color[0]), ValuesOf(color[1]), ValuesOf(color[2]),
      ValuesOf(hn::Sub(one, passes)), hn::Rebind<std::uint16_t, Floats>(),
      pixels.Colors[i].Values.data());
  }
}

void SimpleColorsOf(const HitRays& rays, const Array<std::array<float, 3>>& normals,
  const std::array<Array<float>, 3>& own, const SimpleLight& light,
  Array<std::array<std::uint8_t, 4>>& colors)
{
  const Floats d;
  const hn::Rebind<std::uint8_t, Floats> db;
  using V = hn::Vec<Floats>;
  const Raiser raise(light.Power);
  const bool isShiny = IsShiny(light.Specular);
  const V toward[3] = { hn::Set(d, light.Toward[0]), hn::Set(d, light.Toward[1]),
    hn::Set(d, light.Toward[2]) };
  for (std::size_t i = 0; i < rays.Count; i += hn::Lanes(d))
  {
    V n[3], ray[3];
    hn::LoadInterleaved3(d, normals[i].data(), n[0], n[1], n[2]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      ray[a] = isShiny ? LoadAsFloats(&(*rays.Direction)[a][i]) : hn::Zero(d);
    }
    const Reflection reflection = Reflect(n, toward, ray, isShiny, raise);
    const auto bytes = [&](std::size_t a) HWY_ATTR
    {
      const V color = hn::LoadU(d, &own[a][i]);
      const V diffuse = hn::Mul(hn::Mul(hn::Set(d, light.Diffuse[a]), reflection.Cosine), color);
      const V sum = hn::Add(diffuse, hn::Mul(hn::Set(d, light.Specular[a]), reflection.Shine));
      return BytesOf(hn::Add(hn::Mul(hn::Set(d, light.Ambient), color), sum));
    };
    hn::StoreInterleaved4(
      bytes(0), bytes(1), bytes(2), hn::Set(db, std::uint8_t(255)), db, colors[i].data());
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

/// Matrices whose largest number is less than this, and more than its inverse, need not be scaled.
constexpr double AboutOne = 4096.0;

HWY_EXPORT(RaysOf);
HWY_EXPORT(TakeFiniteOf);
HWY_EXPORT(FacingNormalsOf);
HWY_EXPORT(AddLightTo);
HWY_EXPORT(ColorsOf);
HWY_EXPORT(CompositeRoundOf);
HWY_EXPORT(SimpleColorsOf);

void FindRays(const View& view, const Array<double>& x, const Array<double>& y, HitRays& rays)
{
  rays.Eye = view.Origin;
  rays.AreApart = view.Parallel;
  rays.Direction = &rays.Own;
  HWY_DYNAMIC_DISPATCH(RaysOf)(view, x, y, rays);
}

std::uint64_t TakeFinite(const Array<double>& distances, Array<double>& finite)
{
  return HWY_DYNAMIC_DISPATCH(TakeFiniteOf)(distances, finite);
}

void FindFacingNormals(const HitRays& rays, const glm::dmat3& worldFromGradient,
  const HitRays::Vectors& gradients, Array<std::array<float, 3>>& normals)
{
  // Lengths do not matter. Scale the largest number of the matrix to about 1 by a power of two,
  // which changes no digit.
  double largest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    largest = std::max(largest, std::abs(worldFromGradient[i / 3][i % 3]));
  }
  glm::dmat3 matrix = worldFromGradient;
  const bool isAboutOne = largest > 1.0 / AboutOne && largest < AboutOne;
  const int exponent = largest > 0.0 && !isAboutOne ? -std::ilogb(largest) : 0;
  for (int i = 0; i < 9 && exponent != 0; ++i)
  {
    matrix[i / 3][i % 3] = std::ldexp(matrix[i / 3][i % 3], exponent);
  }
  HWY_DYNAMIC_DISPATCH(FacingNormalsOf)(rays, matrix, gradients, normals);
}

void AddLight(const HitRays& rays, PhongSums& sums)
{
  HWY_DYNAMIC_DISPATCH(AddLightTo)(rays, sums);
}

void FindColors(const HitRays& rays, const Array<std::array<float, 3>>& normals,
  const std::array<Array<float>, 3>& own, const SimpleLight& light,
  Array<std::array<std::uint8_t, 4>>& colors)
{
  HWY_DYNAMIC_DISPATCH(SimpleColorsOf)(rays, normals, own, light, colors);
}

void CompositeRound(const LayerRound& round, CompositedPixels& pixels)
{
  HWY_DYNAMIC_DISPATCH(CompositeRoundOf)(round, pixels);
}

void RoundColors(const PhongSums& sums, Array<std::array<std::uint8_t, 4>>& colors)
{
  HWY_DYNAMIC_DISPATCH(ColorsOf)(sums, colors);
}

}
}
#endif
