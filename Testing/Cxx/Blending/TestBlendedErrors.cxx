// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A mistake in a blended volume gets one error with its value and remedy, and the last picture
// stays. Methods that only surfaces have are refused in one sentence.

#include "BlendedScene.h"
#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "vtkTemporalCoherencePicker.h"

#include <vtkAppendFilter.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

namespace
{

constexpr int Composite = vtkVolumeMapper::COMPOSITE_BLEND;
constexpr int Maximum = vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
const double NaN = std::numeric_limits<double>::quiet_NaN();

/// Spoil a scene that has a valid picture, and mend it.
void ExpectError(int mode, const std::string& word, const std::function<void(Scene&)>& spoil,
  const std::function<void(Scene&)>& mend)
{
  BlendedScene scene(mode);
  Mistake mistake(scene, word);
  spoil(scene);
  mistake.ExpectRefused();
  mend(scene);
  mistake.ExpectMended();
}

vtkSmartPointer<vtkImageData> Components(int count)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 5, 5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, count);
  return image;
}

void TestInputs()
{
  const auto data = Volumes::FourSpheres(32);
  for (const int mode : BlendModes)
  {
    vtkNew<vtkAppendFilter> mesh;
    mesh->AddInputData(Volumes::FourSpheres(5));
    mesh->Update();
    const auto restore = [&](Scene& scene) { scene.Mapper->SetInputData(data); };
    ExpectError(
      mode, "vtkUnstructuredGrid, which can only be drawn by isosurfaces",
      [&](Scene& scene) { scene.Mapper->SetInputData(mesh->GetOutput()); }, restore);
    ExpectError(
      mode, "5 components, more than the 4",
      [&](Scene& scene) { scene.Mapper->SetInputData(Components(5)); }, restore);
    ExpectError(
      mode, "Blend mode 6 is not supported",
      [](Scene& scene) { scene.Mapper->SetBlendModeToSlice(); },
      [&](Scene& scene) { scene.Mapper->SetBlendMode(mode); });
  }
  ExpectError(
    Maximum, "3 components that depend on one another",
    [](Scene& scene)
    {
      scene.Mapper->SetInputData(Components(3));
      scene.Volume->GetProperty()->IndependentComponentsOff();
    },
    [&](Scene& scene) { scene.Mapper->SetInputData(data); });
}

void TestNumbers()
{
  ExpectError(
    Maximum, "Lab/CIEDE2000",
    [](Scene& scene)
    { scene.Volume->GetProperty()->GetRGBTransferFunction()->SetColorSpaceToLabCIEDE2000(); },
    [](Scene& scene)
    { scene.Volume->GetProperty()->GetRGBTransferFunction()->SetColorSpaceToRGB(); });
  ExpectError(
    Maximum, "two-dimensional transfer functions",
    [](Scene& scene)
    { scene.Volume->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D); },
    [](Scene& scene)
    { scene.Volume->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D); });
  ExpectError(
    Composite, "Value of node 1 of the scalar opacity",
    [](Scene& scene)
    {
      double node[4] = { 20.0, NaN, 0.5, 0.0 };
      scene.Volume->GetProperty()->GetScalarOpacity()->SetNodeValue(1, node);
    },
    [](Scene& scene)
    {
      double node[4] = { 20.0, 0.0, 0.5, 0.0 };
      scene.Volume->GetProperty()->GetScalarOpacity()->SetNodeValue(1, node);
    });
  ExpectError(
    Maximum, "Colour of node 1 of the colours",
    [](Scene& scene)
    {
      double node[6] = { 128.0, 0.3, std::numeric_limits<double>::infinity(), 0.2, 0.5, 0.0 };
      scene.Volume->GetProperty()->GetRGBTransferFunction()->SetNodeValue(1, node);
    },
    [](Scene& scene)
    {
      double node[6] = { 128.0, 0.3, 0.9, 0.2, 0.5, 0.0 };
      scene.Volume->GetProperty()->GetRGBTransferFunction()->SetNodeValue(1, node);
    });
  ExpectError(
    Composite, "Scalar opacity unit distance of the volume's property",
    [](Scene& scene) { scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.0); },
    [](Scene& scene) { scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(8.0); });
  ExpectError(
    Composite, "SampleDistance of the mapper",
    [](Scene& scene)
    {
      scene.Mapper->FixedStepSamplingOn();
      scene.Mapper->SetSampleDistance(-1.0f);
    },
    [](Scene& scene) { scene.Mapper->SetSampleDistance(0.0f); });
  ExpectError(
    Composite, "Ambient colour of light 0 of the renderer",
    [](Scene& scene)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetAmbientColor(0.1, NaN, 0.3);
      scene.Renderer->RemoveAllLights();
      scene.Renderer->AddLight(light);
      scene.Volume->GetProperty()->ShadeOn();
    },
    [](Scene& scene)
    {
      scene.Renderer->RemoveAllLights();
      scene.Volume->GetProperty()->ShadeOff();
    });
  ExpectError(
    Composite, "Ambient of the volume's property",
    [](Scene& scene)
    {
      scene.Volume->GetProperty()->ShadeOn();
      scene.Volume->GetProperty()->SetAmbient(NaN);
    },
    [](Scene& scene) { scene.Volume->GetProperty()->ShadeOff(); });
}

