// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The final light of ambient occlusion is the integral over the hemisphere, by brute force: for
// images, grids and meshes, in both modes, clipped, with any transform. What closed forms tell is
// met, also for translucent surfaces. Settings out of range are refused.

#include "LitScene.h"

#include "Scenes/Mistake.h"
#include "Truth/BruteForceTracer.h"
#include "Volumes/Grids.h"
#include "Volumes/Volumes.h"

#include <vtkAppendFilter.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace
{

using Point = std::array<double, 3>;

constexpr int Width = 48, Height = 36;

/// The unit normal of a pixel's hit.
Point NormalAt(vtkImageData* frame, int x, int y)
{
  Point normal;
  vtkDataArray* normals = frame->GetPointData()->GetArray("Normals");
  normals->GetTuple(x + static_cast<vtkIdType>(y) * Width, normal.data());
  return normal;
}

/// The share of directions around a normal, weighted by cosines, in which nothing is hit.
double OpenShare(
  const BruteForceTracer& truth, const Point& at, const Point& normal, double radius, int side)
{
  Point tangent, other;
  vtkMath::Perpendiculars(normal.data(), tangent.data(), other.data(), 0.0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int open = 0;
  for (int i = 0; i < side * side; ++i)
  {
    const double square = (i % side + share(random)) / side;
    const double angle = 2.0 * vtkMath::Pi() * (i / side + share(random)) / side;
    BruteForceTracer::Line line;
    line.Origin = at;
    for (std::size_t a = 0; a < 3; ++a)
    {
      line.Direction[a] =
        std::sqrt(square) * (std::cos(angle) * tangent[a] + std::sin(angle) * other[a]) +
        std::sqrt(1.0 - square) * normal[a];
    }
    line.Begin = 1e-3 * truth.Field.VoxelSize();
    line.End = radius;
    open += truth.Trace(line).Isovalue < 0;
  }
  return static_cast<double>(open) / (side * side);
}

/// Compare the final light of some pixels with brute force.
void ExpectTruth(
  const std::string& name, LitScene& scene, const BruteForceTracer& truth, double radius)
{
  scene.Mapper->SetAmbientOcclusionRadius(radius);
  scene.LookFrom(2.0, -3.0, 2.5);
  scene.RenderFinal(Width, Height);
  vtkNew<vtkImageData> frame;
  scene.Mapper->GetLastFrame(frame);
  double sum = 0.0, worst = 0.0;
  int count = 0;
  for (int y = 1; y < Height; y += 2)
  {
    for (int x = (y / 2) % 2; x < Width; x += 2)
    {
      if (!scene.IsHitAt(x, y))
      {
        continue;
      }
      const auto line = BruteForceTracer::LineThrough(scene.Renderer, x, y, Width, Height);
      const Point at = line.PointAt(static_cast<double>(scene.DepthAt(x, y)));
      const auto exact = truth.Trace(line);
      if (exact.Isovalue < 0)
      {
        continue;
      }
      const double open = OpenShare(truth, exact.Position, NormalAt(frame, x, y), radius, 24);
      const double error = std::abs(open - scene.OpenAt(x, y));
      sum += error;
      worst = std::max(worst, error);
      ++count;
    }
  }
  const std::string said = name + ": mean " + std::to_string(255.0 * sum / count) + ", worst " +
    std::to_string(255.0 * worst) + " of 255 at " + std::to_string(count) + " points";
  std::cout << said << '\n';
  Expect(count > 20, said + ": too few points");
  // Brute force itself is a sum of 576 rays.
  Expect(sum / count < 1.5 / 255.0 && worst < 12.0 / 255.0, said);
}

vtkSmartPointer<vtkImageData> Image(int type)
{
  auto image = Volumes::FromFormula(28, type, BallAndBowl);
  image->SetSpacing(0.5, 0.4, 0.6);
  return image;
}

void TestImages()
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    const auto image = Image(type);
    LitScene scene(image, { 100.0 });
    scene.Volume->SetOrientation(20.0, 30.0, 40.0);
    scene.Volume->SetScale(1.0, 2.0, 1.5);
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 100.0 };
    ExpectTruth("type " + std::to_string(type), scene, truth, 6.0);
  }
}

