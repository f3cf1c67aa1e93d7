// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The light of a vector of cell segments, step by step. Kernels include this file once for each
// kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsEmittingSegments_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsEmittingSegments_inl_h
#undef TemporalCoherence_KernelsEmittingSegments_inl_h
#else
#define TemporalCoherence_KernelsEmittingSegments_inl_h
#endif

#include "Blending/KernelsCellSamples-inl.h"
#include "Blending/KernelsCubic-inl.h"
#include "Blending/KernelsEmission.h"
#include "Blending/KernelsLight-inl.h"
#include "Blending/KernelsStretch-inl.h"
#include "Blending/KernelsVectors-inl.h"

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

/// A segment is cut into no more steps at first, and in the end into no shorter ones.
constexpr float MostSteps = 64.0f, ShortestStep = 1.0f / 1024.0f;

/// The optical depth of a step, as far as it is seen: at first, and at most.
constexpr float DepthOfStep = 0.5f, MostDepthOfStep = 1.0f;

/// How far the optical depth of a segment may be off, as far as it is seen.
constexpr float DepthTolerance = 1.0f / 512.0f;

/// The square of the steps for each unit by which light, or a gradient opacity, is off a straight
/// line, and by which a normal turns (1 - the cosine), as far as it is seen.
constexpr float StepsOfBend = 1600.0f, StepsOfOpacity = 4096.0f, StepsOfTurn = 4096.0f;

/// Up to this square of steps, light follows a parabola.
constexpr float MostOfParabola = 0.5f;

/// How much a gradient opacity may change in a step, as far as it is seen.
constexpr float MostOpacityChange = 1.0f / 64.0f;

