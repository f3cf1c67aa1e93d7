// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hard shadows are those of brute force, at each pixel: of images, grids and meshes, in both modes,
// clipped, from near and far lights. Soft ones become the mean over the light. Translucent surfaces
// stop the share that is their opacity, and headlights cast no shadows.

#include "LitScene.h"

#include "Checks/Stopper.h"

#include "Scenes/Mistake.h"
#include "Truth/BruteForceTracer.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Grids.h"
#include "Volumes/Volumes.h"

#include <vtkAppendFilter.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace
{

using Point = std::array<double, 3>;

constexpr int Width = 64, Height = 48;

/// A white scene with diffuse light of one light.
struct SunnyScene : Scene
{
  SunnyScene(vtkDataSet* data, const std::vector<double>& isovalues)
    : Scene(data, isovalues)
  {
    vtkVolumeProperty* property = this->Volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    property->SetColor(white);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddLight(this->Light);
    this->Light->SetLightTypeToSceneLight();
    this->SetSun(0.3, -0.4, 1.0);
  }

  /// Shine from a direction, as seen from the middle of the volume.
  void SetSun(double x, double y, double z)
  {
    this->PlaceLight({ x, y, z }, 1.0);
    this->Light->PositionalOff();
  }

  /// Shine from a place in a direction, `share` of the volume's diagonal away.
  void SetLamp(double x, double y, double z, double share)
  {
    this->PlaceLight({ x, y, z }, share);
    this->Light->PositionalOn();
    this->Light->SetConeAngle(180.0);
  }

  /// The light that a pixel shows.
  int LightAt(int x, int y) const { return this->ColorAt(x, y)[0]; }

  /// From a point to a light's middle.
  BruteForceTracer::Line WayFrom(const Point& at) const
  {
    Point place, focus;
    this->Light->GetPosition(place.data());
    this->Light->GetFocalPoint(focus.data());
    BruteForceTracer::Line line;
    line.Origin = at;
    const Point& from = this->Light->GetPositional() ? at : focus;
    vtkMath::Subtract(place.data(), from.data(), line.Direction.data());
    const double length = vtkMath::Normalize(line.Direction.data());
    line.End = this->Light->GetPositional() ? length : 1e3;
    return line;
  }

  vtkNew<vtkLight> Light;

private:
  void PlaceLight(const Point& direction, double share)
  {
    double low[3], high[3];
    const double* bounds = this->Volume->GetBounds();
    for (int a = 0; a < 3; ++a)
    {
      low[a] = bounds[2 * a];
      high[a] = bounds[2 * a + 1];
    }
    const double size = std::sqrt(vtkMath::Distance2BetweenPoints(low, high));
    Point place, middle;
    for (std::size_t a = 0; a < 3; ++a)
    {
      middle[a] = 0.5 * (low[a] + high[a]);
      place[a] = middle[a] + share * size * direction[a];
    }
    this->Light->SetFocalPoint(middle.data());
    this->Light->SetPosition(place.data());
  }
};

/// True if brute force says that a way is free.
bool IsFree(const BruteForceTracer& truth, BruteForceTracer::Line way)
{
  way.Begin = 1e-3 * truth.Field.VoxelSize();
  return truth.Trace(way).Isovalue < 0;
}

/// True if a small step changes what brute force says.
bool IsGrazing(const BruteForceTracer& truth, const BruteForceTracer::Line& way)
{
  const bool isFree = IsFree(truth, way);
  for (int step = 0; step < 6; ++step)
  {
    BruteForceTracer::Line moved = way;
    const double size = (step % 2 == 0 ? 1e-3 : -1e-3) * truth.Field.VoxelSize();
    moved.Origin[static_cast<std::size_t>(step / 2)] += size;
    if (IsFree(truth, moved) != isFree)
    {
      return true;
    }
  }
  return false;
}

/// Compare the shadows of all pixels with brute force.
void ExpectHardShadows(const std::string& name, SunnyScene& scene, const BruteForceTracer& truth)
{
  scene.LookFrom(2.0, -3.0, 2.5);
  scene.Mapper->ShadowsOff();
  Expect(scene.Render(Width, Height), "rendered");
  vtkNew<vtkImageData> plain;
  plain->DeepCopy(scene.Color);
  scene.Mapper->ShadowsOn();
  Expect(scene.Render(Width, Height), "rendered");
  Expect(scene.Mapper->GetFrameIsFinal(), name + ": hard shadows are final");
  int lit = 0, dark = 0, wrong = 0, grazing = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const int before = *static_cast<unsigned char*>(plain->GetScalarPointer(x, y, 0));
      const auto exact = truth.Trace(scene.Renderer, x, y, Width, Height);
      if (before < 2 || exact.Isovalue < 0)
      {
        continue;
      }
      const BruteForceTracer::Line way = scene.WayFrom(exact.Position);
      const bool isFree = IsFree(truth, way);
      lit += isFree;
      dark += !isFree;
      if (scene.LightAt(x, y) != (isFree ? before : 0))
      {
        const bool isGrazing = IsGrazing(truth, way);
        grazing += isGrazing;
        wrong += !isGrazing;
      }
    }
  }
  const std::string said = name + ": " + std::to_string(wrong) + " wrong, " +
    std::to_string(grazing) + " grazing; " + std::to_string(lit) + " lit, " + std::to_string(dark) +
    " in shadow";
  std::cout << said << '\n';
  Expect(lit > 50 && dark > 20 && wrong == 0 && grazing < (lit + dark) / 50, said);
}