void TestModes()
{
  const auto image = Image(VTK_FLOAT);
  for (const bool isNearest : { false, true })
  {
    LitScene scene(image, { 100.0, 112.0 });
    scene.Volume->GetProperty()->SetInterpolationType(
      isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 100.0, 112.0 };
    ExpectTruth(isNearest ? "nearest" : "two isovalues", scene, truth, 3.0);
    scene.Mapper->SetSurfaceModeToThreshold();
    truth.IsThreshold = true;
    ExpectTruth(isNearest ? "nearest solid" : "two solids", scene, truth, 3.0);
  }
}

void TestGrids()
{
  const auto along = Grids::FineInside(24, 0.5);
  const auto grid = Grids::FromFormula({ along, along, along }, VTK_DOUBLE, BallAndBowl);
  LitScene scene(grid, { 100.0 });
  BruteForceTracer truth(grid, scene.Volume);
  truth.Isovalues = { 100.0 };
  ExpectTruth("rectilinear grid", scene, truth, 0.5);
}

/// Voxels as a mesh show the light of the image.
void TestMeshes()
{
  const auto image = Image(VTK_DOUBLE);
  vtkNew<vtkAppendFilter> toMesh;
  toMesh->SetInputData(image);
  toMesh->Update();
  LitScene scene(toMesh->GetOutput(), { 100.0 });
  scene.Mapper->SmoothMeshNormalsOn();
  BruteForceTracer truth(image, scene.Volume);
  truth.Isovalues = { 100.0 };
  ExpectTruth("mesh", scene, truth, 3.0);
}

/// Nothing keeps light away from a convex surface, also where it is cut.
void TestConvex()
{
  const auto image = Volumes::FromFormula(
    24, VTK_FLOAT, [](double x, double y, double z) { return 1.0 - std::hypot(x, y, z); });
  LitScene scene(image, { 0.3 });
  scene.Mapper->SetSurfaceModeToThreshold();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-1.0, 1.0, -0.5);
  plane->SetOrigin(0.1, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  scene.LookFrom(2.0, -3.0, 2.5);
  scene.RenderFinal(Width, Height);
  int hits = 0, dark = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      hits += scene.IsHitAt(x, y);
      dark += scene.IsHitAt(x, y) && scene.ColorAt(x, y)[0] < 253;
    }
  }
  Expect(hits > 100 && dark == 0, std::to_string(dark) + " dark of " + std::to_string(hits));
}

/// A floor below a ceiling of the same height everywhere: the directions within an angle reach the
/// ceiling before light ends.
void TestCeiling()
{
  constexpr double height = 8.0, radius = 10.0;
  const auto image = FloorBelowCeiling(81);
  for (const double opacity : { 1.0, 0.5, 0.1 })
  {
    LitScene scene(image, { height / 2.0 });
    vtkNew<vtkPiecewiseFunction> opacities;
    opacities->AddPoint(0.0, opacity);
    scene.Volume->GetProperty()->SetScalarOpacity(opacities);
    scene.Mapper->SetAmbientOcclusionRadius(radius);
    // Between floor and ceiling, looking down.
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(40.0, 40.0, 10.0);
    camera->SetFocalPoint(40.0, 40.0, 4.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.1, 20.0);
    scene.RenderFinal(Width, Height);
    const double stopped = opacity * (1.0 - std::pow(height / radius, 2));
    const double alpha = scene.ColorAt(Width / 2, Height / 2)[3] / 255.0;
    double worst = 0.0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        worst = std::max(worst, std::abs(scene.OpenAt(x, y) - alpha * (1.0 - stopped)));
      }
    }
    Expect(std::abs(alpha - opacity) < 0.01 && worst < 3.0 / 255.0,
      "opacity " + std::to_string(opacity) + ": " + std::to_string(255.0 * worst) + " of 255");
    scene.Mapper->SetAmbientOcclusionStrength(0.25);
    scene.Render(Width, Height);
    const double weaker = scene.OpenAt(Width / 2, Height / 2);
    Expect(std::abs(weaker - alpha * (1.0 - 0.25 * stopped)) < 3.0 / 255.0, "a quarter of it");
  }
}

