// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Without an isomap the last hits bound the search for the next ones, and the picture is the cold
// one to the last bit.

#include "Checks/Expect.h"
#include "Walks/Sweep.h"

#include <vtkFloatingPointExceptions.h>

#include <cstdlib>

namespace
{

constexpr int Width = 61, Height = 47; ///< with tiles that are not full

void SweepField(Subject subject, const Sweep::Placing& placing, unsigned seed)
{
  const std::string what = "ThresholdHint, " + subject.Describe() + ", " + placing.Name;
  Scene scene(subject.Image, { 0.0 });
  scene.Mapper->IsomapOff();
  subject.Prepare(scene);
  placing.SetCamera(scene);
  std::vector<double> isovalues = Sweep::Up(subject, 50);
  const std::vector<double> down(isovalues.rbegin(), isovalues.rend());
  const std::vector<double> jumps = Sweep::Jumps(subject, 60, seed);
  isovalues.insert(isovalues.end(), down.begin(), down.end());
  isovalues.insert(isovalues.end(), jumps.begin(), jumps.end());
  const Sweep::Routes routes = Sweep::ExpectCold(scene, isovalues, Width, Height, what);
  Sweep::ExpectOnly({ "ThresholdHint" }, routes, what);
  Expect(scene.Mapper->GetIsomapMemory() == 0, what + ": there is an isomap");
}

}

int TestThresholdHint(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which are among the samples.
  vtkFloatingPointExceptions::Disable();
  unsigned seed = 1;
  for (Subject subject : Sweep::AllFields())
  {
    for (const Sweep::Placing& placing : Sweep::AllPlacings())
    {
      for (subject.Mode = 0; subject.Mode < 2; ++subject.Mode)
      {
        subject.IsNearest = ++seed % 4 == 0;
        SweepField(subject, placing, seed);
      }
    }
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
