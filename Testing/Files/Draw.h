// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Draw_h
#define Draw_h

#include "Program/VolumeSource.h"

#include <string>

// Small pictures of a file, made by the example programs' own parts and in their ways, without a
// window. They throw what the programs tell.
void DrawInExplorer(const VolumeSource& source);
void DrawSessionInExplorer(const std::string& path);
void DrawInOrbitAndSweep(const VolumeSource& source);

#endif