/// What a vector of segments adds to its rays.
class SegmentVector
{
public:
  HWY_INLINE SegmentVector(const EmittingVolume& volume, const LitRays& rays,
    const VolumeSegments& segments, std::size_t first, std::size_t count, BlendedRays& seen)
    : Volume(volume)
    , Seen(seen)
    , Count(count)
    , IsSegment(hn::FirstN(Floats(), count))
  {
    const Floats d;
    const auto load = [&](const VolumeSegments::Array<float>& array) HWY_ATTR
    { return hn::IfThenElseZero(this->IsSegment, hn::LoadU(d, &array[first])); };
    this->Ray = hn::IfThenElseZero(
      hn::RebindMask(Integers(), this->IsSegment), hn::LoadU(Integers(), &segments.Ray[first]));
    this->Enter = load(segments.Enter);
    this->Length = load(segments.Length);
    for (std::size_t power = 0; power < 4; ++power)
    {
      this->Values.C[power] = load(segments.Cubic[power]);
    }
    this->Middle = load(segments.Middle);
    this->Span = load(segments.Span);
    this->Bend = load(segments.Bend);
    this->Passed = hn::GatherIndex(d, seen.Passed.data(), this->Ray);
    this->IsSegment = hn::And(this->IsSegment, hn::Gt(this->Passed, hn::Set(d, LeastPassed)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Color[a] = hn::Zero(d);
      this->Begin[a] = load(segments.Begin[a]);
      this->Across[a] = load(segments.Across[a]);
      this->Direction[a] = hn::GatherIndex(d, rays.Direction[a].data(), this->Ray);
      this->Eye[a] = hn::GatherIndex(d, rays.Begin[a].data(), this->Ray);
    }
    LookUp(this->Volume.Tables, this->Values.C[0], this->AtBegin);
    this->ValueAtEnd = this->Values.At(hn::Set(d, 1.0f));
    LookUp(this->Volume.Tables, this->ValueAtEnd, this->AtEnd);
  }

  /// \param corners gradients of the cells, if the volume has any
  HWY_INLINE void Add(const CornerGradients& corners)
  {
    const Floats d;
    const LineGradients gradients(corners, this->Begin, this->Across);
    V mean[4];
    MeanBetween(this->Volume.Tables, this->Values.C[0], this->AtBegin, this->ValueAtEnd,
      this->AtEnd, hn::Zero(d), mean);
    const V depth = hn::Mul(mean[0], this->Length);
    const V steepness = hn::Mul(this->SteepnessOf(this->Volume.Tables), this->Length);
    // Ends may lie beside a peak that is reached between them.
    const V reached = hn::Sub(
      hn::Add(this->Span, this->Span), hn::Abs(hn::Sub(this->ValueAtEnd, this->Values.C[0])));
    const V most = hn::Add(depth, hn::Mul(steepness, hn::Max(reached, hn::Zero(d))));
    const V seen =
      hn::IfThenElseZero(this->IsSegment, hn::Mul(this->Passed, hn::Min(most, hn::Set(d, 1.0f))));
    V square = this->SquareOfSteps(depth, steepness);
    if (!this->Volume.ByGradient.Opacities.empty())
    {
      square = hn::Add(square, hn::Mul(seen, this->OpacityBend(gradients)));
    }
    if (!this->Volume.Lights)
    {
      this->AddSteps<1>(square, gradients, [](V, V) HWY_ATTR { return Unlit(); });
    }
    else if (this->Volume.Lights->AreWhite)
    {
      this->AddLit<1>(square, seen, gradients);
    }
    else
    {
      this->AddLit<3>(square, seen, gradients);
    }
  }

  /// Store what the rays have seen.
  HWY_INLINE void Finish() const
  {
    const Floats d;
    std::int32_t rays[WidestVector];
    hn::StoreU(this->Ray, Integers(), rays);
    const auto store = [&](V value, RayBatch::Array<float>& array) HWY_ATTR
    {
      float values[WidestVector];
      hn::StoreU(value, d, values);
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      {
        if (lane < this->Count)
        {
          array[static_cast<std::size_t>(rays[lane])] = values[lane];
        }
      }
    };
    store(this->Passed, this->Seen.Passed);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V before = hn::GatherIndex(d, this->Seen.Color[a].data(), this->Ray);
      store(hn::Add(before, this->Color[a]), this->Seen.Color[a]);
    }
  }

private:
  /// \param square of the steps that all but light asks for
  /// \param seen   the share of a segment's light that is seen
  template <std::size_t Colors>
  HWY_INLINE void AddLit(V square, V seen, const LineGradients& gradients)
  {
    const Floats d;
    V normals[3][3];
    const LightParabola<Colors> light(this->LightAt<Colors>(gradients, hn::Zero(d), normals[0]),
      this->LightAt<Colors>(gradients, hn::Set(d, 0.5f), normals[1]),
      this->LightAt<Colors>(gradients, hn::Set(d, 1.0f), normals[2]));
    // Two measures, as each is blind for some turns of normals between these places.
    const V turn =
      hn::Sub(hn::Set(d, 1.0f), hn::Min(Dot(normals[0], normals[1]), Dot(normals[1], normals[2])));
    const V ofLight = hn::Mul(seen,
      hn::Max(hn::Mul(light.Off, hn::Set(d, StepsOfBend)), hn::Mul(turn, hn::Set(d, StepsOfTurn))));
    const M isSmooth = hn::Le(ofLight, hn::Set(d, MostOfParabola));
    this->AddSteps<Colors>(hn::Add(square, hn::IfThenElseZero(hn::Not(isSmooth), ofLight)),
      gradients,
      [&](V at, V spread) HWY_ATTR
      {
        ReflectedLight<V, Colors> found = light.At(at, spread);
        if (!hn::AllTrue(d, isSmooth))
        {
          V ignored[3];
          const auto exact = this->LightAt<Colors>(gradients, at, ignored);
          for (std::size_t a = 0; a < Colors; ++a)
          {
            found.Matt[a] = hn::IfThenElse(isSmooth, found.Matt[a], exact.Matt[a]);
            found.Shine[a] = hn::IfThenElse(isSmooth, found.Shine[a], exact.Shine[a]);
          }
        }
        return found;
      });
  }

  /// The square of the steps that the field and the transfer function ask for.
  /// \param steepness of the optical depth, by the value
  HWY_INLINE V SquareOfSteps(V depth, V steepness) const
  {
    const Floats d;
    // What a straight line misses falls with the square of the steps.
    const V off = hn::Mul(steepness, this->Bend);
    const V steps = hn::Mul(hn::Mul(depth, this->Passed), hn::Set(d, 1.0f / DepthOfStep));
    return hn::Max(hn::Mul(hn::Mul(off, this->Passed), hn::Set(d, 1.0f / DepthTolerance)),
      hn::Mul(steps, steps));
  }

  /// The square of the steps that gradient opacities ask for, where all is seen of a segment.
  HWY_INLINE V OpacityBend(const LineGradients& gradients) const
  {
    const Floats d;
    const V middle = this->OpacityAt(gradients, hn::Set(d, 0.5f));
    const V first = hn::Sub(middle, this->OpacityAt(gradients, hn::Zero(d)));
    const V second = hn::Sub(this->OpacityAt(gradients, hn::Set(d, 1.0f)), middle);
    const V change = hn::Max(hn::Max(hn::Abs(first), hn::Abs(second)), hn::Set(d, 0.01f));
    return hn::Mul(change, hn::Set(d, StepsOfOpacity));
  }

