// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Paths of a beam's rays through a cell, and their light in the cells of a leaf. Kernels include
// this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsBeamPaths_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsBeamPaths_inl_h
#undef TemporalCoherence_KernelsBeamPaths_inl_h
#else
#define TemporalCoherence_KernelsBeamPaths_inl_h
#endif

#include "Scene/RayBatch.h"
#include "Volumes/Medium/KernelsVectors-inl.h"

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

/// Light that the rays of a tile gain in the cells of a leaf. Each vector of rays in a cell has a
/// row of slots, from front to back. The light waits for the hard segments.
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
  V Enter, Length;         ///< see VolumeSegments
  V Begin[3], Across[3];   ///< in the coordinates of the cell
  V Shown;                 ///< transmittance in front of the cell
  V Off;                   ///< error of the rays' light so far
  std::size_t Ray;         ///< number of the first ray
  std::size_t Slot;        ///< slot of the first ray
  std::int32_t CellNumber; ///< index in the list of the leaf's cells
};

/// Store the ascending numbers of some lanes.
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
