// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What changed decides the route, and every route shows what a mapper without a past shows.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <cstdlib>
#include <functional>
#include <random>

namespace
{

/// The picture of the scene by a new mapper.
void ExpectFreshPicture(Scene& scene, const std::string& what)
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> fresh;
  fresh->SetAntialiasingToOff();
  fresh->SetInputDataObject(scene.Mapper->GetInputDataObject(0, 0));
  fresh->SetSurfaceMode(scene.Mapper->GetSurfaceMode());
  vtkNew<vtkImageData> color, depth;
  int size[3];
  scene.Color->GetDimensions(size);
  Expect(fresh->MakeImage(scene.Renderer, scene.Volume, size[0], size[1], color, depth), "fresh");
  Expect(AreIdentical(color, scene.Color) && AreIdentical(depth, scene.Depth),
    what + ": the picture is not that of a mapper without a past");
}

void ExpectRoute(Scene& scene, const std::string& route, const std::string& what)
{
  Expect(scene.Render(90, 70), what + ": rendered");
  Expect(scene.Mapper->GetStatistics()->GetRouteAsString() == route,
    what + ": the route is " + scene.Mapper->GetStatistics()->GetRouteAsString() + ", not " +
      route);
  ExpectFreshPicture(scene, what);
}

/// How far bands of the isomap reach is not promised: later isovalues may be in an earlier one's.
void ExpectIsomap(Scene& scene, const std::string& what)
{
  Expect(scene.Render(90, 70), what + ": rendered");
  const std::string route = scene.Mapper->GetStatistics()->GetRouteAsString();
  Expect(route == "IsomapBuild" || route == "IsomapLookup", what + ": the route is " + route);
  ExpectFreshPicture(scene, what);
}

void TestEachChange()
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 200.0, -300.0 });
  scene.Mapper->SetReuseAccuracyToExact();
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();

  ExpectRoute(scene, "Cold", "first frame");
  ExpectRoute(scene, "Redisplay", "nothing");
  property->SetAmbient(0.5);
  ExpectRoute(scene, "Reshade", "ambient");
  property->ShadeOff();
  ExpectRoute(scene, "Reshade", "shade off");
  property->ShadeOn();
  ExpectRoute(scene, "Reshade", "shade on");
  property->GetRGBTransferFunction()->AddRGBPoint(200.0, 0.0, 1.0, 0.0);
  ExpectRoute(scene, "Reshade", "colour at an isovalue");
  property->GetRGBTransferFunction()->AddRGBPoint(9000.0, 0.0, 1.0, 0.0);
  ExpectRoute(scene, "Redisplay", "colour away from the isovalues");
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3.0, 4.0, 5.0);
  light->PositionalOn();
  scene.Renderer->AddLight(light);
  ExpectRoute(scene, "Reshade", "light added");
  light->SetConeAngle(20.0);
  ExpectRoute(scene, "Reshade", "light narrowed");

  property->SetInterpolationTypeToNearest();
  ExpectRoute(scene, "Cold", "interpolation");
  camera->Azimuth(10.0);
  ExpectRoute(scene, "Cold", "camera, EXACT");
  scene.Volume->RotateX(5.0);
  ExpectRoute(scene, "Cold", "prop transform");
  scene.Mapper->SetSurfaceModeToThreshold();
  ExpectRoute(scene, "Cold", "surface mode");
  image->SetOrigin(0.1, 0.0, 0.0);
  ExpectRoute(scene, "Cold", "image origin");
  image->GetPointData()->GetScalars()->SetComponent(17000, 0, 30000);
  image->GetPointData()->GetScalars()->Modified();
  ExpectRoute(scene, "TimeStep", "one sample: most tiles do not see it");
  scene.Mapper->SetInputData(Volumes::Waves());
  ExpectRoute(scene, "Cold", "another image");

  // Ways to set isovalues that VTK's modification times do not tell of.
  property->GetIsoSurfaceValues()->SetValue(1, -200.0);
  ExpectRoute(scene, "IsomapBuild", "isovalue by SetValue");
  property->GetIsoSurfaceValues()->GetValues()[1] = -100.0;
  ExpectIsomap(scene, "isovalue by pointer");
  vtkNew<vtkContourValues> others;
  others->SetValue(0, 50.0);
  property->GetIsoSurfaceValues()->DeepCopy(others);
  ExpectIsomap(scene, "isovalues by DeepCopy");
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  property->SetScalarOpacity(opacity);
  ExpectRoute(scene, "Cold", "invisible");

  scene.Mapper->ClearCache();
  Expect(!scene.Mapper->PickPixel(45, 35, nullptr, nullptr, nullptr), "nothing to pick");
  ExpectRoute(scene, "Cold", "after ClearCache");
}

