// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The rays of a beam in a cell, and what they add in the cells of a leaf. Kernels include this file
// once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsBeamPaths_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsBeamPaths_inl_h
#undef TemporalCoherence_KernelsBeamPaths_inl_h
#else
#define TemporalCoherence_KernelsBeamPaths_inl_h
#endif

#include "Blending/KernelsVectors-inl.h"
#include "Scene/RayBatch.h"

#include <array>
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

/// What the rays of a tile add in the cells of a leaf, in slots: vector by vector, from front to
/// back. Kept until hard segments are added, too.
struct LeafSums
{
  static constexpr std::size_t Slots = 64 * RayBatch::Capacity;
  template <typename T>
  struct alignas(64) Array : std::array<T, Slots + WidestVector>
  {
  };

  Array<float> Passed, First;
  std::array<Array<float>, 3> Color;
};

/// A vector of rays in a cell.
struct CellPaths
{
  V Enter, Length;         ///< as those of VolumeSegments
  V Begin[3], Across[3];   ///< in the coordinates of the cell
  V Shown;                 ///< the share of light that comes to the viewer
  V Off;                   ///< how far what rays have shown may be off
  std::size_t Ray;         ///< the first one
  std::size_t Slot;        ///< of the first one
  std::int32_t CellNumber; ///< among those of the leaf
};

/// Store the numbers of some lanes, which ascend.
/// \param first number of the first lane
HWY_INLINE void AppendNumbers(M which, std::size_t first, std::int32_t* to)
{
  const Integers di;
  const auto numbers = hn::Iota(di, static_cast<std::int32_t>(first));
  hn::StoreU(hn::Compress(numbers, hn::RebindMask(di, which)), di, to);
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
