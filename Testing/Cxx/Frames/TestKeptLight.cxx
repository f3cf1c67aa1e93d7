// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The light of surfaces is kept while the camera moves, and gets better from frame to frame. It is
// forgotten when surfaces change. Frames are the same for any number of threads. Switched off, it
// leaves no trace.

#include "LitScene.h"

#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

constexpr int Width = 160, Height = 120;

vtkSmartPointer<vtkImageData> Rocks()
{
  return Volumes::FromFormula(48, VTK_FLOAT,
    [](double x, double y, double z)
    {
      return 100.0 + 40.0 * (std::sin(7.0 * x) + std::sin(6.0 * y + 1.0) + std::sin(8.0 * z + x)) -
        60.0 * std::hypot(x, y, z);
    });
}

struct TurningScene : LitScene
{
  explicit TurningScene(vtkDataSet* data = Rocks())
    : LitScene(data, { 90.0 })
  {
    this->LookFrom(2.0, -3.0, 1.5);
    this->Renderer->GetActiveCamera()->Zoom(1.5);
  }

  /// Move by some degrees, and render.
  void Turn(double degrees)
  {
    this->Renderer->GetActiveCamera()->Azimuth(degrees);
    Expect(this->Render(Width, Height), "rendered");
  }
};

vtkSmartPointer<vtkImageData> CopyOf(vtkImageData* image)
{
  const auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image);
  return copy;
}

/// The mean difference of two pictures where both hit something, in steps of a byte.
double MeanError(vtkImageData* one, vtkImageData* other)
{
  double sum = 0.0;
  int count = 0;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const int x = pixel % Width, y = pixel / Width;
    const auto* a = static_cast<unsigned char*>(one->GetScalarPointer(x, y, 0));
    const auto* b = static_cast<unsigned char*>(other->GetScalarPointer(x, y, 0));
    if (a[3] != 0 && b[3] != 0)
    {
      sum += std::abs(a[0] - b[0]);
      ++count;
    }
  }
  Expect(count > Width * Height / 10, "there is something to see");
  return sum / count;
}

/// The converged picture of a scene's view.
vtkSmartPointer<vtkImageData> TruthOf(TurningScene& scene)
{
  TurningScene other(static_cast<vtkImageData*>(scene.Mapper->GetInput()));
  other.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  other.RenderFinal(Width, Height);
  return CopyOf(other.Color);
}

/// A picture of a scene's view without a past.
vtkSmartPointer<vtkImageData> FreshOf(TurningScene& scene)
{
  TurningScene other(static_cast<vtkImageData*>(scene.Mapper->GetInput()));
  other.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  other.Render(Width, Height);
  return CopyOf(other.Color);
}

void TestTurning()
{
  TurningScene scene;
  const auto errorNow = [&] { return MeanError(scene.Color, TruthOf(scene)); };
  scene.Turn(0.0);
  const double first = errorNow();
  for (int frame = 0; frame < 10; ++frame)
  {
    scene.Turn(1.0);
  }
  const double afterTen = errorNow();
  const double fresh = MeanError(FreshOf(scene), TruthOf(scene));
  for (int frame = 0; frame < 50; ++frame)
  {
    scene.Turn(1.0);
  }
  const double afterSixty = errorNow();
  scene.Turn(-60.0);
  const double back = errorNow();
  const std::string said = "errors: first " + std::to_string(first) + ", fresh " +
    std::to_string(fresh) + ", after 10 frames " + std::to_string(afterTen) + ", after 60 " +
    std::to_string(afterSixty) + ", back again " + std::to_string(back);
  std::cout << said << '\n';
  Expect(afterTen < 0.6 * fresh && afterSixty < 1.05 * afterTen && back < afterTen, said);
}

/// Near, far and from one side to the other.
void TestOtherViews()
{
  TurningScene scene;
  for (int frame = 0; frame < 16; ++frame)
  {
    scene.Turn(1.0);
  }
  for (const double zoom : { 1.7, 0.35 })
  {
    scene.Renderer->GetActiveCamera()->Zoom(zoom);
    scene.Turn(0.0);
    const auto truth = TruthOf(scene);
    const double kept = MeanError(scene.Color, truth), fresh = MeanError(FreshOf(scene), truth);
    const std::string said = "zoom by " + std::to_string(zoom) + ": " + std::to_string(kept) +
      " instead of " + std::to_string(fresh);
    std::cout << said << '\n';
    Expect(kept < fresh, said);
  }
}

/// All viewers of the data share its light: another camera at the same place, as in screenshots.
void TestOtherCameras()
{
  TurningScene scene;
  for (int frame = 0; frame < 16; ++frame)
  {
    vtkNew<vtkCamera> camera;
    camera->DeepCopy(scene.Renderer->GetActiveCamera());
    scene.Renderer->SetActiveCamera(camera);
    scene.Turn(0.0);
  }
  const auto truth = TruthOf(scene);
  const double kept = MeanError(scene.Color, truth), fresh = MeanError(FreshOf(scene), truth);
  Expect(kept < 0.6 * fresh,
    "other cameras: " + std::to_string(kept) + " instead of " + std::to_string(fresh));
}

