// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hexahedra as vectors of rays see them, as systems of three functions. Kernels include this file
// once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsStraight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsStraight_inl_h
#undef TemporalCoherence_KernelsStraight_inl_h
#else
#define TemporalCoherence_KernelsStraight_inl_h
#endif

#include "Mesh/Cells/HexahedronRoots.h"
#include "Mesh/Cells/KernelsCellFunctions-inl.h"

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

/// ValueAt of Trilinear.h.
template <class V>
HWY_INLINE V ValueAt(const V c[8], const V u[3])
{
  const V low =
    hn::Add(hn::Add(c[0], hn::Mul(u[0], c[1])), hn::Mul(u[1], hn::Add(c[2], hn::Mul(u[0], c[3]))));
  const V high =
    hn::Add(hn::Add(c[4], hn::Mul(u[0], c[5])), hn::Mul(u[1], hn::Add(c[6], hn::Mul(u[0], c[7]))));
  return hn::Add(low, hn::Mul(u[2], high));
}

/// The products that belong to BentTerms.
template <class V>
HWY_INLINE void ProductsOf(const V u[3], V products[4])
{
  products[0] = hn::Mul(u[0], u[1]);
  products[1] = hn::Mul(u[0], u[2]);
  products[2] = hn::Mul(u[1], u[2]);
  products[3] = hn::Mul(products[0], u[2]);
}

template <class V>
HWY_INLINE V BendAt(const V bends[4], const V products[4])
{
  return hn::Add(hn::Add(hn::Mul(bends[0], products[0]), hn::Mul(bends[1], products[1])),
    hn::Add(hn::Mul(bends[2], products[2]), hn::Mul(bends[3], products[3])));
}

/// The slopes of bends.
template <class V>
HWY_INLINE void SlopesOf(const V bends[4], const V u[3], const V products[4], V slopes[3])
{
  const V* const b = bends;
  slopes[0] = Three(hn::Mul(b[0], u[1]), hn::Mul(b[1], u[2]), hn::Mul(b[3], products[2]));
  slopes[1] = Three(hn::Mul(b[0], u[0]), hn::Mul(b[2], u[2]), hn::Mul(b[3], products[1]));
  slopes[2] = Three(hn::Mul(b[1], u[0]), hn::Mul(b[2], u[1]), hn::Mul(b[3], products[0]));
}

/// The equations of a crossing: three functions u + Constant + Bends(u), which are 0 where a ray
/// meets the surface.
///
/// In the coordinates w of StraightCell, rays are linear, and so is the difference but for bends.
/// Its root gives the depth of the surface, which is inserted into the equation of the ray.
template <class D>
struct StraightSystem
{
  using V = hn::Vec<D>;

  HWY_INLINE StraightSystem(const TurnedFunctions<D>& functions, const ShearedRays<D>& rays)
  {
    const D d;
    const HexahedronFunctions& cell = functions.Cell;
    V from[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      from[a] = hn::Sub(functions.OfAxis(cell.Coordinates, a, 0), rays.Turned[a]);
    }
    // Begin the ray at the depth of the cell's middle, where numbers are small.
    const V x = hn::Sub(hn::Mul(rays.ShearX, from[2]), from[0]);
    const V y = hn::Sub(hn::Mul(rays.ShearY, from[2]), from[1]);
    const V far = Three(hn::Abs(rays.Turned[0]), hn::Abs(rays.Turned[1]), hn::Abs(rays.Turned[2]));
    const V error = hn::Set(d, ValueError);
    const V rounded = hn::Mul(error, hn::Add(far, hn::Set(d, cell.Far)));
    const V lost =
      hn::Add(hn::Mul(rounded, hn::Set(d, cell.Straight.Reach)), hn::Set(d, cell.Straight.Lost));
    V value = hn::Set(d, cell.Difference[0]);
    this->PerDepth = hn::Zero(d);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V perX = functions.OfAxis(cell.Straight.Inverse, 0, i);
      const V perY = functions.OfAxis(cell.Straight.Inverse, 1, i);
      this->Origin[i] = hn::Add(hn::Mul(perX, x), hn::Mul(perY, y));
      this->Along[i] = Three(hn::Mul(perX, rays.ShearX), hn::Mul(perY, rays.ShearY),
        functions.OfAxis(cell.Straight.Inverse, 2, i));
      const V slope = hn::Set(d, cell.Difference[std::size_t(1) << i]);
      value = hn::Add(value, hn::Mul(slope, this->Origin[i]));
      this->PerDepth = hn::Add(this->PerDepth, hn::Mul(slope, this->Along[i]));
    }
    const V depthPerValue = hn::Div(hn::Set(d, 1.0), this->PerDepth);
    V most = hn::Zero(d);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V perValue = hn::Mul(this->Along[i], depthPerValue);
      this->Constant[i] = hn::Sub(hn::Mul(perValue, value), this->Origin[i]);
      most = hn::Add(most, hn::Abs(perValue));
      for (std::size_t term = 0; term < BentTerms.size(); ++term)
      {
        const V ofDifference = hn::Set(d, cell.Straight.DifferenceBends[term]);
        this->Bends[i][term] =
          hn::Add(hn::Set(d, cell.Straight.Bends[i][term]), hn::Mul(perValue, ofDifference));
      }
    }
    const V ofDifference = hn::Add(hn::Mul(hn::Set(d, cell.Straight.Slope), lost),
      hn::Mul(hn::Add(error, error), hn::Set(d, cell.LargestDifference)));
    this->Error = hn::Add(lost, hn::Mul(most, ofDifference));
  }

  HWY_INLINE void ValuesAt(const V u[3], const V products[4], V values[3]) const
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      values[i] = Three(this->Constant[i], u[i], BendAt(this->Bends[i], products));
    }
  }

  HWY_INLINE void SlopesAt(const V u[3], const V products[4], V rows[3][3]) const
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      SlopesOf(this->Bends[i], u, products, rows[i]);
      rows[i][i] = hn::Add(rows[i][i], hn::Set(D(), 1.0));
    }
  }

  V Origin[3], Along[3]; ///< the ray in coordinates w, by the depth from the middle of the cell on
  V Constant[3], Bends[3][4];
  V Error;    ///< a bound of rounding errors
  V PerDepth; ///< slope of the difference's linear part by depth
};

/// Bends of the cell itself, along one axis.
template <class V>
HWY_INLINE void BendsOfCell(const HexahedronFunctions& cell, std::size_t i, V bends[4])
{
  for (std::size_t term = 0; term < BentTerms.size(); ++term)
  {
    bends[term] = hn::Set(hn::DFromV<V>(), cell.Straight.Bends[i][term]);
  }
}

/// Lanes where the cell's Jacobian has equal signs at a point and in the middle.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> IsUnfolded(const HexahedronFunctions& cell, const V u[3])
{
  V products[4], rows[3][3], columns[3][3];
  ProductsOf(u, products);
  for (std::size_t i = 0; i < 3; ++i)
  {
    V bends[4];
    BendsOfCell(cell, i, bends);
    SlopesOf(bends, u, products, rows[i]);
    rows[i][i] = hn::Add(rows[i][i], hn::Set(D(), 1.0));
  }
  return hn::Gt(Adjoint(rows, columns), hn::Zero(D()));
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
