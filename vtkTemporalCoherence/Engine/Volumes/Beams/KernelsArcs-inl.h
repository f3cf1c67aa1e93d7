// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Where the values of a field pass from one arc of a transfer function to the next. Kernels include
// this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsArcs_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsArcs_inl_h
#undef TemporalCoherence_KernelsArcs_inl_h
#else
#define TemporalCoherence_KernelsArcs_inl_h
#endif

#include "Volumes/Beams/EmissionArcs.h"
#include "Volumes/Medium/KernelsCubic-inl.h"
#include "Volumes/Medium/KernelsVectors-inl.h"

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// An arc for each lane.
class Arcs
{
public:
  /// \param numbers of the arcs
  HWY_INLINE Arcs(const EmissionArcs& all, V numbers)
    : All(all)
    , Numbers(hn::ConvertTo(Integers(), numbers))
    , InVector(hn::IndicesFromVec(Floats(),
        hn::And(
          this->Numbers, hn::Set(Integers(), static_cast<std::int32_t>(hn::Lanes(Floats()) - 1)))))
    , IsInSecond(hn::Ge(numbers, hn::Set(Floats(), static_cast<float>(hn::Lanes(Floats())))))
  {
  }

  HWY_INLINE M AreEmpty() const
  {
    return hn::Gt(this->Pick(this->All.AreEmpty), hn::Zero(Floats()));
  }
  HWY_INLINE V Low() const { return this->Pick(this->All.Low); }
  HWY_INLINE V High() const { return this->Pick(this->All.High); }
  HWY_INLINE V Precision() const { return this->Pick(this->All.Precision); }

  /// The argument of the polynomials, in [-1, 1], for values in the arcs.
  HWY_INLINE V PlaceOf(V value) const
  {
    const Floats d;
    const V place =
      hn::Mul(hn::Sub(value, this->Pick(this->All.Middle)), this->Pick(this->All.PerValue));
    return hn::Min(hn::Max(place, hn::Set(d, -1.0f)), hn::Set(d, 1.0f));
  }

  /// Extinction or a colour at some places.
  template <std::size_t Count>
  HWY_INLINE void ChannelAt(std::size_t channel, const V (&places)[Count], V (&found)[Count]) const
  {
    const V third = this->Pick(this->All.Powers[channel][3]);
    const V second = this->Pick(this->All.Powers[channel][2]);
    const V first = this->Pick(this->All.Powers[channel][1]);
    const V constant = this->Pick(this->All.Powers[channel][0]);
    for (std::size_t i = 0; i < Count; ++i)
    {
      const V x = places[i];
      const V sum = hn::Add(hn::Mul(hn::Add(hn::Mul(third, x), second), x), first);
      found[i] = hn::Max(hn::Add(hn::Mul(sum, x), constant), hn::Zero(Floats()));
    }
  }

private:
  /// Look up a column at the arc of each lane. For most functions, one or two vectors hold all
  /// arcs.
  HWY_INLINE V Pick(const EmissionArcs::Column& column) const
  {
    const Floats d;
    const std::size_t lanes = hn::Lanes(d);
    const float* const from = column.data();
    if (this->All.Count > 2 * lanes)
    {
      return hn::GatherIndex(d, from, this->Numbers);
    }
    const V first = hn::TableLookupLanes(hn::LoadU(d, from), this->InVector);
    if (this->All.Count <= lanes)
    {
      return first;
    }
    const V second = hn::TableLookupLanes(hn::LoadU(d, from + lanes), this->InVector);
    return hn::IfThenElse(this->IsInSecond, second, first);
  }

  const EmissionArcs& All;
  I Numbers;
  decltype(hn::IndicesFromVec(Floats(), I())) InVector;
  M IsInSecond;
};

using CubicTurns = Cubics::HWY_NAMESPACE::Turns<V>;

/// Tells in which monotone piece a cubic first leaves its arc: the piece up to the first turning
/// point, up to the second one, or any piece.
struct Leaving
{
  /// \param begin share at which the cubics lie in their arcs
  HWY_INLINE Leaving(const CubicTurns& turns, const Arcs& arcs, V begin)
  {
    const V low = arcs.Low(), high = arcs.High();
    const auto isOutside = [&](V value) HWY_ATTR
    { return hn::Or(hn::Lt(value, low), hn::Gt(value, high)); };
    this->BeforeFirst = hn::And(hn::Lt(begin, turns.First), isOutside(turns.AtFirst));
    this->BeforeSecond = hn::AndNot(
      this->BeforeFirst, hn::And(hn::Lt(begin, turns.Second), isOutside(turns.AtSecond)));
    this->Ever = hn::Or(hn::Or(this->BeforeFirst, this->BeforeSecond), isOutside(turns.AtEnd));
  }

  M BeforeFirst, BeforeSecond, Ever;
};

/// Where cubics leave their arcs.
struct ArcEnd
{
  /// \param begin share at which the cubics lie in their arcs
  /// \param number of the arcs
  HWY_INLINE ArcEnd(
    const CubicTurns::Line& cubic, const CubicTurns& turns, const Arcs& arcs, V begin, V number)
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Leaving leaving(turns, arcs, begin);
    const auto choose = [&](V first, V second, V last) HWY_ATTR
    {
      return hn::IfThenElse(
        leaving.BeforeFirst, first, hn::IfThenElse(leaving.BeforeSecond, second, last));
    };
    // The cubic is monotone from left to right.
    V left = hn::Max(begin, choose(zero, turns.First, turns.Second));
    V right = choose(turns.First, turns.Second, one);
    const V last = choose(turns.AtFirst, turns.AtSecond, turns.AtEnd);
    const M isRising = hn::Gt(last, arcs.High());
    const V wanted = hn::IfThenElse(isRising, arcs.High(), arcs.Low());
    const auto ratio = [&](V of, V by) HWY_ATTR
    {
      const M isAny = hn::And(leaving.Ever, hn::Gt(hn::Abs(by), hn::Set(d, 1e-20f)));
      return hn::Div(hn::IfThenElseZero(isAny, of), hn::IfThenElse(isAny, by, one));
    };
    // Start with the secant, then take Newton steps within the bracket.
    const V from = cubic.At(left);
    const V share = ratio(hn::Sub(wanted, from), hn::Sub(last, from));
    V at = hn::Add(left, hn::Mul(hn::Min(hn::Max(share, zero), one), hn::Sub(right, left)));
    const V precision = arcs.Precision();
    for (int step = 0; step < MostNewtonSteps; ++step)
    {
      const V off = hn::IfThenElseZero(leaving.Ever, hn::Sub(cubic.At(at), wanted));
      const M isFound = hn::Le(hn::Abs(off), precision);
      if (hn::AllTrue(d, isFound))
      {
        break;
      }
      const M isBefore = hn::Xor(hn::Lt(off, zero), hn::Not(isRising));
      left = hn::IfThenElse(isBefore, at, left);
      right = hn::IfThenElse(isBefore, right, at);
      const V next = hn::Sub(at, ratio(off, cubic.SlopeAt(at)));
      at = hn::IfThenElse(isFound, at, hn::Min(hn::Max(next, left), right));
    }
    this->Share = hn::IfThenElse(leaving.Ever, at, one);
    const V other = hn::IfThenElse(isRising, one, hn::Set(d, -1.0f));
    this->Next = hn::Add(number, hn::IfThenElseZero(leaving.Ever, other));
  }

  V Share; ///< of the path at the end of the arc, or 1
  V Next;  ///< number of the next arc

private:
  static constexpr int MostNewtonSteps = 6;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
