// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CapTiles_h
#define TemporalCoherence_CapTiles_h

#include "Acceleration/ValueRangePyramid.h"
#include "Scene/FrameKey.h"
#include "Trace/RaySource.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// 1 for each tile in which a ray may begin in a solid, so that it is capped there, else 0.
///
/// Rays begin at faces of the field's box, at the near plane, and at planes that clip or crop. What
/// lies there is only in a solid if its leaf has a sample that is not below the lowest isovalue.
/// Such leaves are projected. Caps behind hidden cells are no matter here: these cells are active.
/// \param rays   of the frame
/// \param ranges of its field
/// \pre key.Samples.HasCells(), and there are isovalues
/// \throws std::bad_alloc
std::vector<std::uint8_t> FindCapTiles(
  const FrameKey& key, const RaySource& rays, const ValueRangePyramid& ranges);

}

#endif
