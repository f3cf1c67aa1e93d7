// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The light of paths along the arcs of a transfer function: where values pass from one arc to the
// next, integration step by step, and a queue that fills vectors. Kernels include this file once
// for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsArcs_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsArcs_inl_h
#undef TemporalCoherence_KernelsArcs_inl_h
#else
#define TemporalCoherence_KernelsArcs_inl_h
#endif

#include "Volumes/Beams/EmissionArcs.h"
#include "Volumes/Beams/KernelsBeamPaths-inl.h"
#include "Volumes/Beams/KernelsEvenCells-inl.h"
#include "Volumes/Medium/KernelsCellGradients-inl.h"
#include "Volumes/Medium/KernelsCubic-inl.h"
#include "Volumes/Medium/KernelsEmittingSegments-inl.h"
#include "Volumes/Medium/KernelsLaneWork-inl.h"
#include "Volumes/Medium/KernelsLight-inl.h"
#include "Volumes/Medium/KernelsSteps-inl.h"
#include "Volumes/Medium/KernelsStretch-inl.h"
#include "Volumes/Medium/KernelsVectors-inl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// An arc for each lane.
class Arcs
{
public:
  /// \param numbers of the arcs
  HWY_INLINE Arcs(const EmissionArcs& all, V numbers)
    : All(all)
    , Numbers(hn::ConvertTo(Integers(), numbers))
    , InVector(hn::IndicesFromVec(Floats(),
        hn::And(
          this->Numbers, hn::Set(Integers(), static_cast<std::int32_t>(hn::Lanes(Floats()) - 1)))))
    , IsInSecond(hn::Ge(numbers, hn::Set(Floats(), static_cast<float>(hn::Lanes(Floats())))))
  {
  }

  HWY_INLINE M AreEmpty() const
  {
    return hn::Gt(this->Pick(this->All.AreEmpty), hn::Zero(Floats()));
  }
  HWY_INLINE V Low() const { return this->Pick(this->All.Low); }
  HWY_INLINE V High() const { return this->Pick(this->All.High); }
  HWY_INLINE V Precision() const { return this->Pick(this->All.Precision); }

  /// The argument of the polynomials, in [-1, 1], for values in the arcs.
  HWY_INLINE V PlaceOf(V value) const
  {
    const Floats d;
    const V place =
      hn::Mul(hn::Sub(value, this->Pick(this->All.Middle)), this->Pick(this->All.PerValue));
    return hn::Min(hn::Max(place, hn::Set(d, -1.0f)), hn::Set(d, 1.0f));
  }

  /// Extinction or a colour at some places.
  template <std::size_t Count>
  HWY_INLINE void ChannelAt(std::size_t channel, const V (&places)[Count], V (&found)[Count]) const
  {
    const V third = this->Pick(this->All.Powers[channel][3]);
    const V second = this->Pick(this->All.Powers[channel][2]);
    const V first = this->Pick(this->All.Powers[channel][1]);
    const V constant = this->Pick(this->All.Powers[channel][0]);
    for (std::size_t i = 0; i < Count; ++i)
    {
      const V x = places[i];
      const V sum = hn::Add(hn::Mul(hn::Add(hn::Mul(third, x), second), x), first);
      found[i] = hn::Max(hn::Add(hn::Mul(sum, x), constant), hn::Zero(Floats()));
    }
  }

private:
  /// Look up a column at the arc of each lane. For most functions, one or two vectors hold all
  /// arcs.
  HWY_INLINE V Pick(const EmissionArcs::Column& column) const
  {
    const Floats d;
    const std::size_t lanes = hn::Lanes(d);
    const float* const from = column.data();
    if (this->All.Count > 2 * lanes)
    {
      return hn::GatherIndex(d, from, this->Numbers);
    }
    const V first = hn::TableLookupLanes(hn::LoadU(d, from), this->InVector);
    if (this->All.Count <= lanes)
    {
      return first;
    }
    const V second = hn::TableLookupLanes(hn::LoadU(d, from + lanes), this->InVector);
    return hn::IfThenElse(this->IsInSecond, second, first);
  }

  const EmissionArcs& All;
  I Numbers;
  decltype(hn::IndicesFromVec(Floats(), I())) InVector;
  M IsInSecond;
};

using CubicTurns = Cubics::HWY_NAMESPACE::Turns<V>;

