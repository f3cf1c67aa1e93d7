// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsBeam.h"

#include <algorithm>
#include <cmath>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsBeamSetUp.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsHull-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using DoubleVector = hn::Vec<Doubles>;

/// Extremes over the rays of a beam.
struct Extremes
{
  double First;    ///< t at which the first ray begins to walk
  double Farthest; ///< largest coordinate of an origin
};

HWY_INLINE void StoreFloats(DoubleVector value, float* to)
{
  const hn::Rebind<float, Doubles> df;
  hn::StoreU(hn::DemoteTo(df, value), df, to);
}

HWY_INLINE hn::Mask<Doubles> DoublesOf(std::uint64_t which, std::size_t first)
{
  const std::uint8_t bits[8] = { static_cast<std::uint8_t>(which >> first) };
  return hn::LoadMaskBits(Doubles(), bits);
}

HWY_INLINE Extremes FindExtremes(const RayBatch& rays, std::uint64_t which, std::size_t count)
{
  const Doubles d;
  DoubleVector first = hn::Set(d, std::numeric_limits<double>::infinity());
  DoubleVector farthest = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    const auto isRay = DoublesOf(which, i);
    const DoubleVector none = hn::Set(d, std::numeric_limits<double>::infinity());
    first = hn::Min(first, hn::IfThenElse(isRay, hn::LoadU(d, &rays.WalkBegin[i]), none));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const DoubleVector origin = hn::IfThenElseZero(isRay, hn::LoadU(d, &rays.Origin[a][i]));
      farthest = hn::Max(farthest, hn::Abs(origin));
    }
  }
  return { hn::GetLane(hn::MinOfLanes(d, first)), hn::GetLane(hn::MaxOfLanes(d, farthest)) };
}

/// Convert rays to the beam's units. Lanes without a ray copy ray `of`.
/// \tparam AreAll every lane has a ray
template <bool AreAll>
HWY_INLINE void ConvertRays(
  const RayBatch& rays, std::uint64_t which, std::size_t of, TileBeam& beam)
{
  const Doubles d;
  const DoubleVector first = hn::Set(d, beam.First), scale = hn::Set(d, beam.Scale);
  const DoubleVector perScale = hn::Set(d, 1.0 / beam.Scale);
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(d))
  {
    const auto load = [&](const RayBatch::Array<double>& from) HWY_ATTR
    {
      const DoubleVector values = hn::LoadU(d, &from[i]);
      return AreAll ? values : hn::IfThenElse(DoublesOf(which, i), values, hn::Set(d, from[of]));
    };
    for (std::size_t a = 0; a < 3; ++a)
    {
      const DoubleVector direction = load(rays.Direction[a]);
      const DoubleVector anchor = hn::Set(d, beam.Anchor[static_cast<int>(a)]);
      const DoubleVector origin =
        hn::Add(hn::Sub(load(rays.Origin[a]), anchor), hn::Mul(first, direction));
      StoreFloats(origin, &beam.Origin[a][i]);
      StoreFloats(hn::Mul(direction, perScale), &beam.Direction[a][i]);
      StoreFloats(hn::Mul(load(rays.Inverse[a]), scale), &beam.Inverse[a][i]);
    }
    const auto convert = [&](const RayBatch::Array<double>& from, TileBeam::Array<float>& to)
                           HWY_ATTR
    { StoreFloats(hn::Mul(hn::Sub(load(from), first), scale), &to[i]); };
    convert(rays.Begin, beam.Begin);
    convert(rays.End, beam.End);
    convert(rays.WalkBegin, beam.WalkBegin);
    convert(rays.WalkEnd, beam.Behind);
  }
}

/// Depths of the rays, and the margin.
/// \return false if the rays are too different, or the margin is too large
HWY_INLINE bool SetUpDepths(double farthest, const glm::ivec3& cells, TileBeam& beam)
{
  const Floats d;
  V largest = hn::Zero(d), longest = hn::Zero(d), least = hn::Set(d, 1.0f);
  V steepest[3] = { hn::Zero(d), hn::Zero(d), hn::Zero(d) };
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(d))
  {
    V at = hn::Zero(d), per = hn::Zero(d);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V origin = hn::LoadU(d, &beam.Origin[a][i]);
      const V direction = hn::LoadU(d, &beam.Direction[a][i]);
      const V forward = hn::Set(d, beam.Forward[static_cast<int>(a)]);
      at = hn::Add(at, hn::Mul(origin, forward));
      per = hn::Add(per, hn::Mul(direction, forward));
      largest = hn::Max(largest, hn::Abs(origin));
      steepest[a] = hn::Max(steepest[a], hn::Abs(direction));
    }
    longest = hn::Max(longest, hn::Abs(hn::LoadU(d, &beam.End[i])));
    least = hn::Min(least, per);
    hn::StoreU(at, d, &beam.AtDepth[i]);
    hn::StoreU(per, d, &beam.PerDepth[i]);
  }
  float reach = 0.0f;
  beam.Steepest = 0.0f;
  for (int a = 0; a < 3; ++a)
  {
    reach =
      std::max(reach, static_cast<float>(std::max(beam.Anchor[a], cells[a] - beam.Anchor[a])));
    beam.Steepest += hn::GetLane(hn::MaxOfLanes(d, steepest[a]));
  }
  reach += hn::GetLane(hn::MaxOfLanes(d, largest));
  reach = std::max(reach, hn::GetLane(hn::MaxOfLanes(d, longest)));
  // `reach` bounds all numbers of a beam. Each number takes fewer than eight operations with
  // rounding errors of at most 2^-24 of `reach`. The second term covers cancellation in the
  // origins, which are computed in double.
  beam.Margin = reach * 0x1p-21f + static_cast<float>(farthest * 0x1p-46);
  constexpr float most = 0x1p-5f;
  return beam.Margin < most && hn::GetLane(hn::MinOfLanes(d, least)) > 0.25f &&
    beam.Steepest < 6.0f;
}

