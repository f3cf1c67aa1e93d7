// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ColdTiles_h
#define TemporalCoherence_ColdTiles_h

#include "Acceleration/TileBounds.h"
#include "Render/Routes.h"

#include <functional>

namespace TemporalCoherence
{

/// Makes one tile of a frame. Thread-safe.
/// \throws std::bad_alloc
using TileWork = std::function<TraceCounts(std::int64_t tile, const PixelRect& part, Frame& frame)>;

// How cold frames are made, for routes that make some of their tiles in this way.

/// Make room for the frame, and find out where its rays can see anything.
LeapedSpace BeginSurfaces(FrameTask& task);
LeapedSpace BeginBlended(FrameTask& task);

/// The work of a cold frame on a tile. The task must outlive it.
/// \throws std::bad_alloc
TileWork SurfaceWork(const FrameTask& task, const LeapedSpace& space);
TileWork BlendedWork(const FrameTask& task, const LeapedSpace& space);

}

#endif
