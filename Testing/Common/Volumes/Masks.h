// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Masks_h
#define Testing_Masks_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
VTK_ABI_NAMESPACE_END

/// Masks of volumes, for SetMaskInput.
namespace Masks
{

/// Chooses the value of a sample (i, j, k).
using ChooseValue = std::function<int(int, int, int)>;

/// An image of so many points along each axis, with one scalar of a VTK type for each.
vtkSmartPointer<vtkImageData> Make(const int count[3], int scalarType, const ChooseValue& value);

/// One for each point of an image.
vtkSmartPointer<vtkImageData> For(
  vtkImageData* image, const ChooseValue& value, int scalarType = VTK_UNSIGNED_CHAR);

/// Give a mapper a binary mask, or none.
void SetBinary(vtkGPUVolumeRayCastMapper* mapper, vtkImageData* mask);

struct Named
{
  std::string Name;
  ChooseValue Value;
};

/// Masks for an image of 32^3 points: thick and thin ones, smooth ones and others.
std::vector<Named> All();

/// Independent random values: 0 with some probability, else from 1 to 3.
ChooseValue Random(double chance, unsigned seed);

}

#endif
