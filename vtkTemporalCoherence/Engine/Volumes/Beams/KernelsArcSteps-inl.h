// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Integrates paths through cells step by step along the arcs of a transfer function. Kernels
// include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsArcSteps_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsArcSteps_inl_h
#undef TemporalCoherence_KernelsArcSteps_inl_h
#else
#define TemporalCoherence_KernelsArcSteps_inl_h
#endif

#include "Volumes/Beams/KernelsArcs-inl.h"
#include "Volumes/Medium/KernelsCellGradients-inl.h"
#include "Volumes/Medium/KernelsEmittingSegments-inl.h"
#include "Volumes/Medium/KernelsLight-inl.h"
#include "Volumes/Medium/KernelsSteps-inl.h"
#include "Volumes/Medium/KernelsStretch-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Largest optical depth of a step along an arc with nothing in front of it, and of any step. The
/// limit grows with the inverse root of the transmittance in front.
constexpr float DepthOfArcStep = 0.8f, MostDepthOfArcStep = 2.0f;

/// Largest turn of normals between places of a step: 1 - the cosine of the angle, weighted by the
/// transmittance in front and the optical depth.
constexpr float MostTurnOfPlaces = 0.01f;

/// Converts the change of light across a kink into an equivalent turn.
constexpr float TurnOfBend = 0.5f;

/// A kink of light ends a step only from this share of the path on.
constexpr float ShortestBeforeBend = 0.02f;

/// Three points of a step, by Gauss and Legendre: quadrature is exact for degree 5.
struct PlaceTriple
{
  static constexpr float At[3] = { 0.11270167f, 0.5f, 0.88729833f };
  static constexpr float Weight[3] = { 5.0f / 18.0f, 4.0f / 9.0f, 5.0f / 18.0f };
  /// Weights of the values at the three points in the integral of a parabola up to each point.
  static constexpr float Before[3][3] = { { 0.13888889f, -0.03597667f, 0.00978944f },
    { 0.30026319f, 0.22222222f, -0.02248542f }, { 0.26798833f, 0.48042111f, 0.13888889f } };
};

/// A vector of paths through cells.
struct ArcPaths
{
  template <class Visitor>
  HWY_INLINE void EachColumn(const Visitor& visit)
  {
    visit(this->Enter);
    visit(this->Length);
    visit(this->Shown);
    visit(this->Begin);
    visit(this->Arc);
    for (std::size_t i = 0; i < 4; ++i)
    {
      visit(this->Values.C[i]);
      for (auto& toward : this->Toward.Along)
      {
        visit(toward.C[i]);
      }
    }
    this->Turning.EachColumn(visit);
  }
  static constexpr std::size_t Columns = 5 + 4 * 4 + CubicTurns::Columns;

  /// True for paths that may emit light behind Begin, in the present or a later arc.
  /// \param arcs the present ones
  HWY_INLINE M AreSeen(const Arcs& arcs) const
  {
    return hn::Or(hn::Not(arcs.AreEmpty()), Leaving(this->Turning, arcs, this->Begin).Ever);
  }

  HWY_INLINE ArcEnd EndOf(const Arcs& arcs) const
  {
    return { this->Values, this->Turning, arcs, this->Begin, this->Arc };
  }

  V Enter, Length;      ///< see VolumeSegments
  V Shown;              ///< transmittance in front of the path
  V Begin;              ///< share of the path that is integrated already
  V Arc;                ///< number of the arc at Begin
  Line Values;          ///< in bins
  LineGradients Toward; ///< towards lower values, in the world; only with lights
  CubicTurns Turning;   ///< turning points of Values
};

/// Integrates the light of a vector of paths.
template <std::size_t Colors>
class ArcSteps
{
public:
  ArcSteps(const EmittingVolume& volume, const EmissionArcs& arcs)
    : Volume(volume)
    , All(arcs)
  {
    const V zero = hn::Zero(Floats());
    this->Now.EachColumn([&](V& value) HWY_ATTR { value = zero; });
    this->Longest = zero;
    this->IsOn = hn::Lt(zero, zero);
  }

