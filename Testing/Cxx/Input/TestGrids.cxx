// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Grids of every sort look like the images that they are made of, whatever holds their numbers.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/SameSurface.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;
using Arrange = std::function<void(Scene&)>;

/// Differs in each cell, and from axis to axis.
Image Waves(int type = VTK_FLOAT)
{
  const Image image = Volumes::FromFormula(17, type,
    [](double x, double y, double z)
    { return 50.0 * (1.0 + std::sin(3.0 * x + y) * std::cos(2.5 * y) + 0.5 * z); });
  image->SetSpacing(0.25, 0.5, 0.125);
  image->SetOrigin(-2.0, 5.0, 1.0);
  return image;
}

/// Every interpolation of it is the same plane.
Image Slope()
{
  const Image image = Volumes::FromFormula(9, VTK_DOUBLE,
    [](double x, double y, double z) { return 100.0 + 30.0 * x + 50.0 * y + 20.0 * z; });
  image->SetSpacing(0.25, 0.5, 0.125);
  return image;
}

void ExpectImage(
  const std::string& name, vtkDataSet* grid, vtkImageData* image, double isovalue,
  const Arrange& arrange = [](Scene&) {})
{
  Scene ofImage(image, { isovalue }), ofGrid(grid, { isovalue });
  for (Scene* scene : { &ofImage, &ofGrid })
  {
    arrange(*scene);
    scene->LookFrom(1.0, 2.0, 0.7);
  }
  ExpectSameSurface(name, ofGrid, ofImage);
}

/// Sorts of grids, and types of cells.
void TestSorts()
{
  const Image waves = Waves(), slope = Slope();
  ExpectImage("voxels", VtkMeshes::Unstructured(waves, VTK_VOXEL), waves, 60.0);
  ExpectImage("hexahedra", VtkMeshes::Unstructured(waves, VTK_HEXAHEDRON), waves, 60.0);
  ExpectImage("curvilinear", VtkMeshes::Curvilinear(waves), waves, 60.0);
  ExpectImage("explicit", VtkMeshes::Explicit(waves), waves, 60.0);
  for (const int type : { VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    ExpectImage(
      "cells of type " + std::to_string(type), VtkMeshes::Unstructured(slope, type), slope, 103.0);
  }
  const auto turned = [](Scene& scene)
  {
    scene.Volume->SetScale(1.0, -2.0, 0.5);
    scene.Volume->RotateX(30.0);
    scene.Volume->SetPosition(3.0, 2.0, 1.0);
  };
  ExpectImage("turned", VtkMeshes::Curvilinear(waves), waves, 60.0, turned);
}

/// Cropping and clipping are those of the image; solids are capped by them and by the boundary.
void TestRegions()
{
  const Image waves = Waves();
  const auto solid = [](Scene& scene) { scene.Mapper->SetSurfaceModeToThreshold(); };
  ExpectImage("solid", VtkMeshes::Curvilinear(waves), waves, 60.0, solid);
  const auto cropped = [](Scene& scene)
  {
    scene.Mapper->SetSurfaceModeToThreshold();
    scene.Mapper->CroppingOn();
    scene.Mapper->SetCroppingRegionPlanes(-1.1, 0.9, 6.3, 11.2, 1.33, 2.21);
    scene.Mapper->SetCroppingRegionFlagsToFence();
  };
  ExpectImage("cropped", VtkMeshes::Unstructured(waves, VTK_HEXAHEDRON), waves, 60.0, cropped);
}

/// Where the near plane clips a solid of thin cells, its cap faces the viewer.
void TestThinCells()
{
  const Image solid = Volumes::FromFormula(
    5, VTK_DOUBLE, [](double x, double y, double z) { return 10.0 + x + y + z; });
  solid->SetOrigin(0.0, 0.0, 0.0);
  for (const double thickness : { 1.0, 1e-3, 1e-5 })
  {
    solid->SetSpacing(1.0, 1.0, thickness);
    for (const int type : { VTK_TETRA, VTK_HEXAHEDRON })
    {
      Scene scene(VtkMeshes::Unstructured(solid, type), { 1.0 });
      scene.Mapper->SetSurfaceModeToThreshold();
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetFocalPoint(2.0, 2.0, 0.0);
      camera->SetPosition(2.0, 2.0, 4.5 * thickness + 0.1);
      camera->SetViewUp(0.0, 1.0, 0.0);
      camera->SetParallelScale(1.5);
      camera->ParallelProjectionOn();
      camera->SetClippingRange(0.1 + 1.2 * thickness, 1.0 + 10.0 * thickness);
      Expect(scene.Render(40, 40), "thin cells: rendered");
      int others = 0;
      for (int pixel = 0; pixel < 40 * 40; ++pixel)
      {
        double normal[3] = {};
        const bool isHit =
          scene.Mapper->PickPixel(pixel % 40, pixel / 40, nullptr, normal, nullptr);
        others += !isHit || normal[2] < 1.0 - 1e-6;
      }
      Expect(others == 0,
        "cells " + std::to_string(thickness) + " thin: " + std::to_string(others) +
          " caps do not face the viewer");
    }
  }
}

/// Numbers of all types, of points and of values, in any layout.
void TestArrays()
{
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    const Image waves = Waves(type);
    ExpectImage(std::string("values of ") + waves->GetScalarTypeAsString(),
      VtkMeshes::Curvilinear(waves), waves, 60.5);
  }
  const Image waves = Waves();
  for (const bool isLarge : { false, true })
  {
    const auto grid = VtkMeshes::Unstructured(waves, VTK_HEXAHEDRON);
    isLarge ? grid->GetCells()->ConvertTo64BitStorage() : grid->GetCells()->ConvertTo32BitStorage();
    ExpectImage(isLarge ? "64 bits" : "32 bits", grid, waves, 60.0);
  }
  const auto grid = VtkMeshes::Unstructured(waves, VTK_VOXEL);
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->SetNumberOfComponents(3);
  apart->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    apart->SetTuple(i, grid->GetPoint(i));
  }
  grid->GetPoints()->SetData(apart);
  ExpectImage("coordinates apart", grid, waves, 60.0);
}

