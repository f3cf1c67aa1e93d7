// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper draws adaptive grids and curved cells, keeps what it made, and notices changes.

#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/Scene.h"
#include "Truth/SameSurface.h"
#include "Volumes/AmrGrids.h"
#include "Volumes/CurvedGrids.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellTypeSource.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

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
  Expect(amr.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_NONE, "one level: is a mesh");
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
  Expect(amr.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_BUILT, "levels: built");
  amr.Renderer->GetActiveCamera()->Azimuth(10.0);
  Expect(amr.Render(50, 50) && amr.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_KEPT,
    "levels: kept");
  vtkDataArray* values = GridAt(grid, 1, 0)->GetCellData()->GetScalars();
  values->SetComponent(3, 0, 9.0);
  values->Modified();
  Expect(amr.Render(50, 50) && amr.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_BUILT,
    "levels: changed");
}

/// Quadratic hexahedra of a linear function show its plane; picks tell the cells of the grid.
void TestCurved()
{
  constexpr int N = 5;
  const auto grid =
    TileCubes(VTK_QUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_QUADRATIC_HEXAHEDRON), N);
  GiveValues(Slope, grid);
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
  Expect(curved.Mapper->GetStatistics()->GetMeshPointError() < 1e-9 &&
      curved.Mapper->GetStatistics()->GetMeshValueError() < 1e-9,
    "curved cells: straight ones are exact");
  grid->GetPointData()->GetScalars()->Modified();
  Expect(curved.Render(50, 50) &&
      curved.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_NEW_VALUES,
    "curved cells: new values");
  grid->GetPoints()->SetPoint(1, 0.21, -0.01, 0.0);
  grid->GetPoints()->Modified();
  Expect(
    curved.Render(50, 50) && curved.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_BUILT,
    "curved cells: new points");
  const double error = curved.Mapper->GetStatistics()->GetMeshPointError();
  Expect(error > 1e-6 && error <= 1e-3, "curved cells: told " + std::to_string(error));
  Expect(curved.Render(50, 50) && curved.Mapper->GetStatistics()->GetMeshPointError() == error,
    "curved cells: the error of a kept mesh");
  Expect(straight.Mapper->GetStatistics()->GetMeshPointError() == 0.0 &&
      straight.Mapper->GetStatistics()->GetMeshValueError() == 0.0,
    "curved cells: an image has no error");
}

/// Render, and expect that all is set up, for the picture of a mapper without a past.
void ExpectBuilt(const std::string& name, Scene& scene, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkImageData> before;
  before->DeepCopy(scene.Depth);
  Expect(
    scene.Render(70, 60) && scene.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_BUILT,
    name + ": set up " + std::to_string(scene.Mapper->GetStatistics()->GetMeshSetUp()));
  Scene cold(grid, { 0.6 });
  cold.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  Expect(cold.Render(70, 60), name + ": cold");
  Expect(AreIdentical(cold.Color, scene.Color) && AreIdentical(cold.Depth, scene.Depth),
    name + ": not the cold picture");
  Expect(!AreIdentical(before, scene.Depth), name + ": another picture");
}

/// Cubes as polyhedra.
/// \param missing gets the faces of its neighbour instead of its own
vtkSmartPointer<vtkUnstructuredGrid> Polyhedra(vtkIdType missing)
{
  constexpr int faces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  const auto cubes = TileCubes(VTK_HEXAHEDRON, HexahedronPattern(VTK_HEXAHEDRON), 4);
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(cubes->GetPoints());
  for (vtkIdType cell = 0; cell < cubes->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> own, shown;
    cubes->GetCellPoints(cell, own);
    cubes->GetCellPoints(cell == missing ? cell ^ 1 : cell, shown);
    std::vector<vtkIdType> stream;
    for (const auto& face : faces)
    {
      stream.push_back(4);
      for (const int corner : face)
      {
        stream.push_back(shown->GetId(corner));
      }
    }
    grid->InsertNextCell(VTK_POLYHEDRON, 8, own->GetPointer(0), 6, stream.data());
  }
  GiveValues(Slope, grid);
  return grid;
}

