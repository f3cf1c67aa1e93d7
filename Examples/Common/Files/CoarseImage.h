// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarseImage_h
#define CoarseImage_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkTemporalCoherenceBrickSource;
struct Volume;

// A small image in memory that stands in for a volume that is read as it is needed: the volume
// itself if it is small. Its array has the name of the volume's.
vtkSmartPointer<vtkImageData> CoarseImageOf(vtkTemporalCoherenceBrickSource* bricks);

// What is looked at where all samples would be: the coarse image, if there is one.
vtkDataObject* SamplesInMemory(const Volume& volume);

// The least and the greatest finite value of such a volume. Where those of a mapped file are not
// known, they are those of its coarse image; of samples of 8 bits, those of the type.
std::array<double, 2> RangeOf(const Volume& volume);

#endif