/// Tells in which monotone piece a cubic first leaves its arc: the piece up to the first turning
/// point, up to the second one, or any piece.
struct Leaving
{
  /// \param begin share at which the cubics lie in their arcs
  HWY_INLINE Leaving(const CubicTurns& turns, const Arcs& arcs, V begin)
  {
    const V low = arcs.Low(), high = arcs.High();
    const auto isOutside = [&](V value) HWY_ATTR
    { return hn::Or(hn::Lt(value, low), hn::Gt(value, high)); };
    this->BeforeFirst = hn::And(hn::Lt(begin, turns.First), isOutside(turns.AtFirst));
    this->BeforeSecond = hn::AndNot(
      this->BeforeFirst, hn::And(hn::Lt(begin, turns.Second), isOutside(turns.AtSecond)));
    this->Ever = hn::Or(hn::Or(this->BeforeFirst, this->BeforeSecond), isOutside(turns.AtEnd));
  }

  M BeforeFirst, BeforeSecond, Ever;
};

/// Where cubics leave their arcs.
struct ArcEnd
{
  /// \param begin share at which the cubics lie in their arcs
  /// \param number of the arcs
  HWY_INLINE ArcEnd(
    const CubicTurns::Line& cubic, const CubicTurns& turns, const Arcs& arcs, V begin, V number)
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Leaving leaving(turns, arcs, begin);
    const auto choose = [&](V first, V second, V last) HWY_ATTR
    {
      return hn::IfThenElse(
        leaving.BeforeFirst, first, hn::IfThenElse(leaving.BeforeSecond, second, last));
    };
    // The cubic is monotone from left to right.
    V left = hn::Max(begin, choose(zero, turns.First, turns.Second));
    V right = choose(turns.First, turns.Second, one);
    const V last = choose(turns.AtFirst, turns.AtSecond, turns.AtEnd);
    const M isRising = hn::Gt(last, arcs.High());
    const V wanted = hn::IfThenElse(isRising, arcs.High(), arcs.Low());
    const auto ratio = [&](V of, V by) HWY_ATTR
    {
      const M isAny = hn::And(leaving.Ever, hn::Gt(hn::Abs(by), hn::Set(d, 1e-20f)));
      return hn::Div(hn::IfThenElseZero(isAny, of), hn::IfThenElse(isAny, by, one));
    };
    // Start with the secant, then take Newton steps within the bracket.
    const V from = cubic.At(left);
    const V share = ratio(hn::Sub(wanted, from), hn::Sub(last, from));
    V at = hn::Add(left, hn::Mul(hn::Min(hn::Max(share, zero), one), hn::Sub(right, left)));
    const V precision = arcs.Precision();
    for (int step = 0; step < MostNewtonSteps; ++step)
    {
      const V off = hn::IfThenElseZero(leaving.Ever, hn::Sub(cubic.At(at), wanted));
      const M isFound = hn::Le(hn::Abs(off), precision);
      if (hn::AllTrue(d, isFound))
      {
        break;
      }
      const M isBefore = hn::Xor(hn::Lt(off, zero), hn::Not(isRising));
      left = hn::IfThenElse(isBefore, at, left);
      right = hn::IfThenElse(isBefore, right, at);
      const V next = hn::Sub(at, ratio(off, cubic.SlopeAt(at)));
      at = hn::IfThenElse(isFound, at, hn::Min(hn::Max(next, left), right));
    }
    this->Share = hn::IfThenElse(leaving.Ever, at, one);
    const V other = hn::IfThenElse(isRising, one, hn::Set(d, -1.0f));
    this->Next = hn::Add(number, hn::IfThenElseZero(leaving.Ever, other));
  }

  V Share; ///< of the path at the end of the arc, or 1
  V Next;  ///< number of the next arc

private:
  static constexpr int MostNewtonSteps = 6;
};

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

/// A range of arcs, the last one included.
struct ArcRange
{
  std::size_t First, Last;
};

/// Collects paths, and integrates them in full vectors.
template <std::size_t Colors>
class ArcQueue
{
public:
  /// \param sums get the light of each path in its slot; the slots of paths that add nothing stay
  ///   as they are
  ArcQueue(
    const EmittingVolume& volume, const EmissionArcs& arcs, const LitRays& rays, LeafSums& sums)
    : Volume(volume)
    , All(arcs)
    , Rays(rays)
    , Sums(sums)
    , Steps(volume, arcs)
  {
  }

