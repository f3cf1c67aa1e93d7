// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A survey of a vector of cell segments before their integration: emission at both ends, light in
// between, and the number of steps. Kernels include this file once for each kind of vectors, hence
// the toggling guard.
#if defined(TemporalCoherence_KernelsEmittingSegments_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsEmittingSegments_inl_h
#undef TemporalCoherence_KernelsEmittingSegments_inl_h
#else
#define TemporalCoherence_KernelsEmittingSegments_inl_h
#endif

#include "Volumes/Medium/KernelsCellGradients-inl.h"
#include "Volumes/Medium/KernelsCubic-inl.h"
#include "Volumes/Medium/KernelsEmission.h"
#include "Volumes/Medium/KernelsLight-inl.h"
#include "Volumes/Medium/KernelsStretch-inl.h"
#include "Volumes/Medium/KernelsVectors-inl.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Line = Cubics::HWY_NAMESPACE::Cubic<V>;

/// Optical depth of a step, times the transmittance in front: at first, and at most.
constexpr float DepthOfStep = 0.5f, MostDepthOfStep = 1.0f;

/// Error of the optical depth of a segment, times the transmittance in front, at most.
constexpr float DepthTolerance = 1.0f / 512.0f;

/// Fields may have a turning point if their slope varies by more than this share.
constexpr float MostSpeed = 1.6f;

/// Squared number of steps per change of the gradient opacity over half a segment, weighted by the
/// visible light.
constexpr float StepsOfOpacity = 4096.0f;

/// Squared number of steps per change of light between the two places, weighted by the visible
/// light. The place of emission is known only roughly.
constexpr float StepsOfSlope = 450.0f;

/// Squared number of steps per turn of normals, up to MostTurn. Larger turns limit the length of
/// each step instead.
constexpr float StepsOfTurn = 300.0f, MostTurn = 0.1f;

/// Light is linear where normals turn less than this, weighted by the visible light.
constexpr float LinearTurn = 1.2e-4f;

/// Change of the gradient opacity in a step, weighted by the visible light, at most.
constexpr float MostOpacityChange = 1.0f / 64.0f;

/// Directions and begin points of the rays of segments, or zeros if lighting does not need them.
struct RayVectors
{
  RayVectors() = default;

  /// \param rays one for each lane
  HWY_INLINE RayVectors(const EmittingVolume& volume, const LitRays& all, const std::int32_t* rays)
  {
    std::fill_n(this->Direction, 4, hn::Zero(Floats()));
    std::fill_n(this->Begin, 4, hn::Zero(Floats()));
    if (volume.Lights && volume.Lights->AskForRays())
    {
      const Integers di;
      std::int32_t places[WidestVector];
      hn::StoreU(hn::Mul(hn::LoadU(di, rays), hn::Set(di, LitRays::Row)), di, places);
      LoadRows(all.Rows.data(), places, this->Direction);
      LoadRows(all.Rows.data() + 4, places, this->Begin);
    }
  }

  /// Points of rays at distance t from their begin.
  HWY_INLINE void PointAt(V t, V point[3]) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      point[a] = hn::Add(this->Begin[a], hn::Mul(t, this->Direction[a]));
    }
  }

  V Direction[4], Begin[4]; ///< by axis; [3] is padding
};

/// The largest change of emission from bin to bin, for values within `span` of the middle.
HWY_INLINE V SteepnessOf(const TransferTables& tables, V middle, V span)
{
  const Floats d;
  const std::size_t count = tables.Steepness.size() / TransferTables::Levels;
  const V last = hn::Set(d, static_cast<float>(count - 1));
  const V perBlock = hn::Set(d, 1.0f / (1 << TransferTables::BlockBits));
  const V block = hn::Floor(hn::Min(hn::Max(hn::Mul(middle, perBlock), hn::Zero(d)), last));
  V place = block;
  for (int level = 0; level < TransferTables::Levels - 1; ++level)
  {
    const V reach = hn::Set(d, static_cast<float>(1 << (TransferTables::BlockBits + level)));
    place = hn::Add(
      place, hn::IfThenElseZero(hn::Gt(span, reach), hn::Set(d, static_cast<float>(count))));
  }
  std::int32_t places[WidestVector];
  float found[WidestVector];
  hn::StoreU(hn::ConvertTo(Integers(), place), Integers(), places);
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
  {
    found[lane] = tables.Steepness[static_cast<std::size_t>(places[lane])];
  }
  return hn::LoadU(d, found);
}

