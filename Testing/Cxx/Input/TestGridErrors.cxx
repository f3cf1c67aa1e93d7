// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Mistakes in grids get one sentence with value and remedy, and the last picture stays: also if no
// cell has volume. Grids with nothing but hidden cells make an empty picture, and so do empty
// pieces.

#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/Scene.h"
#include "Volumes/AmrGrids.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOverlappingAMR.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkTrivialProducer.h>
#include <vtkTypeInt32Array.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(8, VTK_DOUBLE,
    [](double x, double y, double z) { return 200.0 - 100.0 * std::hypot(x, y, z); });
}

Grid Balls(int cellType = VTK_HEXAHEDRON)
{
  Grid grid = Grid::New();
  grid->DeepCopy(VtkMeshes::Unstructured(Ball(), cellType));
  return grid;
}

/// Draw a grid, spoil it, expect one error with `words`, and draw a good one again.
void ExpectRefused(const std::string& words, const std::function<void(Grid&, Scene&)>& spoil)
{
  Grid grid = Balls();
  Scene scene(grid, { 130.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Mistake mistake(scene, words);
  spoil(grid, scene);
  grid->Modified();
  mistake.ExpectRefused();
  Expect(!mistake.Message.empty() && mistake.Message.find(';') != std::string::npos,
    words + ": tells no remedy: " + mistake.Message);
  scene.Mapper->SetMaskInput(nullptr);
  scene.Mapper->SetMeshMemoryLimit(0);
  scene.Mapper->SetVectorModeToDisabled();
  scene.Mapper->SetScalarModeToDefault();
  scene.Mapper->SetInputData(Balls());
  mistake.ExpectMended();
}

/// Points of the cells of a grid, as numbers that can be written.
vtkDataArray* IdsOf(vtkUnstructuredGrid* grid)
{
  grid->GetCells()->Modified();
  return grid->GetCells()->GetConnectivityArray();
}

void TestPoints()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, infinity, -infinity })
  {
    ExpectRefused("Cell 0 of the input has the point 9 at (-0.714286, ",
      [=](Grid& grid, Scene&)
      {
        grid->GetPoints()->GetData()->SetComponent(9, 1, bad);
        grid->GetPoints()->Modified();
      });
  }
  ExpectRefused("Cell 7 of the input has the point 512, but there are 512 points",
    [](Grid& grid, Scene&) { IdsOf(grid)->SetComponent(8 * 7 + 3, 0, 512.0); });
  ExpectRefused("Cell 7 of the input has the point -1, but there are 512 points",
    [](Grid& grid, Scene&) { IdsOf(grid)->SetComponent(8 * 7 + 3, 0, -1.0); });
}

void TestCells()
{
  ExpectRefused("Cell 3 of the input has points that begin or end outside",
    [](Grid& grid, Scene&)
    {
      grid->GetCells()->GetOffsetsArray()->SetComponent(4, 0, 1e6);
      grid->GetCells()->Modified();
    });
  ExpectRefused("The input has 1 cell of type 200, which VTK does not know; leave it out",
    [](Grid& grid, Scene&)
    {
      VtkMeshes::TypesOf(grid)->SetComponent(5, 0, 200);
      VtkMeshes::TypesOf(grid)->Modified();
    });
  ExpectRefused("Cell 0 of the input has 4 points, which is not the number for its type 13",
    [](Grid& grid, Scene& scene)
    {
      grid = Balls(VTK_TETRA);
      VtkMeshes::TypesOf(grid)->SetComponent(0, 0, VTK_WEDGE);
      scene.Mapper->SetInputData(grid);
    });
}

/// Points of a ball, and a triangle.
Grid Sheet()
{
  Grid sheet = Grid::New();
  sheet->SetPoints(VtkMeshes::PointsOf(Ball()));
  sheet->GetPointData()->ShallowCopy(Ball()->GetPointData());
  const vtkIdType ids[] = { 0, 1, 2 };
  sheet->InsertNextCell(VTK_TRIANGLE, 3, ids);
  return sheet;
}