  /// \param arcs that the values of the cell span
  HWY_INLINE void Append(
    M which, const EvenCell& cell, const ArcRange& arcs, const CellPaths& through)
  {
    const Floats d;
    ArcPaths paths;
    paths.EachColumn([](V& value) HWY_ATTR { value = hn::Zero(Floats()); });
    paths.Enter = through.Enter;
    paths.Length = through.Length;
    paths.Shown = through.Shown;
    paths.Values = cell.Value.Along(through.Begin, through.Across);
    if (this->Volume.Lights)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        paths.Toward.Along[a] = cell.Toward[a].Along(through.Begin, through.Across);
      }
    }
    paths.Turning = CubicTurns(paths.Values);
    paths.Arc = hn::Set(d, static_cast<float>(arcs.First));
    for (std::size_t arc = arcs.First; arc < arcs.Last; ++arc)
    {
      const M isAbove = hn::Gt(paths.Values.C[0], hn::Set(d, this->All.High[arc]));
      paths.Arc = hn::Add(paths.Arc, hn::IfThenElseZero(isAbove, hn::Set(d, 1.0f)));
    }
    const M isSeen = hn::And(which, this->LeaveEmptyArcs(which, paths));
    std::size_t column = 0;
    paths.EachColumn([&](V value) HWY_ATTR
      { hn::StoreU(hn::Compress(value, isSeen), d, &this->Columns[column++][this->Count]); });
    AppendNumbers(isSeen, through.Ray, &this->Ray[this->Count]);
    AppendNumbers(isSeen, through.Slot, &this->Slot[this->Count]);
    this->Count += hn::CountTrue(d, isSeen);
    if (this->Count > VolumeSegments::Capacity - WidestVector)
    {
      this->Sum();
    }
  }

  /// Integrate the queued paths, and store their light in their slots.
  HWY_NOINLINE void Sum()
  {
    if (this->Count == 0)
    {
      return;
    }
    this->FillLastVector();
    this->Next = 0;
    WorkThrough([&]() HWY_ATTR { return this->Steps.IsOn; },
      [&]() { return this->Next < this->Count; }, [&]() HWY_ATTR { this->Refill(); },
      [&]() HWY_ATTR { this->Steps.AddNext(this->Vectors); });
    this->StoreDone();
    this->Count = 0;
  }

private:
  template <typename T>
  using Array = VolumeSegments::Array<T>;

  /// Move the begin of paths in an empty arc to its end.
  /// \return paths with a share left
  HWY_INLINE M LeaveEmptyArcs(M which, ArcPaths& paths) const
  {
    const Floats d;
    const Arcs arcs(this->All, paths.Arc);
    const M isEmpty = hn::And(which, arcs.AreEmpty());
    if (!hn::AllFalse(d, isEmpty))
    {
      const ArcEnd end = paths.EndOf(arcs);
      paths.Begin = hn::IfThenElse(isEmpty, end.Share, paths.Begin);
      paths.Arc = hn::IfThenElse(isEmpty, end.Next, paths.Arc);
    }
    return hn::Lt(paths.Begin, hn::Set(d, 1.0f));
  }

  /// Give the next paths to idle lanes.
  HWY_NOINLINE void Refill()
  {
    this->StoreDone();
    const LaneWork::Taken taken = this->Work.Take(&this->Slot[this->Next], this->Count - this->Next,
      [&](std::size_t i) { return this->Ray[this->Next + i]; });
    std::size_t column = 0;
    this->Steps.Now.EachColumn(
      [&](V& value) HWY_ATTR { value = taken.Load(&this->Columns[column++][this->Next], value); });
    this->Vectors = RayVectors(this->Volume, this->Rays, this->Work.Rays());
    this->Next += taken.Count;
    this->Steps.Begin(taken.Which);
  }

  HWY_INLINE void StoreDone()
  {
    this->Work.Finish(this->Steps.IsOn, this->Steps.Added, this->Steps.Now.Enter,
      this->Steps.Now.Length, this->Sums);
  }

  /// Zero the unused lanes of the last vector.
  void FillLastVector()
  {
    std::fill_n(&this->Ray[this->Count], WidestVector, 0);
    std::fill_n(&this->Slot[this->Count], WidestVector, 0);
    for (auto& column : this->Columns)
    {
      std::fill_n(&column[this->Count], WidestVector, 0.0f);
    }
  }

  const EmittingVolume& Volume;
  const EmissionArcs& All;
  const LitRays& Rays;
  LeafSums& Sums;
  std::size_t Count = 0, Next = 0;
  Array<std::int32_t> Ray, Slot;
  std::array<Array<float>, ArcPaths::Columns> Columns;
  LaneWork Work;
  RayVectors Vectors;
  ArcSteps<Colors> Steps;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
