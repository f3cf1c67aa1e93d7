// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In scenes of VTK's tests that vary what is drawn, outlines are within a pixel of those of
// polygons (vtkFlyingEdges3D), and median colours within 3/255.
//
// Scenes: TestGPURayCastIsosurface, ChangedArray, VolumePlane, VolumeUpdate, PerspectiveParallel.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/PolygonPeer.h"
#include "Volumes/Volumes.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRTAnalyticSource.h>

#include <cmath>
#include <cstdlib>

namespace
{

/// Three colours at three isovalues, all opaque.
void SetWaveletColors(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(220.0, 0.0, 1.0, 0.0);
  color->AddRGBPoint(150.0, 1.0, 1.0, 1.0);
  color->AddRGBPoint(190.0, 0.0, 1.0, 1.0);
  property->SetColor(color);
}

/// No contour of the new list, then one, none, three.
void TestIsosurface()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-60, 60, -60, 60, -60, 60);
  wavelet->Update();
  Scene scene(wavelet->GetOutput(), { 0.0 });
  SetWaveletColors(scene.Volume->GetProperty());
  scene.Renderer->SetBackground(0.5, 0.5, 0.5);
  PolygonPeer peer(scene.Volume, scene.Renderer, 400, 300);
  scene.Renderer->ResetCamera();
  const std::vector<std::vector<double>> lists = { { 0.0 }, { 220.0 }, {},
    { 220.0, 150.0, 190.0 } };
  for (const std::vector<double>& isovalues : lists)
  {
    scene.SetIsovalues(isovalues);
    peer.SetContours(wavelet->GetOutput());
    const bool isEmpty = isovalues.empty() || isovalues[0] == 0.0;
    peer.ExpectAgreement(
      "Isosurface, " + std::to_string(isovalues.size()) + " isovalue(s)", isEmpty ? 0 : 5000);
  }
  scene.Renderer->GetActiveCamera()->Azimuth(30.0);
  scene.Renderer->GetActiveCamera()->Elevation(20.0);
  scene.Renderer->ResetCameraClippingRange();
  peer.ExpectAgreement("Isosurface, three isovalues, turned");
}

/// Another array of the same image is chosen between two frames.
void TestChangedArray()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->Update();
  vtkNew<vtkImageData> image;
  image->ShallowCopy(wavelet->GetOutput());
  vtkDataArray* values = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> sine;
  sine->SetName("sin_RTData");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sine->InsertNextValue(static_cast<float>(100.0 * std::sin(values->GetTuple1(i) / 40.0)));
  }
  image->GetPointData()->AddArray(sine);

  Scene scene(image, { 60.0 });
  scene.Mapper->SetScalarModeToUsePointFieldData();
  PolygonPeer peer(scene.Volume, scene.Renderer);
  peer.LookFrom(1.0, 2.0, 0.7);
  vtkNew<vtkImageData> same;
  same->ShallowCopy(image);
  for (const char* name : { "sin_RTData", "RTData", "sin_RTData" })
  {
    scene.Mapper->SelectScalarArray(name);
    scene.SetIsovalues({ name[0] == 's' ? 60.0 : 160.0 });
    same->GetPointData()->SetActiveScalars(name);
    peer.SetContours(same);
    peer.ExpectAgreement(std::string("ChangedArray, ") + name);
  }
}

/// A thin volume, two samples deep, with a plane right through it.
void TestVolumePlane()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-49, 50, -49, 50, 0, 1);
  wavelet->SetCenter(0.0, 0.0, 0.0);
  wavelet->Update();
  wavelet->GetOutput()->SetSpacing(1.0, 1.0, 10.0);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-70.0, -70.0, 5.0);
  plane->SetPoint1(70.0, -70.0, 5.0);
  plane->SetPoint2(-70.0, 70.0, 5.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);

  Scene scene(wavelet->GetOutput(), { 125.0, 157.0 });
  SetWaveletColors(scene.Volume->GetProperty());
  scene.Renderer->AddActor(actor);
  PolygonPeer peer(scene.Volume, scene.Renderer, 300, 301);
  peer.SetContours(wavelet->GetOutput());
  peer.LookFrom(0.5, -1.0, 0.6);
  peer.ExpectAgreement("VolumePlane");
  actor->VisibilityOff();
  peer.ExpectAgreement("VolumePlane, without the plane", 4000);
}

/// Other data by the same pipeline, and another pipeline.
void TestVolumeUpdate()
{
  Scene scene(Volumes::FourSpheres(60), { 100.0 });
  PolygonPeer peer(scene.Volume, scene.Renderer);
  peer.SetContours(scene.Mapper->GetInput());
  peer.LookFrom(1.0, -2.0, 0.7);
  peer.ExpectAgreement("VolumeUpdate, first input");

  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-27, 28, -27, 28, -27, 28);
  wavelet->SetCenter(30.0, 30.0, 30.0);
  wavelet->Update();
  scene.Mapper->SetInputConnection(wavelet->GetOutputPort());
  scene.SetIsovalues({ 150.0 });
  peer.SetContours(wavelet->GetOutput());
  peer.LookFrom(1.0, -2.0, 0.7);
  peer.ExpectAgreement("VolumeUpdate, second input");
  wavelet->SetXFreq(40.0);
  wavelet->SetCenter(0.0, 10.0, 0.0);
  wavelet->Update();
  peer.SetContours(wavelet->GetOutput());
  peer.ExpectAgreement("VolumeUpdate, updated input");
}

/// A window of odd size, an odd number of samples, and the projection changed between frames.
void TestPerspectiveParallel()
{
  const auto ball = Volumes::FromFormula(127, VTK_UNSIGNED_CHAR,
    [](double x, double y, double z) { return 255.0 / 3.0 * (x * x + y * y + z * z); });
  Scene scene(ball, { 40.0 });
  PolygonPeer peer(scene.Volume, scene.Renderer, 301, 300);
  peer.SetContours(ball);
  scene.Renderer->ResetCamera();
  peer.ExpectAgreement("PerspectiveParallel, perspective");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  peer.ExpectAgreement("PerspectiveParallel, parallel");
}

/// Plain colours.
void TestUnlit()
{
  Scene scene(Volumes::FourSpheres(60), { 100.0 });
  scene.Volume->GetProperty()->ShadeOff();
  PolygonPeer peer(scene.Volume, scene.Renderer);
  peer.SetContours(scene.Mapper->GetInput());
  peer.LookFrom(1.0, -2.0, 1.5);
  peer.ExpectAgreement("shading off");
}

}

int TestAgainstPolygonsScenes(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestIsosurface();
  TestChangedArray();
  TestVolumePlane();
  TestVolumeUpdate();
  TestPerspectiveParallel();
  TestUnlit();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
