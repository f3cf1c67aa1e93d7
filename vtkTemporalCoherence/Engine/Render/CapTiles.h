// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CapTiles_h
#define TemporalCoherence_CapTiles_h

#include "Acceleration/ValueRangePyramid.h"
#include "Lattice/RaySource.h"
#include "Scene/FrameKey.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// 1 for each tile in which a ray may begin in a solid, so that it is capped there, else 0.
///
/// Rays begin at faces of the field's box, at the near plane, and at planes that clip or crop. A
/// solid can only be there if the leaf's largest sample reaches the lowest isovalue, or if it has a
/// drawn label. Such leaves are projected. Caps behind hidden cells need no search: these cells are
/// active.
/// \param rays   of the frame
/// \param ranges of its field
/// \pre key.Samples.HasCells(), and there are isovalues
/// \throws std::bad_alloc
std::vector<std::uint8_t> FindCapTiles(
  const FrameKey& key, const RaySource& rays, const ValueRangePyramid& ranges);

}

#endif
