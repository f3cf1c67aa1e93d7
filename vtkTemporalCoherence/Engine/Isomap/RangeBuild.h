// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RangeBuild_h
#define TemporalCoherence_RangeBuild_h

#include "Isomap/BandBuilder.h"
#include "Isomap/Isomap.h"
#include "Scene/Progress.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// A requested band of isovalues, to be built for the whole picture at once.
struct RangeBuild
{
  BandSource Source;
  ValueBand Band;
  std::size_t MemoryLimit; ///< of all bands together, in bytes
  std::uint64_t Frame;     ///< number of the frame that needs it
  double Patience = 0.05;  ///< seconds between reports, plus the time to finish the tiles in work
};

/// Build a band for every group of an isomap. Bands that it contains are dropped, and the least
/// recently used ones if the memory limit requires it. Old and new bands together stay within the
/// limit, up to one group's band for each thread.
/// \param isDropped set if a band was dropped for want of memory
/// \param cellsRead is increased
/// \return Built, or Stopped or TooLarge, which leave nothing of the band. Other bands may have
///         made room for it, but only if sample groups showed that it probably fits.
/// \throws std::bad_alloc; this leaves nothing of the band, either
Isomap::Outcome BuildRange(const RangeBuild& wanted, Isomap& map, const ReportProgress& report,
  bool& isDropped, std::int64_t& cellsRead);

}

#endif