/// The length over which normals turn by an angle, or a very large number for normals that never
/// do. It is exact for linear normals.
/// \param normal  of any length
/// \param turning its derivative
/// \param tangent of the angle
HWY_INLINE V LengthOfTurn(const V normal[3], const V turning[3], V tangent)
{
  const Floats d;
  const V square = Dot(normal, normal), along = Dot(normal, turning);
  const V all = hn::Mul(square, Dot(turning, turning));
  const V across = hn::Sqrt(hn::Max(hn::Sub(all, hn::Mul(along, along)), hn::Zero(d)));
  const V rest = hn::Sub(across, hn::Mul(along, tangent));
  const M turns = hn::Gt(rest, hn::Set(d, 1e-30f));
  const V one = hn::Set(d, 1.0f);
  return hn::IfThenElse(
    turns, hn::Div(hn::Mul(square, tangent), hn::IfThenElse(turns, rest, one)), hn::Set(d, 1e30f));
}

/// A vector of cell segments, with all inputs of their light.
/// \tparam Colors channels of light: 1 where all lights are white, else 3
template <std::size_t Colors>
struct EmittingSegments
{
  /// Call visit for each stored number of a segment.
  template <class Visitor>
  HWY_INLINE void EachColumn(const Visitor& visit)
  {
    visit(this->Enter);
    visit(this->Length);
    visit(this->ValueAtEnd);
    visit(this->Turn);
    visit(this->AtBegin.Moment);
    visit(this->AtEnd.Moment);
    visit(this->AtBegin.Boost);
    visit(this->AtEnd.Boost);
    visit(this->AtBegin.Walls);
    visit(this->AtEnd.Walls);
    for (V& need : this->Needs)
    {
      visit(need);
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      visit(this->Values.C[i]);
      for (auto& gradient : this->Gradients.Along)
      {
        visit(gradient.C[i]);
      }
      visit(this->AtBegin.Value[i]);
      visit(this->AtBegin.Sum[i]);
      visit(this->AtEnd.Value[i]);
      visit(this->AtEnd.Sum[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      visit(this->AtBegin.Order[i]);
      visit(this->AtEnd.Order[i]);
    }
    this->Light.EachColumn(visit);
  }
  static constexpr std::size_t Columns = 10 + 4 + 4 * 8 + 3 * 2 + LightLine<Colors>::Columns;

  /// The squared number of steps to begin with.
  /// \param shown transmittance in front of a segment
  HWY_INLINE V SquareOfSteps(V shown) const
  {
    const V steps = hn::Mul(this->Needs[ForDepth], shown);
    const V square = hn::Max(hn::Mul(this->Needs[ForOff], shown), hn::Mul(steps, steps));
    const V more = hn::Add(this->Needs[ForGradient], this->Needs[ForSlope]);
    return hn::Add(square, hn::Mul(more, shown));
  }

  /// True where light is linear.
  HWY_INLINE M IsSmooth(V shown) const
  {
    const Floats d;
    // Highlights may change where normals hardly turn.
    return hn::And(hn::Le(hn::Mul(this->Turn, shown), hn::Set(d, LinearTurn)),
      hn::Le(hn::Mul(this->Needs[ForSlope], shown), hn::Set(d, 1.0f)));
  }

  /// True where a segment needs more than one step.
  HWY_INLINE M IsHard(V shown) const
  {
    return hn::Or(
      hn::Not(this->IsSmooth(shown)), hn::Gt(this->SquareOfSteps(shown), hn::Set(Floats(), 1.0f)));
  }

  V Enter, Length; ///< Enter: t from the ray's Begin; Length: in the world
  Line Values;     ///< in bins
  LineGradients Gradients;
  V ValueAtEnd;
  EmissionAt AtBegin, AtEnd;
  LightLine<Colors> Light;
  V Turn; ///< of normals, times the opacity of the segment
  /// Terms of SquareOfSteps. The error of a straight line falls with the square of the steps.
  enum Need
  {
    ForOff,
    ForDepth,
    ForGradient,
    ForSlope
  };
  V Needs[4];
};

/// The gradient opacity at a share of segments.
HWY_INLINE V OpacityAt(const EmittingVolume& volume, const LineGradients& gradients, V share)
{
  const Floats d;
  if (volume.ByGradient.Opacities.empty())
  {
    return hn::Set(d, 1.0f);
  }
  V gradient[3];
  gradients.At(share, gradient);
  V square = hn::Zero(d);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V scaled = hn::Mul(gradient[a], hn::Set(d, volume.PerStep[static_cast<int>(a)]));
    square = hn::Add(square, hn::Mul(scaled, scaled));
  }
  return OpacityOf(volume.ByGradient, hn::Sqrt(square));
}

/// The light at two shares of segments.
/// \return see ReflectBoth
/// \param normals at these shares, of unit length
template <std::size_t Colors>
HWY_INLINE V LightAt(const EmittingVolume& volume, const RayVectors& rays,
  const EmittingSegments<Colors>& segments, const V shares[2], V normals[2][3],
  ReflectedLight<V, Colors> light[2])
{
  V points[2][3];
  for (std::size_t place = 0; place < 2; ++place)
  {
    V gradient[3];
    segments.Gradients.At(shares[place], gradient);
    FindNormals(volume.WorldFromGradient, gradient, normals[place]);
    rays.PointAt(hn::Add(segments.Enter, hn::Mul(shares[place], segments.Length)), points[place]);
  }
  const LitPoints at[2] = { { normals[0], rays.Direction, points[0] },
    { normals[1], rays.Direction, points[1] } };
  return ReflectBoth<Colors, V>(*volume.Lights, at, light);
}

/// Finds the inputs of the light of cell segments.
class SegmentSurvey
{
public:
  HWY_INLINE SegmentSurvey(
    const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments)
    : Volume(volume)
    , Rays(rays)
    , Segments(segments)
  {
  }

