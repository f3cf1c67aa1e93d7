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

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V Three(V a, V b, V c)
{
  return hn::Add(hn::Add(a, b), c);
}

template <class V>
HWY_INLINE V LargestOf(V a, V b, V c)
{
  return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c));
}

template <class V>
HWY_INLINE void CrossRows(const V a[3], const V b[3], V out[3])
{
  out[0] = hn::Sub(hn::Mul(a[1], b[2]), hn::Mul(a[2], b[1]));
  out[1] = hn::Sub(hn::Mul(a[2], b[0]), hn::Mul(a[0], b[2]));
  out[2] = hn::Sub(hn::Mul(a[0], b[1]), hn::Mul(a[1], b[0]));
}

template <class V>
HWY_INLINE V DotRows(const V a[3], const V b[3])
{
  return Three(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1]), hn::Mul(a[2], b[2]));
}

/// The columns of a matrix's inverse, multiplied by its determinant.
/// \return the determinant
template <class V>
HWY_INLINE V Adjoint(const V rows[3][3], V columns[3][3])
{
  CrossRows(rows[1], rows[2], columns[0]);
  CrossRows(rows[2], rows[0], columns[1]);
  CrossRows(rows[0], rows[1], columns[2]);
  return DotRows(rows[0], columns[0]);
}

/// The same with all differences as sums: how much was added up.
template <class V>
HWY_INLINE V AmountOfAdjoint(const V rows[3][3], V columns[3][3])
{
  for (std::size_t j = 0; j < 3; ++j)
  {
    const V *const a = rows[(j + 1) % 3], *const b = rows[(j + 2) % 3];
    columns[j][0] = hn::Add(hn::Mul(a[1], b[2]), hn::Mul(a[2], b[1]));
    columns[j][1] = hn::Add(hn::Mul(a[2], b[0]), hn::Mul(a[0], b[2]));
    columns[j][2] = hn::Add(hn::Mul(a[0], b[1]), hn::Mul(a[1], b[0]));
  }
  return DotRows(rows[0], columns[0]);
}

/// ValueAt and GradientAt of Trilinear.h.
template <class V>
HWY_INLINE V ValueAt(const V c[8], const V u[3])
{
  const V low =
    hn::Add(hn::Add(c[0], hn::Mul(u[0], c[1])), hn::Mul(u[1], hn::Add(c[2], hn::Mul(u[0], c[3]))));
  const V high =
    hn::Add(hn::Add(c[4], hn::Mul(u[0], c[5])), hn::Mul(u[1], hn::Add(c[6], hn::Mul(u[0], c[7]))));
  return hn::Add(low, hn::Mul(u[2], high));
}

template <class V>
HWY_INLINE void GradientAt(const V c[8], const V u[3], V out[3])
{
  const V high1 = hn::Add(c[5], hn::Mul(u[1], c[7]));
  const V high0 = hn::Add(c[6], hn::Mul(u[0], c[7]));
  out[0] = hn::Add(hn::Add(c[1], hn::Mul(u[1], c[3])), hn::Mul(u[2], high1));
  out[1] = hn::Add(hn::Add(c[2], hn::Mul(u[0], c[3])), hn::Mul(u[2], high0));
  out[2] = hn::Add(hn::Add(c[4], hn::Mul(u[0], c[5])), hn::Mul(u[1], high0));
}

/// Restrict of Trilinear.h.
template <class V>
HWY_INLINE void Restrict(const V middle[3], const V half[3], V c[8])
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::size_t bit = std::size_t(1) << a;
    for (std::size_t k = 0; k < 8; ++k)
    {
      if ((k & bit) == 0)
      {
        c[k] = hn::Add(c[k], hn::Mul(middle[a], c[k + bit]));
        c[k + bit] = hn::Mul(half[a], c[k + bit]);
      }
    }
  }
}

/// A bound of a function's amount without its constant part.
template <class V>
HWY_INLINE V ReachOf(const V c[8])
{
  const V linear = Three(hn::Abs(c[1]), hn::Abs(c[2]), hn::Abs(c[4]));
  const V pairs = Three(hn::Abs(c[3]), hn::Abs(c[5]), hn::Abs(c[6]));
  return Three(linear, pairs, hn::Abs(c[7]));
}

