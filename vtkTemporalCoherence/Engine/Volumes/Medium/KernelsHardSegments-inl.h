// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Segments for which one step is not enough. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsHardSegments_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsHardSegments_inl_h
#undef TemporalCoherence_KernelsHardSegments_inl_h
#else
#define TemporalCoherence_KernelsHardSegments_inl_h
#endif

#include "Volumes/Medium/KernelsEmittingSegments-inl.h"
#include "Volumes/Medium/KernelsLaneWork-inl.h"
#include "Volumes/Medium/KernelsSteps-inl.h"

#include <algorithm>
#include <array>
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

/// Segments that need several steps.
template <std::size_t Colors>
class HardSegments
{
public:
  /// Append some lanes of a vector.
  /// \param first segment of the vector
  HWY_INLINE void Append(M which, std::size_t first, EmittingSegments<Colors>& segments)
  {
    const Floats d;
    const Integers di;
    const auto numbers = hn::Iota(di, static_cast<std::int32_t>(first));
    hn::StoreU(hn::Compress(numbers, hn::RebindMask(di, which)), di, &this->Number[this->Count]);
    std::size_t column = 0;
    segments.EachColumn([&](V value) HWY_ATTR
      { hn::StoreU(hn::Compress(value, which), d, &this->Columns[column++][this->Count]); });
    this->Count += hn::CountTrue(d, which);
  }

  HWY_INLINE void Load(std::size_t first, EmittingSegments<Colors>& segments) const
  {
    std::size_t column = 0;
    segments.EachColumn(
      [&](V& value) HWY_ATTR { value = hn::LoadU(Floats(), &this->Columns[column++][first]); });
  }

  /// Drop segments for which one step is enough, as little of their light reaches the viewer.
  HWY_INLINE void KeepHard()
  {
    const Floats d;
    const Integers di;
    this->FillLastVector();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Count; i += hn::Lanes(d))
    {
      EmittingSegments<Colors> segments;
      this->Load(i, segments);
      const V shown = hn::LoadU(d, &this->Shown[i]);
      const auto number = hn::LoadU(di, &this->Number[i]);
      const M isHard = hn::And(hn::Gt(shown, hn::Set(d, LeastPassed)), segments.IsHard(shown));
      std::size_t column = 0;
      segments.EachColumn([&](V value) HWY_ATTR
        { hn::StoreU(hn::Compress(value, isHard), d, &this->Columns[column++][kept]); });
      hn::StoreU(hn::Compress(shown, isHard), d, &this->Shown[kept]);
      hn::StoreU(hn::Compress(number, hn::RebindMask(di, isHard)), di, &this->Number[kept]);
      kept += hn::CountTrue(d, isHard);
    }
    this->Count = kept;
  }

  /// Zero the unused lanes of the last vector.
  void FillLastVector()
  {
    std::fill_n(&this->Number[this->Count], WidestVector, 0);
    std::fill_n(&this->Shown[this->Count], WidestVector, 0.0f);
    for (auto& column : this->Columns)
    {
      std::fill_n(&column[this->Count], WidestVector, 0.0f);
    }
  }

  template <typename T>
  using Array = VolumeSegments::Array<T>;

  std::size_t Count = 0;
  Array<std::int32_t> Number; ///< index in the list of all segments
  Array<float> Shown;         ///< transmittance in front of the segment
  std::array<Array<float>, EmittingSegments<Colors>::Columns> Columns;
};

/// Survey a vector of segments, and integrate each in one step. Append hard segments, which need
/// more steps, to a list.
/// \param shown transmittance in front of the segments, at most
template <std::size_t Colors>
HWY_NOINLINE void AddInOneStep(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, std::size_t first, const CornerGradients& corners, V shown,
  HardSegments<Colors>& hard, SegmentSums& sums)
{
  const Floats d;
  EmittingSegments<Colors> found;
  SegmentSurvey(volume, rays, segments).Find(first, corners, found);
  const Steps<Colors> steps(volume, found);
  const Step whole = steps.Whole();
  V mean[4];
  const V depth = steps.DepthOf(whole, mean);
  const M isSegment = hn::FirstN(d, static_cast<std::size_t>(segments.Count) - first);
  V& ofDepth = found.Needs[found.ForDepth];
  ofDepth = hn::Max(ofDepth, hn::Mul(depth, hn::Set(d, 1.0f / DepthOfStep)));
  const M isHard = hn::And(isSegment, found.IsHard(shown));
  if (!hn::AllFalse(d, isHard))
  {
    hard.Append(isHard, first, found);
  }
  AddedLight added;
  steps.Add(
    whole, hn::Mul(depth, whole.Opacity), mean,
    [&](V at, V) HWY_ATTR { return found.Light.Of(at); }, added);
  hn::StoreU(added.Passed, d, &sums.Passed[first]);
  for (std::size_t a = 0; a < 3; ++a)
  {
    hn::StoreU(added.Color[a], d, &sums.Color[a][first]);
  }
  hn::StoreU(added.FirstIn(found.Enter, found.Length), d, &sums.First[first]);
}

