// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hits in the coordinates of a mesh, in vectors of hits.

#include "Mesh/Tracing/KernelsHitPlaces.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tracing/KernelsHitPlaces.cxx"
#include <hwy/foreach_target.h>

#include "Shade/KernelsHitPoints-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

void FindPlaces(const HitRays& rays, const glm::dmat4& indexFromWorld, const glm::dvec3& low,
  double scale, MeshKernels::PointsInCells::Vectors& places)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  for (std::size_t i = 0; i < rays.Count; i += hn::Lanes(d))
  {
    hn::Vec<decltype(d)> index[3];
    HitPoints::HWY_NAMESPACE::Find(d, rays, indexFromWorld, i, index);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto first = hn::Set(d, low[static_cast<int>(a)]);
      hn::Store(hn::Add(first, hn::Mul(hn::Set(d, scale), index[a])), d, &places[a][i]);
    }
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindPlaces);

void FindHitPlaces(const HitRays& rays, const glm::dmat4& indexFromWorld, const glm::dvec3& low,
  double scale, MeshKernels::PointsInCells::Vectors& places)
{
  HWY_DYNAMIC_DISPATCH(FindPlaces)(rays, indexFromWorld, low, scale, places);
}

}
#endif