/// The slider of a user: opacities of what is seen already.
void TestOpacities()
{
  Scene scene(Volumes::Waves(), { 200.0, -300.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  const auto set = [&](double high, double low)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(-300.0, low);
    opacity->AddPoint(200.0, high);
    property->SetScalarOpacity(opacity);
  };
  const auto expectNothingTraced = [&](const std::string& what)
  {
    Expect(scene.Mapper->GetStatistics()->GetNumberOfTracedRays() == 0 &&
        scene.Mapper->GetStatistics()->GetNumberOfFieldSamples() == 0,
      what + ": rays were traced");
  };
  set(0.8, 0.9);
  ExpectRoute(scene, "Cold", "first frame");
  const vtkIdType layers = scene.Mapper->GetStatistics()->GetNumberOfLayers();
  set(0.3, 0.4);
  ExpectRoute(scene, "Recomposite", "more light");
  Expect(scene.Mapper->GetStatistics()->GetNumberOfTracedRays() > 0, "nothing more is seen");
  Expect(scene.Mapper->GetStatistics()->GetNumberOfTracedRays() <
      scene.Mapper->GetStatistics()->GetNumberOfRays(),
    "all was traced");
  Expect(scene.Mapper->GetStatistics()->GetNumberOfLayers() > layers,
    "layers that are seen now are not counted");
  set(0.8, 0.9);
  ExpectRoute(scene, "Recomposite", "less light");
  expectNothingTraced("less light");
  Expect(scene.Mapper->GetStatistics()->GetNumberOfLayers() == layers,
    "layers that no light reaches are counted");
  property->GetScalarOpacity()->AddPoint(200.0, 0.3); // modifies the function in place
  property->SetAmbient(0.4);
  ExpectRoute(scene, "Recomposite", "one opacity, and light");
  set(1.0, 1.0);
  ExpectRoute(scene, "Recomposite", "opaque");
  expectNothingTraced("opaque");
  set(0.3, 0.4);
  ExpectRoute(scene, "Recomposite", "translucent again");
  expectNothingTraced("translucent again");
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.0, 0.1);
  byGradient->AddPoint(100.0, 0.9);
  property->SetGradientOpacity(byGradient);
  ExpectRoute(scene, "Recomposite", "gradient opacity");
  scene.Mapper->ReuseFramesOff();
  scene.Mapper->IsomapOff();
  set(0.5, 0.5);
  ExpectRoute(scene, "Cold", "nothing may be re-used");
}

