// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hexahedra as vectors of rays see them: systems of three functions, and the roots of these.
// Kernels include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsRoots_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsRoots_inl_h
#undef TemporalCoherence_KernelsRoots_inl_h
#else
#define TemporalCoherence_KernelsRoots_inl_h
#endif

#include "Mesh/Cells/HexahedronFunctions.h"
#include "Mesh/Cells/HexahedronRoots.h"
#include "Mesh/Cells/KernelsSheared-inl.h"

#include <algorithm>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The functions of a cell, with coordinates in the sheared order of rays along one axis.
template <class D>
struct TurnedFunctions
{
  HWY_INLINE TurnedFunctions(const HexahedronFunctions& cell, std::size_t axis)
    : Cell(cell)
  {
    const auto axes = TurnedAxes(axis);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Axes[a] = static_cast<std::size_t>(axes[a]);
    }
  }

  /// Number k of sheared axis a, in all lanes.
  /// \param numbers of the cell, by axis
  template <std::size_t Number>
  HWY_INLINE hn::Vec<D> OfAxis(
    const std::array<std::array<double, Number>, 3>& numbers, std::size_t a, std::size_t k) const
  {
    return hn::Set(D(), numbers[this->Axes[a]][k]);
  }

  const HexahedronFunctions& Cell;

private:
  std::size_t Axes[3];
};

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

/// The part of a cell that can hold roots of a system, and bounds of these roots.
template <class D>
struct KnownPart
{
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  /// Start with the whole cell, where the coefficients bound the bends.
  HWY_INLINE explicit KnownPart(const StraightSystem<D>& system)
  {
    const D d;
    const V one = hn::Set(d, 1.0), minusOne = hn::Set(d, -1.0);
    const V around = hn::Add(system.Error, hn::Set(d, Margin));
    this->IsOut = hn::Lt(one, minusOne);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V* const b = system.Bends[i];
      const V bend =
        hn::Add(hn::Add(hn::Abs(b[0]), hn::Abs(b[1])), hn::Add(hn::Abs(b[2]), hn::Abs(b[3])));
      const V reach = hn::Add(bend, around);
      const V low = hn::Neg(hn::Add(reach, system.Constant[i]));
      const V high = hn::Sub(reach, system.Constant[i]);
      this->IsOut = hn::Or(this->IsOut, hn::Or(hn::Gt(low, one), hn::Lt(high, minusOne)));
      this->Low[i] = hn::Max(low, minusOne);
      this->High[i] = hn::Min(high, one);
      this->Around[i] = hn::Set(d, MostAround);
    }
  }

  /// Start with a box.
  HWY_INLINE KnownPart(const V middle[3], const V half[3])
  {
    const D d;
    this->IsOut = hn::Lt(hn::Set(d, 0.0), hn::Set(d, 0.0));
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Low[i] = hn::Sub(middle[i], half[i]);
      this->High[i] = hn::Add(middle[i], half[i]);
      this->Around[i] = hn::Mul(half[i], hn::Set(d, MostAround));
    }
  }

  /// Cut the part to the neighbourhood of the ray, ignoring the surface. This helps where the ray
  /// nearly runs along the surface.
  HWY_INLINE void CutToRay(const HexahedronFunctions& cell, const StraightSystem<D>& system)
  {
    const D d;
    const V half = hn::Set(d, 0.5), largest = hn::Set(d, 1e300), smallest = hn::Set(d, -1e300);
    V middle[3], size[3], products[4], sizes[4], lowBend[3], highBend[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      middle[i] = hn::Mul(half, hn::Add(this->Low[i], this->High[i]));
      size[i] = hn::Mul(half, hn::Sub(this->High[i], this->Low[i]));
    }
    ProductsOf(middle, products);
    ProductsOf(size, sizes);
    V in = smallest, out = largest;
    for (std::size_t i = 0; i < 3; ++i)
    {
      V bends[4], slopes[3];
      BendsOfCell(cell, i, bends);
      SlopesOf(bends, middle, products, slopes);
      const V bend = BendAt(bends, products);
      V reach = Three(system.Error, hn::Set(d, Slack), hn::Mul(hn::Abs(bends[3]), sizes[3]));
      V reachOfPoint = hn::Mul(hn::Abs(hn::Add(slopes[i], hn::Set(d, 1.0))), size[i]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        const V pair = hn::Abs(hn::Add(bends[a], hn::Mul(bends[3], middle[2 - a])));
        reach = hn::Add(reach, hn::Mul(pair, sizes[a]));
        if (a != i)
        {
          reach = hn::Add(reach, hn::Mul(hn::Abs(slopes[a]), size[a]));
        }
      }
      reachOfPoint = hn::Add(reachOfPoint, reach);
      reach = hn::Add(reach, hn::Mul(hn::Abs(slopes[i]), size[i]));
      lowBend[i] = hn::Sub(bend, reach);
      highBend[i] = hn::Add(bend, reach);
      const V from = hn::Sub(hn::Add(middle[i], bend), system.Origin[i]);
      const V perW = hn::Max(hn::Min(hn::Div(hn::Set(d, 1.0), system.Along[i]), largest), smallest);
      const V first = hn::Mul(hn::Sub(from, reachOfPoint), perW);
      const V last = hn::Mul(hn::Add(from, reachOfPoint), perW);
      in = hn::Max(in, hn::Min(first, last));
      out = hn::Min(out, hn::Max(first, last));
    }
    this->IsOut = hn::Or(this->IsOut, hn::Gt(in, out));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V first = hn::Mul(in, system.Along[i]), last = hn::Mul(out, system.Along[i]);
      const V low = hn::Sub(hn::Add(system.Origin[i], hn::Min(first, last)), highBend[i]);
      const V high = hn::Sub(hn::Add(system.Origin[i], hn::Max(first, last)), lowBend[i]);
      this->Low[i] = hn::Max(this->Low[i], low);
      this->High[i] = hn::Min(this->High[i], high);
      this->IsOut = hn::Or(this->IsOut, hn::Gt(this->Low[i], this->High[i]));
    }
  }

  /// Multiply a system by the inverse of its slopes in the middle of the part. The remaining bends
  /// bound the roots' place and number.
  HWY_INLINE void Narrow(const StraightSystem<D>& system)
  {
    const D d;
    const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
    V size[3], products[4], sizes[4], rows[3][3], columns[3][3], values[3], bends[3][4];
    V most = one;
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Middle[i] = hn::Mul(half, hn::Add(this->Low[i], this->High[i]));
      size[i] = hn::Mul(half, hn::Sub(this->High[i], this->Low[i]));
    }
    ProductsOf(this->Middle, products);
    ProductsOf(size, sizes);
    system.SlopesAt(this->Middle, products, rows);
    system.ValuesAt(this->Middle, products, values);
    for (std::size_t i = 0; i < 3; ++i)
    {
      most = hn::Mul(most, Three(hn::Abs(rows[i][0]), hn::Abs(rows[i][1]), hn::Abs(rows[i][2])));
    }
    const V determinant = Adjoint(rows, columns);
    // False in lanes with NaN.
    this->IsRegular = hn::Gt(hn::Abs(determinant), hn::Mul(hn::Set(d, LeastSpan), most));
    const V scale = hn::Div(one, hn::IfThenElse(this->IsRegular, determinant, one));
    V inverse[3][3];
    this->Error = hn::Zero(d);
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        inverse[i][j] = hn::Mul(columns[j][i], scale);
      }
      this->Error = hn::Max(
        this->Error, Three(hn::Abs(inverse[i][0]), hn::Abs(inverse[i][1]), hn::Abs(inverse[i][2])));
    }
    this->Error = hn::Mul(this->Error, system.Error);
    const V slack = hn::Add(this->Error, hn::Set(d, Slack));
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Bound(system, inverse[i], bends[i]);
      this->Cut(DotRows(inverse[i], values), hn::Add(BendAt(bends[i], sizes), slack), size[i], i);
    }
    this->FindWhetherOnly(bends);
  }

  V Low[3], High[3]; ///< of the part
  V Around[3];       ///< distance beyond the part up to which roots are found, too
  V Middle[3];       ///< of the part before it was narrowed
  V Reach[3];        ///< if IsOnly: at most one root lies within this distance of the middle
  V Start[3];        ///< near the root
  V Error;           ///< a bound of rounding errors of roots
  M IsOut, IsOnly, IsRegular;

