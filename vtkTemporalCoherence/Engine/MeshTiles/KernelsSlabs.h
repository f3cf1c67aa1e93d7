// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsSlabs_h
#define TemporalCoherence_KernelsSlabs_h

#include "MeshTiles/KernelsOutlines.h"
#include "MeshTiles/SlabOutlines.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Find the pixels of a tile that may see values of a band in each tetrahedron of a leaf. Values
/// that are not finite may be any.
/// \param width  of the band, as a difference from its lowest value
/// \param pixels one bit each for every cell: column + 8 row
void PixelsOfSlabs(const OutlineView& view, const SlabOutlines& cells, double width,
  std::array<std::uint64_t, 64>& pixels);

}

#endif
