// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendChanges_h
#define Testing_BlendChanges_h

#include "Walks/RandomChanges.h"

#include <vector>

/// Changes of how a volume is blended, for fields with values up to 1700.
namespace BlendChanges
{

/// Every mode, isosurfaces among them.
std::vector<Change> OfMode(Scene& scene, RandomViews& views);

/// Ramps, jumps and colours, unit distances and ranges.
std::vector<Change> OfLook(Scene& scene, RandomViews& views);

}

#endif
