// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In an interaction, windows show frames from fewer rays. When the camera rests, each kind of
// picture ends as the cold one, which a stop does not spoil. Picks and depths fit the picture.

#include "Checks/Expect.h"
#include "Checks/Stopper.h"
#include "Scenes/Scene.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

namespace
{

constexpr int Width = 210, Height = 170;
constexpr double Interactive = 1e9, Still = 1e-4; ///< frames a second

struct Kind
{
  std::string Name;
  bool IsMesh;
  std::function<void(Scene&)> SetUp;
};

void SetLayers(Scene& scene)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.4);
  opacity->AddPoint(255.0, 0.5);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
}

void SetVeil(Scene& scene)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(120.0, 0.02);
  opacity->AddPoint(255.0, 0.2);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  scene.Mapper->SetBlendModeToComposite();
}

std::vector<Kind> AllKinds()
{
  const auto clip = [](Scene& scene)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(scene.Mapper->GetInput()->GetCenter());
    plane->SetNormal(1.0, 0.4, 0.2);
    scene.Mapper->AddClippingPlane(plane);
  };
  return { { "opaque", false, [](Scene&) {} }, { "layers", false, SetLayers },
    { "mesh", true, [](Scene&) {} }, { "mesh, layers", true, SetLayers },
    { "composite", false, SetVeil },
    { "composite, nearest", false,
      [](Scene& scene)
      {
        SetVeil(scene);
        scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
      } },
    { "composite, clipped, parallel", false,
      [clip](Scene& scene)
      {
        SetVeil(scene);
        clip(scene);
        scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      } },
    { "layers, clipped", false,
      [clip](Scene& scene)
      {
        SetLayers(scene);
        clip(scene);
      } },
    { "solid", false,
      [clip](Scene& scene)
      {
        scene.Mapper->SetSurfaceModeToThreshold();
        clip(scene);
      } },
    { "maximum", false, [](Scene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); } },
    { "average", false, [](Scene& scene) { scene.Mapper->SetBlendModeToAverageIntensity(); } } };
}

vtkSmartPointer<vtkDataSet> DataOf(const Kind& kind)
{
  const vtkSmartPointer<vtkImageData> image = Volumes::FourSpheres(kind.IsMesh ? 14 : 40);
  return kind.IsMesh ? vtkSmartPointer<vtkDataSet>(VtkMeshes::Unstructured(image, VTK_TETRA))
                     : vtkSmartPointer<vtkDataSet>(image);
}

struct Stage : Scene
{
  explicit Stage(const Kind& kind)
    : Scene(DataOf(kind), { 100.0, 160.0 })
  {
    this->Volume->GetProperty()->SetInterpolationTypeToLinear();
    kind.SetUp(*this);
    this->LookFrom(1.0, 2.0, 0.5);
    this->Mapper->SetMaximumImageSampleDistance(4.0f);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
  }
  void Draw(double rate)
  {
    this->Window->SetDesiredUpdateRate(rate);
    this->Window->Render();
  }
  vtkNew<vtkRenderWindow> Window;
};

/// The mean difference of colours.
double ErrorOf(vtkImageData* image, vtkImageData* exact)
{
  const auto* a = static_cast<unsigned char*>(image->GetScalarPointer());
  const auto* b = static_cast<unsigned char*>(exact->GetScalarPointer());
  double sum = 0.0;
  for (int i = 0; i < 4 * Width * Height; ++i)
  {
    sum += std::abs(a[i] - b[i]);
  }
  return sum / (4 * Width * Height);
}

void TestKind(const Kind& kind)
{
  Stage stage(kind);
  stage.Draw(Interactive);
  Expect(
    IsRoute(stage, "FewerRays") && !stage.Mapper->GetFrameIsFinal(), kind.Name + ": fewer rays");
  vtkNew<vtkImageData> shown, depths;
  Expect(stage.GetLastFrame(shown, depths), kind.Name + ": read");
  int picked = 0, seen = 0;
  for (int y = 0; y < Height; y += 3)
  {
    for (int x = 0; x < Width; x += 3)
    {
      const bool isHit = stage.Mapper->PickPixel(x, y, nullptr, nullptr, nullptr);
      const auto* color = static_cast<unsigned char*>(shown->GetScalarPointer(x, y, 0));
      seen += color[0] + color[1] + color[2] + color[3] != 0;
      picked += isHit;
      const float depth = *static_cast<float*>(depths->GetScalarPointer(x, y, 0));
      Expect(isHit == std::isfinite(depth), kind.Name + ": depths are those of picks");
    }
  }
  Expect(picked > 200 && picked == seen, kind.Name + ": what is seen is picked");

  // A stopped frame leaves the picture.
  {
    const Stopper stopper(stage.Mapper, 0);
    Expect(!stage.Render(Width, Height), kind.Name + ": stopped");
  }
  vtkNew<vtkImageData> after, depthsAfter;
  Expect(stage.GetLastFrame(after, depthsAfter) && AreIdentical(shown, after) &&
      AreIdentical(depths, depthsAfter),
    kind.Name + ": a stop leaves the picture");

  // The camera rests.
  stage.Draw(Still);
  Expect(IsRoute(stage, "Refine") && stage.Mapper->GetFrameIsFinal(), kind.Name + ": refined");
  ColdWitness witness;
  Expect(stage.Render(Width, Height) && IsRoute(stage, "Redisplay") && witness.Draw(stage) &&
      witness.IsIdentical(stage),
    kind.Name + ": the cold picture");

  // An image is final in one call, edges included.
  stage.LookFrom(2.0, 1.0, 0.7);
  stage.Draw(Interactive);
  stage.Mapper->SetAntialiasingToWhenStill();
  Expect(stage.Render(Width, Height) && stage.Mapper->GetFrameIsFinal(), kind.Name + ": an image");

  const double error = ErrorOf(shown, witness.Color);
  Expect(error > 0.0 && error < 6.0, kind.Name + ": error " + std::to_string(error));
}

}

int TestFewerRays(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  for (const Kind& kind : AllKinds())
  {
    TestKind(kind);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
