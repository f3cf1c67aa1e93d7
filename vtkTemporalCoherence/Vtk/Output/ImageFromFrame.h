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
/// comments and Documentation/Mapper.md tell what they hold.
enum FrameArray
{
  ColorArray = 1,
  DepthArray = 2,
  NormalsArray = 4,
  IsovalueIndexArray = 8,
  AnswerArray = 16,
  AllFrameArrays = 31
};

/// An image, and the arrays that it gets.
struct FrameImage
{
  vtkImageData* Image = nullptr; ///< null gets nothing
  int Arrays = 0;                ///< a sum of FrameArray
};

/// Write arrays of a frame into images. Each image has the frame's size then, and these arrays and
/// nothing else. The first array is the active scalars. An array that the image has already, and
/// that nobody else refers to, keeps its memory.
/// \param places position in the property's list of each isovalue of the frame
/// \throws std::bad_alloc, the images then being as they were
void WriteImages(
  const Frame& frame, const std::vector<int>& places, const std::vector<FrameImage>& images);

}

#endif