void TestWithoutVolume()
{
  const auto refuse = [](const std::string& words, vtkDataObject* data)
  { ExpectRefused(words, [=](Grid&, Scene& scene) { scene.Mapper->SetInputDataObject(data); }); };
  refuse("no cells with volume, but 1 cell of less than three dimensions", Sheet());
  refuse("The input has no cells;", vtkNew<vtkUnstructuredGrid>().Get());
  refuse("The input has no cells;", vtkNew<vtkStructuredGrid>().Get());
  refuse("The input has no cells;", vtkNew<vtkExplicitStructuredGrid>().Get());
  refuse("The input has no cells;", vtkNew<vtkOverlappingAMR>().Get());
  refuse("The input has no cells;", vtkNew<vtkMultiBlockDataSet>().Get());
  refuse("The input has no cells;", vtkNew<vtkPartitionedDataSetCollection>().Get());
  Grid points = Sheet();
  points->SetCells(VTK_TRIANGLE, vtkNew<vtkCellArray>().Get());
  refuse("The input has no cells, but 512 points;", points);
  vtkNew<vtkStructuredGrid> slice;
  slice->SetDimensions(64, 8, 1);
  slice->SetPoints(VtkMeshes::PointsOf(Ball()));
  slice->GetPointData()->ShallowCopy(Ball()->GetPointData());
  refuse("no cells with volume, but 441 cells of less than three dimensions", slice);

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  blocks->SetBlock(0, nullptr);
  blocks->SetBlock(1, vtkNew<vtkUnstructuredGrid>().Get());
  refuse("The input has no cells;", blocks);
  blocks->SetBlock(2, Sheet());
  blocks->SetBlock(3, sphere->GetOutput());
  refuse("no cells with volume, but 97 cells of less than three dimensions", blocks);
}

void TestScalars()
{
  ExpectRefused("has an array 'few' of 17 tuples, but 512 points",
    [](Grid& grid, Scene&)
    {
      vtkNew<vtkDoubleArray> few;
      few->SetName("few");
      few->SetNumberOfTuples(17);
      grid->GetPointData()->SetScalars(few);
    });
  ExpectRefused("has an array 'many' of 512 tuples, but 343 cells",
    [](Grid& grid, Scene&)
    {
      vtkNew<vtkDoubleArray> many;
      many->SetName("many");
      many->SetNumberOfTuples(512);
      many->FillValue(1.0);
      grid->GetPointData()->Initialize();
      grid->GetCellData()->SetScalars(many);
    });
  ExpectRefused("has an array 'few' of 17 tuples, but 343 cells",
    [](Grid& grid, Scene&)
    {
      vtkNew<vtkDoubleArray> few;
      few->SetName("few");
      few->SetNumberOfTuples(17);
      grid->GetPointData()->Initialize();
      grid->GetCellData()->SetScalars(few);
    });
  const auto choose = [](const char* name)
  {
    return [name](Grid&, Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      if (name)
      {
        scene.Mapper->SelectScalarArray(name);
      }
    };
  };
  ExpectRefused("ScalarMode asks for an array on points, but none is chosen;", choose(nullptr));
  ExpectRefused("no array of numbers named 'pressure' on its points;", choose("pressure"));
  ExpectRefused("no array number 7 on its cells, or it holds no numbers;",
    [](Grid&, Scene& scene)
    {
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectScalarArray(7);
    });
  ExpectRefused("no scalars", [](Grid& grid, Scene&) { grid->GetPointData()->Initialize(); });
  ExpectRefused("VectorComponent is 3",
    [](Grid&, Scene& scene)
    {
      scene.Mapper->SetVectorModeToComponent();
      scene.Mapper->SetVectorComponent(3);
    });
  for (const vtkIdType flags : { 7, 344 })
  {
    ExpectRefused(std::to_string(flags) + " tuples of 1 component(s), but 343 cells",
      [&](Grid& grid, Scene&) { Ghosts::AddFlags(grid->GetCellData(), flags); });
  }
}

/// Components that no array has, where the lengths of vectors were drawn before, also of adaptive
/// grids.
void TestComponents()
{
  AmrTestLevels levels;
  levels.Boxes = { { { glm::ivec3(0), glm::ivec3(7) } }, { { glm::ivec3(4), glm::ivec3(11) } } };
  levels.Ratios = { 2 };
  const auto amr = MakeAmr(
    levels, [](const glm::dvec3& at) { return 200.0 - 20.0 * glm::distance(at, glm::dvec3(4.0)); });
  const Grid balls = Balls();
  for (vtkDataObject* data :
    { static_cast<vtkDataObject*>(amr), static_cast<vtkDataObject*>(balls) })
  {
    for (const int component : { -1, 1, 256 })
    {
      Scene scene(nullptr, { 150.0 });
      scene.Mapper->SetInputDataObject(data);
      scene.Mapper->SetVectorModeToMagnitude();
      scene.LookFrom(1.0, 2.0, 0.5);
      Mistake mistake(scene, "VectorComponent is " + std::to_string(component) + ", but array ");
      scene.Mapper->SetVectorModeToComponent();
      scene.Mapper->SetVectorComponent(component);
      mistake.ExpectRefused();
      scene.Mapper->SetVectorModeToMagnitude();
      mistake.ExpectMended();
    }
  }
}