  /// \param corners gradients of the cells, if the volume has any
  template <std::size_t Colors>
  HWY_INLINE void Find(
    std::size_t first, const CornerGradients& corners, EmittingSegments<Colors>& found) const
  {
    const Floats d;
    found.Enter = hn::LoadU(d, &this->Segments.Enter[first]);
    found.Length = hn::LoadU(d, &this->Segments.Length[first]);
    V begin[3], across[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = hn::LoadU(d, &this->Segments.Begin[a][first]);
      across[a] = hn::LoadU(d, &this->Segments.Across[a][first]);
    }
    for (std::size_t power = 0; power < 4; ++power)
    {
      found.Values.C[power] = hn::LoadU(d, &this->Segments.Cubic[power][first]);
    }
    found.Gradients = LineGradients(corners, begin, across);
    LookUp(this->Volume.Tables, found.Values.C[0], found.AtBegin);
    found.ValueAtEnd = found.Values.At(hn::Set(d, 1.0f));
    LookUp(this->Volume.Tables, found.ValueAtEnd, found.AtEnd);
    const V most = this->FindDepths(first, found);
    found.Needs[found.ForGradient] = this->Volume.ByGradient.Opacities.empty()
      ? hn::Zero(d)
      : hn::Mul(most, this->OpacityBend(found.Gradients));
    this->FindLight(first, most, found);
  }

private:
  /// \return upper estimate of the opacity of a segment
  template <std::size_t Colors>
  HWY_INLINE V FindDepths(std::size_t first, EmittingSegments<Colors>& found) const
  {
    const Floats d;
    const TransferTables& tables = this->Volume.Tables;
    V mean[4];
    MeanBetween(
      tables, found.Values.C[0], found.AtBegin, found.ValueAtEnd, found.AtEnd, hn::Zero(d), mean);
    const V span = hn::LoadU(d, &this->Segments.Span[first]);
    const V middle = hn::LoadU(d, &this->Segments.Middle[first]);
    const V depth = hn::Mul(mean[0], found.Length);
    const V steepness = hn::Mul(SteepnessOf(tables, middle, span), found.Length);
    const V bend = hn::LoadU(d, &this->Segments.Bend[first]);
    const V perTolerance = hn::Set(d, 1.0f / DepthTolerance);
    const V rise = hn::Abs(hn::Sub(found.ValueAtEnd, found.Values.C[0]));
    // The speed of values on a straight line differs from the field's by at most this share.
    const V speed = hn::Div(hn::Mul(hn::Set(d, 8.0f), bend), hn::Max(rise, hn::Set(d, 1e-20f)));
    const V ofSpeed = hn::Mul(hn::Mul(depth, speed), perTolerance);
    const V ofSteepness = hn::Mul(hn::Mul(steepness, bend), perTolerance);
    found.Needs[found.ForOff] = hn::IfThenElse(hn::Lt(speed, hn::Set(d, MostSpeed)),
      hn::Min(hn::Mul(ofSpeed, ofSpeed), ofSteepness), ofSteepness);
    found.Needs[found.ForDepth] = hn::Mul(depth, hn::Set(d, 1.0f / DepthOfStep));
    // The field may reach a peak beyond the values of both ends.
    const V reached = hn::Sub(hn::Add(span, span), rise);
    const V most = hn::Add(depth, hn::Mul(steepness, hn::Max(reached, hn::Zero(d))));
    return hn::Min(most, hn::Set(d, 1.0f));
  }

