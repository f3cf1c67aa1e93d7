// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hexahedra as functions that vectors of rays see. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsSeenFunctions_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsSeenFunctions_inl_h
#undef TemporalCoherence_KernelsSeenFunctions_inl_h
#else
#define TemporalCoherence_KernelsSeenFunctions_inl_h
#endif

#include "Mesh/HexahedronFunctions.h"
#include "Mesh/KernelsRoots-inl.h"
#include "Mesh/KernelsSheared-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The functions of one cell, the same for all rays, which have the same axis.
template <class D>
struct SameFunctions
{
  using V = hn::Vec<D>;
  HWY_INLINE SameFunctions(const HexahedronFunctions& cell, std::size_t axis)
    : From(cell)
  {
    const auto axes = TurnedAxes(axis);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Coordinates[a] = cell.Coordinates[static_cast<std::size_t>(axes[a])].data();
    }
  }
  HWY_INLINE V At(std::size_t a, std::size_t k, const std::size_t*) const
  {
    return hn::Set(D(), this->Coordinates[a][k]);
  }
  HWY_INLINE V Difference(std::size_t k, const std::size_t*) const
  {
    return hn::Set(D(), this->From.Difference[k]);
  }
  HWY_INLINE V Far(const std::size_t*) const { return hn::Set(D(), this->From.Far); }
  HWY_INLINE V LargestDifference(const std::size_t*) const
  {
    return hn::Set(D(), this->From.LargestDifference);
  }

  const HexahedronFunctions& From;
  const double* Coordinates[3];
};

/// Those of another cell for each ray.
template <class D>
struct OwnFunctions
{
  using V = hn::Vec<D>;
  HWY_INLINE OwnFunctions(const HexahedronFunctions* cells, const MeshRays& rays)
    : Cells(cells)
  {
    for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
    {
      const auto axes = TurnedAxes(rays.AxisOf(std::min(ray, rays.Count - 1)));
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Axes[a][ray] = static_cast<std::uint8_t>(axes[a]);
      }
    }
  }
  HWY_INLINE V At(std::size_t a, std::size_t k, const std::size_t* ray) const
  {
    return this->Gather(
      ray, [&](std::size_t i) HWY_ATTR { return this->Cells[i].Coordinates[this->Axes[a][i]][k]; });
  }
  HWY_INLINE V Difference(std::size_t k, const std::size_t* ray) const
  {
    return this->Gather(ray, [&](std::size_t i) HWY_ATTR { return this->Cells[i].Difference[k]; });
  }
  HWY_INLINE V Far(const std::size_t* ray) const
  {
    return this->Gather(ray, [&](std::size_t i) HWY_ATTR { return this->Cells[i].Far; });
  }
  HWY_INLINE V LargestDifference(const std::size_t* ray) const
  {
    return this->Gather(
      ray, [&](std::size_t i) HWY_ATTR { return this->Cells[i].LargestDifference; });
  }

  const HexahedronFunctions* Cells;
  TileArray<std::uint8_t> Axes[3];

private:
  template <class Get>
  HWY_INLINE V Gather(const std::size_t* ray, const Get& get) const
  {
    HWY_ALIGN double values[hn::MaxLanes(D())];
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
    {
      values[lane] = get(ray[lane]);
    }
    return hn::Load(D(), values);
  }
};

/// Some rays, in any order.
template <class D>
struct GatheredRays
{
  using V = hn::Vec<D>;

  HWY_INLINE GatheredRays(const MeshRays& rays, const std::size_t* ray)
  {
    HWY_ALIGN double values[6][hn::MaxLanes(D())];
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
    {
      const std::size_t i = ray[lane];
      values[0][lane] = rays.Turned[0][i];
      values[1][lane] = rays.Turned[1][i];
      values[2][lane] = rays.Turned[2][i];
      values[3][lane] = rays.ShearX[i];
      values[4][lane] = rays.ShearY[i];
      values[5][lane] = rays.PerDepth[i];
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Turned[a] = hn::Load(D(), values[a]);
    }
    this->ShearX = hn::Load(D(), values[3]);
    this->ShearY = hn::Load(D(), values[4]);
    this->PerDepth = hn::Load(D(), values[5]);
  }

  V Turned[3], ShearX, ShearY, PerDepth;
};

/// A hexahedron as a vector of rays sees it. All functions are trilinear, by their coefficients.
template <class D>
struct SeenFunctions
{
  using V = hn::Vec<D>;

  /// \param ray the place of each ray, for functions of pairs
  template <class Rays, class Functions>
  HWY_INLINE SeenFunctions(const Rays& rays, const Functions& functions, const std::size_t* ray)
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      V x = functions.At(0, k, ray), y = functions.At(1, k, ray), depth = functions.At(2, k, ray);
      if (k == 0)
      {
        x = hn::Sub(x, rays.Turned[0]);
        y = hn::Sub(y, rays.Turned[1]);
        depth = hn::Sub(depth, rays.Turned[2]);
      }
      this->System[0][k] = hn::Sub(x, hn::Mul(rays.ShearX, depth));
      this->System[1][k] = hn::Sub(y, hn::Mul(rays.ShearY, depth));
      this->System[2][k] = functions.Difference(k, ray);
      this->T[k] = hn::Mul(depth, rays.PerDepth);
    }
    const V far = Three(hn::Abs(rays.Turned[0]), hn::Abs(rays.Turned[1]), hn::Abs(rays.Turned[2]));
    this->Largest[0] = this->Largest[1] = hn::Add(far, functions.Far(ray));
    this->Largest[2] = functions.LargestDifference(ray);
  }

  V System[3][8]; ///< x, y and the difference, whose common roots are searched
  V T[8];         ///< the distance along the ray
  V Largest[3];   ///< of the system, and of all that it was computed from
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
