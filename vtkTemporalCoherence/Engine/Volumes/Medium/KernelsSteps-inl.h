// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The light of a vector of cell segments, in one step or in several. Kernels include this file once
// for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsSteps_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsSteps_inl_h
#undef TemporalCoherence_KernelsSteps_inl_h
#else
#define TemporalCoherence_KernelsSteps_inl_h
#endif

#include "Volumes/Medium/KernelsEmittingSegments-inl.h"

#include <algorithm>
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

/// First number of steps of a segment, at most. A step of the shortest share is always taken.
constexpr float MostSteps = 64.0f, ShortestStep = 1.0f / 1024.0f;

/// The turn of normals makes no step shorter than this.
constexpr float ShortestTurn = 1.0f / 64.0f;

/// Tangent of the angle by which normals may turn in a fully visible step: 31 degrees, for which
/// light at two places is exact enough.
constexpr float TangentOfTurn = 0.6f;

/// Optical depth of the first visible step, at least.
constexpr float LeastSeen = 1e-4f;

/// The longest step that the turn of normals allows.
/// \param normal, turning see LengthOfTurn
/// \param seen transmittance in front of the step, at most
HWY_INLINE V LongestTurn(
  const EmittingVolume& volume, const V normal[3], const V turning[3], V seen)
{
  const Floats d;
  // Highlights change faster.
  const float blunt = 1.0f / std::sqrt(volume.Sharpness());
  const V tangent = hn::Div(hn::Set(d, TangentOfTurn * blunt),
    hn::Min(hn::Max(hn::Mul(hn::Set(d, 2.0f), seen), hn::Set(d, 1e-4f)), hn::Set(d, 1.0f)));
  const V turn = LengthOfTurn(normal, turning, tangent);
  return hn::Max(turn, hn::Set(d, std::max(ShortestTurn * blunt, ShortestStep)));
}

/// Light of a vector of segments with nothing in front of them.
struct AddedLight
{
  HWY_INLINE AddedLight()
    : Passed(hn::Set(Floats(), 1.0f))
    , First(hn::Set(Floats(), SegmentSums::Never))
  {
    std::fill_n(this->Color, 3, hn::Zero(Floats()));
  }

  /// t of the first visible point in segments, or Never.
  /// \param enter, length of the segments
  HWY_INLINE V FirstIn(V enter, V length) const
  {
    const V never = hn::Set(Floats(), SegmentSums::Never);
    const V at = hn::Add(enter, hn::Mul(this->First, length));
    return hn::IfThenElse(hn::Eq(this->First, never), never, at);
  }

  V Passed;   ///< share of the light from behind that passes
  V Color[3]; ///< multiplied by its opacity
  V First;    ///< share of the segment at its first visible point, or Never
};

/// A step along segments.
struct Step
{
  V Begin, End;
  V ValueAtBegin, ValueAtEnd;
  EmissionAt AtBegin, AtEnd;
  V Opacity; ///< by the gradient
};

/// The state of a vector of segments between their steps.
struct StepWalk
{
  HWY_INLINE StepWalk()
  {
    const Floats d;
    const V zero = hn::Zero(d);
    this->Shown = this->Length = this->Longest = this->Opacity = zero;
    this->FirstTurn = this->SecondTurn = zero;
    this->At.Begin = this->At.End = this->At.ValueAtBegin = this->At.ValueAtEnd = zero;
    this->At.AtBegin.Clear();
    this->At.AtEnd.Clear();
    this->IsOn = hn::Lt(zero, zero);
  }

  Step At;                 ///< the last step, and the begin of the next one
  V Length, Longest;       ///< of the next step
  V Opacity;               ///< gradient opacity at the begin of the next step
  V Shown;                 ///< transmittance in front of the segment
  V FirstTurn, SecondTurn; ///< turning points of the field, as shares; only with opaque values
  AddedLight Added;
  M IsOn; ///< segments that are not finished
};

/// Steps along a vector of segments.
template <std::size_t Colors>
class Steps
{
public:
  HWY_INLINE Steps(const EmittingVolume& volume, const EmittingSegments<Colors>& segments)
    : Volume(volume)
    , Segments(segments)
  {
  }

  /// Whole segments as one step.
  HWY_INLINE Step Whole() const
  {
    const Floats d;
    const EmittingSegments<Colors>& all = this->Segments;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    return { zero, one, all.Values.C[0], all.ValueAtEnd, all.AtBegin, all.AtEnd,
      hn::Mul(hn::Set(d, 0.5f), hn::Add(this->OpacityAt(zero), this->OpacityAt(one))) };
  }

  HWY_INLINE V OpacityAt(V share) const
  {
    return EmissionKernels::HWY_NAMESPACE::OpacityAt(this->Volume, this->Segments.Gradients, share);
  }