  /// Start the paths in some lanes of Now.
  HWY_INLINE void Begin(M which)
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f);
    const auto begin = [which](V value, V& of) HWY_ATTR { of = hn::IfThenElse(which, value, of); };
    begin(one, this->Longest);
    begin(one, this->Added.Passed);
    begin(hn::Set(d, SegmentSums::Never), this->Added.First);
    for (V& color : this->Added.Color)
    {
      begin(hn::Zero(d), color);
    }
    this->IsOn = hn::Or(this->IsOn, which);
  }

  /// Add a step of each path. No step leaves its arc.
  HWY_INLINE void AddNext(const RayVectors& rays)
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f);
    ArcPaths& now = this->Now;
    const Arcs arcs(this->All, now.Arc);
    const ArcEnd end = now.EndOf(arcs);
    const V seen = hn::Mul(now.Shown, this->Added.Passed);
    const V whole = hn::Max(hn::Sub(end.Share, now.Begin), hn::Zero(d));
    ArcStep step;
    step.Share = hn::Min(whole, this->Longest);
    if (this->Volume.Lights)
    {
      step.Share = hn::Min(step.Share, this->LongestOfLight(seen));
    }
    step.Share = hn::IfThenElse(arcs.AreEmpty(), whole, step.Share);
    this->FindExtinction(arcs, step);
    this->Shorten(arcs, seen, step);
    ReflectedLight<V, Colors> light[3];
    const V turn = this->FindLight(rays, step.Share, light);
    const M isTaken = hn::And(this->IsOn, IsGood(turn, seen, step));
    step.Depth = hn::IfThenElseZero(isTaken, step.Depth);
    this->Add(arcs, step, light);
    // Retry steps with too large a turn at half their length; double the limit after a good step.
    this->Longest = hn::IfThenElse(isTaken, hn::Min(one, hn::Add(this->Longest, this->Longest)),
      hn::Mul(hn::Set(d, 0.5f), step.Share));
    const M isLeft = hn::And(isTaken, hn::Ge(step.Share, whole));
    const V stop = hn::IfThenElse(isLeft, end.Share, hn::Add(now.Begin, step.Share));
    now.Begin = hn::IfThenElse(isTaken, stop, now.Begin);
    now.Arc = hn::IfThenElse(isLeft, end.Next, now.Arc);
    const V left = hn::Mul(now.Shown, this->Added.Passed);
    this->IsOn =
      hn::And(this->IsOn, hn::And(hn::Lt(now.Begin, one), hn::Gt(left, hn::Set(d, 1e-4f))));
    if (!hn::AllFalse(d, hn::And(isLeft, this->IsOn)))
    {
      const M isSeen = now.AreSeen(Arcs(this->All, now.Arc));
      this->IsOn = hn::And(this->IsOn, hn::Or(hn::Not(isLeft), isSeen));
    }
  }

  ArcPaths Now;
  AddedLight Added;
  M IsOn; ///< paths that are not finished

