// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshOrder_h
#define TemporalCoherence_MeshOrder_h

#include "Mesh/Tree/MeshCheck.h"
#include "Mesh/Tree/MeshReader.h"
#include "Scene/DefaultInitAllocator.h"
#include "Scene/Progress.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

using CellNumbers = std::vector<std::uint32_t, DefaultInitAllocator<std::uint32_t>>;

/// Sort the cells of chunks along a Hilbert curve, so that neighbours in the order are neighbours
/// in space. Cells whose centres the curve cannot tell apart are sorted along a finer curve.
/// \return the numbers of cells; the same for any number of threads; empty if it was stopped
/// \throws std::bad_alloc
CellNumbers OrderCells(const MeshReader& reader, const std::vector<CellChunk>& chunks,
  const ReportProgress& progress, bool& isStopped);

/// The memory that OrderCells takes for a number of cells, at its peak.
std::size_t MemoryToOrder(std::int64_t cells);

}

#endif