private:
  /// Bounds of bends around the middle.
  HWY_INLINE void Bound(const StraightSystem<D>& system, const V inverse[3], V bends[4]) const
  {
    for (std::size_t term = 0; term < BentTerms.size(); ++term)
    {
      const V column[3] = { system.Bends[0][term], system.Bends[1][term], system.Bends[2][term] };
      bends[term] = DotRows(inverse, column);
    }
    for (std::size_t term = 0; term < 3; ++term)
    {
      bends[term] = hn::Abs(hn::Add(bends[term], hn::Mul(bends[3], this->Middle[2 - term])));
    }
    bends[3] = hn::Abs(bends[3]);
  }

  /// Keep the interval around the linear part's root that the bound `reach` of the bends allows.
  HWY_INLINE void Cut(V value, V reach, V size, std::size_t i)
  {
    const V low = hn::Neg(hn::Add(reach, value)), high = hn::Sub(reach, value);
    const auto isBeside = hn::Or(hn::Gt(low, size), hn::Lt(high, hn::Neg(size)));
    this->IsOut = hn::Or(this->IsOut, hn::And(this->IsRegular, isBeside));
    const V inLow = hn::Max(low, hn::Neg(size)), inHigh = hn::Min(high, size);
    this->Reach[i] = hn::Add(hn::Max(hn::Neg(inLow), inHigh), this->Around[i]);
    this->Start[i] = hn::Add(this->Middle[i], hn::Max(inLow, hn::Min(hn::Neg(value), inHigh)));
    this->Low[i] = hn::IfThenElse(this->IsRegular, hn::Add(this->Middle[i], inLow), this->Low[i]);
    this->High[i] =
      hn::IfThenElse(this->IsRegular, hn::Add(this->Middle[i], inHigh), this->High[i]);
  }

  /// Two roots u and v satisfy |u - v| <= S |u - v|, where S bounds the slopes of the bends. If the
  /// spectral radius of S is below 1, then u = v. Test: MostSlope minus S has positive leading
  /// minors.
  HWY_INLINE void FindWhetherOnly(const V bends[3][4])
  {
    const D d;
    const V zero = hn::Zero(d), most = hn::Set(d, MostSlope);
    V products[4], rows[3][3];
    ProductsOf(this->Reach, products);
    for (std::size_t i = 0; i < 3; ++i)
    {
      SlopesOf(bends[i], this->Reach, products, rows[i]);
      rows[i][i] = hn::Sub(most, rows[i][i]);
    }
    const auto product = [&](std::size_t i, std::size_t a, std::size_t j, std::size_t b) HWY_ATTR
    { return hn::Mul(rows[i][a], rows[j][b]); };
    const V second = hn::Sub(product(0, 0, 1, 1), product(0, 1, 1, 0));
    const V minor0 = hn::Sub(product(1, 1, 2, 2), product(1, 2, 2, 1));
    const V minor1 = hn::Add(product(1, 0, 2, 2), product(1, 2, 2, 0));
    const V minor2 = hn::Add(product(1, 0, 2, 1), product(1, 1, 2, 0));
    const V third = hn::Sub(hn::Mul(rows[0][0], minor0),
      hn::Add(hn::Mul(rows[0][1], minor1), hn::Mul(rows[0][2], minor2)));
    const auto isWell = hn::And(this->IsRegular, hn::Lt(this->Error, hn::Set(d, MostErrorOfRoot)));
    this->IsOnly = hn::And(hn::And(isWell, hn::Gt(rows[0][0], zero)),
      hn::And(hn::Gt(second, zero), hn::Gt(third, zero)));
  }
};