/// A system multiplied by the inverse of its linear part, on [-1, 1]^3.
template <class D>
struct NearlyLinear
{
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  /// \param largest of each function, for rounding errors
  HWY_INLINE NearlyLinear(const V system[3][8], const V largest[3])
  {
    const D d;
    const V rows[3][3] = { { system[0][1], system[0][2], system[0][4] },
      { system[1][1], system[1][2], system[1][4] }, { system[2][1], system[2][2], system[2][4] } };
    V columns[3][3];
    this->Determinant = Adjoint(rows, columns);
    const V one = hn::Set(d, 1.0), least = hn::Set(d, LeastDeterminant);
    const V most = hn::Mul(hn::Mul(largest[0], largest[1]), largest[2]);
    this->IsRegular = hn::Gt(hn::Abs(this->Determinant), hn::Mul(least, most));
    const V scale = hn::Div(one, hn::IfThenElse(this->IsRegular, this->Determinant, one));
    const V error = hn::Set(d, ValueError);
    // Rounding errors of the inverse: those of its products, whose amounts are added up.
    V amounts[3][3], sums[3][3];
    for (std::size_t j = 0; j < 3; ++j)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        amounts[j][i] = hn::Abs(rows[j][i]);
      }
    }
    const V all = AmountOfAdjoint(amounts, sums), lost = hn::Mul(error, hn::Abs(scale));
    const V constant[3] = { hn::Abs(system[0][0]), hn::Abs(system[1][0]), hn::Abs(system[2][0]) };
    for (std::size_t i = 0; i < 3; ++i)
    {
      V inverse[3];
      for (std::size_t j = 0; j < 3; ++j)
      {
        inverse[j] = hn::Mul(columns[j][i], scale);
      }
      const V sum = Three(hn::Mul(hn::Abs(inverse[0]), largest[0]),
        hn::Mul(hn::Abs(inverse[1]), largest[1]), hn::Mul(hn::Abs(inverse[2]), largest[2]));
      const V ofInverse = hn::Add(all,
        Three(hn::Mul(sums[0][i], constant[0]), hn::Mul(sums[1][i], constant[1]),
          hn::Mul(sums[2][i], constant[2])));
      this->Error[i] = hn::Add(hn::Mul(lost, ofInverse), hn::Mul(error, sum));
      constexpr std::size_t terms[5] = { 0, 3, 5, 6, 7 };
      for (std::size_t term = 0; term < 5; ++term)
      {
        const V column[3] = { system[0][terms[term]], system[1][terms[term]],
          system[2][terms[term]] };
        this->Parts[i][term] = DotRows(inverse, column);
      }
    }
  }

  /// Bounds of the nonlinear parts, and of their slopes.
  HWY_INLINE void Bound(V rest[3], V& steepest) const
  {
    steepest = hn::Zero(D());
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V triple = hn::Abs(this->Parts[i][4]);
      rest[i] = hn::Add(
        Three(hn::Abs(this->Parts[i][1]), hn::Abs(this->Parts[i][2]), hn::Abs(this->Parts[i][3])),
        triple);
      steepest = hn::Max(steepest, Three(rest[i], rest[i], triple));
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
        Three(hn::Mul(p[1], v01), hn::Mul(p[2], v02), hn::Mul(p[3], v12)), hn::Mul(p[4], all));
      value[i] = Three(p[0], v[i], bent);
      rows[i][0] = Three(hn::Mul(p[1], v[1]), hn::Mul(p[2], v[2]), hn::Mul(p[4], v12));
      rows[i][1] = Three(hn::Mul(p[1], v[0]), hn::Mul(p[3], v[2]), hn::Mul(p[4], v02));
      rows[i][2] = Three(hn::Mul(p[2], v[0]), hn::Mul(p[3], v[1]), hn::Mul(p[4], v01));
      rows[i][i] = hn::Add(rows[i][i], one);
    }
    const V determinant = Adjoint(rows, columns);
    const M isZero = hn::Eq(determinant, hn::Zero(d));
    const V scale = hn::Div(one, hn::IfThenElse(isZero, one, determinant));
    for (std::size_t i = 0; i < 3; ++i)
    {
      move[i] = hn::Mul(scale,
        Three(hn::Mul(value[0], columns[0][i]), hn::Mul(value[1], columns[1][i]),
          hn::Mul(value[2], columns[2][i])));
    }
  }

  /// Newton's method for lanes with one root at most.
  /// \param v gets the roots
  /// \return lanes with a root
  HWY_INLINE M Solve(M lanes, V v[3]) const
  {
    const D d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    V most[3], least[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      most[i] = Three(one, hn::Set(d, Margin), this->Error[i]);
      least[i] = hn::Neg(most[i]);
      v[i] = hn::Max(least[i], hn::Min(hn::Neg(this->Parts[i][0]), most[i]));
    }
    M isThere = hn::Lt(one, zero);
    for (int step = 0; step < MostNewtonSteps && !hn::AllFalse(d, lanes); ++step)
    {
      V move[3], moved = zero;
      this->Step(v, move);
      const M isLast =
        hn::And(lanes, hn::Le(LargestOf(move[0], move[1], move[2]), hn::Set(d, LastStep)));
      M isIn = isLast;
      for (std::size_t i = 0; i < 3; ++i)
      {
        // Beyond the box by less than the last step: no root of this box.
        const V free = hn::Sub(v[i], move[i]);
        const V next = hn::Max(least[i], hn::Min(free, most[i]));
        isIn = hn::And(isIn, hn::Le(hn::Abs(free), most[i]));
        moved = hn::Max(moved, hn::Abs(hn::Sub(next, v[i])));
        v[i] = hn::IfThenElse(lanes, next, v[i]);
      }
      isThere = hn::Or(isThere, isIn);
      lanes = hn::AndNot(hn::Or(isLast, hn::Le(moved, hn::Set(d, LastMove))), lanes);
    }
    return isThere;
  }

  V Parts[3][5]; ///< coefficients but the linear ones, which are those of the coordinates
  V Error[3];    ///< rounding errors
  V Determinant; ///< of the linear part
  M IsRegular;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
