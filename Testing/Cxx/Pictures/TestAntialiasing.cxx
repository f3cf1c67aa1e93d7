// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Antialiased pictures come near those with 64 rays a pixel, for all that can be drawn. Alpha is
// the share of a pixel that is covered. Depths, normals and isovalues stay those of the pixel's
// centre.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

constexpr int Width = 100, Height = 76;
constexpr int Finer = 8; ///< rays of the truth along each axis of a pixel

using Mapper = vtkTemporalCoherenceVolumeMapper;

struct Kind
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
  std::vector<double> Isovalues;
  std::function<void(Scene& scene)> Prepare = [](Scene&) {};
  double Worst = 1.0 / 3.0; ///< the worst error, by that of one ray
};

vtkSmartPointer<vtkImageData> Rocks()
{
  return Volumes::FromFormula(40, VTK_SHORT,
    [](double x, double y, double z)
    {
      return 1000.0 +
        400.0 * (std::sin(7.0 * x) + std::sin(6.0 * y + 1.0) + std::sin(8.0 * z + x)) -
        600.0 * std::hypot(x, y, z);
    });
}

void SetOpacity(Scene& scene, double opacity)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, opacity);
  scene.Volume->GetProperty()->SetScalarOpacity(function);
}

void Clip(Scene& scene)
{
  scene.Mapper->SetSurfaceModeToThreshold();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.05, 0.0);
  plane->SetNormal(-1.0, -0.4, 0.3);
  scene.Mapper->AddClippingPlane(plane);
}

void Blend(Scene& scene, int mode)
{
  scene.Mapper->SetBlendMode(mode);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(895.0, 0.0);
  opacity->AddPoint(905.0, 0.9);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(0.05);
}

std::vector<Kind> AllKinds()
{
  const auto rocks = Rocks();
  return {
    { "rocks", rocks, { 900.0 } },
    { "waves", Volumes::Waves(), { 200.0, -300.0 } },
    { "nearest", rocks, { 900.0 },
      [](Scene& scene) { scene.Volume->GetProperty()->SetInterpolationTypeToNearest(); }, 0.5 },
    { "parallel view", rocks, { 900.0 },
      [](Scene& scene)
      {
        scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
        scene.Renderer->ResetCamera();
      } },
    { "THRESHOLD, clipped", rocks, { 900.0 }, Clip },
    { "two pieces of a ray", rocks, { 900.0 },
      [](Scene& scene)
      {
        scene.Mapper->CroppingOn();
        scene.Mapper->SetCroppingRegionFlagsToFence();
        scene.Mapper->SetCroppingRegionPlanes(-0.4, 0.3, -0.4, 0.4, -0.5, 0.2);
      } },
    { "layers", rocks, { 700.0, 1100.0 }, [](Scene& scene) { SetOpacity(scene, 0.5); } },
    { "grid", VtkMeshes::Rectilinear(rocks), { 900.0 } },
    { "mesh", VtkMeshes::Unstructured(rocks, VTK_TETRA), { 900.0 } },
    { "layers of a mesh", VtkMeshes::Unstructured(rocks, VTK_HEXAHEDRON), { 700.0, 1100.0 },
      [](Scene& scene) { SetOpacity(scene, 0.5); } },
    { "composite", rocks, {},
      [](Scene& scene) { Blend(scene, vtkVolumeMapper::COMPOSITE_BLEND); } },
    { "maximum", rocks, {},
      [](Scene& scene) { Blend(scene, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND); }, 0.7 },
  };
}

struct PixelScene : Scene
{
  explicit PixelScene(const Kind& kind)
    : Scene(kind.Data, kind.Isovalues)
  {
    this->Mapper->SetAntialiasingToWhenStill();
    this->LookFrom(1.0, -2.0, 0.7);
    this->Renderer->GetActiveCamera()->Zoom(1.3);
    kind.Prepare(*this);
    this->Renderer->ResetCameraClippingRange(this->Mapper->GetBounds());
  }

  vtkSmartPointer<vtkImageData> Make(int antialiasing, int finer = 1)
  {
    this->Mapper->SetAntialiasing(antialiasing);
    const auto made = vtkSmartPointer<vtkImageData>::New();
    Expect(
      this->Mapper->MakeImage(this->Renderer, this->Volume, finer * Width, finer * Height, made),
      "rendered");
    return made;
  }
};

const unsigned char* ColorAt(vtkImageData* image, int x, int y)
{
  int size[3];
  image->GetDimensions(size);
  auto* colors = image->GetPointData()->GetArray("Color");
  return static_cast<unsigned char*>(colors->GetVoidPointer(0)) + 4 * (y * size[0] + x);
}

