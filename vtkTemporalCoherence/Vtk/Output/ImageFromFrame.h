// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageFromFrame_h
#define TemporalCoherence_ImageFromFrame_h

#include "Scene/Frame.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Images that take the planes of a frame, each another one or null.
struct PictureImages
{
  vtkImageData* Color = nullptr;   ///< unsigned char RGBA
  vtkImageData* Depth = nullptr;   ///< float distance along the ray, infinity where nothing is hit
  vtkImageData* Normals = nullptr; ///< three floats, 0 where nothing is hit
  vtkImageData* Isovalues =
    nullptr;                       ///< int position in the property's list, -1 where nothing is hit
  vtkImageData* Answers = nullptr; ///< unsigned char, the numbers of Answer
};

/// Copy a frame into images. Those that have the size and type already, and share their scalars
/// with nobody, keep their memory.
/// \param places position in the property's list of each isovalue of the frame
/// \throws std::bad_alloc, the images then being as they were
void WritePicture(const Frame& frame, const std::vector<int>& places, const PictureImages& images);

}

#endif
