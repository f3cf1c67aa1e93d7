// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells as vectors of rays see them. Kernels include this file once for each kind of vectors, hence
// the toggling guard.
#if defined(TemporalCoherence_KernelsSheared_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsSheared_inl_h
#undef TemporalCoherence_KernelsSheared_inl_h
#else
#define TemporalCoherence_KernelsSheared_inl_h
#endif

#include "Mesh/Cells/CornerPoints.h"

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

using Doubles = hn::CappedTag<double, WidestVector / 2>;

/// One bit for each lane.
template <class D>
HWY_INLINE std::uint64_t BitsOf(D d, hn::Mask<D> mask)
{
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0];
}

/// The points of one cell, broadcast to all lanes.
template <class D, class Cell>
struct SamePoints
{
  using V = hn::Vec<D>;
  HWY_INLINE SamePoints(const Cell& cell, std::size_t axis)
    : From(cell)
    , Axes(TurnedAxes(axis))
  {
  }
  HWY_INLINE V At(std::size_t corner, std::size_t a) const
  {
    return hn::Set(D(), this->From.Points[corner][this->Axes[a]]);
  }
  HWY_INLINE V Value(std::size_t corner) const { return hn::Set(D(), this->From.Values[corner]); }
  HWY_INLINE V Handedness() const { return hn::Set(D(), this->From.Handedness); }

  const Cell& From;
  std::array<glm::length_t, 3> Axes;
};

/// Places of rays.
template <class D>
using Places = hn::Vec<hn::RebindToSigned<D>>;

/// A vector of rays.
template <class D>
struct ShearedRays
{
  using V = hn::Vec<D>;

  /// Rays in any order.
  HWY_INLINE ShearedRays(const MeshRays& rays, Places<D> ray)
  {
    const D d;
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Turned[a] = hn::GatherIndex(d, rays.Turned[a].data(), ray);
    }
    this->ShearX = hn::GatherIndex(d, rays.ShearX.data(), ray);
    this->ShearY = hn::GatherIndex(d, rays.ShearY.data(), ray);
    this->PerDepth = hn::GatherIndex(d, rays.PerDepth.data(), ray);
  }

  HWY_INLINE ShearedRays(const MeshRays& rays, std::size_t i)
  {
    const D d;
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Turned[a] = hn::LoadU(d, &rays.Turned[a][i]);
    }
    this->ShearX = hn::LoadU(d, &rays.ShearX[i]);
    this->ShearY = hn::LoadU(d, &rays.ShearY[i]);
    this->PerDepth = hn::LoadU(d, &rays.PerDepth[i]);
  }

  /// A corner in sheared coordinates. t is the distance along the ray.
  template <class Points>
  HWY_INLINE void See(const Points& points, std::size_t corner, V& x, V& y, V& t) const
  {
    const V depth = hn::Sub(points.At(corner, 2), this->Turned[2]);
    x = hn::Sub(hn::Sub(points.At(corner, 0), this->Turned[0]), hn::Mul(this->ShearX, depth));
    y = hn::Sub(hn::Sub(points.At(corner, 1), this->Turned[1]), hn::Mul(this->ShearY, depth));
    t = hn::Mul(depth, this->PerDepth);
  }

  V Turned[3], ShearX, ShearY, PerDepth;
};

/// Call work(first ray, bits of its wanted rays) for each vector with a wanted ray.
template <class Work>
HWY_INLINE void ForEachVector(std::uint64_t which, const Work& work)
{
  const Doubles d;
  constexpr std::uint64_t lanes = (std::uint64_t(1) << hn::MaxLanes(d)) - 1;
  for (std::size_t i = 0; i < MeshRays::Capacity && which >> i != 0; i += hn::Lanes(d))
  {
    const std::uint64_t wanted = which >> i & lanes;
    if (wanted != 0)
    {
      work(i, wanted);
    }
  }
}

/// Call work(places of rays, bits of lanes) for wanted rays, packed into full vectors: a cell
/// covers only parts of a tile's rows.
template <class Work>
HWY_INLINE void ForEachFullVector(std::uint64_t which, const Work& work)
{
  constexpr std::size_t lanes = hn::MaxLanes(Doubles());
  HWY_ALIGN std::int64_t places[MeshRays::Capacity + lanes];
  std::size_t count = 0;
  for (std::uint64_t left = which; left != 0; left &= left - 1)
  {
    places[count++] = static_cast<std::int64_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
  }
  // No lane is uninitialised.
  std::fill_n(places + count, lanes, count > 0 ? places[count - 1] : 0);
  for (std::size_t i = 0; i < count; i += lanes)
  {
    work(places + i, (std::uint64_t(1) << std::min(lanes, count - i)) - 1);
  }
}

/// Call work(tag, points, vector of rays, its first ray, bits of its wanted rays) for each vector
/// with a wanted ray. Rays with different axes are never wanted together.
template <class Cell, class Work>
HWY_INLINE void ForEachVector(
  const MeshRays& rays, std::uint64_t which, const Cell& cell, const Work& work)
{
  const Doubles d;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::uint64_t along = which & rays.Along[axis];
    const SamePoints<Doubles, Cell> points(cell, axis);
    ForEachVector(along,
      [&](std::size_t i, std::uint64_t wanted) HWY_ATTR
      { work(d, points, ShearedRays<Doubles>(rays, i), i, wanted); });
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
