// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hits in index space, in vectors. Kernels include this file once for each kind of vectors, hence
// the toggling guard.
#if defined(TemporalCoherence_KernelsHitPoints_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsHitPoints_inl_h
#undef TemporalCoherence_KernelsHitPoints_inl_h
#else
#define TemporalCoherence_KernelsHitPoints_inl_h
#endif

#include "Scene/HitRays.h"

#include <glm/glm.hpp>

#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HitPoints
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Find the coordinates of hits, from hit i on.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void Find(
  D d, const HitRays& rays, const glm::dmat4& indexFromWorld, std::size_t i, V (&found)[3])
{
  const glm::dmat4& m = indexFromWorld;
  const V t = hn::LoadU(d, &rays.T[i]);
  V point[3];
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V unit = hn::LoadU(d, &(*rays.Direction)[a][i]);
    const V begin =
      rays.AreApart ? hn::LoadU(d, &rays.Begin[a][i]) : hn::Set(d, rays.Eye[static_cast<int>(a)]);
    point[a] = hn::Add(begin, hn::Mul(t, unit));
  }
  for (int a = 0; a < 3; ++a)
  {
    const V inPlane =
      hn::Add(hn::Mul(hn::Set(d, m[0][a]), point[0]), hn::Mul(hn::Set(d, m[1][a]), point[1]));
    found[a] =
      hn::Add(inPlane, hn::Add(hn::Mul(hn::Set(d, m[2][a]), point[2]), hn::Set(d, m[3][a])));
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