  /// The optical depth of a step, without gradient opacity.
  /// \param mean gets the mean emission
  HWY_INLINE V DepthOf(const Step& step, V mean[4]) const
  {
    const Floats d;
    const V half = hn::Set(d, 0.5f), share = hn::Sub(step.End, step.Begin);
    const V middle = this->Segments.Values.At(hn::Add(step.Begin, hn::Mul(half, share)));
    const V ends = hn::Mul(half, hn::Add(step.ValueAtBegin, step.ValueAtEnd));
    const V lift = hn::Mul(hn::Set(d, 2.0f / 3.0f), hn::Sub(middle, ends));
    MeanBetween(this->Volume.Tables, step.ValueAtBegin, step.AtBegin, step.ValueAtEnd, step.AtEnd,
      lift, mean);
    return hn::Mul(hn::Mul(mean[0], this->Segments.Length), share);
  }

  /// Composite a step behind the light of its segment so far.
  /// \param lightAt finds the light around a share of the segment, given the standard deviation
  template <typename LightAt>
  HWY_INLINE void Add(
    const Step& step, V depth, V mean[4], const LightAt& lightAt, AddedLight& added) const
  {
    const Floats d;
    const V share = hn::Sub(step.End, step.Begin);
    const V spread = SpreadOf(step.AtBegin, step.AtEnd);
    const V centre =
      CentreOf(step.ValueAtBegin, step.AtBegin, step.ValueAtEnd, step.AtEnd, depth, spread);
    const V at = hn::Add(step.Begin, hn::Mul(centre, share));
    PullColors(this->Volume.Tables, step.ValueAtBegin, step.AtBegin, step.ValueAtEnd, step.AtEnd,
      depth, mean);
    const ReflectedLight<V, Colors> light = lightAt(at, hn::Mul(share, spread));
    const V left = hn::Mul(added.Passed, ExpOfMinus(depth));
    const V perMean = hn::Div(hn::Sub(added.Passed, left), hn::Max(mean[0], hn::Set(d, 1e-30f)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t color = Colors == 1 ? 0 : a;
      const V lit =
        hn::Add(hn::Mul(mean[a + 1], light.Matt[color]), hn::Mul(mean[0], light.Shine[color]));
      const V emitted = hn::Min(hn::Max(lit, hn::Zero(d)), mean[0]);
      added.Color[a] = hn::Add(added.Color[a], hn::Mul(perMean, emitted));
    }
    const M isFirst = hn::And(hn::Gt(depth, hn::Set(d, LeastSeen)), hn::Gt(added.First, at));
    added.First = hn::IfThenElse(isFirst, at, added.First);
    added.Passed = left;
  }

  /// Start some segments.
  /// \param which lanes start
  /// \param shown transmittance in front of the segments
  HWY_INLINE void Begin(M which, V shown, StepWalk& walk) const
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f), count = hn::Ceil(hn::Sqrt(this->Segments.SquareOfSteps(shown)));
    const V longest = hn::Div(one, hn::Min(hn::Max(count, one), hn::Set(d, MostSteps)));
    const auto begin = [which](V value, V& of) HWY_ATTR { of = hn::IfThenElse(which, value, of); };
    begin(shown, walk.Shown);
    begin(longest, walk.Longest);
    begin(longest, walk.Length);
    begin(this->OpacityAt(hn::Zero(d)), walk.Opacity);
    walk.At.End = hn::IfThenZeroElse(which, walk.At.End);
    walk.At.ValueAtEnd = hn::IfThenElse(which, this->Segments.Values.C[0], walk.At.ValueAtEnd);
    walk.At.AtEnd.Take(which, this->Segments.AtBegin);
    GoOn(which, walk.At);
    if (this->Volume.Tables.AreOpaqueAnywhere)
    {
      const Cubics::HWY_NAMESPACE::Turns<V> turns(this->Segments.Values);
      begin(turns.First, walk.FirstTurn);
      begin(turns.Second, walk.SecondTurn);
    }
    begin(one, walk.Added.Passed);
    begin(hn::Set(d, SegmentSums::Never), walk.Added.First);
    for (V& color : walk.Added.Color)
    {
      begin(hn::Zero(d), color);
    }
    walk.IsOn = hn::Or(walk.IsOn, which);
  }

  /// Add one step of each segment.
  /// \param isSmooth segments with linear light
  /// \param lightAt  see Add
  template <typename LightAt>
  HWY_INLINE void AddNext(M isSmooth, const LightAt& lightAt, StepWalk& walk) const
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    Step& step = walk.At;
    V most = walk.Length;
    if (!hn::AllTrue(d, hn::Or(isSmooth, hn::Not(walk.IsOn))))
    {
      V gradient[3], change[3], normal[3], turning[3];
      this->Segments.Gradients.At(step.Begin, gradient);
      this->Segments.Gradients.ChangeAt(step.Begin, change);
      Transform(this->Volume.WorldFromGradient, gradient, normal);
      Transform(this->Volume.WorldFromGradient, change, turning);
      const V turn =
        LongestTurn(this->Volume, normal, turning, hn::Mul(walk.Shown, walk.Added.Passed));
      most = hn::IfThenElse(isSmooth, most, hn::Min(most, turn));
    }
    // The last step includes a tiny rest of its segment.
    const M isLast = hn::Gt(hn::Add(step.Begin, hn::Mul(most, hn::Set(d, 1.001f))), one);
    step.End = hn::IfThenElse(isLast, one, hn::Add(step.Begin, most));
    if (this->Volume.Tables.AreOpaqueAnywhere)
    {
      StopAtTurns(walk);
    }
    this->FindEnd(hn::Or(hn::Eq(step.End, one), hn::Not(walk.IsOn)), step);
    const V opacityThere = this->OpacityAt(step.End);
    step.Opacity = hn::Mul(half, hn::Add(walk.Opacity, opacityThere));
    V mean[4];
    V depth = this->DepthOf(step, mean);
    const V share = hn::Sub(step.End, step.Begin);
    const M isShort = hn::Le(share, hn::Set(d, ShortestStep));
    const M isGood =
      IsGood(depth, hn::Sub(opacityThere, walk.Opacity), hn::Mul(walk.Shown, walk.Added.Passed));
    const M isTaken = hn::And(walk.IsOn, hn::Or(isShort, isGood));
    depth = hn::IfThenElseZero(isTaken, hn::Mul(depth, step.Opacity));
    if (!hn::AllFalse(d, hn::Gt(depth, zero)))
    {
      this->Add(step, depth, mean, lightAt, walk.Added);
    }
    // Retry a bad step at a quarter of its length; double the length after a good one.
    walk.Length = hn::IfThenElse(isTaken, hn::Min(walk.Longest, hn::Add(walk.Length, walk.Length)),
      hn::Mul(hn::Set(d, 0.25f), share));
    walk.Opacity = hn::IfThenElse(isTaken, opacityThere, walk.Opacity);
    GoOn(isTaken, step);
    const V left = hn::Mul(walk.Shown, walk.Added.Passed);
    walk.IsOn =
      hn::And(walk.IsOn, hn::And(hn::Lt(step.Begin, one), hn::Gt(left, hn::Set(d, 1e-4f))));
  }

  /// True where a step is exact enough.
  /// \param change of the gradient opacity
  /// \param shown  transmittance in front of the step
  static HWY_INLINE M IsGood(V depth, V change, V shown)
  {
    const Floats d;
    const V seen = hn::Mul(shown, hn::Min(depth, hn::Set(d, 1.0f)));
    return hn::And(hn::Le(hn::Mul(depth, shown), hn::Set(d, MostDepthOfStep)),
      hn::Le(hn::Mul(hn::Abs(change), seen), hn::Set(d, MostOpacityChange)));
  }

