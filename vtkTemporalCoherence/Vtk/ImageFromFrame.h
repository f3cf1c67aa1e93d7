// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageFromFrame_h
#define TemporalCoherence_ImageFromFrame_h

#include "Frame.h"

class vtkImageData;

namespace TemporalCoherence
{

/// Copy a frame into images; either may be null. Images that have the size and type already, and
/// share their scalars with nobody, keep their memory.
/// \param color gets unsigned char RGBA
/// \param depth gets float distances along the rays, infinity where nothing is hit
/// \throws std::bad_alloc, the images then being as they were
void WritePicture(const Frame& frame, vtkImageData* color, vtkImageData* depth);

}

#endif
