// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The last frame as images and as points.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetLastFrame(vtkImageData* frame, int arrays)
{
  static_assert(static_cast<int>(TemporalCoherence::ColorArray) == FRAME_COLOR &&
      static_cast<int>(TemporalCoherence::DepthArray) == FRAME_DEPTH &&
      static_cast<int>(TemporalCoherence::NormalsArray) == FRAME_NORMALS &&
      static_cast<int>(TemporalCoherence::IsovalueIndexArray) == FRAME_ISOVALUE_INDEX &&
      static_cast<int>(TemporalCoherence::AnswerArray) == FRAME_ANSWER &&
      static_cast<int>(TemporalCoherence::AllFrameArrays) == FRAME_ALL,
    "FrameArrays tells the same as FrameArray");
  std::string error;
  if (!frame)
  {
    error = "GetLastFrame got null for the frame; give it a vtkImageData.";
  }
  else if (arrays & ~FRAME_ALL)
  {
    error = "GetLastFrame got " + std::to_string(arrays) +
      " for the arrays; give it FRAME_ALL, or a sum of FRAME_COLOR, FRAME_DEPTH, FRAME_NORMALS, "
      "FRAME_ISOVALUE_INDEX and FRAME_ANSWER.";
  }
  const bool isThere =
    error.empty() && this->Internal->Frames.WriteImages({ { frame, arrays } }, error);
  this->Internal->ReportOnce(error);
  return isThere;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::GetColorImage(vtkImageData* image)
{
  std::string error;
  this->Internal->Frames.WriteBufferColors(image, error);
  this->Internal->ReportOnce(error);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::GetDepthImage(vtkImageData* image)
{
  std::string error;
  this->Internal->Frames.WriteBufferDepths(
    image, this->GetDepthImageScalarType(), this->GetClampDepthToBackface() != 0, error);
  this->Internal->ReportOnce(error);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetVisibleSurface(vtkPolyData* points)
{
  std::string error;
  const bool isThere = points && this->Internal->Frames.WriteSurface(points, error);
  this->Internal->ReportOnce(error);
  return isThere;
}
VTK_ABI_NAMESPACE_END
