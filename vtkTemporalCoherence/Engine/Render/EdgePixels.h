// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EdgePixels_h
#define TemporalCoherence_EdgePixels_h

#include "Scene/Frame.h"
#include "Scene/Tiles.h"

#include <cstdint>

namespace TemporalCoherence
{

/// What tells an edge.
enum class EdgeSign : std::uint8_t
{
  Colors, ///< neighbours differ in colour or opacity
  Normals ///< neighbours show other surfaces, or their normals differ: for grainy colours
};

/// Find the pixels of a tile that differ from one of their eight neighbours.
/// \param frame with one ray a pixel
/// \return one bit for each pixel of `part`, row by row
std::uint64_t FindEdges(const Frame& frame, const PixelRect& part, EdgeSign sign);

}

#endif
