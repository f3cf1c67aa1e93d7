// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Depth images, and frames after resources were released, agree with polygons in the scenes of
// VTK's TestGPURayCastRenderDepthToImage and ReleaseResources.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/PolygonPeer.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>

namespace
{

constexpr int Width = 321, Height = 300;

/// Cosine between the ray through a pixel and the direction of projection.
double CosineAt(vtkCamera* camera, int x, int y)
{
  if (camera->GetParallelProjection())
  {
    return 1.0;
  }
  const double pixel =
    2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) / Height;
  return 1.0 / std::hypot(1.0, pixel * (x + 0.5 - 0.5 * Width), pixel * (y + 0.5 - 0.5 * Height));
}

/// The depth image is that of the polygons' z-buffer, to a fraction of a voxel.
void TestRenderDepthToImage()
{
  Scene scene(Volumes::FourSpheres(60), { 100.0 });
  PolygonPeer peer(scene.Volume, scene.Renderer, Width, Height);
  peer.SetContours(scene.Mapper->GetInput());
  peer.LookFrom(0.6, -2.0, 1.2);
  scene.Renderer->GetActiveCamera()->Zoom(1.3);
  for (const bool isParallel : { false, true })
  {
    const std::string name = isParallel ? "RenderDepthToImage, parallel" : "RenderDepthToImage";
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(isParallel);
    scene.Renderer->ResetCameraClippingRange();
    peer.ExpectAgreement(name, 10000);
    const WindowPixels polygons = peer.DrawPolygons();
    Expect(scene.Render(Width, Height), name + ": rendered");
    std::vector<double> differences;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const float depth = polygons.Depths[static_cast<std::size_t>(y * Width + x)];
        if (depth < 1.0f && std::isfinite(scene.DepthAt(x, y)))
        {
          const double along = CosineAt(camera, x, y) * static_cast<double>(scene.DepthAt(x, y));
          differences.push_back(std::abs(along - peer.DistanceOf(depth)));
        }
      }
    }
    std::sort(differences.begin(), differences.end());
    const std::size_t count = differences.size();
    Expect(count > 10000, name + ": both have depths");
    const double median = differences[count / 2], most = differences[count * 9 / 10];
    std::cout << name << ": " << median << " voxel (median), " << most << " (90 %)\n";
    Expect(median < 0.05 && most < 0.25, name + ": another depth than that of polygons");
  }
}

/// Rendering goes on after resources were released, in the same window and, when that is gone, in
/// another one.
void TestReleaseResources()
{
  Scene scene(Volumes::FourSpheres(48), { 100.0 });
  auto first = std::make_unique<PolygonPeer>(scene.Volume, scene.Renderer, 250, 200);
  first->SetContours(scene.Mapper->GetInput());
  first->LookFrom(1.0, -2.0, 0.7);
  scene.Renderer->GetActiveCamera()->Azimuth(-40.0);
  first->ExpectAgreement("ReleaseResources, first window");
  scene.Mapper->ReleaseGraphicsResources(first->GetWindow());
  first->ExpectAgreement("ReleaseResources, released");
  scene.Volume->ReleaseGraphicsResources(first->GetWindow());
  scene.Mapper->ClearCache();
  first->ExpectAgreement("ReleaseResources, volume released and all forgotten");
  first->GetWindow()->Finalize();
  first->GetWindow()->SetSize(200, 250);
  first->ExpectAgreement("ReleaseResources, window closed and opened");
  first.reset();

  PolygonPeer second(scene.Volume, scene.Renderer, 180, 240);
  second.SetContours(scene.Mapper->GetInput());
  second.ExpectAgreement("ReleaseResources, second window");
}

/// Two windows at once, drawn in turn, one of them closed by and by.
void TestTwoWindows()
{
  Scene one(Volumes::FourSpheres(48), { 100.0 }), two(Volumes::FourSpheres(40), { 120.0 });
  PolygonPeer ofOne(one.Volume, one.Renderer, 200, 200);
  ofOne.SetContours(one.Mapper->GetInput());
  ofOne.LookFrom(1.0, -2.0, 0.7);
  {
    PolygonPeer ofTwo(two.Volume, two.Renderer, 240, 180);
    ofTwo.SetContours(two.Mapper->GetInput());
    ofTwo.LookFrom(0.6, -2.0, 1.2);
    ofOne.ExpectAgreement("one of two windows");
    ofTwo.ExpectAgreement("the other of two windows");
    ofOne.ExpectAgreement("one of two windows, again");
    ofOne.GetWindow()->MakeCurrent();
    two.Renderer->RemoveVolume(two.Volume);
  }
  ofOne.ExpectAgreement("the window that is left");
}

}

int TestAgainstPolygonsWindows(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestRenderDepthToImage();
  TestReleaseResources();
  TestTwoWindows();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