/// Shadows of lights far and near.
void ExpectShadows(const std::string& name, SunnyScene& scene, const BruteForceTracer& truth)
{
  scene.SetSun(0.3, -0.4, 1.0);
  ExpectHardShadows(name + ", sun", scene, truth);
  scene.SetLamp(0.2, -0.4, 0.7, 0.8);
  ExpectHardShadows(name + ", lamp", scene, truth);
}

vtkSmartPointer<vtkImageData> Image(int type)
{
  auto image = Volumes::FromFormula(28, type, BallAndBowl);
  image->SetSpacing(0.5, 0.4, 0.6);
  return image;
}

void TestImages()
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_DOUBLE })
  {
    const auto image = Image(type);
    SunnyScene scene(image, { 100.0 });
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 100.0 };
    ExpectShadows("type " + std::to_string(type), scene, truth);
  }
}

void TestModes()
{
  const auto image = Image(VTK_FLOAT);
  for (const bool isNearest : { false, true })
  {
    SunnyScene scene(image, { 100.0, 112.0 });
    scene.Volume->GetProperty()->SetInterpolationType(
      isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 100.0, 112.0 };
    ExpectShadows(isNearest ? "nearest" : "two isovalues", scene, truth);
    scene.Mapper->SetSurfaceModeToThreshold();
    truth.IsThreshold = true;
    ExpectShadows(isNearest ? "nearest solid" : "two solids", scene, truth);
  }
}

void TestGridsAndMeshes()
{
  const auto along = Grids::FineInside(24, 0.5);
  const auto grid = Grids::FromFormula({ along, along, along }, VTK_DOUBLE, BallAndBowl);
  SunnyScene scene(grid, { 100.0 });
  BruteForceTracer truth(grid, scene.Volume);
  truth.Isovalues = { 100.0 };
  ExpectShadows("rectilinear grid", scene, truth);

  const auto image = Image(VTK_DOUBLE);
  vtkNew<vtkAppendFilter> toMesh;
  toMesh->SetInputData(image);
  toMesh->Update();
  SunnyScene ofMesh(toMesh->GetOutput(), { 100.0 });
  BruteForceTracer ofImage(image, ofMesh.Volume);
  ofImage.Isovalues = { 100.0 };
  ExpectShadows("mesh", ofMesh, ofImage);
}

/// What is clipped away casts no shadow.
void TestClipped()
{
  const auto image = Image(VTK_FLOAT);
  SunnyScene scene(image, { 100.0 });
  scene.SetSun(0.1, 0.0, 1.0);
  scene.LookFrom(1.0, -2.0, 3.0);
  scene.Mapper->ShadowsOn();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, -1.0);
  const double* middle = scene.Volume->GetCenter();
  plane->SetOrigin(middle[0], middle[1], 0.8 * middle[2]);
  scene.Mapper->AddClippingPlane(plane);
  Expect(scene.Render(Width, Height), "rendered");
  vtkNew<vtkImageData> shadowed;
  shadowed->DeepCopy(scene.Color);
  scene.Mapper->ShadowsOff();
  Expect(scene.Render(Width, Height), "rendered");
  Expect(AreIdentical(shadowed, scene.Color), "the ball is cut away, so the bowl has no shadow");
}

