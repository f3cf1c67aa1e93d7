// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsVolumeSegments_h
#define TemporalCoherence_KernelsVolumeSegments_h

#include "Blending/VolumeSegments.h"
#include "Scene/Field.h"
#include "Trace/KernelsWalk.h"

#include <array>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// Kernels that find what rays pass in cells, in the widest vectors of the machine. Every kind of
/// vectors gives the same bits.
namespace SegmentsKernels
{

/// How samples are counted in bins: u = sample * PerValue + Shift.
struct BinScale
{
  float PerValue, Shift;
};

/// Values in bins between which nothing else is seen; both ends count.
struct SeenBins
{
  static constexpr std::size_t Most = 4;
  std::size_t Count = 0; ///< 0: everything is
  std::array<std::array<float, 2>, Most> Bands{};
};

/// The corners of the cells of walks, in bins: [x + 2 y + 4 z].
using CornerValues = std::array<RayBatch::Array<float>, 8>;

/// Find the segments of rays in their present cells, and leave out those in which nothing is seen.
/// \param rays  the rays, and their cells
void FindSegments(
  const RayWalks& rays, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found);

/// The same for samples that vectors gather.
void FindSegments(const RayWalks& rays, const NarrowSamples<std::uint8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);
void FindSegments(const RayWalks& rays, const NarrowSamples<std::int8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);
void FindSegments(const RayWalks& rays, const NarrowSamples<std::uint16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);
void FindSegments(const RayWalks& rays, const NarrowSamples<std::int16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);

}

}

#endif
