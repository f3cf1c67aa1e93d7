// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Scene_h
#define Testing_Scene_h

#include "Checks/AreIdentical.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <vector>

/// A volume, a camera and a renderer without a window: what most tests render.
struct Scene
{
  /// \param data      may be null
  /// \param isovalues replace the property's list
  Scene(vtkDataSet* data, const std::vector<double>& isovalues);

  void SetIsovalues(const std::vector<double>& isovalues);

  /// Look at the whole volume from a direction (from the volume to the camera).
  void LookFrom(double x, double y, double z);

  /// MakeImage into Color and Depth.
  bool Render(int width, int height);

  /// Colours and depths of the mapper's last frame.
  bool GetLastFrame(vtkImageData* color, vtkImageData* depth);

  float DepthAt(int x, int y) const
  {
    return *static_cast<float*>(Depth->GetScalarPointer(x, y, 0));
  }
  const unsigned char* ColorAt(int x, int y) const
  {
    return static_cast<unsigned char*>(Color->GetScalarPointer(x, y, 0));
  }

  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkImageData> Color, Depth;
};

#endif
