// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_MissingSamples_h
#define Testing_MissingSamples_h

#include "Scenes/Subject.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// Data with samples that are not numbers, and the same data with blanked ones.
namespace MissingSamples
{

using Image = vtkSmartPointer<vtkImageData>;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int N = 21;

inline double Waves(double x, double y, double z)
{
  return 50.0 + 30.0 * std::sin(3.0 * x + y) * std::cos(2.5 * y) + 20.0 * z;
}

/// Where samples are missing.
using Missing = std::function<bool(int, int, int)>;

inline std::vector<std::pair<std::string, Missing>> AllMissing()
{
  const auto scatter = [](int i, int j, int k) { return (i * 7 + j * 13 + k * 29) % 53 == 0; };
  return { { "half", [](int i, int, int) { return i >= 12; } }, { "scattered", scatter },
    { "a block", [](int i, int j, int k) { return i > 6 && i < 12 && j > 8 && k > 3 && k < 15; } },
    { "a plane", [](int, int, int k) { return k == 10; } },
    { "the last sample",
      [](int i, int j, int k) { return i == N - 1 && j == N - 1 && k == N - 1; } } };
}

/// The image with samples that are not numbers.
inline Image WithHoles(int type, const Missing& isMissing)
{
  Image image = Volumes::FromFormula(N, type, Waves);
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  for (int i = 0; i < N * N * N; ++i)
  {
    if (isMissing(i % N, i / N % N, i / N / N))
    {
      samples->SetComponent(i, 0, NaN);
    }
  }
  return image;
}

/// The same image, whose samples are there but flagged as hidden.
inline Image Blanked(int type, const Missing& isMissing)
{
  Image image = Volumes::FromFormula(N, type, Waves);
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  for (int i = 0; i < N * N * N; ++i)
  {
    if (isMissing(i % N, i / N % N, i / N / N))
    {
      samples->SetComponent(i, 0, 50.0); // within the range of the others
    }
  }
  Ghosts::FlagPoints(image,
    [&](int i, int j, int k)
    { return isMissing(i, j, k) ? vtkDataSetAttributes::HIDDENPOINT : 0; });
  return image;
}

/// One of the sorts of data that an image can be given as.
struct Sort
{
  std::string Name;
  std::function<vtkSmartPointer<vtkDataSet>(vtkImageData*)> Of;
  bool IsMesh = true;
};

inline std::vector<Sort> AllSorts()
{
  const auto cells = [](int type)
  { return [=](vtkImageData* image) { return VtkMeshes::Unstructured(image, type); }; };
  const auto uneven = [](vtkImageData* image)
  {
    const auto grid = VtkMeshes::Rectilinear(image);
    for (int axis = 0; axis < 3; ++axis)
    {
      Grids::SetCoordinates(grid, axis, Grids::FineInside(N, 0.3));
    }
    return grid;
  };
  return { { "image", [](vtkImageData* image) { return image; }, false },
    { "rectilinear grid", uneven, false }, { "curvilinear grid", VtkMeshes::Curvilinear },
    { "explicit grid", VtkMeshes::Explicit }, { "voxels", cells(VTK_VOXEL) },
    { "hexahedra", cells(VTK_HEXAHEDRON) }, { "tetrahedra", cells(VTK_TETRA) },
    { "wedges", cells(VTK_WEDGE) } };
}

}

#endif
