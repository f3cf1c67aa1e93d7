// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/KernelsEmission.h"

#include <cstddef>
#include <cstdint>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Blending/KernelsEmission.cxx"
#include <hwy/foreach_target.h>

#include "Blending/KernelsCellSamples-inl.h"
#include "Blending/KernelsEmittingSegments-inl.h"
#include "Blending/KernelsVectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Add the segments of a vector. Not for each type of samples again.
HWY_NOINLINE void AddVector(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, std::size_t begin, std::size_t end,
  const CornerGradients& gradients, BlendedRays& seen)
{
  SegmentVector vector(volume, rays, segments, begin, end - begin, seen);
  vector.Add(gradients);
  vector.Finish();
}

/// \param loaderAt makes what loads the samples around the cells of a vector
template <typename LoaderAt>
HWY_INLINE void AddAll(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, const LoaderAt& loaderAt, BlendedRays& seen)
{
  for (std::size_t i = 0, end = 0; i < static_cast<std::size_t>(segments.Count); i = end)
  {
    end = segments.EndOfVector(i, hn::Lanes(Floats()));
    const CornerGradients gradients =
      volume.HasGradients() ? CornerGradients(loaderAt(i, end)) : CornerGradients();
    AddVector(volume, rays, segments, i, end, gradients, seen);
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
