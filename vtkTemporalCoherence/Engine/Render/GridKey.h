// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridKey_h
#define TemporalCoherence_GridKey_h

#include "Scene/FrameKey.h"

namespace TemporalCoherence
{

/// The key of a picture with fewer rays in the same view.
/// \param rays along each axis
/// \throws std::bad_alloc
FrameKey KeyOfGrid(const FrameKey& key, const glm::ivec2& rays);

}

#endif
