// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The cells that hits lie in.

#include "Shade/KernelsGradients.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Shade/KernelsCells.cxx"
#include <hwy/foreach_target.h>

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

/// Share of a voxel by which a hit of nearest interpolation is moved along the ray, from the face
/// between two samples into the box of the sample that the ray enters.
constexpr double IntoNextBox = 1e-2;

template <class V>
HWY_INLINE V Dot(V ax, V ay, V az, V bx, V by, V bz)
{
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

/// Store doubles as Real.
template <class D>
HWY_INLINE void StoreAs(D d, hn::Vec<D> value, double* to)
{
  hn::StoreU(value, d, to);
}
template <class D>
HWY_INLINE void StoreAs(D, hn::Vec<D> value, float* to)
{
  const hn::Rebind<float, D> df;
  hn::StoreU(hn::DemoteTo(df, value), df, to);
}

template <typename Real>
HWY_INLINE bool FindAllCells(const CellSpace& space, const HitRays& rays, CellPoints<Real>& found)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
  const glm::dmat4& m = space.IndexFromWorld;
  auto isOuter = hn::Lt(zero, zero);
  // Up to the end of the widest vectors of Real.
  for (std::size_t i = 0; i < WholeVectors(found.Count); i += hn::Lanes(d))
  {
    V p[3];
    HitPoints::HWY_NAMESPACE::Find(d, rays, m, i, p);
    if (space.IsNearest)
    {
      V unit[3], along[3];
      for (std::size_t a = 0; a < 3; ++a)
      {
        unit[a] = hn::LoadU(d, &(*rays.Direction)[a][i]);
      }
      for (int a = 0; a < 3; ++a)
      {
        along[a] = Dot(
          hn::Set(d, m[0][a]), hn::Set(d, m[1][a]), hn::Set(d, m[2][a]), unit[0], unit[1], unit[2]);
      }
      const V square = Dot(along[0], along[1], along[2], along[0], along[1], along[2]);
      const V perLength = hn::Div(one, hn::Sqrt(square));
      for (int a = 0; a < 3; ++a)
      {
        p[a] = hn::Add(p[a], hn::Mul(hn::Set(d, IntoNextBox), hn::Mul(along[a], perLength)));
      }
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V last = hn::Set(d, static_cast<double>(space.Dimensions[static_cast<int>(a)] - 2));
      const V cell = hn::Min(hn::Max(hn::Floor(p[a]), zero), last);
      const V in = hn::Min(hn::Max(hn::Sub(p[a], cell), zero), one);
      const V at = space.IsNearest ? hn::Floor(hn::Add(in, half)) : in;
      isOuter = hn::Or(isOuter, hn::Or(hn::Le(cell, zero), hn::Ge(cell, last)));
      hn::StoreU(hn::DemoteTo(di, cell), di, &found.Cell[a][i]);
      StoreAs(d, at, &found.At[a][i]);
    }
  }
  return hn::AllFalse(d, isOuter);
}

bool CellsFloat(const CellSpace& space, const HitRays& rays, CellPoints<float>& found)
{
  return FindAllCells(space, rays, found);
}

bool CellsDouble(const CellSpace& space, const HitRays& rays, CellPoints<double>& found)
{
  return FindAllCells(space, rays, found);
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

HWY_EXPORT(CellsFloat);
HWY_EXPORT(CellsDouble);

bool FindCells(const CellSpace& space, const HitRays& rays, CellPoints<float>& found)
{
  return HWY_DYNAMIC_DISPATCH(CellsFloat)(space, rays, found);
}

bool FindCells(const CellSpace& space, const HitRays& rays, CellPoints<double>& found)
{
  return HWY_DYNAMIC_DISPATCH(CellsDouble)(space, rays, found);
}

}
}
#endif
