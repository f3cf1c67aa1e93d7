// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In a cold frame, hit or miss agrees with a double-precision brute-force tracer for at least 99.99
// % of the pixels, depth to 1e-3 voxel for at least 99.9 % of the hits.

#include "Checks/Expect.h"
#include "Checks/Skip.h"
#include "Scenes/Scene.h"
#include "Truth/Agreement.h"
#include "Volumes/Volumes.h"

#include <cstdlib>
#include <string>

namespace
{

void TestVolume(const std::string& name, vtkImageData* image, double isovalue)
{
  Scene scene(image, { isovalue });
  const auto check = [&](const std::string& what)
  {
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { isovalue };
    truth.IsThreshold =
      scene.Mapper->GetSurfaceMode() == vtkTemporalCoherenceVolumeMapper::THRESHOLD;
    ExpectColdTruth(name + ", " + what, scene, truth, 480, 360, 3);
  };

  scene.LookFrom(-1.0, -2.0, 0.8);
  check("from outside");
  scene.LookFrom(0.0, 0.0, 1.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  check("parallel, along an axis");
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.LookFrom(1.0, 0.3, -0.7);
  check("parallel, capped");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
  check("nearest samples");
}

}

/// Of two volumes made by formula; or of a real one and isovalues, which are the arguments.
int TestColdAgainstBruteForce(int argc, char* argv[])
{
  if (argc == 1)
  {
    TestVolume("spheres64", Volumes::FourSpheres(64), 100.0);
    TestVolume("marschner-lobb100", Volumes::MarschnerLobb(100), 128.0);
    return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  const std::string name = argv[1];
  const vtkSmartPointer<vtkImageData> image = Volumes::Load(name);
  if (!image)
  {
    return SkipWithout(name);
  }
  Expect(argc > 2, "isovalues are given");
  for (int i = 2; i < argc; ++i)
  {
    TestVolume(name + ", " + argv[i], image, std::stod(argv[i]));
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