/// What asks for surfaces has an answer, too.
void TestSurfaces(int mode)
{
  const std::string name = NameOfMode(mode);
  BlendedScene scene(mode);
  vtkNew<vtkTest::ErrorObserver> errors;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkNew<vtkImageData> frame;
  Expect(
    scene.Mapper->MakeImage(scene.Renderer, scene.Volume, 40, 40, frame) && !errors->GetError(),
    name + ": no isovalue is needed");
  double position[3], normal[3];
  int index = 7;
  Expect(scene.Mapper->PickPixel(20, 20, position, normal, &index) && index == -1 &&
      std::isfinite(position[0] + position[1] + position[2]),
    name + ": a pixel is picked, and no isovalue");
  const bool hasNormal = mode == vtkVolumeMapper::COMPOSITE_BLEND;
  Expect(std::abs(vtkMath::Norm(normal) - (hasNormal ? 1.0 : 0.0)) < 1e-5,
    name + ": the normal of what is seen first, or none");
  vtkNew<vtkPolyData> points;
  Expect(!scene.Mapper->GetVisibleSurface(points) && errors->GetError() &&
      errors->GetErrorMessage().find("shows no surface") != std::string::npos,
    name + ": no visible surface");
  errors->Clear();
  const double begin[3] = { 45.0, 85.0, 35.0 }, end[3] = { 15.0, 15.0, 15.0 };
  double t;
  Expect(!scene.Mapper->IntersectWithLine(scene.Volume, begin, end, t, position, normal, &index) &&
      errors->GetErrorMessage().find("isosurfaces only") != std::string::npos,
    name + ": no surface on a line");
  errors->Clear();
  Expect(!scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume) && !errors->GetError(),
    name + ": no isomap, which is no error");
  vtkNew<vtkImageData> color, depth;
  scene.Mapper->GetColorImage(color);
  scene.Mapper->GetDepthImage(depth);
  Expect(
    color->GetNumberOfPoints() == 1600 && depth->GetNumberOfPoints() == 1600 && !errors->GetError(),
    name + ": buffers");
  // And back.
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.SetIsovalues({ 100.0 });
  Expect(scene.Render(40, 40) && scene.Mapper->PickPixel(20, 20, position, normal, &index) &&
      index == 0 && scene.Mapper->GetVisibleSurface(points) && points->GetNumberOfPoints() > 100 &&
      !errors->GetError(),
    name + ": isosurfaces again");
}

}

int TestBlendedErrors(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestInputs();
  TestNumbers();
  for (const int mode : BlendModes)
  {
    TestSurfaces(mode);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