  /// The squared number of steps for gradient opacities.
  HWY_INLINE V OpacityBend(const LineGradients& gradients) const
  {
    const Floats d;
    const auto at = [&](float share) HWY_ATTR
    { return OpacityAt(this->Volume, gradients, hn::Set(d, share)); };
    const V middle = at(0.5f);
    const V first = hn::Sub(middle, at(0.0f)), second = hn::Sub(at(1.0f), middle);
    const V change = hn::Max(hn::Max(hn::Abs(first), hn::Abs(second)), hn::Set(d, 0.01f));
    return hn::Mul(change, hn::Set(d, StepsOfOpacity));
  }

  /// Find the light at a pair of places, and the steps that its change needs.
  template <std::size_t Colors>
  HWY_INLINE void FindLight(std::size_t first, V most, EmittingSegments<Colors>& found) const
  {
    const Floats d;
    if (!this->Volume.Lights)
    {
      found.Light.SetUnlit();
      found.Turn = found.Needs[found.ForSlope] = hn::Zero(d);
      return;
    }
    const RayVectors rays(this->Volume, this->Rays, &this->Segments.Ray[first]);
    const V shares[2] = { hn::Set(d, PlacePair::First), hn::Set(d, PlacePair::Second) };
    V normals[2][3];
    const V hidden = LightAt<Colors>(this->Volume, rays, found, shares, normals, found.Light.At);
    V ends[2][3], atEnds[2][3];
    for (std::size_t end = 0; end < 2; ++end)
    {
      found.Gradients.At(hn::Set(d, static_cast<float>(end)), ends[end]);
      FindNormals(this->Volume.WorldFromGradient, ends[end], atEnds[end]);
    }
    // A turn there and back shows between a place and the end next to it.
    const V beside =
      hn::Min(CosineBetween(atEnds[0], normals[0]), CosineBetween(normals[1], atEnds[1]));
    const V back = hn::Mul(hn::Set(d, 7.5f), OneMinus(beside));
    const V along =
      TurnOf(CosineBetween(normals[0], normals[1]), CosineBetween(atEnds[0], atEnds[1]));
    const V turn = hn::Mul(hn::Set(d, this->Volume.Sharpness()), hn::Max(along, back));
    found.Turn = hn::Mul(most, turn);
    const V change = hn::Add(found.Light.Slope(), hidden);
    const V turned = hn::Min(turn, hn::Set(d, MostTurn));
    found.Needs[found.ForSlope] = hn::Mul(most,
      hn::Add(hn::Mul(change, hn::Set(d, StepsOfSlope)), hn::Mul(turned, hn::Set(d, StepsOfTurn))));
  }

  const EmittingVolume& Volume;
  const LitRays& Rays;
  const VolumeSegments& Segments;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
