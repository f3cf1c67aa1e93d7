// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/KernelsEmission.h"

#include <algorithm>
#include <cmath>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Blending/KernelsEmission.cxx"
#include <hwy/foreach_target.h>

#include "Blending/KernelsCellSamples-inl.h"
#include "Blending/KernelsCubic-inl.h"
#include "Blending/KernelsLight-inl.h"
#include "Blending/KernelsStretch-inl.h"
#include "Blending/KernelsVectors-inl.h"

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
constexpr float DepthTolerance = 1.0f / 1024.0f;

/// The square of the steps for each unit by which light, or a gradient opacity, is off a straight
/// line, and by which a normal turns (1 - the cosine), as far as it is seen.
constexpr float StepsOfBend = 1600.0f, StepsOfOpacity = 4096.0f, StepsOfTurn = 2048.0f;

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

  /// \param gradients of the cells, if the volume has any
  HWY_INLINE void Add(const CornerGradients& gradients)
  {
    const Floats d;
    const V zero = hn::Zero(d);
    V mean[4];
    MeanBetween(this->Volume.Tables, this->Values.C[0], this->AtBegin, this->ValueAtEnd,
      this->AtEnd, zero, mean);
    const V depth = hn::Mul(mean[0], this->Length);
    const V seen =
      hn::IfThenElseZero(this->IsSegment, hn::Mul(this->Passed, hn::Min(depth, hn::Set(d, 1.0f))));
    V square = this->SquareOfSteps(depth);
    if (!this->Volume.ByGradient.Opacities.empty())
    {
      square = hn::Add(square, hn::Mul(seen, this->OpacityBend(gradients)));
    }
    if (!this->Volume.Lights)
    {
      this->AddSteps(square, gradients, [](V, V) HWY_ATTR { return Unlit(); });
      return;
    }
    V normals[3][3];
    const LightParabola light(this->LightAt(gradients, zero, normals[0]),
      this->LightAt(gradients, hn::Set(d, 0.5f), normals[1]),
      this->LightAt(gradients, hn::Set(d, 1.0f), normals[2]));
    // Two measures, as each is blind for some turns of normals between these places.
    const V turn =
      hn::Sub(hn::Set(d, 1.0f), hn::Min(Dot(normals[0], normals[1]), Dot(normals[1], normals[2])));
    const V ofLight = hn::Mul(seen,
      hn::Max(hn::Mul(light.Off, hn::Set(d, StepsOfBend)), hn::Mul(turn, hn::Set(d, StepsOfTurn))));
    const M isSmooth = hn::Le(ofLight, hn::Set(d, MostOfParabola));
    this->AddSteps(hn::Add(square, hn::IfThenElseZero(hn::Not(isSmooth), ofLight)), gradients,
      [&](V at, V spread) HWY_ATTR
      {
        ReflectedLight<V> found = light.At(at, spread);
        if (!hn::AllTrue(d, isSmooth))
        {
          V ignored[3];
          const ReflectedLight<V> exact = this->LightAt(gradients, at, ignored);
          for (std::size_t a = 0; a < 3; ++a)
          {
            found.Matt[a] = hn::IfThenElse(isSmooth, found.Matt[a], exact.Matt[a]);
            found.Shine[a] = hn::IfThenElse(isSmooth, found.Shine[a], exact.Shine[a]);
          }
        }
        return found;
      });
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
  /// The square of the steps that the field and the transfer function ask for.
  HWY_INLINE V SquareOfSteps(V depth) const
  {
    const Floats d;
    // What a straight line misses falls with the square of the steps.
    const V off =
      hn::Mul(this->SteepnessOf(this->Volume.Tables), hn::Mul(this->Bend, this->Length));
    const V steps = hn::Mul(hn::Mul(depth, this->Passed), hn::Set(d, 1.0f / DepthOfStep));
    return hn::Max(hn::Mul(hn::Mul(off, this->Passed), hn::Set(d, 1.0f / DepthTolerance)),
      hn::Mul(steps, steps));
  }

  /// The square of the steps that gradient opacities ask for, where all is seen of a segment.
  HWY_INLINE V OpacityBend(const CornerGradients& gradients) const
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
  template <typename LightAt>
  HWY_INLINE void AddSteps(V square, const CornerGradients& gradients, const LightAt& lightAt)
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
        this->AddStep(at, depth, mean, lightAt(at, spread));
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

  static HWY_INLINE ReflectedLight<V> Unlit()
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    return { { one, one, one }, { zero, zero, zero } };
  }

  HWY_INLINE void PlaceAt(V share, V place[3]) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      place[a] = hn::Add(this->Begin[a], hn::Mul(share, this->Across[a]));
    }
  }

  /// \param normal there, of unit length
  HWY_INLINE ReflectedLight<V> LightAt(const CornerGradients& gradients, V share, V normal[3]) const
  {
    V place[3], gradient[3], point[3];
    this->PlaceAt(share, place);
    gradients.At(place, gradient);
    FindNormals(this->Volume.WorldFromGradient, gradient, normal);
    const V t = hn::Add(this->Enter, hn::Mul(share, this->Length));
    for (std::size_t a = 0; a < 3; ++a)
    {
      point[a] = hn::Add(this->Eye[a], hn::Mul(t, this->Direction[a]));
    }
    return Reflect<V>(*this->Volume.Lights, { normal, this->Direction, point });
  }

  /// Composite a step behind what has been seen.
  HWY_INLINE void AddStep(V at, V depth, const V mean[4], const ReflectedLight<V>& light)
  {
    const Floats d;
    const V zero = hn::Zero(d);
    const V left = hn::Mul(this->Passed, ExpOfMinus(depth));
    const V perMean = hn::Div(hn::Sub(this->Passed, left), hn::Max(mean[0], hn::Set(d, 1e-30f)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V lit = hn::Add(hn::Mul(mean[a + 1], light.Matt[a]), hn::Mul(mean[0], light.Shine[a]));
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

  HWY_INLINE V OpacityAt(const CornerGradients& gradients, V share) const
  {
    const Floats d;
    const GradientTable& table = this->Volume.ByGradient;
    if (table.Opacities.empty())
    {
      return hn::Set(d, 1.0f);
    }
    V place[3], gradient[3];
    this->PlaceAt(share, place);
    gradients.At(place, gradient);
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

/// \param loaderAt makes what loads the samples around the cells of a vector
template <typename LoaderAt>
HWY_INLINE void AddAll(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, const LoaderAt& loaderAt, BlendedRays& seen)
{
  for (std::size_t i = 0, end = 0; i < static_cast<std::size_t>(segments.Count); i = end)
  {
    end = segments.EndOfVector(i, hn::Lanes(Floats()));
    SegmentVector vector(volume, rays, segments, i, end - i, seen);
    vector.Add(volume.HasGradients() ? CornerGradients(loaderAt(i, end)) : CornerGradients());
    vector.Finish();
  }
}

void AddOfValues(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const SamplesAround& around, BlendedRays& seen)
{
  AddAll(
    volume, rays, segments,
    [&](std::size_t i, std::size_t) HWY_ATTR {
      return ArrayLoader{ around, i };
    },
    seen);
}

template <typename T>
HWY_INLINE void AddOfSamples(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, const NarrowSamples<T>& samples, float perValue,
  BlendedRays& seen)
{
  AddAll(
    volume, rays, segments,
    [&](std::size_t i, std::size_t end) HWY_ATTR
    { return RowLoader<T>(samples, segments, i, end, perValue); },
    seen);
}

void AddOfUInt8(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint8_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

void AddOfInt8(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int8_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

void AddOfUInt16(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint16_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

void AddOfInt16(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int16_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace EmissionKernels
{

HWY_EXPORT(AddOfValues);
HWY_EXPORT(AddOfUInt8);
HWY_EXPORT(AddOfInt8);
HWY_EXPORT(AddOfUInt16);
HWY_EXPORT(AddOfInt16);

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const SamplesAround& around, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfValues)(volume, rays, segments, around, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint8_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfUInt8)(volume, rays, segments, samples, perValue, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int8_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfInt8)(volume, rays, segments, samples, perValue, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint16_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfUInt16)(volume, rays, segments, samples, perValue, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int16_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfInt16)(volume, rays, segments, samples, perValue, seen);
}

}
}
#endif