/// The mean colours of the pixels of a finer picture, rounded.
std::vector<std::array<int, 4>> MeansOf(vtkImageData* fine)
{
  std::vector<std::array<int, 4>> means;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    std::array<int, 4> sum{};
    for (int ray = 0; ray < Finer * Finer; ++ray)
    {
      const unsigned char* color =
        ColorAt(fine, pixel % Width * Finer + ray % Finer, pixel / Width * Finer + ray / Finer);
      for (std::size_t c = 0; c < 4; ++c)
      {
        sum[c] += color[c];
      }
    }
    for (int& c : sum)
    {
      c = (2 * c + Finer * Finer) / (2 * Finer * Finer);
    }
    means.push_back(sum);
  }
  return means;
}

struct Errors
{
  double Mean = 0.0;
  int Worst = 0;
};

Errors ErrorsOf(vtkImageData* image, const std::vector<std::array<int, 4>>& truth)
{
  Errors errors;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const unsigned char* color = ColorAt(image, pixel % Width, pixel / Width);
    for (std::size_t c = 0; c < 4; ++c)
    {
      const int error = std::abs(color[c] - truth[static_cast<std::size_t>(pixel)][c]);
      errors.Mean += error / (4.0 * Width * Height);
      errors.Worst = std::max(errors.Worst, error);
    }
  }
  return errors;
}

bool HasSame(vtkImageData* a, vtkImageData* b, const char* array)
{
  vtkNew<vtkImageData> one, other;
  one->SetDimensions(a->GetDimensions());
  other->SetDimensions(b->GetDimensions());
  one->GetPointData()->SetScalars(a->GetPointData()->GetArray(array));
  other->GetPointData()->SetScalars(b->GetPointData()->GetArray(array));
  return AreIdentical(one, other);
}

void TestErrors(const Kind& kind)
{
  PixelScene scene(kind);
  const auto plain = scene.Make(Mapper::ANTIALIASING_OFF);
  const auto smooth = scene.Make(Mapper::ANTIALIASING_WHEN_STILL);
  const auto truth = MeansOf(scene.Make(Mapper::ANTIALIASING_OFF, Finer));
  const Errors before = ErrorsOf(plain, truth), after = ErrorsOf(smooth, truth);
  const auto text = [](const Errors& errors)
  { return std::to_string(errors.Mean) + ", worst " + std::to_string(errors.Worst); };
  std::cout << kind.Name << ": " << text(before) << " -> " << text(after) << '\n';
  Expect(before.Mean > 0.5, kind.Name + ": there are edges");
  Expect(after.Mean <= 0.26 * before.Mean, kind.Name + ": mean error " + text(after));
  Expect(after.Worst <= kind.Worst * before.Worst, kind.Name + ": worst error " + text(after));
  for (const char* array : { "Depth", "Normals", "IsovalueIndex" })
  {
    Expect(HasSame(plain, smooth, array), kind.Name + ": " + array + " stay");
  }
}

/// The share of pixel (x, y) within a circle.
double ShareOf(int x, int y, double centreX, double centreY, double radius)
{
  constexpr int Grid = 32;
  int inside = 0;
  for (int i = 0; i < Grid * Grid; ++i)
  {
    inside += std::hypot(x + (i % Grid + 0.5) / Grid - centreX,
                y + (i / Grid + 0.5) / Grid - centreY) < radius;
  }
  return static_cast<double>(inside) / (Grid * Grid);
}

void TestCoverageOfASphere()
{
  const double radius = 0.7;
  Scene scene(Volumes::FromFormula(
                65, VTK_DOUBLE, [](double x, double y, double z) { return -std::hypot(x, y, z); }),
    { -radius });
  scene.Mapper->SetAntialiasingToWhenStill();
  scene.LookFrom(0.0, 0.0, 5.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  constexpr int size = 90;
  Expect(scene.Render(size, size), "sphere");
  double error = 0.0, worst = 0.0;
  int edges = 0;
  for (int pixel = 0; pixel < size * size; ++pixel)
  {
    const int x = pixel % size, y = pixel / size;
    const double share = ShareOf(x, y, 0.5 * size, 0.5 * size, 0.5 * size * radius);
    const double alpha = scene.ColorAt(x, y)[3] / 255.0;
    if (share > 0.0 && share < 1.0)
    {
      ++edges;
      error += std::abs(alpha - share);
      worst = std::max(worst, std::abs(alpha - share));
    }
    else
    {
      Expect(alpha == share, "a pixel beside the edge is whole or empty");
    }
  }
  Expect(edges > 100, "the edge of the sphere");
  Expect(error / edges < 0.045, "mean error of coverage: " + std::to_string(error / edges));
  Expect(worst < 0.19, "worst error of coverage: " + std::to_string(worst));
}

}

int TestAntialiasing(int, char*[])
{
  for (const Kind& kind : AllKinds())
  {
    TestErrors(kind);
  }
  TestCoverageOfASphere();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