/// Other faces are noticed, whether they are new objects or written in place.
void TestNewFaces()
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) // later ones have no stream of faces
  for (const bool isInPlace : { true, false })
  {
    const auto grid = Polyhedra(-1);
    Scene scene(grid, { 0.6 });
    scene.LookFrom(1.0, 2.0, 0.7);
    Expect(scene.Render(70, 60), "faces: rendered");
    const vtkIdType seen = scene.Mapper->PickCell(35, 30, nullptr);
    Expect(seen >= 0, "faces: a cell is seen");
    const auto other = Polyhedra(seen);
    if (isInPlace)
    {
      grid->GetFaces()->DeepCopy(other->GetFaces());
      grid->GetFaces()->Modified();
    }
    else
    {
      grid->SetCells(
        grid->GetCellTypesArray(), grid->GetCells(), other->GetFaceLocations(), other->GetFaces());
    }
    ExpectBuilt(isInPlace ? "faces in place" : "new faces", scene, grid);
  }
#endif
}

/// Weights and degrees tell where the points lie that are made.
void TestWeightsAndDegrees()
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_BEZIER_HEXAHEDRON);
  source->SetCellOrder(2);
  source->SetBlocksDimensions(2, 2, 2);
  source->Update();
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->DeepCopy(source->GetOutput());
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weights");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    double at[3];
    grid->GetPoint(p, at);
    grid->GetPoints()->SetPoint(p, at[0] + 0.1 * std::sin(3.0 * at[1]), at[1], at[2]);
    weights->InsertNextValue(1.0);
  }
  GiveValues(Slope, grid);
  grid->GetPointData()->SetRationalWeights(weights);
  Scene scene(grid, { 0.6 });
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(70, 60), "weights: rendered");
  const auto spoil = [&](double by)
  {
    for (vtkIdType p = 0; p < weights->GetNumberOfTuples(); p += 2)
    {
      weights->SetValue(p, weights->GetValue(p) * by);
    }
  };
  spoil(3.0);
  weights->Modified();
  ExpectBuilt("weights", scene, grid);
  spoil(2.0);
  grid->Modified();
  ExpectBuilt("weights, told by the grid", scene, grid);
  vtkNew<vtkDoubleArray> others;
  others->DeepCopy(weights);
  others->FillValue(1.0);
  grid->GetPointData()->SetRationalWeights(others);
  ExpectBuilt("new weights", scene, grid);
}

/// A point is told by its number in the data, not in the cells that are made.
void TestBadPoint()
{
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    for (const bool isCurved : { false, true })
    {
      const auto grid = isCurved
        ? TileCubes(VTK_QUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_QUADRATIC_HEXAHEDRON), 4)
        : Polyhedra(-1);
      GiveValues(Slope, grid);
      Scene scene(grid, { 0.6 });
      scene.LookFrom(1.0, 2.0, 0.7);
      vtkNew<vtkIdList> corners;
      grid->GetCellPoints(20, corners);
      const vtkIdType spoilt = corners->GetId(5);
      Mistake mistake(scene, " of the input has the point " + std::to_string(spoilt) + " at (");
      double place[3];
      grid->GetPoint(spoilt, place);
      grid->GetPoints()->SetPoint(spoilt, place[0], bad, place[2]);
      grid->GetPoints()->Modified();
      mistake.ExpectRefused();
      grid->GetPoints()->SetPoint(spoilt, place);
      grid->GetPoints()->Modified();
      mistake.ExpectMended();
    }
  }
}

/// A wrong cell is told with its block, and the last picture stays.
void TestMistakes()
{
  TestBadPoint();
  const auto grid = Polyhedra(-1);
  Scene scene(grid, { 0.6 });
  scene.LookFrom(1.0, 2.0, 0.7);
  Mistake mistake(
    scene, "Cell 2 of Block 2 ('rotor') has points that begin or end outside of the 160 point ids");
  const auto curved =
    TileCubes(VTK_QUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_QUADRATIC_HEXAHEDRON), 2);
  GiveValues(Slope, curved);
  curved->GetCells()->GetOffsetsArray()->SetComponent(3, 0, 1e8);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  blocks->SetBlock(1, curved);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "rotor");
  scene.Mapper->SetInputDataObject(blocks);
  mistake.ExpectRefused();
  scene.Mapper->SetInputData(grid);
  mistake.ExpectMended();
}

}

int TestShapesDrawn(int, char*[])
{
  TestOneLevel();
  TestLevels();
  TestCurved();
  TestNewFaces();
  TestWeightsAndDegrees();
  TestMistakes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
