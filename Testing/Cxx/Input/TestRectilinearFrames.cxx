// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rectilinear grids from frame to frame: routes, changes, threads, mistakes, and grids that are
// images.

#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/Scene.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Grids.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomChanges.h"
#include "Walks/RandomViews.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;
using Grid = vtkSmartPointer<vtkRectilinearGrid>;

double BlobAt(double x, double y, double z)
{
  return 60.0 * (1.5 - x * x - 2.0 * y * y - 0.5 * z * z + 0.3 * x * y + 0.2 * z);
}

double WavesAt(double x, double y, double z)
{
  return 1000.0 * (std::sin(5.0 * x) * std::cos(4.0 * y) + 0.7 * z);
}

Grids::Coordinates RandomCoordinates(double ratio)
{
  return { Grids::Random(31, ratio, 1), Grids::Random(22, ratio, 2), Grids::Random(27, ratio, 3) };
}

/// A grid that is an image looks like it, byte for byte, and has its routes.
void TestUniform()
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  image->SetOrigin(0.5, -3.0, 2.0);
  image->SetSpacing(0.25, 0.5, 0.125);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    Scene ofImage(image, { 200.0, -300.0 });
    Grid grid = Grids::FromImage(image, type);
    Scene ofGrid(grid, { 200.0, -300.0 });
    for (Scene* scene : { &ofImage, &ofGrid })
    {
      scene->Mapper->SetSurfaceModeToThreshold();
      scene->LookFrom(1.0, 2.0, 0.5);
      Expect(scene->Render(120, 90), "uniform: rendered");
    }
    Expect(AreIdentical(ofImage.Color, ofGrid.Color) && AreIdentical(ofImage.Depth, ofGrid.Depth),
      "uniform: not the picture of the image");
    ofGrid.SetIsovalues({ 210.0, -300.0 });
    Expect(ofGrid.Render(120, 90) && IsRoute(ofGrid, "IsomapBuild"), "uniform: has an isomap");
  }
  // All but uniform: another tracer, nearly the same picture.
  Grid grid = Grids::FromImage(image, VTK_DOUBLE);
  grid->GetXCoordinates()->SetComponent(7, 0, grid->GetXCoordinates()->GetComponent(7, 0) + 1e-5);
  Scene ofImage(image, { 200.0, -300.0 }), ofGrid(grid, { 200.0, -300.0 });
  for (Scene* scene : { &ofImage, &ofGrid })
  {
    scene->LookFrom(1.0, 2.0, 0.5);
    Expect(scene->Render(120, 90), "almost uniform: rendered");
  }
  double farthest = 0.0;
  int silhouettes = 0, colors = 0;
  for (int pixel = 0; pixel < 120 * 90; ++pixel)
  {
    const int x = pixel % 120, y = pixel / 120;
    const double here = static_cast<double>(ofImage.DepthAt(x, y));
    const double there = static_cast<double>(ofGrid.DepthAt(x, y));
    if (std::isinf(here) || std::isinf(there))
    {
      silhouettes += std::isinf(here) != std::isinf(there);
      continue;
    }
    farthest = std::max(farthest, std::abs(here - there));
    for (int c = 0; c < 3; ++c)
    {
      colors += std::abs(ofImage.ColorAt(x, y)[c] - ofGrid.ColorAt(x, y)[c]) > 1;
    }
  }
  Expect(farthest < 1e-3 && silhouettes <= 2 && colors <= 2,
    "almost uniform: " + std::to_string(farthest) + " apart, " + std::to_string(silhouettes) +
      " silhouettes and " + std::to_string(colors) + " colours differ");
}

