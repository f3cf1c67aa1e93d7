// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Each pixel of translucent surfaces is within 2/255 of a compositor of all crossings, which brute
// force finds. Every exact route makes the cold picture.

#include "Checks/Expect.h"
#include "Truth/ColdWitness.h"
#include "Truth/Compositor.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "Walks/Sweep.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cstdlib>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

/// Three contours of VTK's wavelet, with opacities 1, 0.6 and 0.2.
void TestWavelet()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-12, 12, -12, 12, -12, 12);
  wavelet->Update();
  const std::vector<std::array<double, 5>> nodes = { { 100.0, 0.2, 0.4, 1.0, 0.2 },
    { 150.0, 0.9, 0.9, 0.1, 0.6 }, { 200.0, 1.0, 0.2, 0.1, 1.0 } };
  for (const bool shade : { false, true })
  {
    for (const bool threshold : { false, true })
    {
      Scene scene(wavelet->GetOutput(), { 100.0, 150.0, 200.0 });
      SetColors(scene, nodes);
      scene.Volume->GetProperty()->SetShade(shade);
      scene.Mapper->SetSurfaceMode(threshold);
      scene.LookFrom(1.0, 0.8, 0.5);
      const std::string name = std::string("wavelet, ") + (threshold ? "THRESHOLD" : "CROSSING") +
        (shade ? ", shaded" : "");
      // With caps, the brute-force normal is not that of the face.
      if (!(threshold && shade))
      {
        ExpectComposite(name, scene, Compositor(scene, wavelet->GetOutput()));
      }
      // Order carries no meaning, and nothing is drawn twice.
      vtkNew<vtkImageData> before;
      scene.Render(100, 80);
      before->DeepCopy(scene.Color);
      scene.SetIsovalues({ 200.0, 100.0, 150.0, 100.0 });
      scene.Mapper->ClearCache();
      Expect(scene.Render(100, 80) && AreIdentical(before, scene.Color),
        name + ": another order of the list");
      int index = -1;
      Expect(scene.Mapper->PickPixel(50, 40, nullptr, nullptr, &index) && index >= 0 && index < 3,
        name + ": the first of two equal isovalues is picked");
    }
  }
}

/// Show three translucent isovalues of noise from 0 to 100.
void DressNoise(Scene& scene, bool nearest, bool threshold)
{
  SetColors(scene,
    { { 30.75, 0.1, 0.3, 0.9, 0.15 }, { 50.5, 0.8, 0.3, 0.2, 0.3 },
      { 80.25, 0.2, 0.9, 0.1, 0.5 } });
  scene.Volume->GetProperty()->ShadeOff();
  scene.Volume->GetProperty()->SetInterpolationType(nearest ? 0 : 1);
  scene.Mapper->SetSurfaceMode(threshold);
  scene.LookFrom(0.9, 0.7, 0.4);
}

/// Noise, inside it, all types of samples, both interpolations, clipped.
void TestFields()
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const bool nearest : { false, true })
    {
      for (const bool threshold : { false, true })
      {
        vtkSmartPointer<vtkImageData> image = Volumes::Noise(9, type, 0.0, 100.0);
        Scene scene(image, { 50.5, 80.25, 30.75 });
        DressNoise(scene, nearest, threshold);
        const std::string name = "noise of type " + std::to_string(type) +
          (nearest ? ", nearest" : "") + (threshold ? ", THRESHOLD" : ", CROSSING");
        ExpectComposite(name, scene, Compositor(scene, image.Get()), 60, 50);
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.1, 0.0, 0.0);
        plane->SetNormal(-1.0, -0.3, 0.2);
        scene.Mapper->AddClippingPlane(plane);
        ExpectComposite(name + ", clipped", scene, Compositor(scene, image.Get()), 60, 50);
      }
    }
  }
}

