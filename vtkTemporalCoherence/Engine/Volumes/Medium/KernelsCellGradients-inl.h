// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Gradients of a field in a vector of cells.
// Kernels include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsCellGradients_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellGradients_inl_h
#undef TemporalCoherence_KernelsCellGradients_inl_h
#else
#define TemporalCoherence_KernelsCellGradients_inl_h
#endif

#include "Volumes/Medium/KernelsCubic-inl.h"
#include "Volumes/Medium/KernelsVectors-inl.h"
#include "Volumes/Medium/VolumeCell.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Twice the gradients of a field at the corners of a vector of cells.
struct CornerGradients
{
  /// \param places offsets of the cells from the first one of a list, in floats
  HWY_INLINE CornerGradients(const VolumeCell* cells, const std::int32_t* places)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      LoadRows(cells->Gradients[axis].data(), places, this->Along[axis]);
      LoadRows(cells->Gradients[axis].data() + 4, places, this->Along[axis] + 4);
    }
  }
  HWY_INLINE CornerGradients()
  {
    for (auto& corners : this->Along)
    {
      std::fill_n(corners, 8, hn::Zero(Floats()));
    }
  }

  V Along[3][8]; ///< by axis, [x + 2 y + 4 z]
};

/// Twice the gradients of a field along a vector of segments, trilinear between the corners.
struct LineGradients
{
  LineGradients() = default;

  /// \param begin, across paths through the cells
  HWY_INLINE LineGradients(const CornerGradients& corners, const V begin[3], const V across[3])
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Along[axis] = Cubics::HWY_NAMESPACE::CubicAlong(corners.Along[axis], begin, across);
    }
  }

  HWY_INLINE void At(V share, V gradient[3]) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      gradient[axis] = this->Along[axis].At(share);
    }
  }

  /// Derivatives of the gradients by the share.
  HWY_INLINE void ChangeAt(V share, V change[3]) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      change[axis] = this->Along[axis].SlopeAt(share);
    }
  }

  Cubics::HWY_NAMESPACE::Cubic<V> Along[3];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
