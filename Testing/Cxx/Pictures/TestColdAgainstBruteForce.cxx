// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The contract of a cold frame: hit or miss agrees with a double-precision brute-force tracer for
// at least 99.99 % of the pixels, depth to 1e-3 voxel for at least 99.9 % of the hits.

#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <cstdlib>
#include <iostream>

namespace
{

bool TestVolume(const Volumes::Sample& sample)
{
  vtkSmartPointer<vtkImageData> image = Volumes::Load(sample.Name);
  if (!image)
  {
    std::cout << sample.Name << ": not there, skipped\n";
    return true;
  }
  Scene scene(image, { sample.Isovalue });
  bool agrees = true;
  const auto check = [&](const std::string& what)
  {
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { sample.Isovalue };
    truth.IsThreshold =
      scene.Mapper->GetSurfaceMode() == vtkTemporalCoherenceVolumeMapper::THRESHOLD;
    agrees &= AgreesWithTruth(sample.Name + ", " + what, scene, truth, 480, 360, 3);
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
  return agrees;
}

}

int TestColdAgainstBruteForce(int, char*[])
{
  bool agrees = true;
  for (const Volumes::Sample& sample :
    std::vector<Volumes::Sample>{ { "spheres64", 100 }, { "marschner-lobb100", 128 },
      { "engine.vti", 70 }, { "engine.vti", 180 }, { "brain.vti", 40 }, { "cthead.vti", 600 },
      { "bonsai.vti", 40 }, { "isabel.vti", 20 }, { "homo.vti", -0.03 }, { "homo.vti", 0.03 },
      { "hydrogen.vti", 0.1 }, { "ironProt.vtk", 128 } })
  {
    agrees &= TestVolume(sample);
  }
  return agrees ? EXIT_SUCCESS : EXIT_FAILURE;
}