/// Diffuse light is dimmed as well, specular light is not; without shading nothing is.
void TestTerms()
{
  const auto image = Image(VTK_FLOAT);
  LitScene scene(image, { 100.0 });
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  scene.LookFrom(0.0, 0.0, 1.0);
  property->SetAmbient(0.0);
  property->SetSpecular(1.0);
  property->SetSpecularPower(1.0);
  scene.RenderFinal(Width, Height);
  vtkNew<vtkImageData> shiny;
  shiny->DeepCopy(scene.Color);
  scene.Mapper->AmbientOcclusionOff();
  scene.Render(Width, Height);
  Expect(AreIdentical(shiny, scene.Color), "specular light is not dimmed");
  property->SetSpecular(0.0);
  property->SetDiffuse(1.0);
  scene.Render(Width, Height);
  vtkNew<vtkImageData> plain;
  plain->DeepCopy(scene.Color);
  scene.Mapper->AmbientOcclusionOn();
  scene.RenderFinal(Width, Height);
  int darker = 0, brighter = 0;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const int x = pixel % Width, y = pixel / Width;
    const int before = *static_cast<unsigned char*>(plain->GetScalarPointer(x, y, 0));
    darker += scene.ColorAt(x, y)[0] < before;
    brighter += scene.ColorAt(x, y)[0] > before;
  }
  Expect(darker > 100 && brighter == 0, "diffuse light is dimmed");
  property->ShadeOff();
  scene.Render(Width, Height);
  Expect(scene.Mapper->GetFrameIsFinal(), "plain colours need no light");
  vtkNew<vtkImageData> unlit;
  unlit->DeepCopy(scene.Color);
  scene.Mapper->AmbientOcclusionOff();
  scene.Render(Width, Height);
  Expect(AreIdentical(unlit, scene.Color), "plain colours stay");
}

void TestSettings()
{
  Scene scene(Image(VTK_FLOAT), { 100.0 });
  vtkNew<vtkTest::ErrorObserver> errors;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkTemporalCoherenceVolumeMapper* mapper = scene.Mapper;
  const auto expectRefused = [&](const std::string& name, const std::function<void(double)>& set)
  {
    errors->Clear();
    set(std::numeric_limits<double>::quiet_NaN());
    Expect(errors->GetError() && errors->GetErrorMessage().find(name) != std::string::npos,
      name + " is refused by name: " + errors->GetErrorMessage());
  };
  expectRefused(
    "AmbientOcclusionRadius", [=](double to) { mapper->SetAmbientOcclusionRadius(to); });
  expectRefused(
    "AmbientOcclusionStrength", [=](double to) { mapper->SetAmbientOcclusionStrength(to); });
  Expect(mapper->GetAmbientOcclusionRadius() == 0.0 && mapper->GetAmbientOcclusionStrength() == 1.0,
    "they keep their values");
  mapper->SetAmbientOcclusionRadius(-1.0);
  mapper->SetAmbientOcclusionStrength(1.5);
  Expect(mapper->GetAmbientOcclusionRadius() == 0.0 && mapper->GetAmbientOcclusionStrength() == 1.0,
    "they are clamped");
  mapper->SetAmbientOcclusionRays(1000);
  Expect(mapper->GetAmbientOcclusionRays() == 64, "at most 64 rays");
}

}

int TestAmbientOcclusion(int, char*[])
{
  TestImages();
  TestModes();
  TestGrids();
  TestMeshes();
  TestConvex();
  TestCeiling();
  TestTerms();
  TestSettings();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