/// Frames made with the help of earlier ones are those of a mapper without a past.
void TestRoutes(const std::string& name, vtkRectilinearGrid* grid, unsigned seed)
{
  std::map<std::string, int> routes;
  Scene scene(grid, { 100.0 });
  ColdWitness cold;
  scene.Mapper->SetReuseAccuracyToPaper();
  scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
  RandomViews views(scene, seed, 140);
  const std::vector<Change> moves = ChangesOfView(scene, views);
  std::vector<Change> others = ChangesOfIsovalues(scene, views);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  const std::vector<Change> more = {
    { false, [&] { scene.Mapper->SetSurfaceMode(1 - scene.Mapper->GetSurfaceMode()); } },
    { false, [=] { property->SetAmbient(property->GetAmbient() > 0.3 ? 0.1 : 0.5); } },
    { true, [=] { property->SetInterpolationType(1 - property->GetInterpolationType()); } },
    { false, [&] { scene.SetIsovalues({ views.Between(-500.0, 500.0) }); } },
    { true,
      [&, grid]
      {
        // In place, and without a word of it.
        vtkDataArray* x = grid->GetXCoordinates();
        const int i = 1 + views.Pick(static_cast<int>(x->GetNumberOfTuples()) - 2);
        const double low = x->GetTuple1(i - 1), high = x->GetTuple1(i + 1);
        x->SetComponent(i, 0, low + views.Between(0.3, 0.7) * (high - low));
      } },
    { false, // tiles may be copied
      [&, grid]
      {
        vtkDataArray* scalars = grid->GetPointData()->GetScalars();
        for (vtkIdType i = views.Pick(9000), end = i + 200; i < end; ++i)
        {
          scalars->SetComponent(i, 0, 1000.0 * views.Pick(3) - 500.0);
        }
        scalars->Modified();
      } },
    { false, [&] { scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume); } },
  };
  others.insert(others.end(), more.begin(), more.end());
  const auto pickOf = [&views](const std::vector<Change>& changes) -> const Change&
  { return changes[static_cast<std::size_t>(views.Pick(static_cast<int>(changes.size())))]; };
  for (int step = 0; step < 150; ++step)
  {
    const std::string what = name + ", step " + std::to_string(step);
    const Change& change = pickOf(views.Pick(3) ? moves : others);
    change.Make();
    Expect(views.Render(), what + ": rendered");
    ++routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
    Expect(!change.IsOfData || step == 0 || IsRoute(scene, "Cold"), what + ": data changed");
    ExpectPromise(scene, cold, what);
    if (views.Pick(4) == 0)
    {
      ExpectRefined(scene, views, cold, what);
    }
  }
  Sweep::Tell(name, routes);
  Expect(routes["ImageCache"] > 10, name + ": too few frames from the image cache");
  Expect(routes["IsomapBuild"] + routes["IsomapLookup"] > 10, name + ": too few isomaps");
}

/// Lengths of vectors are computed once, and nothing of a grid is kept after ClearCache.
void TestVectors()
{
  const auto positive = [](double x, double y, double z) { return std::max(BlobAt(x, y, z), 0.0); };
  Grid grid = Grids::FromFormula(RandomCoordinates(4.0), VTK_FLOAT, positive);
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    vectors->InsertNextTuple2(0.6 * scalars->GetTuple1(i), -0.8 * scalars->GetTuple1(i));
  }
  Scene ofScalars(grid, { 70.0 });
  ofScalars.LookFrom(1.0, 2.0, 0.5);
  Expect(ofScalars.Render(90, 70), "vectors: scalars rendered");
  Grid other = Grids::FromFormula(RandomCoordinates(4.0), VTK_FLOAT, positive);
  other->GetPointData()->SetScalars(vectors);
  Scene scene(other, { 70.0 });
  scene.Mapper->SetVectorModeToMagnitude();
  scene.LookFrom(1.0, 2.0, 0.5);
  for (const char* route : { "Cold", "Redisplay" })
  {
    Expect(scene.Render(90, 70) && IsRoute(scene, route), std::string("vectors: ") + route);
  }
  long different = 0;
  for (int pixel = 0; pixel < 90 * 70; ++pixel)
  {
    const float here = scene.DepthAt(pixel % 90, pixel / 90);
    const float there = ofScalars.DepthAt(pixel % 90, pixel / 90);
    different += std::isinf(here) ? !std::isinf(there) : !(std::abs(here - there) < 1e-4f);
  }
  Expect(different <= 2, "vectors: " + std::to_string(different) + " pixels differ");

  const int references = vectors->GetReferenceCount();
  scene.Mapper->ClearCache();
  Expect(vectors->GetReferenceCount() < references, "the arrays of a grid are let go");
}

