// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Ranges of cubics, in vectors. Kernels include this file once for each kind of vectors, hence the
// toggling guard.
#if defined(TemporalCoherence_KernelsRange_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsRange_inl_h
#undef TemporalCoherence_KernelsRange_inl_h
#else
#define TemporalCoherence_KernelsRange_inl_h
#endif

#include "Lattice/KernelsSegment-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Evaluate of CellRoot.h.
template <class V>
HWY_INLINE V EvaluateAt(const V b[4], V s)
{
  const V q0 = Mix(b[0], b[1], s), q1 = Mix(b[1], b[2], s), q2 = Mix(b[2], b[3], s);
  return Mix(Mix(q0, q1, s), Mix(q1, q2, s), s);
}

/// Widen ranges, in the lanes of `live`, by the values at the turning points of the cubics:
/// TurningPoints of CellRoot.h.
template <class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_INLINE void WidenByTurns(D d, const V b[4], M live, V& lowest, V& highest)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1);
  V d0 = hn::Sub(b[1], b[0]), d1 = hn::Sub(b[2], b[1]), d2 = hn::Sub(b[3], b[2]);
  // Scaled by the largest, so that squares neither overflow nor vanish.
  const V largest = hn::Max(hn::Abs(d0), hn::Max(hn::Abs(d1), hn::Abs(d2)));
  const V unit = hn::IfThenElse(hn::Gt(largest, zero), largest, one);
  d0 = hn::Div(d0, unit);
  d1 = hn::Div(d1, unit);
  d2 = hn::Div(d2, unit);
  const V halfB = hn::Sub(d1, d0), a = hn::Sub(hn::Sub(d2, d1), halfB);
  const V discriminant = hn::Sub(hn::Mul(halfB, halfB), hn::Mul(a, d0));
  const M turns = hn::And(live, hn::Gt(discriminant, zero));
  const V root = hn::Sqrt(hn::IfThenElse(turns, discriminant, zero));
  const V q = hn::Neg(hn::Add(halfB, hn::CopySign(root, halfB)));
  const V numerators[2] = { d0, q }, denominators[2] = { q, a };
  for (int i = 0; i < 2; ++i)
  {
    const M isPoint = hn::And(turns, hn::Ne(denominators[i], zero));
    const V s = hn::Div(numerators[i], hn::IfThenElse(isPoint, denominators[i], one));
    const M isWithin = hn::And(isPoint, hn::And(hn::Gt(s, zero), hn::Lt(s, one)));
    const V value = EvaluateAt(b, hn::IfThenElse(isWithin, s, zero));
    lowest = hn::IfThenElse(isWithin, hn::Min(lowest, value), lowest);
    highest = hn::IfThenElse(isWithin, hn::Max(highest, value), highest);
  }
}

/// RangeOf of CellRoot.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void RangesOf(D d, const V b[4], V& lowest, V& highest)
{
  lowest = hn::Min(b[0], b[3]);
  highest = hn::Max(b[0], b[3]);
  // A cubic lies within the range of its coefficients: it exceeds the range of its ends only if an
  // inner coefficient does.
  const auto isBeyond =
    hn::Or(hn::Gt(hn::Max(b[1], b[2]), highest), hn::Lt(hn::Min(b[1], b[2]), lowest));
  if (!hn::AllFalse(d, isBeyond))
  {
    WidenByTurns(d, b, isBeyond, lowest, highest);
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
