// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KernelsRectilinear.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Shade/KernelsRectilinear.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsDifference-inl.h"
#include "Shade/KernelsHitPoints-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace GradientKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using V = hn::Vec<Doubles>;
using Integers = hn::RebindToSigned<Doubles>;

/// GridCoordinates::CellOf.
HWY_INLINE hn::Vec<Integers> CellsOf(const std::vector<double>& all, V coordinates)
{
  const Doubles d;
  const Integers di;
  auto before = hn::Zero(di);
  std::size_t left = all.size() - 2;
  while (left > 0)
  {
    const std::size_t step = (left + 1) / 2;
    const auto isBefore = hn::Lt(coordinates, hn::GatherIndex(d, all.data() + step, before));
    const auto steps = hn::Set(di, static_cast<std::int64_t>(step));
    before = hn::Add(before, hn::IfThenZeroElse(hn::RebindMask(di, isBefore), steps));
    left -= step;
  }
  return before;
}

void GridCellsOf(
  const GridCoordinates& grid, const glm::dmat4& m, const HitRays& rays, CellPoints<double>& found)
{
  const Doubles d;
  const hn::Rebind<std::int32_t, Doubles> dn;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < WholeVectors(found.Count); i += hn::Lanes(d))
  {
    V points[3];
    HitPoints::HWY_NAMESPACE::Find(d, rays, m, i, points);
    for (int a = 0; a < 3; ++a)
    {
      const V at = points[a];
      const std::vector<double>& all = grid.Of(a);
      const auto cell = CellsOf(all, at);
      const V low = hn::GatherIndex(d, all.data(), cell);
      const V size = hn::Sub(hn::GatherIndex(d, all.data() + 1, cell), low);
      const V share = hn::Min(hn::Max(hn::Div(hn::Sub(at, low), size), zero), one);
      const auto axis = static_cast<std::size_t>(a);
      hn::StoreU(hn::DemoteTo(dn, hn::ConvertTo(d, cell)), dn, &found.Cell[axis][i]);
      hn::StoreU(share, d, &found.At[axis][i]);
    }
  }
}

/// The gradients at the corners of a cell, along each axis: [4 face + edge], as in GridCells.
using CornerGradients = std::array<std::array<double, 8>, 3>;
constexpr std::size_t NumbersOfCell = sizeof(CornerGradients) / sizeof(double);

template <class V>
HWY_INLINE V Bounded(V gradient, V largest)
{
  return hn::Min(hn::Max(gradient, hn::Neg(largest)), largest);
}

HWY_INLINE void FindCornerGradients(
  const GridCells& around, std::size_t cell, double largest, CornerGradients& gradients)
{
  const hn::CappedTag<double, 4> d;
  const auto most = hn::Set(d, largest);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t edge = 0; edge < 4; edge += hn::Lanes(d))
    {
      const auto valueAt = [&](std::size_t place) HWY_ATTR
      {
        return DifferenceKernels::HWY_NAMESPACE::Differ(
          d, around.FromIsovalue[cell], hn::LoadU(d, &around.Around[cell][axis][place][edge]));
      };
      const auto first = hn::Sub(valueAt(2), valueAt(0));
      const auto second = hn::Sub(valueAt(3), valueAt(1));
      const std::array<double, 2>& between = around.Between[cell][axis];
      hn::StoreU(Bounded(hn::Div(first, hn::Set(d, between[0])), most), d, &gradients[axis][edge]);
      hn::StoreU(
        Bounded(hn::Div(second, hn::Set(d, between[1])), most), d, &gradients[axis][4 + edge]);
    }
  }
}

/// Interpolate the gradients at the corners of a vector of points' cells.
HWY_INLINE void Interpolate(const std::array<CornerGradients, RayBatch::Capacity>& corners,
  hn::Vec<Integers> first, const CellPoints<double>& points, std::size_t i, V sums[3])
{
  const Doubles d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  V weights[3][2];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const V at = hn::LoadU(d, &points.At[axis][i]);
    weights[axis][0] = hn::Sub(one, at);
    weights[axis][1] = at;
    sums[axis] = zero;
  }
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::size_t side[3] = { corner & 1, corner >> 1 & 1, corner >> 2 };
    const V weight =
      hn::Mul(hn::Mul(weights[0][side[0]], weights[1][side[1]]), weights[2][side[2]]);
    const auto counts = hn::Gt(weight, zero); // not 0 times a hole
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
      const double* const place = &corners[0][axis][4 * side[axis] + side[b] + 2 * side[c]];
      const V sum = hn::Add(sums[axis], hn::Mul(weight, hn::GatherIndex(d, place, first)));
      sums[axis] = hn::IfThenElse(counts, sum, sums[axis]);
    }
  }
}

void InGrid(const GridCells& around, const Array<std::int32_t>& cells,
  const CellPoints<double>& points, double largest, Vectors& gradients)
{
  std::array<CornerGradients, RayBatch::Capacity> corners;
  for (std::size_t cell = 0; cell < around.Count; ++cell)
  {
    FindCornerGradients(around, cell, largest, corners[cell]);
  }
  const Doubles d;
  const Integers di;
  const hn::Rebind<std::int32_t, Doubles> dn;
  Array<double> factors;
  for (std::size_t i = 0; i < WholeVectors(points.Count); ++i)
  {
    factors[i] = around.FromIsovalue[static_cast<std::size_t>(cells[i])].Factor;
  }
  for (std::size_t i = 0; i < WholeVectors(points.Count); i += hn::Lanes(d))
  {
    const auto numbers = hn::Set(dn, static_cast<std::int32_t>(NumbersOfCell));
    const auto first = hn::PromoteTo(di, hn::Mul(hn::LoadU(dn, &cells[i]), numbers));
    V sums[3];
    Interpolate(corners, first, points, i, sums);
    const V factor = hn::LoadU(d, &factors[i]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const V gradient = hn::Div(sums[axis], factor);
      hn::StoreU(Bounded(gradient, hn::Set(d, largest)), d, &gradients[axis][i]);
    }
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace GradientKernels
{

HWY_EXPORT(GridCellsOf);
HWY_EXPORT(InGrid);

void FindGridCells(const GridCoordinates& grid, const glm::dmat4& indexFromWorld,
  const HitRays& rays, CellPoints<double>& found)
{
  HWY_DYNAMIC_DISPATCH(GridCellsOf)(grid, indexFromWorld, rays, found);
}

void InterpolateInGrid(const GridCells& around, const Array<std::int32_t>& cells,
  const CellPoints<double>& points, double largest, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(InGrid)(around, cells, points, largest, gradients);
}

}
}
#endif
