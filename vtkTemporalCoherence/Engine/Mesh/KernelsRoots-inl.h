// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Roots of three trilinear functions, in vectors of systems. Kernels include this file once for
// each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsRoots_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsRoots_inl_h
#undef TemporalCoherence_KernelsRoots_inl_h
#else
#define TemporalCoherence_KernelsRoots_inl_h
#endif

#include "Mesh/HexahedronRoots.h"

#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// What these functions compute with, for each kind of vectors. Trilinear functions are arrays of
/// coefficients as in Trilinear.h.
template <class D>
struct RootVectors
{
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  static HWY_INLINE V Three(V a, V b, V c) { return hn::Add(hn::Add(a, b), c); }

  /// The cross product of two rows.
  static HWY_INLINE void Cross(const V a[3], const V b[3], V out[3])
  {
    out[0] = hn::Sub(hn::Mul(a[1], b[2]), hn::Mul(a[2], b[1]));
    out[1] = hn::Sub(hn::Mul(a[2], b[0]), hn::Mul(a[0], b[2]));
    out[2] = hn::Sub(hn::Mul(a[0], b[1]), hn::Mul(a[1], b[0]));
  }

  static HWY_INLINE V Dot(const V a[3], const V b[3])
  {
    return Three(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1]), hn::Mul(a[2], b[2]));
  }

  /// Multiply a matrix's inverse, by its columns, with its determinant.
  static HWY_INLINE V Adjoint(const V rows[3][3], V columns[3][3])
  {
    Cross(rows[1], rows[2], columns[0]);
    Cross(rows[2], rows[0], columns[1]);
    Cross(rows[0], rows[1], columns[2]);
    return Dot(rows[0], columns[0]);
  }

  /// From values at corners.
  static HWY_INLINE void Coefficients(const V corners[8], V scale, V c[8])
  {
    const V first = hn::Mul(scale, hn::Set(D(), 0.125));
    V a[8], b[8];
    for (std::size_t k = 0; k < 8; k += 2)
    {
      a[k] = hn::Add(corners[k], corners[k + 1]);
      a[k + 1] = hn::Sub(corners[k + 1], corners[k]);
    }
    for (const std::size_t k : { 0, 1, 4, 5 })
    {
      b[k] = hn::Add(a[k], a[k + 2]);
      b[k + 2] = hn::Sub(a[k + 2], a[k]);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      c[k] = hn::Mul(first, hn::Add(b[k], b[k + 4]));
      c[k + 4] = hn::Mul(first, hn::Sub(b[k + 4], b[k]));
    }
  }

  static HWY_INLINE V ValueAt(const V c[8], const V u[3])
  {
    const V low = hn::Add(
      hn::Add(c[0], hn::Mul(u[0], c[1])), hn::Mul(u[1], hn::Add(c[2], hn::Mul(u[0], c[3]))));
    const V high = hn::Add(
      hn::Add(c[4], hn::Mul(u[0], c[5])), hn::Mul(u[1], hn::Add(c[6], hn::Mul(u[0], c[7]))));
    return hn::Add(low, hn::Mul(u[2], high));
  }

  static HWY_INLINE void GradientAt(const V c[8], const V u[3], V out[3])
  {
    const V high1 = hn::Add(c[5], hn::Mul(u[1], c[7]));
    const V high0 = hn::Add(c[6], hn::Mul(u[0], c[7]));
    out[0] = hn::Add(hn::Add(c[1], hn::Mul(u[1], c[3])), hn::Mul(u[2], high1));
    out[1] = hn::Add(hn::Add(c[2], hn::Mul(u[0], c[3])), hn::Mul(u[2], high0));
    out[2] = hn::Add(hn::Add(c[4], hn::Mul(u[0], c[5])), hn::Mul(u[1], high0));
  }
};

/// A box of each lane.
template <class D>
struct RootBox
{
  hn::Vec<D> Middle[3], Half[3];
};

/// A system multiplied by the inverse of its linear part, on a box.
template <class D>
struct NearlyLinear
{
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Use = RootVectors<D>;

