// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Light_h
#define Light_h

class vtkRenderer;
class vtkVolumeProperty;

// From the upper left behind the viewer, so that shapes show; and weakly from the viewer.
void AddStudioLights(vtkRenderer* renderer);

// The gentle gloss of bone.
void SetSatinShading(vtkVolumeProperty* property);

#endif
