// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Subject_h
#define Testing_Subject_h

#include "Scenes/Scene.h"
#include "Volumes/Grids.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

/// A volume, isovalues and a mode.
struct Subject
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  std::vector<double> Isovalues;
  int Mode = vtkTemporalCoherenceVolumeMapper::CROSSING;
  bool IsNearest = false;
  int Component = 0;
  bool IsGrid = false; ///< drawn as a rectilinear grid, whose cells are finest inside

  std::string Describe() const
  {
    const std::string isovalues =
      this->Isovalues.empty() ? "" : ", " + std::to_string(this->Isovalues.size()) + " isovalue(s)";
    return this->Name +
      (this->Mode == vtkTemporalCoherenceVolumeMapper::CROSSING ? ", CROSSING" : ", THRESHOLD") +
      (this->IsNearest ? ", nearest" : "") + (this->IsGrid ? ", as a grid" : "") + isovalues;
  }

  void Prepare(Scene& scene) const
  {
    if (this->IsGrid)
    {
      const auto grid = Grids::FromImage(this->Image, VTK_DOUBLE);
      for (int axis = 0; axis < 3; ++axis)
      {
        Grids::SetCoordinates(
          grid, axis, Grids::FineInside(this->Image->GetDimensions()[axis], 0.2));
      }
      scene.Mapper->SetInputDataObject(grid);
    }
    scene.Mapper->SetSurfaceMode(this->Mode);
    scene.Mapper->SetVectorMode(vtkTemporalCoherenceVolumeMapper::COMPONENT);
    scene.Mapper->SetVectorComponent(this->Component);
    scene.Volume->GetProperty()->SetInterpolationType(
      this->IsNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  }
};

#endif
