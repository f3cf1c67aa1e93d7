// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerMerge_h
#define TemporalCoherence_LayerMerge_h

#include "Scene/Frame.h"
#include "Scene/Tiles.h"

#include <vector>

namespace TemporalCoherence
{

/// Merge lists of layers of a tile, given one behind the other, into the order of Frame::Layers:
/// round by round from front to back, and by pixel within a round. Each ray meets its layers in the
/// order of HitOrder. A layer that is in several lists remains once.
/// \param width     of the picture
/// \param isovalues that the layers name by their positions
/// \param layers    in any order
/// \throws std::bad_alloc; the layers are then unchanged
void MergeLayers(const PixelRect& part, int width, const std::vector<double>& isovalues,
  std::vector<LayerHit>& layers);

}

#endif