void TestThreadsAndLeaping()
{
  Grid grid = Grids::FromFormula(RandomCoordinates(10.0), VTK_SHORT, WavesAt);
  Scene scene(grid, { 200.0, -300.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  ColdWitness witness;
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    scene.Mapper->SetSurfaceMode(mode);
    vtkSMPTools::Initialize(1);
    Expect(scene.Render(333, 222), "threads: rendered");
    for (const int threads : { 2, 7 })
    {
      vtkSMPTools::Initialize(threads);
      witness.Mapper->SetSpaceLeaping(threads == 2);
      Expect(witness.Draw(scene) && witness.IsIdentical(scene),
        std::to_string(threads) + " threads, or plain walks, give another picture");
    }
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// Bad coordinates get one error that tells what and where; the last picture stays.
void TestErrors()
{
  const auto expectError = [](const std::string& word, const std::function<void(Grid&)>& spoil)
  {
    Grid grid = Grids::FromFormula(RandomCoordinates(6.0), VTK_FLOAT, BlobAt);
    Scene scene(grid, { 70.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    Mistake mistake(scene, word);
    spoil(grid);
    mistake.ExpectRefused();
    Expect(mistake.Message.find("vtkRectilinearGrid::Set") != std::string::npos,
      word + ": the message tells what to do");
    scene.Mapper->SetInputData(Grids::FromFormula(RandomCoordinates(6.0), VTK_FLOAT, BlobAt).Get());
    mistake.ExpectMended();
  };
  const auto put = [](int axis, int i, double value)
  {
    return [axis, i, value](Grid& grid)
    {
      vtkDataArray* along[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
        grid->GetZCoordinates() };
      along[axis]->SetComponent(i, 0, value);
    };
  };
  expectError("The y coordinates", put(1, 5, 30.0));
  expectError("at position 6", put(0, 5, 30.0));
  expectError("nan at position 3", put(2, 3, std::numeric_limits<double>::quiet_NaN()));
  expectError("inf at position 0", put(2, 0, std::numeric_limits<double>::infinity()));
  expectError("is followed by -1 at position 1", put(0, 1, -1.0));
  expectError("hold 5 values, but it has 22 points",
    [](Grid& grid) {
      Grids::SetCoordinates(grid, 1, { 0.0, 1.0, 2.0, 3.0, 4.0 });
    });
  expectError("hold 0 values, but", [](Grid& grid) { grid->SetZCoordinates(nullptr); });
}

/// What is empty, but no mistake.
void TestEmpty()
{
  const auto isEmpty = [](const std::string& what, vtkRectilinearGrid* grid)
  {
    Scene scene(grid, { 70.0 });
    scene.Mapper->SetSurfaceModeToThreshold();
    scene.LookFrom(1.0, 2.0, 0.5);
    bool isSeen = !scene.Render(40, 30);
    for (int pixel = 0; pixel < 40 * 30 && !isSeen; ++pixel)
    {
      isSeen = scene.ColorAt(pixel % 40, pixel / 40)[3] != 0;
    }
    Expect(!isSeen, what + ": an empty picture");
  };
  isEmpty("no samples", vtkNew<vtkRectilinearGrid>().Get());
  isEmpty("one slice",
    Grids::FromFormula({ Grids::Random(9, 3.0, 1), Grids::Random(8, 3.0, 2), { 0.5 } }, VTK_FLOAT,
      [](double, double, double) { return 100.0; }));
}

}

int TestRectilinearFrames(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestUniform();
  TestRoutes("gentle",
    Grids::FromFormula({ Grids::FineInside(40, 0.4), Grids::FineInside(34, -0.4), Grids::Even(30) },
      VTK_SHORT, WavesAt),
    3);
  TestRoutes("random", Grids::FromFormula(RandomCoordinates(3.0), VTK_FLOAT, WavesAt), 4);
  TestVectors();
  TestThreadsAndLeaping();
  TestErrors();
  TestEmpty();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
