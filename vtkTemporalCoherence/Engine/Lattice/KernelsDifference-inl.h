// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Differences from an isovalue in double, in vectors. Kernels include this file once for each kind
// of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsDifference_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsDifference_inl_h
#undef TemporalCoherence_KernelsDifference_inl_h
#else
#define TemporalCoherence_KernelsDifference_inl_h
#endif

#include "Scene/Difference.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace DifferenceKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Differences of a vector of samples, bit-identical to Difference.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V Differ(D d, const DifferenceInDouble& from, V sample)
{
  const V limit = hn::Set(d, from.Limit), lowest = hn::Set(d, -from.Limit);
  const V inUnits = hn::Mul(sample, hn::Set(d, from.Factor));
  const V difference = hn::Sub(hn::Sub(inUnits, hn::Set(d, from.High)), hn::Set(d, from.Low));
  const V raised = hn::IfThenElse(hn::Gt(difference, lowest), difference, lowest);
  const V clamped = hn::IfThenElse(hn::Lt(raised, limit), raised, limit);
  const auto isBelow = hn::Lt(sample, hn::Set(d, from.Isovalue));
  return hn::IfThenElse(isBelow, hn::Min(clamped, hn::Set(d, -from.Least)), clamped);
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
