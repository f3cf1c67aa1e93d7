// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_LitScene_h
#define Testing_LitScene_h

#include "Checks/Expect.h"
#include "Scenes/Scene.h"

#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// A ball over a bowl: convex, concave, and one above the other. The surface of both is at 100.
inline double BallAndBowl(double x, double y, double z)
{
  const double ball = 0.42 - std::hypot(x - 0.1, y, z - 0.35);
  const double bowl = 0.35 * (x * x + y * y) - 0.55 - z;
  return 100.0 + 100.0 * std::max(ball, bowl);
}

/// A floor at height 4 below a ceiling at height 12, where values are 4. Seventeen samples high.
inline vtkSmartPointer<vtkImageData> FloorBelowCeiling(int side)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, 17);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int k = 0; k < 17; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        *static_cast<float*>(image->GetScalarPointer(i, j, k)) = std::abs(k - 8.0f);
      }
    }
  }
  return image;
}

/// A scene whose colours are what ambient occlusion leaves of white: 255 where all light arrives.
struct LitScene : Scene
{
  LitScene(vtkDataSet* data, const std::vector<double>& isovalues)
    : Scene(data, isovalues)
  {
    vtkVolumeProperty* property = this->Volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(1.0);
    property->SetDiffuse(0.0);
    property->SetSpecular(0.0);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    property->SetColor(white);
    this->Mapper->AmbientOcclusionOn();
    this->Mapper->ProgressiveImagesOn(); // as frames of a window
  }

  /// Render the final light in one call.
  void RenderFinal(int width, int height)
  {
    this->Mapper->ProgressiveImagesOff();
    Expect(this->Render(width, height) && this->Mapper->GetFrameIsFinal(), "the light is final");
    this->Mapper->ProgressiveImagesOn();
  }

  /// The share of the light that arrives at a pixel.
  double OpenAt(int x, int y) const { return this->ColorAt(x, y)[0] / 255.0; }
  bool IsHitAt(int x, int y) const { return this->ColorAt(x, y)[3] != 0; }
};

#endif
