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

/// The point arrays of a frame, one bit each: vtkTemporalCoherenceVolumeMapper::FrameArrays, whose
/// comments and Documentation/Mapper.md describe them.
enum FrameArray
{
  ColorArray = 1,
  DepthArray = 2,
  NormalsArray = 4,
  IsovalueIndexArray = 8,
  AnswerArray = 16,
  AllFrameArrays = 31
};

/// An image with the selection of its arrays.
struct FrameImage
{
  vtkImageData* Image = nullptr; ///< null: ignored
  int Arrays = 0;                ///< a sum of FrameArray
};

/// Write arrays of a frame into images. Each image then has the frame's size, these arrays, and
/// nothing else. The first array is the active scalars. An existing array of the image keeps its
/// memory if nothing else refers to it.
/// \param places position in the property's list of each isovalue of the frame
/// \throws std::bad_alloc, the images are then unchanged
void WriteImages(
  const Frame& frame, const std::vector<int>& places, const std::vector<FrameImage>& images);

}

#endif