/// Roots of lanes whose part, widened by Around, holds at most one root.
template <class D>
struct OnlyRoots
{
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  /// Run Newton's method, which may fail in some lanes.
  HWY_INLINE OnlyRoots(const StraightSystem<D>& system, const KnownPart<D>& part, M lanes)
  {
    const D d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0), lastStep = hn::Set(d, LastStep);
    std::copy(part.Start, part.Start + 3, this->At);
    this->IsFound = this->IsPositive = hn::Lt(one, zero);
    for (int step = 0; step < MostStepsOfVectors && !hn::AllFalse(d, lanes); ++step)
    {
      V products[4], rows[3][3], values[3], columns[3][3];
      ProductsOf(this->At, products);
      system.SlopesAt(this->At, products, rows);
      system.ValuesAt(this->At, products, values);
      const V determinant = Adjoint(rows, columns);
      const V scale = hn::Div(one, determinant);
      V longest = zero, moved = zero;
      M isNear = lanes;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const V column[3] = { columns[0][i], columns[1][i], columns[2][i] };
        const V move = hn::Mul(scale, DotRows(values, column));
        const V from = hn::Sub(hn::Sub(this->At[i], move), part.Middle[i]);
        const V near = hn::Max(hn::Neg(part.Reach[i]), hn::Min(from, part.Reach[i]));
        const V next = hn::Add(part.Middle[i], near);
        isNear = hn::And(isNear, hn::Le(hn::Abs(from), part.Reach[i]));
        longest = hn::Max(longest, hn::Abs(move));
        moved = hn::Max(moved, hn::Abs(hn::Sub(next, this->At[i])));
        this->At[i] = hn::IfThenElse(lanes, next, this->At[i]);
      }
      const M isLast = hn::And(lanes, hn::Le(longest, lastStep));
      const M isFound = hn::And(isLast, isNear);
      this->IsFound = hn::Or(this->IsFound, isFound);
      this->IsPositive = hn::Or(this->IsPositive, hn::And(isFound, hn::Gt(determinant, zero)));
      lanes = hn::AndNot(hn::Or(isLast, hn::Le(moved, hn::Set(d, LastMove))), lanes);
    }
    this->IsInCell = this->IsFound;
    const V error = hn::Mul(hn::Set(d, MostOfErrors), part.Error);
    const V most = Three(one, hn::Set(d, Margin), error);
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->IsInCell = hn::And(this->IsInCell, hn::Le(hn::Abs(this->At[i]), most));
    }
  }

  V At[3];
  M IsFound; ///< the root is known; if it lies outside of the cell, the part holds none
  M IsInCell;
  M IsPositive; ///< the determinant of slopes
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
