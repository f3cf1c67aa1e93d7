// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In scenes of VTK's tests that vary where volume and viewer are, outlines are within a pixel of
// those of polygons, and median colours within 3/255.
//
// Scenes: TestGPURayCastOrientedVolume, VolumeRotation, VolumeScale, VolumeOrientation,
// CameraInside, CameraInsideSmallSpacing, CameraInsideTransformation,
// CameraInsideNonUniformScaleTransform.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/PolygonPeer.h"
#include "Volumes/Volumes.h"

#include <vtkActor.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkFlyingEdges3D.h>
#include <vtkMatrix3x3.h>
#include <vtkReverseSense.h>
#include <vtkTransform.h>

#include <cmath>
#include <cstdlib>

namespace
{

/// A vase with a knot, so that no two directions look alike.
vtkSmartPointer<vtkImageData> Vase()
{
  return Volumes::FromFormula(61, VTK_FLOAT,
    [](double x, double y, double z)
    {
      const double wall = 0.35 + 0.2 * std::cos(3.0 * z) * (1.0 - 0.4 * z);
      const double body = wall - std::hypot(x, 1.2 * y);
      const double knot = 0.25 - std::hypot(x - 0.5, y + 0.3, z - 0.2);
      return std::log(std::exp(8.0 * body) + std::exp(8.0 * knot)) / 8.0;
    });
}

/// A labyrinth around the origin.
vtkSmartPointer<vtkImageData> Gyroid()
{
  return Volumes::FromFormula(64, VTK_FLOAT,
    [](double x, double y, double z)
    {
      return std::sin(7.0 * x) * std::cos(7.0 * y) + std::sin(7.0 * y) * std::cos(7.0 * z) +
        std::sin(7.0 * z) * std::cos(7.0 * x);
    });
}

void TestOrientedVolume()
{
  const auto image = Vase();
  image->SetOrigin(200.0, 100.0, 40.0);
  image->SetSpacing(3.2, 3.2, 1.5);
  vtkNew<vtkTransform> turn;
  turn->RotateZ(20.0);
  turn->RotateX(35.0);
  vtkNew<vtkMatrix3x3> direction;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      direction->SetElement(i, j, turn->GetMatrix()->GetElement(i, j));
    }
  }
  image->SetDirectionMatrix(direction);
  Scene scene(image, { 0.0 });
  PolygonPeer peer(scene.Volume, scene.Renderer);
  peer.SetContours(image);
  scene.Renderer->ResetCamera();
  scene.Renderer->GetActiveCamera()->Zoom(1.6);
  peer.ExpectAgreement("OrientedVolume");
  scene.Volume->SetScale(1.0, 0.5, 2.0);
  scene.Volume->RotateY(50.0);
  peer.UpdatePolygons();
  peer.LookFrom(1.0, -2.0, 0.8);
  peer.ExpectAgreement("OrientedVolume, transformed");
}

void TestRotationAndScale()
{
  Scene scene(Vase(), { 0.0 });
  PolygonPeer peer(scene.Volume, scene.Renderer, 400, 400);
  peer.SetContours(scene.Mapper->GetInput());
  scene.Volume->RotateY(45.0);
  scene.Volume->RotateZ(-90.0);
  scene.Volume->RotateX(90.0);
  peer.UpdatePolygons();
  peer.LookFrom(0.3, -2.0, 0.8);
  peer.ExpectAgreement("VolumeRotation");
  scene.Volume->SetScale(0.3, 1.0, 2.5);
  peer.UpdatePolygons();
  peer.LookFrom(0.3, -2.0, 0.8);
  peer.ExpectAgreement("VolumeRotation, scaled");

  const auto stretched = Vase();
  stretched->SetSpacing(1.0, 2.0, 3.0);
  stretched->SetOrigin(10.0, 20.0, 30.0);
  Scene scaled(stretched, { 0.0 });
  PolygonPeer ofScaled(scaled.Volume, scaled.Renderer, 400, 400);
  ofScaled.SetContours(stretched);
  ofScaled.LookFrom(0.5, -1.0, 0.4);
  ofScaled.ExpectAgreement("VolumeScale");
}

void TestMirrored()
{
  Scene scene(Vase(), { 0.0 });
  scene.Volume->SetScale(1.0, -1.0, 1.0);
  PolygonPeer peer(scene.Volume, scene.Renderer, 400, 400);
  // Triangles that are mirrored show their backs, and VTK turns their normals for that.
  vtkNew<vtkFlyingEdges3D> contours;
  contours->SetInputData(scene.Mapper->GetInput());
  contours->SetValue(0, 0.0);
  vtkNew<vtkReverseSense> turned;
  turned->SetInputConnection(contours->GetOutputPort());
  turned->ReverseCellsOn();
  turned->ReverseNormalsOff();
  turned->Update();
  peer.AddPolygons(turned->GetOutput(), 0.0);
  peer.LookFrom(0.5, -1.0, 0.4);
  peer.ExpectAgreement("VolumeOrientation");
}

/// The viewer amid the surfaces, in volumes of ordinary and of very small size.
void TestCameraInside()
{
  for (const double size : { 2.0, 0.0005 })
  {
    const auto image = Gyroid();
    image->SetSpacing(size / 63.0, size / 63.0, size / 63.0);
    image->SetOrigin(-0.5 * size, -0.5 * size, -0.5 * size);
    Scene scene(image, { 0.3 });
    PolygonPeer peer(scene.Volume, scene.Renderer, 301, 300);
    peer.SetContours(image);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.05 * size, -0.11 * size, 0.02 * size);
    camera->SetFocalPoint(0.4 * size, 0.1 * size, 0.1 * size);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(60.0);
    camera->SetClippingRange(0.001 * size, 2.0 * size);
    const std::string name = size < 1.0 ? "CameraInsideSmallSpacing" : "CameraInside";
    peer.ExpectAgreement(name, 30000);
    camera->Yaw(100.0);
    peer.ExpectAgreement(name + ", turned", 30000);
  }
}

void TestCameraInsideTransformed()
{
  Scene scene(Gyroid(), { 0.3 });
  scene.Volume->SetOrigin(0.3, 0.2, 0.3);
  scene.Volume->RotateX(180.0);
  scene.Volume->RotateY(85.0);
  scene.Volume->RotateZ(55.0);
  PolygonPeer peer(scene.Volume, scene.Renderer, 301, 300);
  peer.SetContours(scene.Mapper->GetInput());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const auto enter = [&]
  {
    peer.UpdatePolygons();
    const double* center = scene.Volume->GetCenter();
    camera->SetPosition(center[0] + 0.1, center[1] - 0.1, center[2]);
    camera->SetFocalPoint(center[0] - 1.0, center[1] + 1.0, center[2] + 0.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(70.0);
    camera->SetClippingRange(0.01, 10.0);
  };
  enter();
  peer.ExpectAgreement("CameraInsideTransformation", 30000);
  scene.Volume->SetScale(0.9, 0.3, 3.0);
  enter();
  peer.ExpectAgreement("CameraInsideNonUniformScaleTransform", 30000);
}

}

int TestAgainstPolygonsTransforms(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestOrientedVolume();
  TestRotationAndScale();
  TestMirrored();
  TestCameraInside();
  TestCameraInsideTransformed();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
