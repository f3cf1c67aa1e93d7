// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Translucent polygons that cut through translucent isosurfaces, peeled by depth, are within 2/255
// of a compositor that finds all of them by brute force.

#include "Truth/GlassScene.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{

constexpr double Bound = 2.0; ///< of 255

/// The largest share of pixels that are farther off, at outlines or where two depths are equal.
constexpr double MostUndecided = 0.001;

/// Minus the distance from the middle.
vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(
    31, VTK_FLOAT, [](double x, double y, double z) { return -std::sqrt(x * x + y * y + z * z); });
}

/// Nested spheres.
std::vector<std::array<double, 5>> Shells(int count, double opacity)
{
  std::vector<std::array<double, 5>> nodes;
  for (int i = 0; i < count; ++i)
  {
    const double share = (i + 1.0) / count;
    nodes.push_back({ -0.9 * share, share, 1.0 - 0.8 * share, i % 2 ? 0.9 : 0.1, opacity });
  }
  return nodes;
}

vtkSmartPointer<vtkPolyData> Plane(double height)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, height);
  plane->SetPoint1(1.0, -1.0, height);
  plane->SetPoint2(-1.0, 1.0, height);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> Sphere(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(12);
  sphere->Update();
  return sphere->GetOutput();
}

/// Look at the scene's first volume.
void Look(GlassScene& scene, bool isParallel)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(1.5, -4.0, 2.5);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetParallelProjection(isParallel);
  camera->SetParallelScale(1.4);
  camera->SetClippingRange(2.0, 9.0);
}

void Check(GlassScene& scene, const std::string& name)
{
  constexpr int pixels = GlassScene::Width * GlassScene::Height;
  const GlassScene::Result result = scene.Compare(Bound);
  std::cout << name << ": " << result.Mixed << " pixels with polygons and isosurfaces, at most "
            << result.Largest << " / 255 off, " << result.Mean << " in the mean; "
            << result.Undecided << " are undecided\n";
  Expect(result.Wrong == 0,
    name + ": " + std::to_string(result.Wrong) + " of " + std::to_string(result.Compared) +
      " pixels are wrong, by up to " + std::to_string(result.Largest) + " / 255");
  Expect(result.Undecided <= MostUndecided * pixels,
    name + ": " + std::to_string(result.Undecided) + " pixels are undecided");
  Expect(result.Mixed > pixels / 10,
    name + ": only " + std::to_string(result.Mixed) + " pixels have polygons and isosurfaces");
}

/// Planes before, between, behind and through nested spheres. Along a line of sight there are up to
/// twice as many layers as spheres, and as many polygons as planes.
void TestShells(int shells, double opacity, int planes, bool isParallel)
{
  GlassScene scene;
  Look(scene, isParallel);
  scene.AddVolume(Ball(), Shells(shells, opacity));
  for (int i = 0; i < planes; ++i)
  {
    vtkActor* actor =
      scene.AddPolygons(Plane(0.0), { 0.2 * (i % 6), 1.0 - 0.15 * (i % 6), i % 2 ? 1.0 : 0.3 },
        i % 3 == 0 ? opacity : 0.2 + 0.1 * (i % 7));
    actor->GetProperty()->SetLighting(i % 2);
    actor->SetPosition(0.1 * i - 0.3, 1.1 - 2.2 * i / planes, 0.05 * i);
    actor->SetOrientation(90.0 - 17.0 * i, 13.0 * i, 21.0 * i);
  }
  Check(scene,
    std::to_string(shells) + " shells and " + std::to_string(planes) + " planes of opacity " +
      std::to_string(opacity) + (isParallel ? ", parallel" : ""));
}

/// Two volumes that interpenetrate, spheres of polygons, and an opaque prop.
void TestMany(bool isOpaqueInside)
{
  GlassScene scene({ 1.0, 1.0, 1.0 });
  Look(scene, false);
  scene.AddVolume(Ball(), Shells(2, 0.4));
  Scene& waves = scene.AddVolume(Volumes::Waves(),
    { { -600.0, 0.9, 0.1, 0.1, 0.3 }, { 100.0, 0.1, 0.9, 0.1, isOpaqueInside ? 1.0 : 0.5 },
      { 800.0, 0.1, 0.2, 0.9, 0.6 } });
  waves.Volume->SetPosition(0.5, 0.2, 0.3);
  waves.Volume->SetOrientation(20.0, 30.0, 40.0);
  waves.Volume->SetScale(0.7);
  vtkActor* first = scene.AddPolygons(Sphere(0.7), { 1.0, 0.8, 0.0 }, 0.3);
  first->SetPosition(-0.5, -0.4, 0.2);
  scene.AddPolygons(Sphere(0.8), { 0.0, 0.8, 1.0 }, 0.5)->SetPosition(0.6, -0.2, 0.1);
  vtkActor* plane = scene.AddPolygons(Plane(0.1), { 1.0, 0.0, 1.0 }, 0.7);
  plane->GetProperty()->LightingOn();
  scene.AddPolygons(Sphere(0.3), { 0.3, 0.3, 0.3 }, 1.0)->SetPosition(0.1, 0.5, 0.0);
  Check(scene,
    std::string("two volumes and many polygons") + (isOpaqueInside ? ", opaque within" : ""));
}

/// One of two volumes changes, and the layers of the other are taken as they were.
void TestChanges()
{
  GlassScene scene;
  Look(scene, false);
  Scene& ball = scene.AddVolume(Ball(), Shells(2, 0.5));
  Scene& other = scene.AddVolume(Ball(), Shells(1, 0.3));
  other.Volume->SetPosition(0.6, 0.0, 0.2);
  vtkActor* plane = scene.AddPolygons(Plane(0.0), { 1.0, 0.9, 0.2 }, 0.4);
  Check(scene, "two balls");
  plane->SetPosition(0.0, 0.0, 0.3);
  Check(scene, "the plane moved");
  other.Volume->SetPosition(0.0, 0.5, 0.0);
  Check(scene, "the second ball moved");
  SetColors(ball, Shells(2, 0.2));
  Check(scene, "the first ball has another opacity");
  ball.Volume->VisibilityOff();
  scene.Window->Render();
  ball.Volume->VisibilityOn();
  Check(scene, "the first ball was hidden for a while");
  scene.Renderer->RemoveVolume(ball.Volume);
  scene.Renderer->AddVolume(ball.Volume);
  Check(scene, "the first ball is drawn after the second");
  scene.Renderer->GetActiveCamera()->Azimuth(40.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(2.5, 8.0);
  Check(scene, "seen from the side");
}

}

int TestGlass(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestShells(1, 0.5, 1, false);
  TestShells(2, 0.1, 4, false);
  TestShells(4, 0.9, 3, true);
  TestShells(4, 0.2, 6, true);
  TestShells(4, 0.1, 16, false);
  TestShells(6, 0.3, 12, false);
  TestMany(false);
  TestMany(true);
  TestChanges();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
