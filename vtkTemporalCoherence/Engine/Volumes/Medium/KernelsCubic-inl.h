// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Trilinear functions along lines, in vectors. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsCubic_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCubic_inl_h
#undef TemporalCoherence_KernelsCubic_inl_h
#else
#define TemporalCoherence_KernelsCubic_inl_h
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace Cubics
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A trilinear function along a line through a cell: the sum of C[i] x^i.
template <class V>
struct Cubic
{
  V C[4];

  HWY_INLINE V At(V x) const
  {
    const V first = hn::Add(hn::Mul(this->C[3], x), this->C[2]);
    return hn::Add(hn::Mul(hn::Add(hn::Mul(first, x), this->C[1]), x), this->C[0]);
  }

  HWY_INLINE V SlopeAt(V x) const
  {
    const hn::DFromV<V> d;
    const V bend = hn::Add(
      hn::Mul(hn::Set(d, 2.0f), this->C[2]), hn::Mul(hn::Mul(hn::Set(d, 3.0f), this->C[3]), x));
    return hn::Add(this->C[1], hn::Mul(bend, x));
  }
};

/// \param v      values at the corners of the cell, [x + 2 y + 4 z]
/// \param begin  the point at x = 0, in the coordinates of the cell
/// \param across from there to the point at x = 1
template <class V>
HWY_INLINE Cubic<V> CubicAlong(const V v[8], const V begin[3], const V across[3])
{
  V at[4], slope[4]; // along the four edges in x, by y and z
  for (std::size_t yz = 0; yz < 4; ++yz)
  {
    const V rise = hn::Sub(v[2 * yz + 1], v[2 * yz]);
    at[yz] = hn::Add(v[2 * yz], hn::Mul(begin[0], rise));
    slope[yz] = hn::Mul(across[0], rise);
  }
  V first[2], second[2], third[2];
  for (std::size_t z = 0; z < 2; ++z)
  {
    const V rise = hn::Sub(at[2 * z + 1], at[2 * z]);
    const V bend = hn::Sub(slope[2 * z + 1], slope[2 * z]);
    first[z] = hn::Add(at[2 * z], hn::Mul(begin[1], rise));
    second[z] = hn::Add(hn::Add(slope[2 * z], hn::Mul(begin[1], bend)), hn::Mul(across[1], rise));
    third[z] = hn::Mul(across[1], bend);
  }
  const V rise = hn::Sub(first[1], first[0]), bend = hn::Sub(second[1], second[0]);
  const V twist = hn::Sub(third[1], third[0]);
  Cubic<V> cubic;
  cubic.C[0] = hn::Add(first[0], hn::Mul(begin[2], rise));
  cubic.C[1] = hn::Add(hn::Add(second[0], hn::Mul(begin[2], bend)), hn::Mul(across[2], rise));
  cubic.C[2] = hn::Add(hn::Add(third[0], hn::Mul(begin[2], twist)), hn::Mul(across[2], bend));
  cubic.C[3] = hn::Mul(across[2], twist);
  return cubic;
}

/// Turning points of cubics on [0, 1], and the values there and at 1.
template <class V>
struct Turns
{
  using Line = Cubic<V>;

  Turns() = default;
  HWY_INLINE explicit Turns(const Line& cubic)
  {
    const hn::DFromV<V> d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    // Scale the coefficients, so that no product is too large.
    const V most = hn::Max(hn::Abs(cubic.C[1]), hn::Max(hn::Abs(cubic.C[2]), hn::Abs(cubic.C[3])));
    const V scale = hn::Div(one, hn::Max(most, hn::Set(d, 1e-30f)));
    const V slope = hn::Mul(scale, cubic.C[1]), bend = hn::Mul(scale, cubic.C[2]);
    const V third = hn::Mul(hn::Set(d, 3.0f), hn::Mul(scale, cubic.C[3]));
    const V square = hn::Sub(hn::Mul(bend, bend), hn::Mul(third, slope));
    const auto isTurning = hn::Gt(square, zero);
    const V root = hn::CopySign(hn::Sqrt(hn::Max(square, zero)), bend);
    const V sum = hn::Neg(hn::Add(bend, root));
    const auto share = [&](V of, V by) HWY_ATTR
    {
      const auto isAny = hn::And(isTurning, hn::Gt(hn::Abs(by), hn::Set(d, 1e-20f)));
      const V at = hn::Div(of, hn::IfThenElse(isAny, by, one));
      return hn::Min(hn::Max(hn::IfThenElseZero(isAny, at), zero), one);
    };
    const V either = share(sum, third), other = share(slope, sum);
    this->First = hn::Min(either, other);
    this->Second = hn::Max(either, other);
    this->AtFirst = cubic.At(this->First);
    this->AtSecond = cubic.At(this->Second);
    this->AtEnd = cubic.At(one);
  }

  template <class Visitor>
  HWY_INLINE void EachColumn(const Visitor& visit)
  {
    visit(this->First);
    visit(this->Second);
    visit(this->AtFirst);
    visit(this->AtSecond);
    visit(this->AtEnd);
  }
  static constexpr std::size_t Columns = 5;

  V First, Second;            ///< shares, ascending; 0 or 1 if the cubic does not turn on the path
  V AtFirst, AtSecond, AtEnd; ///< values
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
