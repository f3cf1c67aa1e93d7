// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The last frame as images and as points.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetLastFrame(vtkImageData* color, vtkImageData* depth,
  vtkImageData* normals, vtkImageData* isovalueIndex, vtkImageData* answer)
{
  std::string error;
  const bool isThere =
    this->Internal->Frames.WriteImages({ color, depth, normals, isovalueIndex, answer }, error);
  this->ReportOnce(error);
  return isThere;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::GetColorImage(vtkImageData* image)
{
  std::string error;
  this->Internal->Frames.WriteBufferColors(image, error);
  this->ReportOnce(error);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::GetDepthImage(vtkImageData* image)
{
  std::string error;
  this->Internal->Frames.WriteBufferDepths(
    image, this->GetDepthImageScalarType(), this->GetClampDepthToBackface() != 0, error);
  this->ReportOnce(error);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetVisibleSurface(vtkPolyData* points)
{
  std::string error;
  const bool isThere = points && this->Internal->Frames.WriteSurface(points, error);
  this->ReportOnce(error);
  return isThere;
}
VTK_ABI_NAMESPACE_END