void TestSettings()
{
  ExpectRefused("A mask cannot be used with a vtkUnstructuredGrid",
    [](Grid&, Scene& scene)
    {
      scene.Mapper->SetMaskInput(Ball());
      scene.Mapper->SetMaskTypeToBinary();
    });
  ExpectRefused("more than MeshMemoryLimit (1 MiB)",
    [](Grid& grid, Scene& scene)
    {
      scene.Mapper->SetMeshMemoryLimit(1);
      const auto many = Volumes::Noise(50, VTK_FLOAT, 0.0, 1.0);
      grid = VtkMeshes::Unstructured(many, VTK_TETRA);
      scene.Mapper->SetInputData(grid);
    });
}

void TestBlocks()
{
  ExpectRefused("Cell 2 of Block 2 has the point 999, but there are 512 points",
    [](Grid& grid, Scene& scene)
    {
      IdsOf(grid)->SetComponent(8 * 2, 0, 999.0);
      vtkNew<vtkMultiBlockDataSet> tree;
      tree->SetBlock(0, Balls());
      tree->SetBlock(1, grid);
      scene.Mapper->SetInputDataObject(tree);
    });
  ExpectRefused("Block 2 is a vtkTable",
    [](Grid& grid, Scene& scene)
    {
      vtkNew<vtkMultiBlockDataSet> tree;
      tree->SetBlock(0, grid);
      tree->SetBlock(1, vtkNew<vtkTable>().Get());
      scene.Mapper->SetInputDataObject(tree);
    });
}

/// No mistakes, but nothing to see.
void TestEmptyPictures()
{
  const auto isEmpty = [](const std::string& name, vtkAlgorithm* source)
  {
    Scene scene(Balls(), { 130.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    vtkNew<vtkTest::ErrorObserver> observer;
    scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
    scene.Mapper->SetInputConnection(source->GetOutputPort());
    for (int i = 0; i < 2; ++i)
    {
      Expect(scene.Render(30, 30) && !observer->GetError(),
        name + ": no error, but: " + observer->GetErrorMessage());
    }
    bool empty = true;
    for (int pixel = 0; pixel < 30 * 30; ++pixel)
    {
      empty = empty && std::isinf(scene.DepthAt(pixel % 30, pixel / 30));
    }
    Expect(empty, name + ": an empty picture");
    double t;
    const double begin[] = { 3.0, 3.0, 3.0 }, end[] = { -3.0, -3.0, -3.0 };
    Expect(!scene.Mapper->IntersectWithLine(scene.Volume, begin, end, t, nullptr, nullptr, nullptr),
      name + ": nothing on a line");
  };
  const auto isEmptyData = [&](const std::string& name, vtkDataSet* data)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    isEmpty(name, producer);
  };
  const auto isEmptyPiece = [&](const std::string& name, vtkDataSet* data)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    producer->UpdatePiece(1, 2, 0);
    isEmpty(name, producer);
  };
  isEmptyPiece("a piece without cells", vtkNew<vtkUnstructuredGrid>().Get());
  isEmptyPiece("a piece without points", vtkNew<vtkStructuredGrid>().Get());
  isEmptyPiece("a piece of surfaces", Sheet());
  Grid hidden = Balls();
  hidden->AllocateCellGhostArray();
  hidden->GetCellGhostArray()->FillValue(vtkDataSetAttributes::HIDDENCELL);
  isEmptyData("hidden", hidden);
  Grid nowhere = Balls();
  nowhere->GetPointData()->GetScalars()->Fill(std::numeric_limits<double>::quiet_NaN());
  isEmptyData("NaN", nowhere);
}

}

int TestGridErrors(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestPoints();
  TestCells();
  TestWithoutVolume();
  TestScalars();
  TestComponents();
  TestSettings();
  TestBlocks();
  TestEmptyPictures();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