/// The mean over a light of the ways that are free.
double FreeShare(const BruteForceTracer& truth, const BruteForceTracer::Line& toMiddle,
  const SunnyScene& scene, double radius, int side)
{
  Point x, y;
  vtkMath::Perpendiculars(toMiddle.Direction.data(), x.data(), y.data(), 0.0);
  const bool isLamp = scene.Light->GetPositional() != 0;
  double distance = toMiddle.End;
  if (!isLamp)
  {
    distance = std::sqrt(
      vtkMath::Distance2BetweenPoints(scene.Light->GetPosition(), scene.Light->GetFocalPoint()));
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int open = 0;
  for (int i = 0; i < side * side; ++i)
  {
    const double from = radius * std::sqrt((i % side + share(random)) / side);
    const double angle = 2.0 * vtkMath::Pi() * (i / side + share(random)) / side;
    BruteForceTracer::Line way = toMiddle;
    for (std::size_t a = 0; a < 3; ++a)
    {
      way.Direction[a] =
        distance * toMiddle.Direction[a] + from * (std::cos(angle) * x[a] + std::sin(angle) * y[a]);
    }
    const double length = vtkMath::Normalize(way.Direction.data());
    way.End = isLamp ? length : toMiddle.End;
    open += IsFree(truth, way);
  }
  return static_cast<double>(open) / (side * side);
}

void TestSoftShadows()
{
  const auto image = Image(VTK_FLOAT);
  for (const bool isLamp : { false, true })
  {
    SunnyScene scene(image, { 100.0 });
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 100.0 };
    isLamp ? scene.SetLamp(0.2, -0.4, 0.7, 0.8) : scene.SetSun(0.3, -0.4, 1.0);
    scene.LookFrom(2.0, -3.0, 2.5);
    Expect(scene.Render(Width, Height), "rendered");
    vtkNew<vtkImageData> plain;
    plain->DeepCopy(scene.Color);
    constexpr double radius = 3.0;
    scene.Mapper->ShadowsOn();
    scene.Mapper->SetLightRadius(radius);
    scene.Mapper->SetAmbientOcclusionRays(64);
    for (int frames = 0; frames < 10 && (frames == 0 || !scene.Mapper->GetFrameIsFinal()); ++frames)
    {
      Expect(scene.Render(Width, Height), "rendered");
    }
    Expect(scene.Mapper->GetFrameIsFinal(), "soft shadows become final");
    double sum = 0.0, worst = 0.0;
    int count = 0, half = 0;
    for (int y = 1; y < Height; y += 2)
    {
      for (int x = y / 2 % 2; x < Width; x += 2)
      {
        const int before = *static_cast<unsigned char*>(plain->GetScalarPointer(x, y, 0));
        const auto exact = truth.Trace(scene.Renderer, x, y, Width, Height);
        if (before > 100 && exact.Isovalue >= 0)
        {
          const double share = FreeShare(truth, scene.WayFrom(exact.Position), scene, radius, 24);
          const double error = std::abs(share - static_cast<double>(scene.LightAt(x, y)) / before);
          sum += error;
          worst = std::max(worst, error);
          half += share > 0.05 && share < 0.95;
          ++count;
        }
      }
    }
    const std::string said = std::string(isLamp ? "soft lamp" : "soft sun") + ": mean " +
      std::to_string(255.0 * sum / count) + ", worst " + std::to_string(255.0 * worst) +
      " of 255 at " + std::to_string(count) + " points, " + std::to_string(half) +
      " in half shadow";
    std::cout << said << '\n';
    Expect(count > 20 && half > 5 && sum / count < 1.5 / 255.0 && worst < 12.0 / 255.0, said);
  }
}

/// A floor below a ceiling, and the sun above both.
void TestTranslucent()
{
  const auto image = FloorBelowCeiling(41);
  for (const double opacity : { 1.0, 0.5, 0.2 })
  {
    SunnyScene scene(image, { 4.0 });
    scene.SetSun(0.2, 0.0, 1.0);
    vtkNew<vtkPiecewiseFunction> opacities;
    opacities->AddPoint(0.0, opacity);
    scene.Volume->GetProperty()->SetScalarOpacity(opacities);
    // Between floor and ceiling, looking down.
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(20.0, 20.0, 10.0);
    camera->SetFocalPoint(20.0, 20.0, 4.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.1, 20.0);
    Expect(scene.Render(Width, Height), "rendered");
    const int before = scene.LightAt(Width / 2, Height / 2);
    for (const double radius : { 0.0, 1e-3 })
    {
      scene.Mapper->ShadowsOn();
      scene.Mapper->SetLightRadius(radius);
      Expect(scene.Render(Width, Height), "rendered");
      const double shown = scene.LightAt(Width / 2, Height / 2);
      Expect(before > 40 && std::abs(shown - (1.0 - opacity) * before) < 2.0,
        "opacity " + std::to_string(opacity) + ", radius " + std::to_string(radius) + ": " +
          std::to_string(shown) + " of " + std::to_string(before));
    }
  }
}

