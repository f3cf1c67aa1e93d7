// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FourSpheres_h
#define FourSpheres_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

// The paper's test volume, on [-1, 1]^3: the value falls from 255 in the middle of each of four
// spheres to 0 at a distance of 0.6. Isovalue 100 shows them apart.
vtkSmartPointer<vtkImageData> MakeFourSpheres(int samplesPerAxis);

#endif
