// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper draws adaptive grids and curved cells, keeps what it made, and notices changes.

#include "AmrGrids.h"
#include "Checks/Expect.h"
#include "CurvedGrids.h"
#include "Scenes/Scene.h"
#include "Truth/SameSurface.h"

#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

double Wave(const glm::dvec3& at)
{
  return std::sin(0.9 * at.x) + 0.5 * std::cos(0.7 * at.y) + 0.2 * at.z;
}

double Slope(const glm::dvec3& at)
{
  return 0.7 * at.x + 0.4 * at.y + 0.2 * at.z;
}

/// An image of cells, as an adaptive grid has them.
vtkSmartPointer<vtkImageData> ImageOf(const AmrFunction& function, int cells, double spacing)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (int c = 0; c < cells * cells * cells; ++c)
  {
    const glm::dvec3 cell(c % cells, c / cells % cells, c / cells / cells);
    values->InsertNextValue(function((cell + 0.5) * spacing));
  }
  image->GetCellData()->SetScalars(values);
  return image;
}

/// One level is drawn as the image that it is, byte for byte.
void TestOneLevel()
{
  AmrTestLevels levels;
  levels.Spacing = glm::dvec3(0.5);
  levels.Boxes = { CutBox({ glm::ivec3(0), glm::ivec3(11) }, 6) };
  Scene image(ImageOf(Wave, 12, 0.5), { 0.8 }), amr(nullptr, { 0.8 });
  amr.Mapper->SetInputDataObject(MakeAmr(levels, Wave));
  for (Scene* scene : { &image, &amr })
  {
    scene->LookFrom(1.0, 2.0, 0.7);
    Expect(scene->Render(70, 60), "one level: rendered");
  }
  Expect(AreIdentical(image.Color, amr.Color) && AreIdentical(image.Depth, amr.Depth),
    "one level: not the picture of the image");
  Expect(amr.Mapper->GetMeshSetUp() == Mapper::MESH_NONE, "one level: is a mesh");
}

/// Several levels have the plane of a linear function, without cracks; the mesh is kept.
void TestLevels()
{
  AmrTestLevels levels;
  levels.Spacing = glm::dvec3(0.5);
  levels.Ratios = { 2 };
  levels.Boxes = { CutBox({ glm::ivec3(0), glm::ivec3(11) }, 6),
    CutBox({ glm::ivec3(8), glm::ivec3(15) }, 4) };
  const auto grid = MakeAmr(levels, Slope);
  Scene image(ImageOf(Slope, 12, 0.5), { 3.8 }), amr(nullptr, { 3.8 });
  amr.Mapper->SetInputDataObject(grid);
  for (Scene* scene : { &image, &amr })
  {
    scene->LookFrom(1.0, 2.0, 0.7);
  }
  ExpectSameSurface("levels", amr, image);
  Expect(amr.Mapper->GetMeshSetUp() == Mapper::MESH_BUILT, "levels: built");
  amr.Renderer->GetActiveCamera()->Azimuth(10.0);
  Expect(amr.Render(50, 50) && amr.Mapper->GetMeshSetUp() == Mapper::MESH_KEPT, "levels: kept");
  vtkDataArray* values = grid->GetDataSet(1, 0)->GetCellData()->GetScalars();
  values->SetComponent(3, 0, 9.0);
  values->Modified();
  Expect(amr.Render(50, 50) && amr.Mapper->GetMeshSetUp() == Mapper::MESH_BUILT, "levels: changed");
}

/// Quadratic hexahedra of a linear function show its plane; picks tell the cells of the grid.
void TestCurved()
{
  constexpr int N = 5;
  const auto grid =
    TileCubes(VTK_QUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_QUADRATIC_HEXAHEDRON), N);
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 at;
    grid->GetPoint(p, &at.x);
    values->InsertNextValue(Slope(at));
  }
  grid->GetPointData()->SetScalars(values);
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(N + 1, N + 1, N + 1);
  image->SetSpacing(1.0 / N, 1.0 / N, 1.0 / N);
  vtkNew<vtkDoubleArray> ofImage;
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    const double* at = image->GetPoint(p);
    ofImage->InsertNextValue(Slope({ at[0], at[1], at[2] }));
  }
  image->GetPointData()->SetScalars(ofImage);
  Scene curved(grid, { 0.6 }), straight(image, { 0.6 });
  for (Scene* scene : { &curved, &straight })
  {
    scene->LookFrom(1.0, 2.0, 0.7);
  }
  ExpectSameSurface("curved cells", curved, straight);
  int hits = 0, wrong = 0;
  for (int pixel = 0; pixel < 90 * 90; pixel += 11)
  {
    double place[3], box[6];
    const vtkIdType cell = curved.Mapper->PickCell(pixel % 90, pixel / 90, nullptr);
    if (cell >= 0 && curved.Mapper->PickPixel(pixel % 90, pixel / 90, place, nullptr, nullptr) &&
      ++hits)
    {
      grid->GetCellBounds(cell, box);
      for (int axis = 0; axis < 3; ++axis)
      {
        wrong += place[axis] < box[2 * axis] - 1e-6 || place[axis] > box[2 * axis + 1] + 1e-6;
      }
    }
  }
  Expect(hits > 50 && wrong == 0, "curved cells: " + std::to_string(wrong) + " wrong cells");
  Expect(curved.Mapper->GetMeshPointError() < 1e-9 && curved.Mapper->GetMeshValueError() < 1e-9,
    "curved cells: straight ones are exact");
  values->Modified();
  Expect(curved.Render(50, 50) && curved.Mapper->GetMeshSetUp() == Mapper::MESH_NEW_VALUES,
    "curved cells: new values");
  grid->GetPoints()->SetPoint(1, 0.21, -0.01, 0.0);
  grid->GetPoints()->Modified();
  Expect(curved.Render(50, 50) && curved.Mapper->GetMeshSetUp() == Mapper::MESH_BUILT,
    "curved cells: new points");
  const double error = curved.Mapper->GetMeshPointError();
  Expect(error > 1e-6 && error <= 1e-3, "curved cells: told " + std::to_string(error));
  Expect(curved.Render(50, 50) && curved.Mapper->GetMeshPointError() == error,
    "curved cells: the error of a kept mesh");
  Expect(straight.Mapper->GetMeshPointError() == 0.0 && straight.Mapper->GetMeshValueError() == 0.0,
    "curved cells: an image has no error");
}

}

int TestShapesDrawn(int, char*[])
{
  TestOneLevel();
  TestLevels();
  TestCurved();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
