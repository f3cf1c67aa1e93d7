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

#include "Mesh/Cells/HexahedronFunctions.h"
#include "Mesh/Cells/KernelsSheared-inl.h"

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

}
}
}
HWY_AFTER_NAMESPACE();

#endif