  /// Add segments step by step.
  /// \param square  of the number of first steps
  /// \param lightAt finds the light around a place, with the mean square of the distance from it
  template <std::size_t Colors, typename LightAt>
  HWY_INLINE void AddSteps(V square, const LineGradients& gradients, const LightAt& lightAt)
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const V first =
      hn::Div(one, hn::Min(hn::Max(hn::Ceil(hn::Sqrt(square)), one), hn::Set(d, MostSteps)));
    V begin = zero, step = first, value = this->Values.C[0];
    EmissionAt last = this->AtBegin;
    V opacity = this->OpacityAt(gradients, zero);
    M isOn = this->IsSegment;
    while (!hn::AllFalse(d, isOn))
    {
      // What is left over of a segment is a part of its last step.
      const M isLast = hn::Gt(hn::Add(begin, hn::Mul(step, hn::Set(d, 1.001f))), one);
      const V end = hn::IfThenElse(isLast, one, hn::Add(begin, step));
      V next = this->ValueAtEnd;
      EmissionAt there = this->AtEnd;
      if (!hn::AllTrue(d, hn::Or(isLast, hn::Not(isOn))))
      {
        next = this->Values.At(end);
        LookUp(this->Volume.Tables, next, there);
      }
      const V share = hn::Sub(end, begin);
      const V middle = this->Values.At(hn::Add(begin, hn::Mul(half, share)));
      const V lift =
        hn::Mul(hn::Set(d, 2.0f / 3.0f), hn::Sub(middle, hn::Mul(half, hn::Add(value, next))));
      V mean[4];
      MeanBetween(this->Volume.Tables, value, last, next, there, lift, mean);
      V depth = hn::Mul(hn::Mul(mean[0], this->Length), share);
      const V opacityThere = this->OpacityAt(gradients, end);
      const M isShort = hn::Le(share, hn::Set(d, ShortestStep));
      const M isTaken =
        hn::And(isOn, hn::Or(isShort, this->IsGood(depth, hn::Sub(opacityThere, opacity))));
      depth =
        hn::IfThenElseZero(isTaken, hn::Mul(depth, hn::Mul(half, hn::Add(opacity, opacityThere))));
      if (!hn::AllFalse(d, hn::Gt(depth, zero)))
      {
        const V centre = CentreOf(value, last, next, there, depth);
        const V at = hn::Add(begin, hn::Mul(centre, share));
        PullColors(last, there, depth, mean);
        const V spread = hn::Mul(hn::Mul(share, share), hn::Set(d, 1.0f / 12.0f));
        this->AddStep<Colors>(at, depth, mean, lightAt(at, spread));
      }
      // Steps that are too long are tried again, and what follows short ones is longer again.
      step = hn::IfThenElse(
        isTaken, hn::Min(first, hn::Add(step, step)), hn::Mul(hn::Set(d, 0.25f), share));
      begin = hn::IfThenElse(isTaken, end, begin);
      value = hn::IfThenElse(isTaken, next, value);
      opacity = hn::IfThenElse(isTaken, opacityThere, opacity);
      Take(isTaken, there, last);
      isOn = hn::And(isOn, hn::And(hn::Lt(begin, one), hn::Gt(this->Passed, hn::Set(d, 1e-4f))));
    }
  }

  /// The largest change of extinction from bin to bin in segments.
  HWY_INLINE V SteepnessOf(const TransferTables& tables) const
  {
    const Floats d;
    const std::size_t count = tables.Steepness.size() / TransferTables::Levels;
    const V last = hn::Set(d, static_cast<float>(count - 1));
    const V perBlock = hn::Set(d, 1.0f / (1 << TransferTables::BlockBits));
    const V block = hn::Floor(hn::Min(hn::Max(hn::Mul(this->Middle, perBlock), hn::Zero(d)), last));
    V place = block;
    for (int level = 0; level < TransferTables::Levels - 1; ++level)
    {
      const V reach = hn::Set(d, static_cast<float>(1 << (TransferTables::BlockBits + level)));
      place = hn::Add(place,
        hn::IfThenElseZero(hn::Gt(this->Span, reach), hn::Set(d, static_cast<float>(count))));
    }
    return hn::GatherIndex(d, tables.Steepness.data(), hn::ConvertTo(Integers(), place));
  }

  /// True where a step may be taken.
  /// \param change of the gradient opacity
  HWY_INLINE M IsGood(V depth, V change) const
  {
    const Floats d;
    const V seen = hn::Mul(this->Passed, hn::Min(depth, hn::Set(d, 1.0f)));
    return hn::And(hn::Le(hn::Mul(depth, this->Passed), hn::Set(d, MostDepthOfStep)),
      hn::Le(hn::Mul(hn::Abs(change), seen), hn::Set(d, MostOpacityChange)));
  }

  static HWY_INLINE void Take(M isTaken, const EmissionAt& there, EmissionAt& last)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      last.Value[i] = hn::IfThenElse(isTaken, there.Value[i], last.Value[i]);
      last.Sum[i] = hn::IfThenElse(isTaken, there.Sum[i], last.Sum[i]);
    }
    last.Moment = hn::IfThenElse(isTaken, there.Moment, last.Moment);
  }

  static HWY_INLINE ReflectedLight<V, 1> Unlit()
  {
    const Floats d;
    return { { hn::Set(d, 1.0f) }, { hn::Zero(d) } };
  }

  /// \param normal there, of unit length
  template <std::size_t Colors>
  HWY_INLINE ReflectedLight<V, Colors> LightAt(
    const LineGradients& gradients, V share, V normal[3]) const
  {
    V gradient[3], point[3];
    gradients.At(share, gradient);
    FindNormals(this->Volume.WorldFromGradient, gradient, normal);
    const V t = hn::Add(this->Enter, hn::Mul(share, this->Length));
    for (std::size_t a = 0; a < 3; ++a)
    {
      point[a] = hn::Add(this->Eye[a], hn::Mul(t, this->Direction[a]));
    }
    return Reflect<Colors, V>(*this->Volume.Lights, { normal, this->Direction, point });
  }

  /// Composite a step behind what has been seen.
  template <std::size_t Colors>
  HWY_INLINE void AddStep(V at, V depth, const V mean[4], const ReflectedLight<V, Colors>& light)
  {
    const Floats d;
    const V zero = hn::Zero(d);
    const V left = hn::Mul(this->Passed, ExpOfMinus(depth));
    const V perMean = hn::Div(hn::Sub(this->Passed, left), hn::Max(mean[0], hn::Set(d, 1e-30f)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t color = Colors == 1 ? 0 : a;
      const V lit =
        hn::Add(hn::Mul(mean[a + 1], light.Matt[color]), hn::Mul(mean[0], light.Shine[color]));
      const V emitted = hn::Min(hn::Max(lit, zero), mean[0]);
      this->Color[a] = hn::Add(this->Color[a], hn::Mul(perMean, emitted));
    }
    this->NoteFirst(hn::Gt(depth, hn::Set(d, 1e-4f)), at);
    this->Passed = left;
  }

  /// Note where rays first see anything.
  HWY_INLINE void NoteFirst(M isSeen, V at) const
  {
    const Floats d;
    const M isFirst = hn::And(isSeen, hn::Gt(this->Passed, hn::Set(d, 0.9999f)));
    if (hn::AllFalse(d, isFirst))
    {
      return;
    }
    float distances[WidestVector];
    std::int32_t rays[WidestVector];
    std::uint8_t bits[8] = {};
    hn::StoreU(hn::Add(this->Enter, hn::Mul(at, this->Length)), d, distances);
    hn::StoreU(this->Ray, Integers(), rays);
    hn::StoreMaskBits(d, isFirst, bits);
    for (std::uint32_t left = bits[0] | static_cast<std::uint32_t>(bits[1]) << 8; left != 0;
         left &= left - 1)
    {
      const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      double& first = this->Seen.First[static_cast<std::size_t>(rays[lane])];
      first = std::min(first, static_cast<double>(distances[lane]));
    }
  }

  HWY_INLINE V OpacityAt(const LineGradients& gradients, V share) const
  {
    const Floats d;
    const GradientTable& table = this->Volume.ByGradient;
    if (table.Opacities.empty())
    {
      return hn::Set(d, 1.0f);
    }
    V gradient[3];
    gradients.At(share, gradient);
    V square = hn::Zero(d);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V scaled = hn::Mul(gradient[a], hn::Set(d, this->Volume.PerStep[static_cast<int>(a)]));
      square = hn::Add(square, hn::Mul(scaled, scaled));
    }
    return OpacityOf(table, hn::Sqrt(square));
  }

  const EmittingVolume& Volume;
  BlendedRays& Seen;
  std::size_t Count;
  M IsSegment; ///< what lies behind something opaque is none
  I Ray;
  V Enter, Length, Middle, Span, Bend;
  Line Values;
  V ValueAtEnd;
  EmissionAt AtBegin, AtEnd;
  V Passed, Color[3], Direction[3], Eye[3], Begin[3], Across[3];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