/// Components, lengths of vectors, and arrays chosen by name.
void TestVectors()
{
  const Image waves = Waves();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < waves->GetNumberOfPoints(); ++i)
  {
    const double value = waves->GetPointData()->GetScalars()->GetTuple1(i);
    vectors->InsertNextTuple3(-0.6 * value, value, 0.8 * value);
  }
  waves->GetPointData()->AddArray(vectors);
  const auto grid = VtkMeshes::Unstructured(waves, VTK_HEXAHEDRON);
  for (const bool isLength : { false, true })
  {
    const auto choose = [&](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectScalarArray("velocity");
      isLength ? scene.Mapper->SetVectorModeToMagnitude()
               : scene.Mapper->SetVectorModeToComponent();
      scene.Mapper->SetVectorComponent(2);
    };
    ExpectImage(isLength ? "lengths" : "a component", grid, waves, isLength ? 80.0 : 45.0, choose);
  }
}

/// Scalars of cells are the means of the cells around each point.
void TestCellScalars()
{
  constexpr int N = 12;
  const Image cells = Image::New();
  cells->SetDimensions(N + 1, N + 1, N + 1);
  vtkNew<vtkDoubleArray> ofCells;
  for (int i = 0; i < N * N * N; ++i)
  {
    ofCells->InsertNextValue(
      std::sin(0.4 * (i % N)) + std::cos(0.5 * (i / N % N)) + 0.1 * (i / N / N));
  }
  cells->GetCellData()->SetScalars(ofCells);
  const Image means = Image::New();
  means->CopyStructure(cells);
  vtkNew<vtkDoubleArray> ofPoints;
  for (vtkIdType point = 0; point < means->GetNumberOfPoints(); ++point)
  {
    vtkNew<vtkIdList> around;
    cells->GetPointCells(point, around);
    double sum = 0.0;
    for (const vtkIdType cell : *around)
    {
      sum += ofCells->GetValue(cell);
    }
    ofPoints->InsertNextValue(sum / static_cast<double>(around->GetNumberOfIds()));
  }
  means->GetPointData()->SetScalars(ofPoints);
  ExpectImage("scalars of hexahedra", VtkMeshes::Unstructured(cells, VTK_HEXAHEDRON), means, 0.9);
  ExpectImage("scalars of a curvilinear grid", VtkMeshes::Curvilinear(cells), means, 0.9);

  Scene averaged(VtkMeshes::Explicit(cells), { 0.9 }), plain(VtkMeshes::Explicit(means), { 0.9 });
  Expect(averaged.Render(40, 40) && averaged.Mapper->GetStatistics()->GetScalarsWereAveraged(),
    "told of averages");
  Expect(plain.Render(40, 40) && !plain.Mapper->GetStatistics()->GetScalarsWereAveraged(),
    "told of no averages");
}

/// In means of cells, infinities of both signs cancel each other like large numbers.
void TestInfiniteCells()
{
  constexpr int N = 6;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Image cells = Image::New(), means = Image::New();
  cells->SetDimensions(N + 1, N + 1, N + 1);
  means->CopyStructure(cells);
  vtkNew<vtkDoubleArray> ofCells, ofPoints;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    ofCells->InsertNextValue(cell % N < N / 2 ? -infinity : infinity);
  }
  for (vtkIdType point = 0; point < means->GetNumberOfPoints(); ++point)
  {
    const int x = static_cast<int>(point % (N + 1));
    ofPoints->InsertNextValue(x == N / 2 ? 0.0 : std::copysign(infinity, x - N / 2));
  }
  cells->GetCellData()->SetScalars(ofCells);
  means->GetPointData()->SetScalars(ofPoints);
  Scene ofCellScalars(VtkMeshes::Curvilinear(cells), { 1.0 });
  Scene ofPointScalars(VtkMeshes::Curvilinear(means), { 1.0 });
  ofCellScalars.LookFrom(1.0, 2.0, 0.7);
  ofPointScalars.LookFrom(1.0, 2.0, 0.7);
  ExpectSameSurface("infinite cells", ofCellScalars, ofPointScalars);
}

}

int TestGrids(int, char*[])
{
  TestSorts();
  TestRegions();
  TestThinCells();
  TestArrays();
  TestVectors();
  TestCellScalars();
  TestInfiniteCells();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
