// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper's clipping planes and cropping cut a volume. Each picture, by every route, agrees with
// brute force on the pieces of each ray, and caps have the normals of the planes.

#include "Checks/Expect.h"
#include "Scenes/Subject.h"
#include "Truth/BruteForceTracer.h"
#include "Truth/ColdWitness.h"
#include "Truth/ExpectTruth.h"
#include "Volumes/Volumes.h"
#include "Walks/Sweep.h"

#include <vtkContourValues.h>
#include <vtkMath.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include <cmath>
#include <cstdlib>

namespace
{

using Point = std::array<double, 3>;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// How many pixels PAPER may lose with each move: the shells of an onion are nearly all silhouette.
constexpr int Eroded = 80;
constexpr int Width = 120, Height = 90;

void AddPlane(Mapper* mapper, const Point& origin, const Point& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  mapper->AddClippingPlane(plane);
}

/// Compare a scene's picture with brute force.
void ExpectTruthOf(const std::string& name, Scene& scene, vtkImageData* image)
{
  BruteForceTracer truth(image, scene.Volume);
  truth.Isovalues = { scene.Volume->GetProperty()->GetIsoSurfaceValues()->GetValue(0) };
  truth.IsThreshold = scene.Mapper->GetSurfaceMode() == Mapper::THRESHOLD;
  ExpectTruth(name, scene, truth, Width, Height);
}

vtkSmartPointer<vtkImageData> Onion(int n)
{
  return Volumes::FromFormula(n, VTK_FLOAT,
    [](double x, double y, double z)
    { return std::cos(7.0 * std::sqrt(x * x + 1.3 * y * y + 0.8 * z * z + 0.1 * x * y)); });
}

void TestPlanes()
{
  vtkSmartPointer<vtkImageData> image = Onion(33);
  for (const bool threshold : { false, true })
  {
    for (const bool nearest : { false, true })
    {
      Scene scene(image, { 0.2 });
      scene.Mapper->SetSurfaceMode(threshold);
      scene.Volume->GetProperty()->SetInterpolationType(nearest ? 0 : 1);
      // Planes lie in the world, wherever the volume is taken.
      scene.Volume->RotateX(30.0);
      scene.Volume->SetScale(1.0, -1.3, 0.8);
      scene.Volume->SetPosition(0.1, 0.2, -0.1);
      scene.LookFrom(1.0, 0.6, 0.4);
      const std::string name =
        std::string(threshold ? "THRESHOLD" : "CROSSING") + (nearest ? ", nearest" : "");
      AddPlane(scene.Mapper, { 0.3, 0.0, 0.0 }, { -1.0, 0.1, 0.2 });
      ExpectTruthOf("one plane, " + name, scene, image);
      AddPlane(scene.Mapper, { 0.0, 0.2, 0.0 }, { 0.2, -2.0, 0.3 });
      AddPlane(scene.Mapper, { 0.0, 0.0, -0.6 }, { 0.0, 0.0, 0.5 });
      ExpectTruthOf("three planes, " + name, scene, image);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      ExpectTruthOf("three planes, parallel, " + name, scene, image);
      scene.Mapper->RemoveAllClippingPlanes();
      ExpectTruthOf("planes taken away, " + name, scene, image);
      AddPlane(scene.Mapper, { 9.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
      Expect(scene.Render(Width, Height), "rendered");
      Expect(!scene.Mapper->PickPixel(Width / 2, Height / 2, nullptr, nullptr, nullptr),
        "everything is clipped");
    }
  }
}

/// Each of the 27 boxes, the flags that have names, and others.
void TestCropping()
{
  vtkSmartPointer<vtkImageData> image = Onion(24);
  image->SetOrigin(-1.2, -0.9, -1.0);
  std::vector<int> flags = { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE,
    VTK_CROP_CROSS, VTK_CROP_INVERTED_CROSS, 0x2AAAAAA, 0x5555555, 0x0010002, 0x7ffffff, 0 };
  for (int box = 0; box < 27; ++box)
  {
    flags.push_back(1 << box);
    flags.push_back(0x7ffffff ^ 1 << box);
  }
  for (const bool threshold : { false, true })
  {
    Scene scene(image, { 0.1 });
    scene.Mapper->SetSurfaceMode(threshold);
    scene.Mapper->CroppingOn();
    scene.Mapper->SetCroppingRegionPlanes(-0.5, 0.31, -0.4, 0.2, -0.3, 0.5);
    scene.LookFrom(0.7, -1.0, 0.5);
    scene.Volume->RotateZ(17.0);
    for (const int flag : flags)
    {
      scene.Mapper->SetCroppingRegionFlags(flag);
      ExpectTruthOf((threshold ? "THRESHOLD, flags " : "CROSSING, flags ") + std::to_string(flag),
        scene, image);
    }
    // Inside, with clipping planes as well.
    scene.Mapper->SetCroppingRegionFlagsToInvertedFence();
    AddPlane(scene.Mapper, { 0.0, 0.0, 0.0 }, { 1.0, 0.5, 0.3 });
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(-0.2, 0.1, 0.0);
    camera->SetFocalPoint(1.0, 0.3, 0.2);
    camera->SetClippingRange(0.01, 10.0);
    ExpectTruthOf("inside the volume", scene, image);
  }
}

/// The box that is kept stays when an axis of the image is reversed.
void TestReversedAxis()
{
  Scene scene(Onion(24), { 0.1 }), reversed(nullptr, { 0.1 });
  vtkSmartPointer<vtkImageData> image = Onion(24);
  vtkNew<vtkImageData> turned;
  turned->DeepCopy(image);
  for (int k = 0; k < 24; ++k)
  {
    for (int j = 0; j < 24; ++j)
    {
      for (int i = 0; i < 24; ++i)
      {
        turned->SetScalarComponentFromDouble(
          i, j, k, 0, image->GetScalarComponentAsDouble(23 - i, j, k, 0));
      }
    }
  }
  turned->SetOrigin(1.0, -1.0, -1.0);
  turned->SetSpacing(-2.0 / 23.0, 2.0 / 23.0, 2.0 / 23.0);
  reversed.Mapper->SetInputData(turned);
  for (Scene* each : { &scene, &reversed })
  {
    each->Mapper->CroppingOn();
    each->Mapper->SetCroppingRegionPlanes(-0.7, 0.1, -0.4, 0.2, -0.3, 0.5);
    each->Mapper->SetCroppingRegionFlags(0x1234567);
    each->LookFrom(0.7, -1.0, 0.5);
  }
  reversed.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  Expect(scene.Render(Width, Height) && reversed.Render(Width, Height), "rendered");
  int different = 0, hits = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const float a = scene.DepthAt(x, y), b = reversed.DepthAt(x, y);
      different += std::isinf(a) != std::isinf(b) || (!std::isinf(a) && std::abs(a - b) > 1e-4f);
      hits += !std::isinf(a);
    }
  }
  Expect(hits > 500 && different <= 2, std::to_string(different) + " pixels of a reversed axis");
}

/// A cap has the normal of the plane that cuts it.
void TestCaps()
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(
    31, VTK_FLOAT, [](double x, double y, double z) { return -std::hypot(x, y, z); });
  Scene scene(image, { -0.8 });
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.Volume->SetScale(1.0, 2.0, 1.0);
  scene.Volume->RotateZ(20.0);
  const double normal[3] = { -0.8, 0.36, -0.48 };
  AddPlane(scene.Mapper, { 0.05, 0.0, 0.0 }, { normal[0], normal[1], normal[2] });
  scene.LookFrom(1.0, -0.3, 0.4);
  Expect(scene.Render(Width, Height), "rendered");
  double position[3], found[3];
  Expect(scene.Mapper->PickPixel(Width / 2, Height / 2, position, found, nullptr), "a cap is seen");
  Expect(std::abs(vtkMath::Dot(position, normal) - 0.05 * normal[0]) < 1e-6, "on the plane");
  Expect(vtkMath::Dot(found, normal) < -0.99999, "with the normal of the clipping plane");

