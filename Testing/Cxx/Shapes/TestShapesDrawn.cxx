// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper draws adaptive grids and curved cells, keeps what it made, and notices changes.

#include "AmrGrids.h"
#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "CurvedGrids.h"
#include "Scenes/Scene.h"
#include "Truth/SameSurface.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

/// Bent quadratic cells, of which many linear ones are made.
vtkSmartPointer<vtkUnstructuredGrid> BentGrid(int n)
{
  auto grid = TileCubes(VTK_QUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_QUADRATIC_HEXAHEDRON), n);
  Bend(grid, 1.0, 0.1, 0.0);
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 at;
    grid->GetPoint(p, &at.x);
    values->InsertNextValue(glm::length(at - 0.45));
  }
  grid->GetPointData()->SetScalars(values);
  return grid;
}

/// What is made of cells counts: it is refused before it is there, and the user's cells are told.
void ExpectLimit(const std::string& what, vtkDataObject* data, double isovalue, vtkIdType cells)
{
  Scene scene(nullptr, { isovalue });
  scene.Mapper->SetInputDataObject(data);
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(30, 30), what + ": drawn without a limit");
  const double needed = scene.Mapper->GetMeshMemory();
  Expect(needed > 3 << 20, what + ": needs " + std::to_string(needed) + " bytes");
  int drawn = 0;
  for (int limit = 1; limit < 3.0 * needed / (1 << 20) && drawn < 2; ++limit)
  {
    Scene limited(nullptr, { isovalue });
    limited.Mapper->SetInputDataObject(data);
    limited.Mapper->SetMeshMemoryLimit(limit);
    limited.LookFrom(1.0, 2.0, 0.7);
    vtkNew<vtkTest::ErrorObserver> observer;
    limited.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
    const bool isDrawn = limited.Render(30, 30);
    drawn += isDrawn;
    const std::string name = what + ", " + std::to_string(limit) + " MiB: ";
    const double kept = limited.Mapper->GetMeshMemory();
    Expect(!isDrawn || kept <= limit * 1048576.0, name + "keeps " + std::to_string(kept));
    const std::string words = "The input has " + std::to_string(cells) + " cells, which need";
    Expect(isDrawn || observer->GetErrorMessage().find(words) != std::string::npos,
      name + "tells " + observer->GetErrorMessage());
  }
  Expect(drawn == 2, what + ": a limit that does");
}

void TestMemoryLimit()
{
  const auto grid = BentGrid(6);
  ExpectLimit("curved cells", grid, 0.3, grid->GetNumberOfCells());
  AmrTestLevels levels;
  levels.Spacing = glm::dvec3(0.5);
  levels.Ratios = { 2 };
  levels.Boxes = { CutBox({ glm::ivec3(0), glm::ivec3(39) }, 20),
    CutBox({ glm::ivec3(8), glm::ivec3(47) }, 20) };
  ExpectLimit("levels", MakeAmr(levels, Slope), 6.0, 2 * 40 * 40 * 40);
}

/// New values of the same cells need no new cells, and nothing tells what was drawn before.
void TestNewValuesOfCurved()
{
  const auto grid = BentGrid(5);
  Scene scene(grid, { 0.3 });
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(90, 90), "new values: drawn");
  vtkDataArray* values = grid->GetPointData()->GetScalars();
  for (const double wave : { 0.0, 0.02, 1.0, 0.0 })
  {
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      glm::dvec3 at;
      grid->GetPoint(p, &at.x);
      values->SetComponent(p, 0, glm::length(at - 0.48) + wave * std::sin(40.0 * at.x));
    }
    values->Modified();
    Scene fresh(grid, { 0.3 });
    fresh.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    Expect(scene.Render(90, 90) && fresh.Render(90, 90), "new values: drawn again");
    Expect(AreIdentical(scene.Depth, fresh.Depth) && AreIdentical(scene.Color, fresh.Color),
      "new values: another picture than that of a new mapper");
    Expect(scene.Mapper->GetMeshValueError() == fresh.Mapper->GetMeshValueError() &&
        scene.Mapper->GetMeshPointError() == fresh.Mapper->GetMeshPointError(),
      "new values: another error");
  }
}

/// Dividing cells tells of progress from the beginning, and can be stopped.
void TestProgress()
{
  struct Listener
  {
    Mapper* Of = nullptr;
    double StopAt = 2.0;
    std::vector<double> Told;
  } listener;
  const auto grid = BentGrid(12);
  Scene scene(grid, { 0.3 });
  scene.LookFrom(1.0, 2.0, 0.7);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&listener);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* to, void* progress)
    {
      auto& of = *static_cast<Listener*>(to);
      of.Told.push_back(*static_cast<double*>(progress));
      if (of.Told.back() >= of.StopAt)
      {
        of.Of->SetAbortExecute(1);
      }
    });
  scene.Mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, command);
  for (const double stopAt : { 0.0, 0.05, 0.15, 0.24 })
  {
    listener = { scene.Mapper, stopAt, {} };
    EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
    Expect(!scene.Render(30, 30) && errors.Count == 0 && !listener.Told.empty() &&
        listener.Told.back() < stopAt + 0.1,
      "progress: stopped at " + std::to_string(stopAt));
  }
  listener = { scene.Mapper, 2.0, {} };
  Expect(scene.Render(30, 30) && std::is_sorted(listener.Told.begin(), listener.Told.end()) &&
      listener.Told.front() < 0.01 && listener.Told.back() == 1.0,
    "progress: from the beginning to the end");
}

}

int TestShapesDrawn(int, char*[])
{
  TestOneLevel();
  TestLevels();
  TestCurved();
  TestMemoryLimit();
  TestNewValuesOfCurved();
  TestProgress();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