  /// \return lanes that are regular
  HWY_INLINE M SetUp(const V system[3][8])
  {
    const D d;
    const V rows[3][3] = { { system[0][1], system[0][2], system[0][4] },
      { system[1][1], system[1][2], system[1][4] }, { system[2][1], system[2][2], system[2][4] } };
    V columns[3][3];
    const V determinant = Use::Adjoint(rows, columns), one = hn::Set(d, 1.0);
    const M isRegular = hn::Gt(hn::Abs(determinant), hn::Set(d, LeastDeterminant));
    const V scale = hn::Div(one, hn::IfThenElse(isRegular, determinant, one));
    // Of the inverse, too.
    V lost = hn::Mul(hn::Set(d, ValueError), hn::Abs(scale));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V longest = hn::Max(hn::Max(hn::Abs(rows[i][0]), hn::Abs(rows[i][1])),
        hn::Max(hn::Abs(rows[i][2]), hn::Abs(system[i][0])));
      lost = hn::Mul(lost, longest);
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V inverse[3] = { hn::Mul(columns[0][i], scale), hn::Mul(columns[1][i], scale),
        hn::Mul(columns[2][i], scale) };
      const V sum = Use::Three(hn::Abs(inverse[0]), hn::Abs(inverse[1]), hn::Abs(inverse[2]));
      this->Error[i] = hn::Add(lost, hn::Mul(hn::Set(d, ValueError), sum));
      for (std::size_t term = 0; term < 5; ++term)
      {
        const std::size_t k = Terms[term];
        this->Parts[i][term] = Use::Three(hn::Mul(inverse[0], system[0][k]),
          hn::Mul(inverse[1], system[1][k]), hn::Mul(inverse[2], system[2][k]));
      }
    }
    return isRegular;
  }

  /// Bounds of the nonlinear parts, and of their slopes.
  HWY_INLINE void Bound(V rest[3], V& steepest) const
  {
    const D d;
    steepest = hn::Zero(d);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V pairs = Use::Three(
        hn::Abs(this->Parts[i][1]), hn::Abs(this->Parts[i][2]), hn::Abs(this->Parts[i][3]));
      const V triple = hn::Abs(this->Parts[i][4]);
      rest[i] = hn::Add(pairs, triple);
      const V steep = hn::Add(hn::Add(rest[i], rest[i]), triple);
      steepest = hn::Max(steepest, steep);
    }
  }

  /// The step of Newton's method.
  HWY_INLINE void Step(const V v[3], V move[3]) const
  {
    const D d;
    const V one = hn::Set(d, 1.0);
    const V v01 = hn::Mul(v[0], v[1]), v02 = hn::Mul(v[0], v[2]), v12 = hn::Mul(v[1], v[2]);
    const V all = hn::Mul(v01, v[2]);
    V rows[3][3], value[3], columns[3][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V* const p = this->Parts[i];
      const V bent = hn::Add(
        Use::Three(hn::Mul(p[1], v01), hn::Mul(p[2], v02), hn::Mul(p[3], v12)), hn::Mul(p[4], all));
      value[i] = Use::Three(p[0], v[i], bent);
      rows[i][0] = Use::Three(hn::Mul(p[1], v[1]), hn::Mul(p[2], v[2]), hn::Mul(p[4], v12));
      rows[i][1] = Use::Three(hn::Mul(p[1], v[0]), hn::Mul(p[3], v[2]), hn::Mul(p[4], v02));
      rows[i][2] = Use::Three(hn::Mul(p[2], v[0]), hn::Mul(p[3], v[1]), hn::Mul(p[4], v01));
      rows[i][i] = hn::Add(rows[i][i], one);
    }
    const V determinant = Use::Adjoint(rows, columns);
    const M isZero = hn::Eq(determinant, hn::Zero(d));
    const V scale = hn::Div(one, hn::IfThenElse(isZero, one, determinant));
    for (std::size_t i = 0; i < 3; ++i)
    {
      move[i] = hn::Mul(scale,
        Use::Three(hn::Mul(value[0], columns[0][i]), hn::Mul(value[1], columns[1][i]),
          hn::Mul(value[2], columns[2][i])));
    }
  }

  /// Take over lanes of another one.
  HWY_INLINE void Take(M lanes, const NearlyLinear& other)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Error[i] = hn::IfThenElse(lanes, other.Error[i], this->Error[i]);
      for (std::size_t term = 0; term < 5; ++term)
      {
        this->Parts[i][term] = hn::IfThenElse(lanes, other.Parts[i][term], this->Parts[i][term]);
      }
    }
  }

  static constexpr std::size_t Terms[5] = { 0, 3, 5, 6, 7 };
  V Parts[3][5]; ///< coefficients but the linear ones, which are those of the coordinates
  V Error[3];    ///< rounding errors
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
