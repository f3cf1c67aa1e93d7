// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The functions of hexahedra in vectors of rays. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsCellFunctions_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellFunctions_inl_h
#undef TemporalCoherence_KernelsCellFunctions_inl_h
#else
#define TemporalCoherence_KernelsCellFunctions_inl_h
#endif

#include "Mesh/HexahedronFunctions.h"
#include "Mesh/KernelsSheared-inl.h"

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

/// The functions of one cell, the same for all rays, which have the same axis.
template <class D>
struct SameFunctions
{
  using V = hn::Vec<D>;
  HWY_INLINE SameFunctions(const HexahedronFunctions& cell, std::size_t axis)
    : First(cell)
  {
    const auto axes = TurnedAxes(axis);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Axes[a] = static_cast<std::size_t>(axes[a]);
    }
  }
  /// \param number in First
  HWY_INLINE V Of(const double& number, Places<D>) const { return hn::Set(D(), number); }
  /// Number k of a turned axis.
  /// \param numbers in First, of all axes
  template <std::size_t Number>
  HWY_INLINE V OfAxis(const std::array<std::array<double, Number>, 3>& numbers, std::size_t a,
    std::size_t k, Places<D>) const
  {
    return hn::Set(D(), numbers[this->Axes[a]][k]);
  }

  const HexahedronFunctions& First;

private:
  std::size_t Axes[3];
};

/// Those of another cell for each ray.
template <class D>
struct OwnFunctions
{
  using V = hn::Vec<D>;
  HWY_INLINE OwnFunctions(const HexahedronFunctions* cells, const MeshRays& rays)
    : First(cells[0])
  {
    static_assert(sizeof(*cells) % sizeof(double) == 0);
    for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
    {
      const auto axes = TurnedAxes(rays.AxisOf(std::min(ray, rays.Count - 1)));
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Axes[a][ray] = axes[a];
      }
      this->Start[ray] = static_cast<std::int64_t>(ray * (sizeof(*cells) / sizeof(double)));
    }
  }
  HWY_INLINE V Of(const double& number, Places<D> ray) const
  {
    return hn::GatherIndex(D(), &number, hn::GatherIndex(DI(), this->Start.data(), ray));
  }
  template <std::size_t Number>
  HWY_INLINE V OfAxis(const std::array<std::array<double, Number>, 3>& numbers, std::size_t a,
    std::size_t k, Places<D> ray) const
  {
    const auto axis = hn::GatherIndex(DI(), this->Axes[a].data(), ray);
    auto at = hn::GatherIndex(DI(), this->Start.data(), ray);
    for (std::size_t i = 0; i < Number; ++i)
    {
      at = hn::Add(at, axis);
    }
    return hn::GatherIndex(D(), &numbers[0][k], at);
  }

  const HexahedronFunctions& First;

private:
  using DI = hn::RebindToSigned<D>;
  TileArray<std::int64_t> Axes[3], Start; ///< of rays
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
