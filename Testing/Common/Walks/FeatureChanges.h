// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_FeatureChanges_h
#define Testing_FeatureChanges_h

#include "Walks/RandomChanges.h"

#include <vector>

/// Changes of features, for fields in [-1, 1]^3 with values up to 1700.
namespace FeatureChanges
{

/// Clipping planes, cropping planes and flags, or neither.
std::vector<Change> OfRegion(Scene& scene, RandomViews& views);

/// Opacities of isovalues and of gradient magnitude; opaque again.
std::vector<Change> OfOpacity(Scene& scene, RandomViews& views);

/// One to four isovalues, some of them equal.
std::vector<Change> OfLists(Scene& scene, RandomViews& views);

/// Colours, lights and shading.
std::vector<Change> OfAppearance(Scene& scene, RandomViews& views);

/// Interpolation, mode, and the transform of the volume.
std::vector<Change> OfVolume(Scene& scene, RandomViews& views);

/// Back to the state of a new scene.
void SwitchOff(Scene& scene);

}

#endif