/// Integrates hard segments again, in several steps. Numbers of steps vary widely, so idle lanes of
/// a vector get other segments.
template <std::size_t Colors>
class HardSteps
{
public:
  HardSteps(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& all,
    const HardSegments<Colors>& hard, SegmentSums& sums)
    : Volume(volume)
    , Rays(rays)
    , All(all)
    , Hard(hard)
    , Sums(sums)
  {
    this->Segments.EachColumn([](V& value) HWY_ATTR { value = hn::Zero(Floats()); });
  }

  HWY_INLINE void AddAll()
  {
    WorkThrough([&]() HWY_ATTR { return this->Walk.IsOn; },
      [&]() { return this->Next < this->Hard.Count; }, [&]() HWY_ATTR { this->Refill(); },
      [&]() HWY_ATTR { this->AddNext(); });
    this->StoreDone();
  }

private:
  HWY_INLINE void AddNext()
  {
    const Floats d;
    const M isSmooth = this->Segments.IsSmooth(this->Walk.Shown);
    Steps<Colors>(this->Volume, this->Segments)
      .AddNext(
        isSmooth,
        [&](V at, V spread) HWY_ATTR
        {
          ReflectedLight<V, Colors> light = this->Segments.Light.Of(at);
          if (!hn::AllTrue(d, hn::Or(isSmooth, hn::Not(this->Walk.IsOn))))
          {
            this->TakeExact(hn::Not(isSmooth), at, spread, light);
          }
          return light;
        },
        this->Walk);
  }

  /// Take the mean light of two places around `at`.
  HWY_INLINE void TakeExact(M which, V at, V spread, ReflectedLight<V, Colors>& light) const
  {
    const Floats d;
    ReflectedLight<V, Colors> pair[2];
    const V shares[2] = { hn::Sub(at, spread), hn::Add(at, spread) };
    V normals[2][3];
    LightAt<Colors>(this->Volume, this->Vectors, this->Segments, shares, normals, pair);
    const auto take = [&](V first, V second, V& of) HWY_ATTR
    { of = hn::IfThenElse(which, hn::Mul(hn::Set(d, 0.5f), hn::Add(first, second)), of); };
    for (std::size_t a = 0; a < Colors; ++a)
    {
      take(pair[0].Matt[a], pair[1].Matt[a], light.Matt[a]);
      take(pair[0].Shine[a], pair[1].Shine[a], light.Shine[a]);
    }
  }

  /// Give the next segments to idle lanes.
  HWY_NOINLINE void Refill()
  {
    this->StoreDone();
    const std::int32_t* const numbers = &this->Hard.Number[this->Next];
    const LaneWork::Taken taken = this->Work.Take(numbers, this->Hard.Count - this->Next,
      [&](std::size_t i) { return this->All.Ray[static_cast<std::size_t>(numbers[i])]; });
    std::size_t column = 0;
    this->Segments.EachColumn([&](V& value) HWY_ATTR
      { value = taken.Load(&this->Hard.Columns[column++][this->Next], value); });
    const V shown = taken.Load(&this->Hard.Shown[this->Next], this->Walk.Shown);
    this->Vectors = RayVectors(this->Volume, this->Rays, this->Work.Rays());
    this->Next += taken.Count;
    Steps<Colors>(this->Volume, this->Segments).Begin(taken.Which, shown, this->Walk);
  }

  HWY_INLINE void StoreDone()
  {
    this->Work.Finish(
      this->Walk.IsOn, this->Walk.Added, this->Segments.Enter, this->Segments.Length, this->Sums);
  }

  const EmittingVolume& Volume;
  const LitRays& Rays;
  const VolumeSegments& All;
  const HardSegments<Colors>& Hard;
  SegmentSums& Sums;
  std::size_t Next = 0;
  LaneWork Work;
  EmittingSegments<Colors> Segments;
  RayVectors Vectors;
  StepWalk Walk;
};

/// Integrate hard segments again, given the transmittance in front of them.
template <std::size_t Colors>
HWY_NOINLINE void AddHard(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, HardSegments<Colors>& hard, SegmentSums& sums)
{
  hard.FillLastVector();
  HardSteps<Colors>(volume, rays, segments, hard, sums).AddAll();
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
