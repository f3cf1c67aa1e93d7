// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/KernelsPlanes.h"

#include "Scene/Disparity.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Scene/KernelsPlanes.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace PlaneKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, TileSize>;

/// Rounded to single precision; infinity stays infinity.
HWY_INLINE hn::Vec<hn::Rebind<float, Doubles>> AsFloats(hn::Vec<Doubles> values)
{
  const hn::Rebind<float, Doubles> df;
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(df, static_cast<float>(hn::GetLane(values)));
#else
  return hn::DemoteTo(df, values);
#endif
}

/// Write the disparities of a row of distances.
HWY_INLINE void StoreDisparities(
  const double* perDepth, const double* distances, bool isParallel, float* plane)
{
  const Doubles d;
  const hn::Rebind<float, Doubles> df;
  for (std::size_t i = 0; i < TileSize; i += hn::Lanes(d))
  {
    const auto per = hn::LoadU(d, perDepth + i), t = hn::LoadU(d, distances + i);
    const auto disparity = isParallel
      ? hn::Max(hn::Div(hn::Neg(t), per), hn::Set(d, DisparityOfMiss(true)))
      : hn::Div(per, t);
    hn::StoreU(AsFloats(disparity), df, plane + i);
  }
}

/// Write the kinds of a row of hits.
HWY_INLINE void StoreKinds(const HitKind* kinds, const std::uint8_t* fromInside, HitKind* plane)
{
  const hn::CappedTag<std::uint8_t, TileSize> d;
  const auto zero = hn::Zero(d);
  for (std::size_t i = 0; i < TileSize; i += hn::Lanes(d))
  {
    const auto kind = hn::LoadU(d, reinterpret_cast<const std::uint8_t*>(kinds + i));
    const auto isNone = hn::Eq(kind, hn::Set(d, static_cast<std::uint8_t>(HitKind::None)));
    const auto isInside = hn::Ne(hn::LoadU(d, fromInside + i), zero);
    const auto within = hn::Set(d, static_cast<std::uint8_t>(HitKind::Within));
    hn::StoreU(hn::IfThenElse(hn::And(isNone, isInside), within, kind), d,
      reinterpret_cast<std::uint8_t*>(plane + i));
  }
}

/// Copy a row.
template <typename T>
HWY_INLINE void StoreRow(const T* from, T* plane)
{
  const hn::CappedTag<T, TileSize> d;
  for (std::size_t i = 0; i < TileSize; i += hn::Lanes(d))
  {
    hn::StoreU(hn::LoadU(d, from + i), d, plane + i);
  }
}

void Store(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame)
{
  for (std::size_t row = 0; row < RayBatch::Capacity; row += TileSize)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[row]);
    StoreRow(&hits.Depth[row], &frame.Depth[pixel]);
    StoreDisparities(&rays.PerDepth[row], &hits.Depth[row], isParallel, &frame.Disparities[pixel]);
    StoreDisparities(
      &rays.PerDepth[row], &hits.FirstEntry[row], isParallel, &frame.FirstEntries[pixel]);
    StoreRow(&hits.Surface[row], &frame.Isovalues[pixel]);
    StoreKinds(&hits.Kind[row], &hits.FromInside[row], &frame.Kinds[pixel]);
    StoreRow(reinterpret_cast<const std::uint8_t*>(&answers[row]),
      reinterpret_cast<std::uint8_t*>(&frame.Answers[pixel]));
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace PlaneKernels
{
HWY_EXPORT(Store);
}

void StoreRows(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame)
{
  using namespace PlaneKernels;
  HWY_DYNAMIC_DISPATCH(Store)(rays, hits, answers, isParallel, frame);
}

}
#endif
