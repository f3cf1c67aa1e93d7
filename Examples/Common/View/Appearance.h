// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Appearance_h
#define Appearance_h

#include <array>
#include <vector>

class vtkColorTransferFunction;
class vtkRenderer;
class vtkVolumeProperty;

// Presets of colour, material and light. Each is named by its position in a list.
std::vector<const char*> PaletteNames();
std::vector<const char*> MaterialNames();
std::vector<const char*> LightNames();

// Over the volume's values.
void SetPalette(vtkColorTransferFunction* colors, int palette, const std::array<double, 2>& range);
void SetMaterial(vtkVolumeProperty* property, int material);
void SetLight(vtkRenderer* renderer, int light);

#endif