  scene.Mapper->RemoveAllClippingPlanes();
  scene.Volume->SetOrientation(0.0, 0.0, 0.0);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(-0.5, 0.123, -1.0, 1.0, -1.0, 1.0);
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  scene.LookFrom(1.0, 0.1, 0.1);
  Expect(scene.Render(Width, Height), "rendered");
  Expect(scene.Mapper->PickPixel(Width / 2, Height / 2, position, found, nullptr), "a cap is seen");
  Expect(std::abs(position[0] - 0.123) < 1e-6 && found[0] > 0.99999, "on the cropping plane");
}

/// The picture of every route is the cold picture (but for what PAPER erodes).
void TestRoutes()
{
  for (const int flags : { VTK_CROP_SUBVOLUME, VTK_CROP_INVERTED_CROSS })
  {
    for (const bool threshold : { false, true })
    {
      const std::string name =
        "flags " + std::to_string(flags) + (threshold ? ", THRESHOLD" : ", CROSSING");
      Scene scene(Onion(40), { 0.1 });
      scene.Mapper->SetReuseAccuracyToPaper();
      scene.Mapper->SetSurfaceMode(threshold);
      scene.Mapper->CroppingOn();
      scene.Mapper->SetCroppingRegionPlanes(-0.5, 0.41, -0.4, 0.6, -0.6, 0.5);
      scene.Mapper->SetCroppingRegionFlags(flags);
      AddPlane(scene.Mapper, { 0.2, 0.0, 0.0 }, { -1.0, 0.4, 0.0 });
      scene.LookFrom(0.7, -1.0, 0.5);
      ColdWitness cold;
      Sweep::Routes routes;
      const auto step = [&](const std::string& what, int mostDifferent)
      {
        Expect(scene.Render(160, 120) && cold.Draw(scene), name + what + ": rendered");
        ++routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
        Expect(
          mostDifferent > 0 ? cold.CountDifferent(scene) <= mostDifferent : cold.IsIdentical(scene),
          name + what + ": not the cold picture, by " +
            scene.Mapper->GetStatistics()->GetRouteAsString() + ", " +
            std::to_string(cold.CountDifferent(scene)) + " pixels differ");
      };
      step(", first", 0);
      for (int i = 0; i < 12; ++i)
      {
        scene.Renderer->GetActiveCamera()->Azimuth(2.0);
        step(", orbit", Eroded * (i + 1));
      }
      for (const bool isomap : { true, false })
      {
        scene.Mapper->SetIsomap(isomap);
        scene.Mapper->SetIsomapRange(0.1, 0.22);
        for (int i = 0; i < 12; ++i)
        {
          scene.SetIsovalues({ 0.1 + 0.03 * (i % 5) });
          step(isomap ? ", sweep" : ", sweep without isomap", 0);
        }
      }
      scene.Mapper->IsomapOn();
      // Whatever is cut otherwise makes a cold frame.
      scene.Mapper->SetCroppingRegionPlanes(-0.5, 0.42, -0.4, 0.6, -0.6, 0.5);
      step(", cropped otherwise", 0);
      Expect(IsRoute(scene, "Cold"), name + ": another crop is cold");
      scene.Mapper->GetClippingPlanes()->GetItem(0)->SetOrigin(0.21, 0.0, 0.0);
      step(", clipped otherwise", 0);
      Expect(IsRoute(scene, "Cold"), name + ": another plane is cold");
      step(", again", 0);
      Expect(IsRoute(scene, "Redisplay"), name + ": nothing changed");
      scene.Mapper->CroppingOff();
      step(", not cropped", 0);
      scene.Mapper->SetCroppingRegionPlanes(-0.1, 0.1, -0.4, 0.6, -0.6, 0.5);
      step(", planes that are off", 0);
      Expect(IsRoute(scene, "Redisplay"), name + ": planes that are off matter to nobody");
      Expect(routes["ImageCache"] >= 8, name + ": the image cache serves");
      Expect(routes["IsomapLookup"] >= 5, name + ": the isomap too");
    }
  }
}

}

int TestRegion(int, char*[])
{
  TestPlanes();
  TestCropping();
  TestReversedAxis();
  TestCaps();
  TestRoutes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