/// In a still view the error falls from frame to frame, until the light is final.
void TestStill()
{
  TurningScene scene;
  const auto truth = TruthOf(scene);
  double last = 255.0;
  int frames = 0;
  do
  {
    scene.Turn(0.0);
    const double error = MeanError(scene.Color, truth);
    Expect(error < 1.05 * last + 0.05,
      "frame " + std::to_string(frames) + ": " + std::to_string(error) + " after " +
        std::to_string(last));
    last = error;
  } while (!scene.Mapper->GetFrameIsFinal() && ++frames < 100);
  std::cout << "still: " << last << " after " << frames << " frames\n";
  Expect(scene.Mapper->GetFrameIsFinal() && frames <= 36 && last < 0.5, "it is final");
  const auto done = CopyOf(scene.Color);
  scene.Turn(0.0);
  Expect(AreIdentical(done, scene.Color), "then it stays");
}

/// What surfaces see of each other changes with them: nothing of the past remains.
void TestForgetting()
{
  TurningScene scene;
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, -1.0);
  plane->SetOrigin(0.0, 0.0, 0.2);
  vtkNew<vtkPiecewiseFunction> half;
  half->AddPoint(0.0, 0.5);
  const std::vector<std::pair<std::string, std::function<void()>>> changes = {
    { "isovalue", [&] { scene.SetIsovalues({ 80.0 }); } },
    { "region", [&] { scene.Mapper->AddClippingPlane(plane); } },
    { "mode", [&] { scene.Mapper->SetSurfaceModeToThreshold(); } },
    { "radius", [&] { scene.Mapper->SetAmbientOcclusionRadius(0.3); } },
    { "opacity", [&] { property->SetScalarOpacity(half); } },
    { "samples",
      [&]
      {
        auto* image = static_cast<vtkImageData*>(scene.Mapper->GetInput());
        *static_cast<float*>(image->GetScalarPointer(24, 24, 24)) += 100.0f;
        image->GetPointData()->GetScalars()->Modified();
      } }
  };
  for (const auto& [name, change] : changes)
  {
    scene.Turn(0.0);
    scene.Turn(1.0);
    change();
    scene.Turn(0.0);
    const auto kept = CopyOf(scene.Color);
    scene.Mapper->ClearCache();
    scene.Turn(0.0);
    Expect(AreIdentical(kept, scene.Color), name + ": as without a past");
  }
}

/// Where a time step changes a surface, others that it changes nothing of may get less light.
void TestTimeStep()
{
  TurningScene scene;
  scene.Turn(0.0);
  auto* image = static_cast<vtkImageData*>(scene.Mapper->GetInput());
  for (const int at : { 20, 28, 24 }) // from the second one on, tiles could be copied
  {
    *static_cast<float*>(image->GetScalarPointer(at, 24, 40)) += 100.0f;
    image->GetPointData()->GetScalars()->Modified();
    scene.Turn(0.0);
    Expect(AreIdentical(scene.Color, FreshOf(scene)), "time step " + std::to_string(at));
  }
}

/// Colours, light and material do not change what is known of the surroundings.
void TestKeeping()
{
  TurningScene scene;
  for (int frame = 0; frame < 16; ++frame)
  {
    scene.Turn(1.0);
  }
  vtkNew<vtkColorTransferFunction> grey;
  grey->AddRGBPoint(0.0, 0.5, 0.5, 0.5);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  const auto truth = TruthOf(scene);
  const double before = MeanError(scene.Color, truth);
  scene.Volume->GetProperty()->SetColor(grey);
  scene.Turn(0.0);
  scene.Volume->GetProperty()->SetColor(white);
  scene.Turn(0.0);
  Expect(MeanError(scene.Color, truth) < before, "new colours go on summing up");
}

/// The bytes of a walk through views, for a number of threads.
std::vector<vtkSmartPointer<vtkImageData>> WalkWith(int threads, bool isTranslucent)
{
  vtkSMPTools::Initialize(threads);
  TurningScene scene;
  if (isTranslucent)
  {
    vtkNew<vtkPiecewiseFunction> half;
    half->AddPoint(0.0, 0.4);
    scene.Volume->GetProperty()->SetScalarOpacity(half);
  }
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const double degrees : { 0.0, 3.0, 0.0, -1.0, 0.0 })
  {
    scene.Turn(degrees);
    pictures.push_back(CopyOf(scene.Color));
  }
  return pictures;
}

void TestThreads()
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  for (const bool isTranslucent : { false, true })
  {
    const auto one = WalkWith(1, isTranslucent), seven = WalkWith(7, isTranslucent);
    for (std::size_t i = 0; i < one.size(); ++i)
    {
      Expect(AreIdentical(one[i], seven[i]), "frame " + std::to_string(i) + " for any threads");
    }
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

void TestOff()
{
  TurningScene lit, plain;
  plain.Mapper->AmbientOcclusionOff();
  plain.Turn(0.0);
  lit.Turn(0.0);
  Expect(!AreIdentical(lit.Color, plain.Color) && AreIdentical(lit.Depth, plain.Depth),
    "light changes colours only");
  lit.Mapper->AmbientOcclusionOff();
  for (const double degrees : { 0.0, 2.0 })
  {
    lit.Turn(degrees);
    plain.Turn(degrees);
    Expect(lit.Mapper->GetFrameIsFinal() && AreIdentical(lit.Color, plain.Color),
      "switched off, it leaves no trace");
  }
}

}

int TestKeptLight(int, char*[])
{
  TestTurning();
  TestOtherViews();
  TestOtherCameras();
  TestStill();
  TestForgetting();
  TestTimeStep();
  TestKeeping();
  TestThreads();
  TestOff();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
