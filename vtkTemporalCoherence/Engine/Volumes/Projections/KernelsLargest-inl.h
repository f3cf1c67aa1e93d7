// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The largest values of cubics, in vectors. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsLargest_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLargest_inl_h
#undef TemporalCoherence_KernelsLargest_inl_h
#else
#define TemporalCoherence_KernelsLargest_inl_h
#endif

#include "Lattice/KernelsRange-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// LargestOf of ExtremeSearch.cxx: the largest values of cubics on [0, 1], and their first shares.
/// \param most the largest coefficients
template <class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_INLINE void LargestOf(D d, const V b[4], V most, V& value, V& share)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1);
  value = b[0];
  share = zero;
  const M mayTurn = hn::Gt(hn::Max(b[1], b[2]), hn::Max(b[0], b[3]));
  if (!hn::AllFalse(d, mayTurn))
  {
    V d0 = hn::Sub(b[1], b[0]), d1 = hn::Sub(b[2], b[1]), d2 = hn::Sub(b[3], b[2]);
    const V largest = hn::Max(hn::Abs(d0), hn::Max(hn::Abs(d1), hn::Abs(d2)));
    const V unit = hn::IfThenElse(hn::Gt(largest, zero), largest, one);
    d0 = hn::Div(d0, unit);
    d1 = hn::Div(d1, unit);
    d2 = hn::Div(d2, unit);
    const V halfB = hn::Sub(d1, d0), a = hn::Sub(hn::Sub(d2, d1), halfB);
    const V discriminant = hn::Sub(hn::Mul(halfB, halfB), hn::Mul(a, d0));
    const M turns = hn::And(mayTurn, hn::Gt(discriminant, zero));
    const V root = hn::Sqrt(hn::IfThenElse(turns, discriminant, zero));
    const V q = hn::Neg(hn::Add(halfB, hn::CopySign(root, halfB)));
    const V numerators[2] = { d0, q }, denominators[2] = { q, a };
    for (int i = 0; i < 2; ++i)
    {
      const M isPoint = hn::And(turns, hn::Ne(denominators[i], zero));
      const V s = hn::Div(numerators[i], hn::IfThenElse(isPoint, denominators[i], one));
      const M isWithin = hn::And(isPoint, hn::And(hn::Gt(s, zero), hn::Lt(s, one)));
      const V at = hn::Min(
        SegmentKernels::HWY_NAMESPACE::EvaluateAt(b, hn::IfThenElse(isWithin, s, zero)), most);
      const M isFirst = hn::And(hn::Eq(at, value), hn::Lt(s, share));
      const M isMore = hn::And(isWithin, hn::Or(hn::Gt(at, value), isFirst));
      value = hn::IfThenElse(isMore, at, value);
      share = hn::IfThenElse(isMore, s, share);
    }
  }
  const M isAtEnd = hn::Gt(b[3], value);
  value = hn::IfThenElse(isAtEnd, b[3], value);
  share = hn::IfThenElse(isAtEnd, one, share);
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