private:
  struct ArcStep
  {
    V Share;         ///< of the path
    V Places[3];     ///< in the arc
    V Extinction[3]; ///< at the places
    V Depth;         ///< optical depth of the step
  };

  /// The longest step that the turn of normals and the kinks of light allow.
  HWY_INLINE V LongestOfLight(V seen) const
  {
    const Floats d;
    V normal[3], turning[3];
    this->Now.Toward.At(this->Now.Begin, normal);
    this->Now.Toward.ChangeAt(this->Now.Begin, turning);
    V share = LongestTurn(this->Volume, normal, turning, seen);
    // Light has a kink where normals turn away from it. End steps there, for directional lights.
    for (const VolumeLight& light : this->Volume.Lights->All)
    {
      if (light.IsPositional)
      {
        continue;
      }
      const V toward[3] = { hn::Set(d, light.Toward.x), hn::Set(d, light.Toward.y),
        hn::Set(d, light.Toward.z) };
      const V cosine = Dot(normal, toward), change = Dot(turning, toward);
      const M isAny = hn::Gt(hn::Abs(change), hn::Set(d, 1e-20f));
      const V at = hn::Div(hn::Neg(cosine), hn::IfThenElse(isAny, change, hn::Set(d, 1.0f)));
      const M isBend =
        hn::And(isAny, hn::And(hn::Gt(at, hn::Set(d, ShortestBeforeBend)), hn::Lt(at, share)));
      share = hn::IfThenElse(isBend, at, share);
    }
    return share;
  }

  HWY_INLINE void FindExtinction(const Arcs& arcs, ArcStep& step) const
  {
    const Floats d;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V at = hn::Add(this->Now.Begin, hn::Mul(hn::Set(d, PlaceTriple::At[i]), step.Share));
      step.Places[i] = arcs.PlaceOf(this->Now.Values.At(at));
    }
    arcs.ChannelAt(0, step.Places, step.Extinction);
    V mean = hn::Zero(d);
    for (std::size_t i = 0; i < 3; ++i)
    {
      mean = hn::Add(mean, hn::Mul(hn::Set(d, PlaceTriple::Weight[i]), step.Extinction[i]));
    }
    step.Depth = hn::Mul(mean, hn::Mul(step.Share, this->Now.Length));
  }

  /// Shorten steps with too large an optical depth.
  HWY_INLINE void Shorten(const Arcs& arcs, V seen, ArcStep& step) const
  {
    const Floats d;
    const V perRoot = InverseRoot(hn::Max(seen, hn::Set(d, 1e-3f)));
    const V most =
      hn::Min(hn::Set(d, MostDepthOfArcStep), hn::Mul(hn::Set(d, DepthOfArcStep), perRoot));
    const M isDeep = hn::And(this->IsOn, hn::Gt(step.Depth, most));
    if (!hn::AllFalse(d, isDeep))
    {
      const V part = hn::Div(most, hn::IfThenElse(isDeep, step.Depth, most));
      const V shortest = hn::Min(step.Share, hn::Set(d, ShortestStep));
      step.Share = hn::IfThenElse(isDeep, hn::Max(hn::Mul(step.Share, part), shortest), step.Share);
      this->FindExtinction(arcs, step);
    }
  }

  /// Find the light at the places of a step.
  /// \return turn of normals between the places: 1 - the cosine of the angle, or more if light has
  ///   a kink in between
  HWY_INLINE V FindLight(const RayVectors& rays, V share, ReflectedLight<V, Colors> light[3]) const
  {
    const Floats d;
    if (!this->Volume.Lights)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        light[i].SetUnlit();
      }
      return hn::Zero(d);
    }
    V normals[3][3], points[3][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V at = hn::Add(this->Now.Begin, hn::Mul(hn::Set(d, PlaceTriple::At[i]), share));
      this->Now.Toward.At(at, normals[i]);
      MakeUnit(normals[i]);
      rays.PointAt(hn::Add(this->Now.Enter, hn::Mul(at, this->Now.Length)), points[i]);
    }
    const LitPoints at[3] = { { normals[0], rays.Direction, points[0] },
      { normals[1], rays.Direction, points[1] }, { normals[2], rays.Direction, points[2] } };
    const V turn = OneMinus(
      hn::Min(CosineBetween(normals[0], normals[1]), CosineBetween(normals[1], normals[2])));
    const VolumeLights& lights = *this->Volume.Lights;
    const LightSum<Colors, V> add(lights);
    light[0] = light[1] = light[2] = AmbientLight<Colors, V>(lights);
    V bend = hn::Zero(d);
    for (const VolumeLight& from : lights.All)
    {
      const ArrivingLight<V> arriving[3] = { { from, at[0] }, { from, at[1] }, { from, at[2] } };
      for (std::size_t i = 0; i < 3; ++i)
      {
        add.Add(from, arriving[i], at[i], arriving[i].Lit(lights.AreTwoSided), light[i]);
      }
      bend = hn::Max(bend, BendOf(from, arriving));
    }
    const V clamped = hn::Max(ClampedIn<Colors, V>(light), ClampedIn<Colors, V>(light + 1));
    return hn::Max(turn, hn::Mul(hn::Set(d, TurnOfBend), hn::Max(bend, clamped)));
  }

  /// Change of a light between the places across a kink: where normals turn away from it, or at the
  /// rim of its cone.
  static HWY_INLINE V BendOf(const VolumeLight& light, const ArrivingLight<V> arriving[3])
  {
    const V first = arriving[0].Cosine, second = arriving[1].Cosine, third = arriving[2].Cosine;
    const V low = hn::Min(first, hn::Min(second, third));
    const V high = hn::Max(first, hn::Max(second, third));
    const V zero = hn::Zero(Floats());
    const M isAcross = hn::And(hn::Lt(low, zero), hn::Gt(high, zero));
    const V atRim = hn::Max(ChangeAtRim(light, arriving[0].Share, arriving[1].Share),
      ChangeAtRim(light, arriving[1].Share, arriving[2].Share));
    return hn::Max(atRim, hn::IfThenElseZero(isAcross, hn::Sub(high, low)));
  }

  static HWY_INLINE M IsGood(V turn, V seen, const ArcStep& step)
  {
    const Floats d;
    const V counts = hn::Mul(seen, hn::Min(step.Depth, hn::Set(d, 1.0f)));
    return hn::Or(hn::Le(hn::Mul(turn, counts), hn::Set(d, MostTurnOfPlaces)),
      hn::Lt(step.Share, hn::Set(d, ShortestTurn)));
  }

  /// Composite steps behind the light of their paths so far.
  HWY_INLINE void Add(
    const Arcs& arcs, const ArcStep& step, const ReflectedLight<V, Colors> light[3])
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const V length = hn::Mul(step.Share, this->Now.Length);
    V weights[3], sum = zero, moment = zero;
    for (std::size_t i = 0; i < 3; ++i)
    {
      V before = zero;
      for (std::size_t k = 0; k < 3; ++k)
      {
        before =
          hn::Add(before, hn::Mul(hn::Set(d, PlaceTriple::Before[i][k]), step.Extinction[k]));
      }
      const V most = hn::Set(d, MostDepthOfArcStep);
      const V depth = hn::Min(hn::Max(hn::Mul(before, length), zero), most);
      weights[i] = hn::Mul(hn::Set(d, PlaceTriple::Weight[i]), ExpOfLittle(depth));
      const V emitted = hn::Mul(weights[i], step.Extinction[i]);
      sum = hn::Add(sum, emitted);
      moment = hn::Add(moment, hn::Mul(hn::Set(d, PlaceTriple::At[i]), emitted));
    }
    // Scale the weights, so that they sum up to the opacity of the step.
    const V left = ExpOfMinus(step.Depth);
    const M isSum = hn::Gt(sum, hn::Set(d, 1e-30f));
    const V perSum = hn::Div(one, hn::IfThenElse(isSum, sum, one));
    const V scale = hn::Mul(hn::Mul(this->Added.Passed, hn::Sub(one, left)), perSum);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::size_t color = Colors == 1 ? 0 : c;
      V own[3], all = zero;
      arcs.ChannelAt(c + 1, step.Places, own);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const V lit = hn::Add(hn::Mul(own[i], light[i].Matt[color]), light[i].Shine[color]);
        const V shown = hn::Mul(step.Extinction[i], hn::Min(hn::Max(lit, zero), one));
        all = hn::Add(all, hn::Mul(weights[i], shown));
      }
      this->Added.Color[c] = hn::Add(this->Added.Color[c], hn::Mul(scale, all));
    }
    const V centre = hn::Add(this->Now.Begin, hn::Mul(hn::Mul(moment, perSum), step.Share));
    const M isFirst =
      hn::And(hn::Gt(step.Depth, hn::Set(d, LeastSeen)), hn::Gt(this->Added.First, centre));
    this->Added.First = hn::IfThenElse(isFirst, centre, this->Added.First);
    this->Added.Passed = hn::Mul(this->Added.Passed, left);
  }

  const EmittingVolume& Volume;
  const EmissionArcs& All;
  V Longest; ///< largest share of the path for the next step
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
