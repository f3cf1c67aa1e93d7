// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Prepares tetrahedra for the search for crossings, in vectors of cells.

#include "Mesh/Tracing/KernelsSortedTetrahedra.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tracing/KernelsSortedTetrahedra.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using V = hn::Vec<Doubles>;
using M = hn::Mask<Doubles>;

/// Points of a vector of cells: x, y, z and the difference.
struct PointVector
{
  V Of[4];

  /// Lexicographic order by x, y, z and the difference.
  HWY_INLINE M IsLessThan(const PointVector& other) const
  {
    M isLess = hn::Lt(this->Of[3], other.Of[3]);
    for (std::size_t a = 3; a-- > 0;)
    {
      const M isSame = hn::Eq(this->Of[a], other.Of[a]);
      isLess = hn::Or(hn::Lt(this->Of[a], other.Of[a]), hn::And(isSame, isLess));
    }
    return isLess;
  }
};

HWY_INLINE void Order(PointVector& a, PointVector& b)
{
  const M isTurned = b.IsLessThan(a);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const V first = hn::IfThenElse(isTurned, b.Of[i], a.Of[i]);
    b.Of[i] = hn::IfThenElse(isTurned, a.Of[i], b.Of[i]);
    a.Of[i] = first;
  }
}

/// MeshDifference, in vectors.
HWY_INLINE V DifferenceOf(const MeshDifference& difference, V value)
{
  const Doubles d;
  const V isovalue = hn::Set(d, difference.Level());
  const V least = hn::Set(d, MeshDifference::Least), largest = hn::Set(d, MeshDifference::Largest);
  const V scaled = hn::Mul(hn::Set(d, difference.Level()), hn::Set(d, difference.Unit()));
  const V from = hn::Sub(hn::Mul(value, hn::Set(d, difference.Unit())), scaled);
  const V lowest = hn::Neg(largest);
  const V below = hn::IfThenElse(hn::Gt(from, lowest), hn::Min(from, hn::Neg(least)), lowest);
  const V above = hn::Min(hn::Max(from, least), largest);
  const V inside = hn::IfThenZeroElse(hn::Eq(value, isovalue), above);
  return hn::IfThenElse(hn::Ge(value, isovalue), inside, below);
}

/// Handedness of sorted points, as in TetrahedronPoints.
HWY_INLINE V HandednessOf(const PointVector points[4])
{
  const Doubles d;
  V edge[3][3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      edge[i][a] = hn::Sub(points[i + 1].Of[a], points[0].Of[a]);
    }
  }
  const auto across = [&](std::size_t a, std::size_t b) HWY_ATTR
  { return hn::Sub(hn::Mul(edge[0][a], edge[1][b]), hn::Mul(edge[1][a], edge[0][b])); };
  const V xy = hn::Add(hn::Mul(across(1, 2), edge[2][0]), hn::Mul(across(2, 0), edge[2][1]));
  const V volume = hn::Add(xy, hn::Mul(across(0, 1), edge[2][2]));
  return hn::IfThenElse(hn::Lt(volume, hn::Zero(d)), hn::Set(d, -1.0), hn::Set(d, 1.0));
}

std::uint64_t Sort(const MeshKernels::TetrahedronLanes& cells, const MeshDifference& difference,
  MeshKernels::SortedTetrahedra& sorted)
{
  const Doubles d;
  std::uint64_t passed = 0;
  for (std::size_t i = 0; i < cells.Count; i += hn::Lanes(d))
  {
    PointVector points[4];
    M isAnyInside = hn::Lt(hn::Set(d, 1.0), hn::Zero(d)), isAnyOutside = isAnyInside;
    for (std::size_t point = 0; point < 4; ++point)
    {
      const auto& numbers = cells.Numbers[point];
      for (std::size_t a = 0; a < 3; ++a)
      {
        points[point].Of[a] = hn::Load(d, &numbers[a][i]);
      }
      const V from = DifferenceOf(difference, hn::Load(d, &numbers[3][i]));
      points[point].Of[3] = from;
      const M isInside = hn::Ge(from, hn::Zero(d));
      isAnyInside = hn::Or(isAnyInside, isInside);
      isAnyOutside = hn::Or(isAnyOutside, hn::Not(isInside));
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::And(isAnyInside, isAnyOutside), bits);
    passed |= static_cast<std::uint64_t>(bits[0]) << i;
    // A stable sort: equal points keep their order.
    for (std::size_t last = 3; last > 0; --last)
    {
      for (std::size_t point = 0; point < last; ++point)
      {
        Order(points[point], points[point + 1]);
      }
    }
    hn::Store(HandednessOf(points), d, &sorted.Handedness[i]);
    for (std::size_t point = 0; point < 4; ++point)
    {
      const V* const of = points[point].Of;
      hn::StoreInterleaved4(of[0], of[1], of[2], of[3], d, sorted.Corners[point][i].data());
    }
  }
  return passed;
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(Sort);

std::uint64_t SortTetrahedra(const MeshKernels::TetrahedronLanes& cells,
  const MeshDifference& difference, MeshKernels::SortedTetrahedra& sorted)
{
  return HWY_DYNAMIC_DISPATCH(Sort)(cells, difference, sorted);
}

}
#endif
