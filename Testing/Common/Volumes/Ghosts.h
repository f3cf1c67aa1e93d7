// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Ghosts_h
#define Testing_Ghosts_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
class vtkImageData;
VTK_ABI_NAMESPACE_END

/// Ghost arrays, which hide cells of images.
namespace Ghosts
{

/// Chooses the flag of a cell or point (i, j, k) of an image.
using ChooseFlag = std::function<int(int, int, int)>;

/// Give an image's cells, or points, a new ghost array.
void FlagCells(vtkImageData* image, const ChooseFlag& flag);
void FlagPoints(vtkImageData* image, const ChooseFlag& flag);

/// Hide each cell with some probability, by any of the bits that hide, mixed with bits that do not.
void HideCells(vtkImageData* image, double chance, unsigned seed);

/// Hide each point with some probability; any point may be a duplicate.
void HidePoints(vtkImageData* image, double chance, unsigned seed);

/// Give points or cells a ghost array of so many flags, which hide nothing.
void AddFlags(vtkDataSetAttributes* attributes, vtkIdType count);

/// Remove both ghost arrays.
void Remove(vtkImageData* image);

}

#endif
