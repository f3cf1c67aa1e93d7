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

/// Cells of walking rays, at most one of each ray: those at one place of their lists.
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

/// The corners of the cells of a row, in bins: [x + 2 y + 4 z].
using CornerValues = std::array<RayBatch::Array<float>, 8>;

/// Find the segments of rays in a row of cells, and append the parts of them in which something may
/// be seen.
/// \pre there is room for a segment of each ray
void FindSegments(
  const CellRow& row, const CornerValues& corners, const SeenBins& seen, VolumeSegments& found);

/// The same for samples that vectors gather.
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