private:
  /// End steps at turning points, where the field may touch an opaque value without passing it.
  static HWY_INLINE void StopAtTurns(StepWalk& walk)
  {
    Step& step = walk.At;
    for (const V turn : { walk.SecondTurn, walk.FirstTurn })
    {
      const M isBetween = hn::And(hn::Gt(turn, step.Begin), hn::Lt(turn, step.End));
      step.End = hn::IfThenElse(isBetween, turn, step.End);
    }
  }

  /// \param isAtEnd lanes without a segment, or whose step ends at the end of its segment
  HWY_INLINE void FindEnd(M isAtEnd, Step& step) const
  {
    step.ValueAtEnd = this->Segments.ValueAtEnd;
    step.AtEnd = this->Segments.AtEnd;
    if (!hn::AllTrue(Floats(), isAtEnd))
    {
      step.ValueAtEnd = this->Segments.Values.At(step.End);
      LookUp(this->Volume.Tables, step.ValueAtEnd, step.AtEnd);
    }
  }

  /// Let the next step begin at the end of a taken step.
  static HWY_INLINE void GoOn(M isTaken, Step& step)
  {
    step.Begin = hn::IfThenElse(isTaken, step.End, step.Begin);
    step.ValueAtBegin = hn::IfThenElse(isTaken, step.ValueAtEnd, step.ValueAtBegin);
    step.AtBegin.Take(isTaken, step.AtEnd);
  }

  const EmittingVolume& Volume;
  const EmittingSegments<Colors>& Segments;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
