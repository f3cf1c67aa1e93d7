// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitValues_h
#define TemporalCoherence_HitValues_h

#include "Scene/FrameKey.h"
#include "Shade/Shader.h"

namespace TemporalCoherence
{

/// Find the values at hits of the array that gives a key's surfaces their looks, if one does.
void FindHitValues(const FrameKey& key, HitList& hits);

}

#endif