/// Widen the rays by the margin, and clear their hits. Lanes without a ray are done.
HWY_INLINE void ClearRays(std::uint64_t which, TileBeam& beam)
{
  const Floats d;
  const V margin = hn::Set(d, beam.Margin);
  beam.Cell.fill(TileBeam::NoCell);
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(d))
  {
    const M isRay = MaskOf(which >> i);
    hn::StoreU(hn::Sub(hn::LoadU(d, &beam.Begin[i]), margin), d, &beam.Begin[i]);
    hn::StoreU(hn::Sub(hn::LoadU(d, &beam.WalkBegin[i]), margin), d, &beam.WalkBegin[i]);
    hn::StoreU(hn::Add(hn::LoadU(d, &beam.End[i]), margin), d, &beam.End[i]);
    const V end = hn::Add(hn::LoadU(d, &beam.Behind[i]), margin);
    const V behind = hn::IfThenElse(isRay, end, hn::Set(d, -1e30f));
    hn::StoreU(behind, d, &beam.Behind[i]);
  }
  MoveAcross(beam);
  beam.CellsPassed = 0;
}

/// Find whether rays are alike and the beam is plain; set ToOrigin and Slack.
HWY_INLINE void FindPaths(const glm::ivec3& cells, TileBeam& beam)
{
  const Floats d;
  const V twice = hn::Set(d, 2.0f * beam.Margin);
  M isAlike = hn::Eq(twice, twice), beginsBefore = isAlike;
  V steepest = hn::Zero(d);
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(d))
  {
    V largest = hn::Zero(d), enter = hn::Set(d, -TileBeam::Never);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      const bool isBack = beam.Flip >> (2 * axis) & 1;
      const V inverse = hn::LoadU(d, &beam.Inverse[a][i]);
      const V origin = hn::LoadU(d, &beam.Origin[a][i]);
      hn::StoreU(hn::Neg(hn::Mul(origin, inverse)), d, &beam.ToOrigin[a][i]);
      const V ahead = isBack ? hn::Neg(inverse) : inverse;
      const V face = hn::Set(d, static_cast<float>((isBack ? cells[axis] : 0) - beam.Anchor[axis]));
      largest = hn::Max(largest, hn::Abs(inverse));
      isAlike = hn::And(isAlike, hn::Gt(ahead, hn::Zero(d)));
      enter = hn::Max(enter, hn::Mul(hn::Sub(face, origin), inverse));
    }
    beginsBefore = hn::And(beginsBefore, hn::Le(hn::LoadU(d, &beam.Begin[i]), enter));
    const V slack = hn::Mul(twice, largest);
    steepest = hn::Max(steepest, slack);
    hn::StoreU(slack, d, &beam.Slack[i]);
  }
  // A ray nearly parallel to faces has a large Slack and perhaps an infinite Inverse.
  constexpr float little = 0.02f;
  const bool isSteep = !(hn::GetLane(hn::MaxOfLanes(d, steepest)) < little);
  beam.AreAlike = hn::AllTrue(d, isAlike);
  beam.IsPlain = beam.AreAlike && hn::AllTrue(d, beginsBefore) && !isSteep;
}

/// Ray 36, near the tile's middle, or the next wanted ray; else the first wanted ray.
inline std::size_t MiddleOf(std::uint64_t which)
{
  constexpr std::size_t middle = 36;
  const std::uint64_t behind = which >> middle;
  return behind != 0 ? middle + hwy::Num0BitsBelowLS1Bit_Nonzero64(behind)
                     : hwy::Num0BitsBelowLS1Bit_Nonzero64(which);
}

bool SetUp(const RayBatch& rays, std::uint64_t which, const glm::ivec3& cells, TileBeam& beam)
{
  beam.Count = RayBatch::Capacity;
  const Extremes extremes = FindExtremes(rays, which, beam.Count);
  const std::size_t middle = MiddleOf(which);
  glm::dvec3 direction, origin;
  for (int a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<std::size_t>(a);
    direction[a] = rays.Direction[axis][middle];
    origin[a] = rays.Origin[axis][middle];
  }
  beam.First = extremes.First;
  beam.Scale = std::max({ std::abs(direction.x), std::abs(direction.y), std::abs(direction.z) });
  // Cameras and transforms may contain numbers of any size.
  constexpr double smallest = 1e-100;
  if (!(beam.Scale > smallest && beam.Scale < 1.0 / smallest &&
        std::abs(beam.First) < 1.0 / smallest))
  {
    return false;
  }
  const glm::dvec3 from = origin + beam.First * direction;
  beam.Anchor = glm::clamp(from, glm::dvec3(0.0), glm::dvec3(cells));
  beam.Forward = glm::normalize(direction / beam.Scale);
  beam.Flip =
    (direction.x < 0.0 ? 3 : 0) | (direction.y < 0.0 ? 12 : 0) | (direction.z < 0.0 ? 48 : 0);
  (~which == 0 ? ConvertRays<true> : ConvertRays<false>)(rays, which, middle, beam);
  if (!SetUpDepths(extremes.Farthest, cells, beam))
  {
    return false;
  }
  ClearRays(which, beam);
  FindPaths(cells, beam);
  SetUpHull(FindNormals(rays, beam), beam);
  return true;
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(SetUp);
}

bool SetUpBeam(const RayBatch& rays, std::uint64_t which, const glm::ivec3& cells, TileBeam& beam)
{
  using namespace BeamKernels;
  return HWY_DYNAMIC_DISPATCH(SetUp)(rays, which, cells, beam);
}

}
#endif
