// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In grids of small whole values, as noise and label maps have them, seen along their axes, no hit
// is invented and none is missed.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"
#include "Volumes/VtkMeshes.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

constexpr int Samples = 10;
/// Pixels are quarters of a cell, on its border and inside.
constexpr int Size = 4 * (Samples - 1) + 1;

/// Values and distances that are closer together are the same, as far as rounding errors tell.
constexpr double Near = 1e-5;

Image WholeValues(const std::function<int(int, int, int)>& valueAt, double spacing)
{
  const Image image = Image::New();
  image->SetDimensions(Samples, Samples, Samples);
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < Samples * Samples * Samples; ++i)
  {
    values->InsertNextValue(valueAt(i % Samples, i / Samples % Samples, i / Samples / Samples));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

Image Noise(unsigned int seed, int most, double spacing)
{
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> whole(-most, most);
  return WholeValues([&](int, int, int) { return whole(engine); }, spacing);
}

/// Balls within each other, and a box.
Image Labels(double spacing)
{
  return WholeValues(
    [](int i, int j, int k)
    {
      const double distance = std::hypot(i - 4.5, j - 4.0, k - 5.0);
      const bool isInBox = std::max({ i, j, k }) < 4;
      return isInBox ? 3 : distance < 2.5 ? 2 : distance < 4.0 ? 1 : 0;
    },
    spacing);
}

void LookAlong(Scene& scene, int axis, bool isBackwards, double spacing)
{
  std::array<double, 3> from{};
  from[static_cast<std::size_t>(axis)] = isBackwards ? -1.0 : 1.0;
  scene.LookFrom(from[0], from[1], from[2]);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  // The outermost pixels look along the faces.
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.5 * Size * spacing / 4.0);
}

/// Each hit is a place where the field has the isovalue, and no surface is nearer but where it only
/// touches the ray, so that rounding errors decide.
void ExpectTrueHits(const std::string& name, Scene& scene, BruteForceTracer truth)
{
  if (!scene.Render(Size, Size))
  {
    Expect(false, name + ": not rendered");
    return;
  }
  const double isovalue = truth.Isovalues[0];
  int hits = 0, invented = 0, missed = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const int x = pixel % Size, y = pixel / Size;
    std::array<double, 3> position;
    const bool isHit = scene.Mapper->PickPixel(x, y, position.data(), nullptr, nullptr);
    const double depth =
      isHit ? static_cast<double>(scene.DepthAt(x, y)) : std::numeric_limits<double>::infinity();
    hits += isHit;
    if (isHit)
    {
      const double difference = truth.Field.DifferenceAt(truth.Field.IndexOf(position), isovalue);
      invented += truth.IsThreshold ? difference < -Near : std::abs(difference) > Near;
    }
    bool isNearer = std::min(x, y) > 0 && std::max(x, y) < Size - 1;
    for (const double off : { -Near, 0.0, Near })
    {
      truth.Isovalues = { isovalue + off };
      const auto expected = truth.Trace(scene.Renderer, x, y, Size, Size);
      isNearer = isNearer && expected.Isovalue >= 0 && expected.Distance * (1.0 + Near) < depth;
    }
    missed += isNearer;
  }
  Expect(hits > Size * Size / 20, name + ": only " + std::to_string(hits) + " hits");
  Expect(invented + missed == 0,
    name + ": " + std::to_string(invented) + " hits without a surface, " + std::to_string(missed) +
      " surfaces missed");
}

void TestImage(const std::string& name, vtkImageData* image, double isovalue, double spacing)
{
  const std::array<std::pair<const char*, vtkSmartPointer<vtkDataSet>>, 3> grids = { {
    { "voxels", VtkMeshes::Unstructured(image, VTK_VOXEL) },
    { "hexahedra", VtkMeshes::Unstructured(image, VTK_HEXAHEDRON) },
    { "curvilinear grid", VtkMeshes::Curvilinear(image) },
  } };
  for (const auto& [kind, grid] : grids)
  {
    Scene scene(grid, { isovalue });
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { isovalue };
    for (int view = 0; view < 12; ++view)
    {
      truth.IsThreshold = view >= 6;
      scene.Mapper->SetSurfaceMode(truth.IsThreshold ? vtkTemporalCoherenceVolumeMapper::THRESHOLD
                                                     : vtkTemporalCoherenceVolumeMapper::CROSSING);
      LookAlong(scene, view % 3, view / 3 % 2 == 1, spacing);
      ExpectTrueHits(name + ", " + kind + ", view " + std::to_string(view), scene, truth);
    }
  }
}

}

int TestWholeGrids(int, char*[])
{
  for (const double spacing : { 1.0, 0.1 })
  {
    for (unsigned int seed = 1; seed <= 3; ++seed)
    {
      const int most = static_cast<int>(seed);
      const std::string name = "noise up to " + std::to_string(most);
      TestImage(name, Noise(seed, most, spacing), 0.0, spacing);
      TestImage(name + " at a half", Noise(seed, most, spacing), 0.5, spacing);
    }
    TestImage("labels", Labels(spacing), 1.0, spacing);
    TestImage("labels at a half", Labels(spacing), 1.5, spacing);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