/// Cells of all sizes, some of them hidden.
void TestGrids()
{
  for (const bool nearest : { false, true })
  {
    for (const bool threshold : { false, true })
    {
      vtkSmartPointer<vtkImageData> noise = Volumes::Noise(9, VTK_SHORT, 0.0, 100.0);
      vtkNew<vtkRectilinearGrid> grid;
      grid->SetDimensions(9, 9, 9);
      vtkNew<vtkDoubleArray> coordinates;
      for (int i = 0; i < 9; ++i)
      {
        coordinates->InsertNextValue(0.01 * (i * i * i + 10 * i));
      }
      grid->SetXCoordinates(coordinates);
      grid->SetYCoordinates(coordinates);
      grid->SetZCoordinates(coordinates);
      grid->GetPointData()->SetScalars(noise->GetPointData()->GetScalars());
      Scene scene(grid, { 50.5, 80.25, 30.75 });
      DressNoise(scene, nearest, threshold);
      const std::string name = std::string("grid") + (nearest ? ", nearest" : "") +
        (threshold ? ", THRESHOLD" : ", CROSSING");
      ExpectComposite(name, scene, Compositor(scene, grid.Get()), 60, 50);
      if (!threshold)
      {
        Ghosts::HideCells(noise, 0.1, 5);
        grid->GetCellData()->ShallowCopy(noise->GetCellData());
        ExpectComposite(name + ", cells hidden", scene, Compositor(scene, grid.Get()), 60, 50);
      }
    }
  }
}

/// More layers in a pixel than are kept: all of them are drawn, by every route.
void TestHaze()
{
  for (const bool threshold : { false, true })
  {
    vtkSmartPointer<vtkImageData> image =
      Volumes::Noise(threshold ? 41 : 21, VTK_SHORT, 0.0, 100.0);
    const std::vector<double> isovalues{ 22.5, 34.5, 46.5, 58.5, 70.5, 82.5 };
    Scene scene(image, isovalues);
    scene.Volume->GetProperty()->ShadeOff();
    scene.Mapper->SetSurfaceMode(threshold);
    scene.LookFrom(0.9, 0.7, 0.4);
    const auto expect = [&](double opacity, const std::string& route)
    {
      SetColors(scene, { { 22.5, 0.1, 0.3, 0.9, opacity }, { 82.5, 0.9, 0.5, 0.1, opacity } });
      const std::string name =
        "haze of opacity " + std::to_string(opacity) + (threshold ? ", THRESHOLD" : ", CROSSING");
      ExpectComposite(name, scene, Compositor(scene, image.Get()), 40, 30);
      Expect(IsRoute(scene, route.c_str()),
        name + ": by " + scene.Mapper->GetStatistics()->GetRouteAsString());
    };
    expect(0.05, "Cold");
    expect(0.01, "Recomposite");
    Expect(scene.Mapper->GetStatistics()->GetNumberOfMergedLayers() >
        scene.Mapper->GetStatistics()->GetNumberOfLayers() / 10,
      "many layers are merged");
    expect(0.05, "Recomposite");
    scene.Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(46.5, 0.1, 0.9, 0.4);
    ExpectComposite("haze in other colours", scene, Compositor(scene, image.Get()), 40, 30);
    Expect(IsRoute(scene, "Reshade"), "only colours changed");
  }
}

