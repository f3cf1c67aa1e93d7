// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Changes_h
#define Fuzz_Changes_h

#include "World/World.h"

#include <vector>

namespace Fuzz
{

/// What may change between two frames.
namespace Changes
{

const std::vector<ChangeKind>& OfData();
const std::vector<ChangeKind>& OfMeshes();
const std::vector<ChangeKind>& OfManyLayers();
const std::vector<ChangeKind>& OfCamera();
const std::vector<ChangeKind>& OfIsovalues();
const std::vector<ChangeKind>& OfAppearance();
const std::vector<ChangeKind>& OfLights();
const std::vector<ChangeKind>& OfLabels();
const std::vector<ChangeKind>& OfRegion();
const std::vector<ChangeKind>& OfTransform();
const std::vector<ChangeKind>& OfSettings();

/// One of them all, by the theme of the run.
void MakeOne(World& world);

}

}

#endif
