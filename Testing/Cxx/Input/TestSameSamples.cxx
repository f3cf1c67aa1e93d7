// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Samples of whole numbers, which often equal the isovalue, show the same surfaces as an image, as
// a rectilinear grid, and as hexahedra and voxels.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/VtkMeshes.h"

#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;
using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr int Width = 150, Height = 130;

/// An image of 10 x 8 x 9 samples, with uneven spacing or not.
Image Make(int type, bool isUneven, const std::function<int(int, int, int)>& value)
{
  Image image = Image::New();
  image->SetDimensions(10, 8, 9);
  if (isUneven)
  {
    image->SetSpacing(0.3, 0.7, 1.1);
    image->SetOrigin(-3.3, 17.1, 0.123);
  }
  image->AllocateScalars(type, 1);
  for (int i = 0; i < 10 * 8 * 9; ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, value(i % 10, i / 10 % 8, i / 80));
  }
  return image;
}

struct Volume
{
  std::string Name;
  std::function<int(int, int, int)> Value;
  double Isovalue;
};

std::vector<Volume> AllVolumes()
{
  // Of a hash, so that the value of a place does not depend on what was asked for before.
  const auto random = [](int seed, int below)
  {
    return [=](int i, int j, int k)
    {
      std::mt19937 engine(static_cast<unsigned int>(seed + i + 17 * j + 289 * k));
      engine.discard(3);
      return static_cast<int>(engine() % static_cast<unsigned int>(below));
    };
  };
  const auto blocks = [=](int i, int j, int k) { return random(5, 3)(i / 2, j / 4, k / 3); };
  return { { "labels", random(1, 4), 2.0 }, { "other labels", random(2, 4), 1.0 },
    { "two labels", random(3, 2), 1.0 }, { "blocks", blocks, 1.0 }, { "high blocks", blocks, 2.0 },
    { "plateaus", [](int i, int j, int k) { return std::min((i + j + k) / 4, 3); }, 3.0 },
    { "a slab in the middle", [](int i, int, int) { return i == 5 ? 2 : 1; }, 2.0 },
    { "a slab at the end", [](int, int j, int) { return j == 7 ? 2 : 1; }, 2.0 },
    { "a gap", [](int, int, int k) { return k == 4 ? 1 : 2; }, 2.0 },
    { "a step", [](int i, int, int) { return i > 4 ? 2 : 1; }, 2.0 },
    { "above a floor", [&](int i, int j, int k) { return 2 + (i * j * k) % 3; }, 2.0 } };
}

/// Pixels whose surfaces differ, or of which only one picture has a surface.
int CountDifferent(const Scene& a, const Scene& b, double length)
{
  int different = 0;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const double here = a.DepthAt(pixel % Width, pixel / Width);
    const double there = b.DepthAt(pixel % Width, pixel / Width);
    const bool isHit = !std::isinf(here);
    different += isHit != !std::isinf(there) || (isHit && std::abs(here - there) > 1e-5 * length);
  }
  return different;
}

void Compare(const Volume& volume, int type, int view)
{
  static const double directions[6][3] = { { 1.0, 0.5, 0.3 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 },
    { -0.3, -1.0, 0.2 }, { 0.0, 1.0, 0.0 }, { -1.0, -1.0, -1.0 } };
  const Image image = Make(type, view % 2 == 1, volume.Value);
  const std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> others = {
    { "rectilinear grid", VtkMeshes::Rectilinear(image) },
    { "curvilinear grid", VtkMeshes::Curvilinear(image) },
    { "hexahedra", VtkMeshes::Unstructured(image, VTK_HEXAHEDRON) },
    { "voxels", VtkMeshes::Unstructured(image, VTK_VOXEL) }
  };
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    Scene reference(image, { volume.Isovalue });
    reference.Mapper->SetSurfaceMode(mode);
    reference.Volume->GetProperty()->SetInterpolationTypeToLinear();
    vtkCamera* camera = reference.Renderer->GetActiveCamera();
    camera->SetParallelProjection(view % 3 != 0);
    camera->SetViewUp(0.01, view == 4 ? 0.0 : 1.0, view == 4 ? 1.0 : 0.02);
    const double* direction = directions[view];
    reference.LookFrom(direction[0], direction[1], direction[2]);
    Expect(reference.Render(Width, Height), volume.Name + ": rendered");
    for (const auto& [name, data] : others)
    {
      Scene scene(data, { volume.Isovalue });
      scene.Mapper->SetSurfaceMode(mode);
      scene.Volume->GetProperty()->SetInterpolationTypeToLinear();
      scene.Renderer->SetActiveCamera(camera);
      const std::string what = volume.Name + " as " + name + ", type " + std::to_string(type) +
        ", view " + std::to_string(view) + ", mode " + std::to_string(mode);
      Expect(scene.Render(Width, Height), what + ": rendered");
      // The contract of cold frames: a ray may touch a line of the surface.
      const int different = CountDifferent(scene, reference, image->GetLength());
      Expect(different <= Width * Height / 10000,
        what + ": " + std::to_string(different) + " pixels differ");
    }
  }
}

/// A mesh is drawn as an image is, however large it is in the world.
void TestSizes()
{
  for (const double size : { 1.0, 1e10, 1e30, 1e36, 1e37, 1e-10, 1e-30, 1e-37, 1e-40 })
  {
    for (const bool isParallel : { false, true })
    {
      const Image image = Make(
        VTK_DOUBLE, false, [](int i, int j, int k) { return 10 * i + (j - 4) * (j - 4) + k * k; });
      image->SetSpacing(size, size, size);
      Scene scene(VtkMeshes::Curvilinear(image), { 60.5 }), reference(image, { 60.5 });
      for (Scene* each : { &scene, &reference })
      {
        each->Volume->GetProperty()->SetInterpolationTypeToLinear();
        // vtkRenderer::ResetCamera does not go so far.
        vtkCamera* camera = each->Renderer->GetActiveCamera();
        camera->SetPosition(20.0 * size, 15.0 * size, 25.0 * size);
        camera->SetFocalPoint(4.5 * size, 3.5 * size, 4.0 * size);
        camera->SetParallelScale(8.0 * size);
        camera->SetParallelProjection(isParallel);
        camera->SetClippingRange(size, 100.0 * size);
        Expect(each->Render(Width, Height), "sizes: rendered");
      }
      int hits = 0;
      for (int pixel = 0; pixel < Width * Height; ++pixel)
      {
        hits += !std::isinf(reference.DepthAt(pixel % Width, pixel / Width));
      }
      const std::string what = "size " + std::to_string(std::log10(size));
      Expect(hits > 1000, what + ": nothing is seen");
      Expect(CountDifferent(scene, reference, 17.0 * size) <= 1, what + ": the mesh differs");
    }
  }
}

}

int TestSameSamples(int, char*[])
{
  TestSizes();
  for (const Volume& volume : AllVolumes())
  {
    for (int view = 0; view < 6; ++view)
    {
      Compare(volume, view < 3 ? VTK_UNSIGNED_CHAR : VTK_DOUBLE, view);
    }
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
