// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsPassedCells_h
#define TemporalCoherence_KernelsPassedCells_h

#include "Trace/SegmentBatch.h"
#include "Trace/SurfaceTracer.h"

namespace TemporalCoherence
{

/// Find where segments cross zero once, in the widest vectors of the machine. The bits are those of
/// SurfaceTracer::FindLayers.
/// \param segments of the cells. Arrays are set up to the end of the last vector
/// \param isSolid  exits are no surfaces
/// \param cells    gets the results
void FindPassedSurfaces(SegmentBatch<float>& segments, bool isSolid, PassedCells& cells);
void FindPassedSurfaces(SegmentBatch<double>& segments, bool isSolid, PassedCells& cells);

/// Find the passages whose lowest key is at most `key`, and whose highest is at least that.
/// \param words get one bit for each
void FindHolding(const std::uint8_t* low, const std::uint8_t* high, std::size_t count,
  std::uint8_t key, std::uint64_t* words);

}

#endif
