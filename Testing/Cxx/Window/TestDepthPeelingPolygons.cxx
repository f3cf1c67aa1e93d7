// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Curved surfaces that are peeled among translucent spheres look as polygons in their place.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkActor.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkFlyingEdges3D.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

namespace
{

using Color = std::array<double, 3>;

/// Curved surfaces in perspective among spheres of glass, and polygons in their place.
void TestAgainstPolygons(bool isOpaque, bool isOwnProp)
{
  const std::string name = std::string(isOpaque ? "opaque" : "translucent") + " surfaces" +
    (isOwnProp ? " of the own prop" : "");
  Scene scene(Volumes::Waves(), { 200.0, 400.0 });
  vtkSmartPointer<vtkVolume> volume = scene.Volume.Get();
  if (isOwnProp)
  {
    volume = vtkSmartPointer<vtkTemporalCoherenceVolume>::New();
    volume->SetMapper(scene.Mapper);
    volume->SetProperty(scene.Volume->GetProperty());
    scene.Renderer->RemoveVolume(scene.Volume);
    scene.Renderer->AddVolume(volume);
  }
  vtkVolumeProperty* property = volume->GetProperty();
  property->ShadeOff();
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetRGBTransferFunction()->AddRGBPoint(200.0, 0.9, 0.6, 0.2);
  property->GetRGBTransferFunction()->AddRGBPoint(400.0, 0.2, 0.8, 0.4);
  const double opacity = isOpaque ? 1.0 : 0.5;
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, opacity);
  scene.LookFrom(1.0, -2.0, 0.7);
  double bounds[6];
  volume->GetBounds(bounds);
  const double size = bounds[1] - bounds[0];
  vtkNew<vtkRenderWindow> window;
  window->SetAlphaBitPlanes(1);
  OpenWindow(window, scene.Renderer, 200, 160);
  scene.Renderer->SetUseDepthPeeling(1);
  scene.Renderer->SetUseDepthPeelingForVolumes(1);
  scene.Renderer->SetMaximumNumberOfPeels(40);
  scene.Renderer->SetOcclusionRatio(0.0);
  const auto add = [&](vtkAlgorithm* source, const Color& color, double opaque)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetOpacity(opaque);
    scene.Renderer->AddActor(actor);
    return actor;
  };
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(size * (0.2 + 0.1 * i));
    sphere->SetCenter(size * (0.3 * i - 0.3), size * (0.2 - 0.2 * i), size * (0.1 * i));
    sphere->SetThetaResolution(100);
    sphere->SetPhiResolution(100);
    add(sphere, { 0.2 * i, 0.3, 1.0 - 0.4 * i }, 0.4);
  }
  const auto draw = [&]
  {
    window->Render();
    vtkNew<vtkUnsignedCharArray> kept;
    kept->DeepCopy(PixelsOf(window));
    return vtkSmartPointer<vtkUnsignedCharArray>(kept.Get());
  };
  const auto withVolume = draw();
  volume->VisibilityOff();
  const auto without = draw();
  for (const auto& [isovalue, color] :
    { std::pair<double, Color>{ 200.0, { 0.9, 0.6, 0.2 } }, { 400.0, { 0.2, 0.8, 0.4 } } })
  {
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(scene.Mapper->GetInput());
    contour->SetValue(0, isovalue);
    add(contour, color, opacity);
  }
  const auto withPolygons = draw();
  const auto shareThatDiffers = [](vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
  {
    int different = 0;
    for (vtkIdType i = 0; i < a->GetNumberOfValues(); i += 4)
    {
      bool differs = false;
      for (vtkIdType c = 0; c < 3; ++c)
      {
        differs = differs || std::abs(a->GetValue(i + c) - b->GetValue(i + c)) > 6;
      }
      different += differs;
    }
    return 4.0 * different / static_cast<double>(a->GetNumberOfValues());
  };
  const double effect = shareThatDiffers(withVolume, without);
  const double share = shareThatDiffers(withVolume, withPolygons);
  std::cout << name << ": " << share << " of the pixels are unlike polygons, " << effect
            << " unlike nothing\n";
  Expect(effect > 0.2, name + ": hardly seen");
  Expect(share < 0.02, name + ": unlike polygons in " + std::to_string(share) + " of the pixels");
}

}

int TestDepthPeelingPolygons(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  for (const bool isOpaque : { true, false })
  {
    TestAgainstPolygons(isOpaque, false);
    TestAgainstPolygons(isOpaque, true);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