/// A user drags one of several see-through surfaces.
void TestOneOfSeveral()
{
  Scene scene(Volumes::Waves(), { 200.0, -300.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->GetScalarOpacity()->AddPoint(0.0, 0.2);
  ExpectRoute(scene, "Cold", "first frame");
  for (int step = 1; step <= 20; ++step)
  {
    const std::string what = "step " + std::to_string(step);
    property->GetIsoSurfaceValues()->SetValue(1, -300.0 + 10.0 * step);
    ExpectIsomap(scene, what);
    Expect(scene.Mapper->GetStatistics()->GetNumberOfPossibleHits() +
          scene.Mapper->GetStatistics()->GetNumberOfDefiniteHits() +
          scene.Mapper->GetStatistics()->GetNumberOfDefiniteMisses() ==
        scene.Mapper->GetStatistics()->GetNumberOfRays(),
      what + ": the counters do not add up");
  }
  scene.Mapper->SetIsomapRange(-100.0, 600.0);
  Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "an isomap");
  scene.SetIsovalues({ 500.0, 200.0, 20.0 });
  ExpectRoute(scene, "IsomapLookup", "an isomap holds them all");
  scene.Mapper->IsomapOff();
  scene.SetIsovalues({ 500.0, 200.0, 30.0 });
  ExpectRoute(scene, "Cold", "without isomap");
}

/// Changes in random order, several at a time.
void TestManyChanges()
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 0.0 });
  scene.Mapper->SetReuseAccuracyToExact();
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  std::mt19937 engine(5);
  const auto pick = [&engine](int n)
  { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
  const std::vector<std::function<void()>> changes = {
    [&] { scene.Renderer->GetActiveCamera()->Azimuth(pick(30)); },
    [&] { scene.Renderer->GetActiveCamera()->Zoom(pick(2) ? 1.1 : 1.0 / 1.1); },
    [&] { scene.Renderer->GetActiveCamera()->SetParallelProjection(pick(2)); },
    [&] { scene.SetIsovalues({ 100.0 * pick(9) - 400.0 }); },
    [&] {
      scene.SetIsovalues({ 100.0 * pick(9), -100.0 * pick(9) });
    },
    [&] { property->SetSpecular(0.1 * pick(5)); },
    [&] { property->SetInterpolationType(pick(2)); },
    [&] { scene.Mapper->SetSurfaceMode(pick(2)); },
    [&] { scene.Mapper->SetSpaceLeaping(pick(2)); },
    [&] { scene.Volume->RotateZ(pick(20)); },
    [&]
    {
      image->GetPointData()->GetScalars()->SetComponent(pick(32768), 0, 1000 * pick(3));
      image->GetPointData()->GetScalars()->Modified();
    },
    [] {},
  };
  for (int step = 0; step < 300; ++step)
  {
    for (int i = pick(3); i >= 0; --i)
    {
      changes[static_cast<std::size_t>(pick(static_cast<int>(changes.size())))]();
    }
    const int size = 40 + 8 * pick(2);
    Expect(scene.Render(size, 40), "rendered");
    ExpectFreshPicture(scene, "step " + std::to_string(step));
  }
}

void TestThreads()
{
  Scene scene(Volumes::Waves(), { 200.0, -300.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkNew<vtkImageData> color, depth;
  // The backend of plain threads starts as many as it is told, whatever the machine has.
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    scene.Mapper->ClearCache();
    Expect(scene.Render(333, 222), "rendered");
    if (threads == 1)
    {
      color->DeepCopy(scene.Color);
      depth->DeepCopy(scene.Depth);
    }
    Expect(AreIdentical(color, scene.Color) && AreIdentical(depth, scene.Depth),
      std::to_string(threads) + " threads give another picture");
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

void TestCounters()
{
  Scene scene(Volumes::Waves(), { 0.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkTemporalCoherenceVolumeMapper* mapper = scene.Mapper;
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Volume->GetProperty()->SetAmbient(frame == 2 ? 0.3 : 0.1);
    Expect(scene.Render(64, 48), "rendered");
    Expect(mapper->GetStatistics()->GetNumberOfRays() == 64 * 48, "one ray a pixel");
    Expect(mapper->GetStatistics()->GetNumberOfDefiniteHits() +
          mapper->GetStatistics()->GetNumberOfDefiniteMisses() +
          mapper->GetStatistics()->GetNumberOfPossibleHits() ==
        mapper->GetStatistics()->GetNumberOfRays(),
      "answers add up to rays");
    const bool cold = frame == 0;
    Expect((mapper->GetStatistics()->GetNumberOfTracedRays() > 0) == cold,
      "rays are traced in a cold frame only");
    Expect((mapper->GetStatistics()->GetNumberOfFieldSamples() > 0) == cold,
      "samples are read in a cold frame only");
    Expect(mapper->GetStatistics()->GetFrameTime() > 0.0 &&
        mapper->GetStatistics()->GetTraceTime() + mapper->GetStatistics()->GetShadeTime() <=
          mapper->GetStatistics()->GetFrameTime(),
      "times add up");
    Expect(mapper->GetStatistics()->GetPresentTime() == 0.0, "nothing is shown");
  }
}

}

int TestRoutes(int, char*[])
{
  TestEachChange();
  TestOpacities();
  TestOneOfSeveral();
  TestManyChanges();
  TestThreads();
  TestCounters();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
