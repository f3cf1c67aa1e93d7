// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures agree with brute force under every transform, projection and image geometry that VTK
// has.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/Agreement.h"
#include "Volumes/Volumes.h"

#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{

vtkSmartPointer<vtkImageData> Blob(int n, int type = VTK_FLOAT)
{
  return Volumes::FromFormula(n, type,
    [](double x, double y, double z)
    { return 60.0 * (1.5 - x * x - 2.0 * y * y - 0.5 * z * z + 0.3 * x * y + 0.2 * z); });
}

void Check(const std::string& name, const std::function<void(Scene&, vtkImageData*)>& arrange,
  const std::vector<double>& isovalues = { 70.0 })
{
  vtkSmartPointer<vtkImageData> image = Blob(30);
  Scene scene(image, isovalues);
  arrange(scene, image);
  for (const bool threshold : { false, true })
  {
    scene.Mapper->SetSurfaceMode(threshold);
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = isovalues;
    truth.IsThreshold = threshold;
    ExpectColdTruth(name + (threshold ? ", THRESHOLD" : ", CROSSING"), scene, truth, 160, 120);
  }
}

void SetDirection(vtkImageData* image)
{
  // A rotation about (1, 1, 1) by 120 degrees, then one about z, then a mirror.
  const double c = 0.8, s = 0.6;
  image->SetDirectionMatrix(0.0, -s, c, 0.0, c, s, -1.0, 0.0, 0.0);
}

void TestTransforms()
{
  Check("rotated prop",
    [](Scene& scene, vtkImageData*)
    {
      scene.Volume->RotateX(31.0);
      scene.Volume->RotateZ(-72.0);
      scene.Volume->SetPosition(3.0, -4.0, 5.0);
      scene.Volume->SetOrigin(0.1, 0.2, 0.3);
      scene.LookFrom(1.0, 0.5, 0.2);
    });
  Check("anisotropic scale and mirror",
    [](Scene& scene, vtkImageData*)
    {
      scene.Volume->SetScale(0.5, -2.0, 7.0);
      scene.Volume->RotateY(12.0);
      scene.LookFrom(1.0, 0.5, 0.2);
    });
  Check("sheared by a user matrix",
    [](Scene& scene, vtkImageData*)
    {
      vtkNew<vtkMatrix4x4> shear;
      shear->SetElement(0, 1, 0.4);
      shear->SetElement(2, 0, -0.7);
      scene.Volume->SetUserMatrix(shear);
      scene.LookFrom(-1.0, 0.5, 0.2);
    });
  Check("spacing, origin and first index",
    [](Scene& scene, vtkImageData* image)
    {
      image->SetSpacing(0.3, 1.7, 0.02);
      image->SetOrigin(100.0, -200.0, 33.0);
      image->SetExtent(-7, 22, 5, 34, 100, 129);
      scene.LookFrom(1.0, -0.5, 0.4);
    });
  Check("direction matrix",
    [](Scene& scene, vtkImageData* image)
    {
      image->SetSpacing(0.3, 0.7, 0.5);
      SetDirection(image);
      image->SetExtent(-7, 22, 5, 34, 100, 129);
      scene.Volume->RotateX(31.0);
      scene.LookFrom(1.0, -0.5, 0.4);
    });
  Check("far from the origin and tiny",
    [](Scene& scene, vtkImageData* image)
    {
      image->SetSpacing(1e-6, 1e-6, 1e-6);
      image->SetOrigin(1.0, 1.0, 1.0);
      scene.LookFrom(1.0, -0.5, 0.4);
    });
}

void TestCameras()
{
  Check("parallel along x",
    [](Scene& scene, vtkImageData*)
    {
      scene.LookFrom(1.0, 0.0, 0.0);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  Check("parallel, oblique",
    [](Scene& scene, vtkImageData*)
    {
      scene.LookFrom(1.0, 2.0, -0.4);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Renderer->GetActiveCamera()->Zoom(1.7);
    });
  Check("wide away", // the depth image is in single precision: no farther
    [](Scene& scene, vtkImageData*)
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      scene.LookFrom(1.0, 2.0, 0.4);
      camera->Dolly(0.02);
      camera->SetViewAngle(0.6);
      scene.Renderer->ResetCameraClippingRange();
    });
  Check("inside the volume",
    [](Scene& scene, vtkImageData*)
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(0.9, -0.8, 0.85);
      camera->SetFocalPoint(-0.2, 0.1, 0.0);
      camera->SetViewAngle(80.0);
      camera->SetClippingRange(0.01, 10.0);
    });
  Check("cut by the clipping planes",
    [](Scene& scene, vtkImageData*)
    {
      scene.LookFrom(1.0, 2.0, 0.4);
      const double distance = scene.Renderer->GetActiveCamera()->GetDistance();
      scene.Renderer->GetActiveCamera()->SetClippingRange(distance - 0.4, distance + 0.3);
    });
  Check("wide angle, off centre, rolled",
    [](Scene& scene, vtkImageData*)
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      scene.LookFrom(-1.0, 2.0, 0.4);
      camera->SetWindowCenter(0.4, -0.3);
      camera->SetViewAngle(100.0);
      camera->Dolly(3.0);
      camera->Roll(33.0);
      scene.Renderer->ResetCameraClippingRange();
    });
  Check("axis through voxel corners",
    [](Scene& scene, vtkImageData* image)
    {
      // With an odd number of pixels the central rays run within planes of samples.
      image->SetSpacing(1.0, 1.0, 1.0);
      image->SetOrigin(-15.0, -15.0, -15.0);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(0.0, 0.0, 100.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewUp(0.0, 1.0, 0.0);
      camera->ParallelProjectionOn();
      camera->SetParallelScale(20.0);
      camera->SetClippingRange(1.0, 200.0);
    });
}

void TestFields()
{
  Check("several isovalues in any order",
    [](Scene& scene, vtkImageData*) { scene.LookFrom(1, 2, 3); }, { 85.0, 20.0, 88.0, 60.0 });
  for (const double side : { 1.0, -1.0 })
  {
    // Cut faces whose samples equal the higher isovalue show it all over.
    Check("cut where samples equal an isovalue",
      [side](Scene& scene, vtkImageData* image)
      {
        image->DeepCopy(Volumes::FromFormula(24, VTK_INT,
          [](double x, double y, double z)
          {
            const double shell = std::max(std::abs(x), std::max(std::abs(y), std::abs(z)));
            return shell > 0.99 ? 2.0 : static_cast<double>(std::sin(91.0 * x * y + z) > 0.0);
          }));
        scene.LookFrom(side, 2.0 * side, 0.7 * side);
      },
      { 1.0, 2.0 });
  }
  Check("nearest samples",
    [](Scene& scene, vtkImageData*)
    {
      scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
      scene.LookFrom(1, 2, 3);
    },
    { 60.0, 85.0 });
  Check("two samples along an axis",
    [](Scene& scene, vtkImageData* image)
    {
      image->DeepCopy(Volumes::FromFormula(
        30, VTK_FLOAT, [](double x, double y, double z) { return 69 + x + y * y - z; }));
      image->SetDimensions(30, 15, 2);
      image->SetSpacing(0.1, 0.1, 1.0);
      scene.LookFrom(1, 2, 3);
    });
}

}

int TestGeometry(int, char*[])
{
  TestTransforms();
  TestCameras();
  TestFields();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
