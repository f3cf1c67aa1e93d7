// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A sweep of 40 isovalues in a still view is looked up and is the cold picture, byte for byte: of
// images and rectilinear grids, with hidden cells, and where cropping leaves several pieces of a
// ray.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Scenes/Subject.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Grids.h"
#include "Volumes/Volumes.h"
#include "Walks/Sweep.h"

#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

/// A volume that makes surfaces harder to find than in a plain image.
struct Case
{
  std::string Name;
  std::function<void(Scene&)> SetUp;
};

std::vector<Case> AllCases()
{
  const auto crop = [](int flags)
  {
    return [flags](Scene& scene)
    {
      scene.Mapper->CroppingOn();
      scene.Mapper->SetCroppingRegionPlanes(-0.5, 0.41, -0.4, 0.6, -0.6, 0.5);
      scene.Mapper->SetCroppingRegionFlags(flags);
    };
  };
  return {
    { "an image", [](Scene&) {} },
    { "a rectilinear grid",
      [](Scene& scene)
      {
        const vtkSmartPointer<vtkImageData> image = Volumes::Waves();
        const auto grid = Grids::FromImage(image, VTK_DOUBLE);
        const std::vector<double> along = Grids::Random(image->GetDimensions()[0], 4.0, 3);
        Grids::SetCoordinates(grid, 0, along);
        scene.Mapper->SetInputData(grid);
      } },
    { "hidden cells",
      [](Scene& scene)
      {
        const vtkSmartPointer<vtkImageData> image = Volumes::Waves();
        Ghosts::HideCells(image, 0.1, 4);
        scene.Mapper->SetInputData(image);
      } },
    { "an inverted cross", crop(VTK_CROP_INVERTED_CROSS) },
    { "an inverted fence", crop(VTK_CROP_INVERTED_FENCE) },
    { "boxes here and there", crop(0x1234567) },
  };
}

std::vector<double> Sweep40()
{
  std::vector<double> isovalues;
  for (int step = 0; step < 40; ++step)
  {
    isovalues.push_back(-300.0 + 15.0 * step);
  }
  return isovalues;
}

/// With IsomapRange set, the first new isovalue builds the isomap, and the others are looked up.
void TestRange(const Case& which, int mode, bool isNearest)
{
  const std::string what = which.Name + (mode == Mapper::CROSSING ? ", CROSSING" : ", THRESHOLD") +
    (isNearest ? ", nearest" : "");
  Scene scene(Volumes::Waves(), {});
  which.SetUp(scene);
  Subject{ {}, {}, {}, mode, isNearest }.Prepare(scene);
  scene.Mapper->SetIsomapRange(-300.0, 300.0);
  scene.LookFrom(0.7, -1.0, 0.5);
  const Sweep::Routes routes = Sweep::ExpectCold(scene, Sweep40(), 96, 72, what);
  const Sweep::Routes expected = { { "Cold", 1 }, { "IsomapBuild", 1 }, { "IsomapLookup", 38 } };
  Expect(routes == expected, what + ": not all are looked up");
}

/// Two isovalues, with and without a tolerance.
void TestSeveral(const Case& which, double tolerance)
{
  const std::string what = which.Name + ", several, tolerance " + std::to_string(tolerance);
  Scene scene(Volumes::Waves(), {});
  which.SetUp(scene);
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.Mapper->SetIsomapTolerance(tolerance);
  scene.Mapper->SetIsomapRange(-300.0, 300.0);
  scene.LookFrom(-1.0, 0.8, 0.5);
  ColdWitness cold;
  int lookUps = 0;
  for (int step = 0; step < 20; ++step)
  {
    scene.SetIsovalues({ 100.0 + 7.0 * step, -200.0 + 3.0 * step });
    Expect(scene.Render(96, 72) && cold.Draw(scene), what + ": rendered");
    lookUps += IsRoute(scene, "IsomapLookup");
    Expect(tolerance > 0.0 ? cold.CountDifferent(scene) < 20 : cold.IsIdentical(scene),
      what + ", step " + std::to_string(step) + ": not the cold picture");
  }
  Expect(lookUps == 18, what + ": " + std::to_string(lookUps) + " look-ups");
}

}

int TestIsomapSweeps(int, char*[])
{
  for (const Case& which : AllCases())
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      TestRange(which, mode, false);
      TestRange(which, mode, true);
    }
    TestSeveral(which, 0.0);
    TestSeveral(which, 0.05);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
