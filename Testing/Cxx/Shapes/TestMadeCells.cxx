// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells that are made keep to a limit of memory, tell their progress, and make no more than new
// values need.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/AmrGrids.h"
#include "Volumes/CurvedGrids.h"

#include <vtkCallbackCommand.h>
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

double Slope(const glm::dvec3& at)
{
  return 0.7 * at.x + 0.4 * at.y + 0.2 * at.z;
}

/// Bent quadratic cells, of which many linear ones are made.
vtkSmartPointer<vtkUnstructuredGrid> BentGrid(int n)
{
  auto grid = TileCubes(VTK_QUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_QUADRATIC_HEXAHEDRON), n);
  Bend(grid, 1.0, 0.1, 0.0);
  GiveValues([](const glm::dvec3& at) { return glm::length(at - 0.45); }, grid);
  return grid;
}

/// What is made of cells counts: it is refused before it is there, and the user's cells are told.
void ExpectLimit(const std::string& what, vtkDataObject* data, double isovalue, vtkIdType cells)
{
  Scene scene(nullptr, { isovalue });
  scene.Mapper->SetInputDataObject(data);
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(30, 30), what + ": drawn without a limit");
  const double needed = scene.Mapper->GetStatistics()->GetMeshMemory();
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
    const double kept = limited.Mapper->GetStatistics()->GetMeshMemory();
    Expect(!isDrawn || kept <= limit * 1048576.0, name + "keeps " + std::to_string(kept));
    const std::string words = "The input has " + std::to_string(cells) + " cells, which need";
    Expect(isDrawn || observer->GetErrorMessage().find(words) != std::string::npos,
      name + "tells " + observer->GetErrorMessage());
  }
  Expect(drawn == 2, what + ": a limit that does");
}

/// Curved cells are divided less if memory is limited, and one warning tells of a large error.
void TestCoarserCurved()
{
  const auto grid = BentGrid(5);
  double last = 0.0;
  for (const int limit : { 0, 16, 4, 1 })
  {
    const std::string name = "curved cells, " + std::to_string(limit) + " MiB: ";
    Scene scene(grid, { 0.3 });
    scene.Mapper->SetMeshMemoryLimit(limit);
    scene.LookFrom(1.0, 2.0, 0.7);
    EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
    Expect(scene.Render(30, 30) && scene.Render(31, 30), name + "drawn");
    const double error = std::max(scene.Mapper->GetStatistics()->GetMeshValueError(),
      scene.Mapper->GetStatistics()->GetMeshPointError());
    const double kept = scene.Mapper->GetStatistics()->GetMeshMemory();
    Expect(error > last && (limit == 0 ? error < 0.01 : kept <= limit * 1048576.0),
      name + "keeps " + std::to_string(kept) + ", error " + std::to_string(error));
    Expect(warnings.Count == (error > 0.01 ? 1 : 0),
      name + std::to_string(warnings.Count) + " warnings");
    last = error;
  }
  Expect(last > 0.01, "curved cells: the smallest limit makes a large error");
  // Another limit counts from the next frame on.
  Scene scene(grid, { 0.3 });
  scene.LookFrom(1.0, 2.0, 0.7);
  for (const int limit : { 1, 0, 4 })
  {
    Scene fresh(grid, { 0.3 });
    fresh.LookFrom(1.0, 2.0, 0.7);
    fresh.Mapper->SetMeshMemoryLimit(limit);
    scene.Mapper->SetMeshMemoryLimit(limit);
    Expect(fresh.Render(30, 30) && scene.Render(30, 30) && AreIdentical(fresh.Color, scene.Color) &&
        scene.Mapper->GetStatistics()->GetMeshValueError() ==
          fresh.Mapper->GetStatistics()->GetMeshValueError(),
      "curved cells, from now on " + std::to_string(limit) + " MiB");
  }
}

/// One cell that holds r^2 exactly shows a sphere within the goal.
void TestSphere()
{
  const auto grid =
    TileCubes(VTK_TRIQUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_TRIQUADRATIC_HEXAHEDRON), 1);
  const auto squared = [](const glm::dvec3& at) { return 16.0 * glm::dot(at - 0.5, at - 0.5); };
  GiveValues(squared, grid);
  Scene scene(grid, { 0.09 });
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(90, 90), "sphere: drawn");
  int hits = 0;
  double worst = 0.0;
  for (int pixel = 0; pixel < 90 * 90; ++pixel)
  {
    glm::dvec3 place;
    if (scene.Mapper->PickPixel(pixel % 90, pixel / 90, &place.x, nullptr, nullptr))
    {
      ++hits;
      worst = std::max(worst, std::abs(squared(place) - 0.09));
    }
  }
  Expect(hits > 10 && worst <= 1e-3 * 12.0,
    "sphere: " + std::to_string(hits) + " hits, off by " + std::to_string(worst));
  Expect(scene.Mapper->GetStatistics()->GetMeshValueError() <= 1e-3, "sphere: the goal is met");
}

void TestMemoryLimit()
{
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
    Expect(scene.Mapper->GetStatistics()->GetMeshValueError() ==
          fresh.Mapper->GetStatistics()->GetMeshValueError() &&
        scene.Mapper->GetStatistics()->GetMeshPointError() ==
          fresh.Mapper->GetStatistics()->GetMeshPointError(),
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

int TestMadeCells(int, char*[])
{
  TestMemoryLimit();
  TestCoarserCurved();
  TestSphere();
  TestNewValuesOfCurved();
  TestProgress();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
