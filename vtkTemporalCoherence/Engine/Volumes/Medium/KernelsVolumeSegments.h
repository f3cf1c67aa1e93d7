// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsVolumeSegments_h
#define TemporalCoherence_KernelsVolumeSegments_h

#include "Lattice/KernelsWalk.h"
#include "Scene/Field.h"
#include "Volumes/Medium/VolumeSegments.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Kernels that find the segments of rays in cells, in the widest vectors of the machine. Every
/// kind of vectors gives the same bits.
namespace SegmentsKernels
{

/// Maps samples to bins: u = sample * PerValue + Shift.
struct BinScale
{
  float PerValue, Shift;
};

/// Bands of visible values, in bins. Both ends belong to a band.
struct SeenBins
{
  static constexpr std::size_t Most = 4;
  std::size_t Count = 0; ///< 0: everything is visible
  std::array<std::array<float, 2>, Most> Bands{};
};

/// Cells of walking rays, from one place of the rays' cell lists: at most one cell for each ray.
struct CellRow
{
  const RayWalks& Walks;
  const NextCells& Next;
  std::size_t Place;

  const std::array<RayBatch::Array<double>, 3>& Cells() const
  {
    return this->Next.Cell[this->Place];
  }
};

/// Values at the corners of the cells of a row, in bins: [x + 2 y + 4 z].
using CornerValues = std::array<RayBatch::Array<float>, 8>;

/// Find the segments of rays in a row of cells, and append their visible parts.
/// \pre there is room for a segment of each ray
void FindSegments(
  const CellRow& row, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found);

/// Find segments in narrow samples, which the kernel itself reads from memory.
void FindSegments(const CellRow& row, const NarrowSamples<std::uint8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);
void FindSegments(const CellRow& row, const NarrowSamples<std::int8_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);
void FindSegments(const CellRow& row, const NarrowSamples<std::uint16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);
void FindSegments(const CellRow& row, const NarrowSamples<std::int16_t>& samples,
  const BinScale& scale, const SeenBins& seen, VolumeSegments& found);

}

}

#endif