/// Lights that cast no shadow change no byte. Each light has a shadow of its own.
void TestLights()
{
  const auto image = Image(VTK_FLOAT);
  SunnyScene scene(image, { 100.0 });
  scene.LookFrom(2.0, -3.0, 2.5);
  scene.Light->SetLightTypeToHeadlight();
  Expect(scene.Render(Width, Height), "rendered");
  vtkNew<vtkImageData> plain;
  plain->DeepCopy(scene.Color);
  scene.Mapper->ShadowsOn();
  Expect(scene.Render(Width, Height), "rendered");
  Expect(AreIdentical(plain, scene.Color), "headlights cast no shadow");

  // Two lights of half the intensity: the sum of both pictures.
  scene.Light->SetLightTypeToSceneLight();
  scene.Light->SetIntensity(0.5);
  scene.SetSun(0.3, -0.4, 1.0);
  vtkNew<vtkLight> other;
  other->SetLightTypeToSceneLight();
  other->SetIntensity(0.5);
  other->SetPosition(-40.0, 10.0, 60.0);
  other->PositionalOn();
  other->SetConeAngle(180.0);
  scene.Renderer->AddLight(other);
  vtkNew<vtkImageData> one;
  other->SwitchOff();
  Expect(scene.Render(Width, Height), "rendered");
  one->DeepCopy(scene.Color);
  vtkNew<vtkImageData> two;
  other->SwitchOn();
  scene.Light->SwitchOff();
  Expect(scene.Render(Width, Height), "rendered");
  two->DeepCopy(scene.Color);
  scene.Light->SwitchOn();
  Expect(scene.Render(Width, Height), "rendered");
  int worst = 0;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const int x = pixel % Width, y = pixel / Width;
    const int sum = *static_cast<unsigned char*>(one->GetScalarPointer(x, y, 0)) +
      *static_cast<unsigned char*>(two->GetScalarPointer(x, y, 0));
    worst = std::max(worst, std::abs(sum - scene.LightAt(x, y)));
  }
  Expect(worst <= 1, "two lights: " + std::to_string(worst));
  Expect(!AreIdentical(one, two), "their shadows differ");
}

/// New colours take the shadows of the frame before. They are those of a mapper without past,
/// whatever has changed between.
void TestKeptShadows()
{
  const auto image = Image(VTK_FLOAT);
  SunnyScene scene(image, { 100.0 });
  scene.LookFrom(2.0, -3.0, 2.5);
  scene.Mapper->ShadowsOn();
  const auto expect = [&](const char* route, const std::string& what)
  {
    Expect(scene.Render(Width, Height) && IsRoute(scene, route), what + ": " + route);
    ColdWitness witness;
    Expect(witness.Draw(scene) && witness.IsIdentical(scene), what + ": as without past");
  };
  expect("Cold", "a first frame");
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetAmbient(0.1);
  expect("Reshade", "a new colour");
  scene.SetSun(-0.5, 0.2, 1.0);
  expect("Reshade", "a moved light");
  property->SetAmbient(0.2);
  expect("Reshade", "and a new colour");
  scene.Mapper->ShadowsOff();
  scene.LookFrom(2.5, -2.0, 2.5);
  expect("Cold", "another view without shadows");
  scene.Mapper->ShadowsOn();
  expect("Reshade", "shadows again");
  scene.Renderer->TwoSidedLightingOff();
  expect("Reshade", "sides that were dark are lit");
  scene.Renderer->TwoSidedLightingOn();
  property->SetAmbient(0.3);
  {
    const Stopper stopper(scene.Mapper, 0);
    scene.SetSun(0.5, 0.5, 1.0);
    Expect(!scene.Render(Width, Height), "stopped");
  }
  scene.SetSun(-0.5, 0.2, 1.0);
  expect("Reshade", "after a stop under another light");
}

void TestSettings()
{
  Scene scene(Image(VTK_FLOAT), { 100.0 });
  vtkNew<vtkTest::ErrorObserver> errors;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  scene.Mapper->SetLightRadius(std::numeric_limits<double>::quiet_NaN());
  Expect(errors->GetError() && errors->GetErrorMessage().find("LightRadius") != std::string::npos,
    "NaN is refused by name");
  scene.Mapper->SetLightRadius(-1.0);
  Expect(scene.Mapper->GetLightRadius() == 0.0, "it is clamped");
}

}

int TestShadows(int, char*[])
{
  TestImages();
  TestModes();
  TestGridsAndMeshes();
  TestClipped();
  TestSoftShadows();
  TestTranslucent();
  TestLights();
  TestKeptShadows();
  TestSettings();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
