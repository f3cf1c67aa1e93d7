// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendChanges_h
#define Testing_BlendChanges_h

#include "Walks/RandomChanges.h"

#include <vector>

/// Changes of how a volume is blended, for fields with values up to 1700.
namespace BlendChanges
{

/// One of some modes of vtkVolumeMapper, and what counts for averages.
std::vector<Change> OfMode(Scene& scene, RandomViews& views, const std::vector<int>& modes);

/// Ramps, jumps and colours, unit distances and ranges.
std::vector<Change> OfLook(Scene& scene, RandomViews& views);

}

#endif