/// Opacity by gradient magnitude; what cannot be seen is not picked.
void TestGradientOpacity()
{
  // Steep at the left, gentle at the right.
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(25, VTK_FLOAT,
    [](double x, double y, double z)
    { return 10.0 * (0.3 + 0.6 * x * x - z + 0.2 * y) * (1.5 - x); });
  image->SetSpacing(0.5, 0.5, 0.5);
  Scene scene(image, { 0.0 });
  SetColors(scene, { { 0.0, 0.9, 0.5, 0.2, 0.8 } });
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.8, 0.0);
  byGradient->AddPoint(1.2, 1.0);
  scene.Volume->GetProperty()->SetGradientOpacity(byGradient);
  scene.LookFrom(0.1, 0.2, 1.0);
  Compositor compositor(scene, image.Get());
  compositor.OpacityByGradient = [](double g) { return std::clamp((g - 0.8) / 0.4, 0.0, 1.0); };
  ExpectComposite("gradient opacity", scene, compositor);
  int clear = 0;
  for (int y = 0; y < 80; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      const bool isSeen = compositor.ColorAt(x, y, 100, 80)[3] > 1e-3;
      const bool isPicked = scene.Mapper->PickPixel(x, y, nullptr, nullptr, nullptr);
      clear += !isSeen;
      Expect(!isSeen || isPicked, "what is seen is picked");
      Expect(isPicked == !std::isinf(scene.DepthAt(x, y)), "as the depth says");
      Expect(isPicked || scene.ColorAt(x, y)[3] == 0, "what is not picked is not seen");
    }
  }
  Expect(clear > 500, "some of the surface is not seen");
  scene.Volume->GetProperty()->DisableGradientOpacityOn();
  compositor.OpacityByGradient = [](double) { return 1.0; };
  ExpectComposite("gradient opacity disabled", scene, compositor);
}

/// The picture of every route is the cold picture (within the bounds of the image cache).
void TestRoutes()
{
  for (const bool threshold : { false, true })
  {
    vtkSmartPointer<vtkImageData> image = Volumes::Waves();
    Scene scene(image, { 0.0, 500.0, -600.0 });
    SetColors(scene,
      { { -900.0, 0.1, 0.3, 0.9, 0.3 }, { 0.0, 0.8, 0.3, 0.2, 0.4 },
        { 900.0, 0.2, 0.9, 0.1, 0.9 } });
    scene.Mapper->SetSurfaceMode(threshold);
    scene.LookFrom(0.7, -1.0, 0.5);
    ColdWitness cold;
    Sweep::Routes routes;
    const auto step = [&](const std::string& what, bool isExact)
    {
      Expect(scene.Render(160, 120) && cold.Draw(scene), what + ": rendered");
      ++routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
      Expect(isExact ? cold.IsIdentical(scene) : cold.CountDifferent(scene) <= 10,
        what + ": not the cold picture, by " + scene.Mapper->GetStatistics()->GetRouteAsString());
    };
    step("first", true);
    for (int i = 0; i < 10; ++i)
    {
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      step("orbit", true);
    }
    step("still", true);
    for (int i = 0; i < 6; ++i)
    {
      scene.SetIsovalues({ 0.0, 505.0 + 5.0 * (i % 4), -600.0 });
      step("one isovalue of three", true);
    }
    for (int i = 0; i < 6; ++i)
    {
      scene.SetIsovalues({ 1.0 + i, 501.0 + 5.0 * i, -600.0 - i });
      step("all three isovalues", true);
    }
    scene.Volume->GetProperty()->SetAmbient(0.4);
    step("another light", true);
    Expect(IsRoute(scene, "Reshade"), "only colours changed");
    scene.Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.1, 0.9, 0.4);
    step("other colours", true);
    Expect(IsRoute(scene, "Reshade"), "only colours changed");
    scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.1);
    step("another opacity", true);
    Expect(IsRoute(scene, "Recomposite"), "only opacities changed");
    scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.0);
    step("one left out", true);
    SetColors(scene, { { 0.0, 0.8, 0.3, 0.2, 1.0 } });
    step("opaque", true);
    SetColors(scene, { { 0.0, 0.8, 0.3, 0.2, 0.4 } });
    step("translucent again", true);
    scene.Mapper->SetReuseAccuracyToExact();
    scene.Renderer->GetActiveCamera()->Elevation(3.0);
    step("EXACT", true);
    scene.Mapper->SpaceLeapingOff();
    scene.Mapper->ClearCache();
    step("no leaping", true);
    scene.Mapper->SpaceLeapingOn();
    step("leaping again", true);
    Expect(routes["IsomapLookup"] + routes["IsomapBuild"] >= 4, "the isomap does");
  }
}

}

int TestTranslucent(int, char*[])
{
  TestWavelet();
  TestFields();
  TestGrids();
  TestHaze();
  TestGradientOpacity();
  TestRoutes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
