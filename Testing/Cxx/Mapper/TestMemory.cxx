// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Without memory for its structures a frame is refused with one error, and the last picture stays.

#include "Checks/Expect.h"
#include "Checks/Sanitized.h"
#include "Checks/Skip.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>

#ifdef __linux__
#include <fstream>
#include <sys/resource.h>
#endif

int TestMemory(int, char*[])
{
#ifdef __linux__
  if (IsMemorySanitized)
  {
    return Skip("this is a build with a sanitizer, where memory cannot be limited");
  }
  Scene scene(Volumes::FourSpheres(32), { 100.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(64, 64), "a small volume");
  vtkNew<vtkImageData> color;
  color->DeepCopy(scene.Color);

  // The block ranges of this image take 65 MiB, more than an arena of glibc reserves beforehand.
  vtkNew<vtkImageData> large;
  large->SetDimensions(1025, 513, 513);
  large->AllocateScalars(VTK_DOUBLE, 1);
  scene.Mapper->SetInputData(large);
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);

  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  rlimit narrow = before;
  narrow.rlim_cur = static_cast<rlim_t>(pages) * 4096 + (4u << 20);
  setrlimit(RLIMIT_AS, &narrow);
  const bool rendered = scene.Render(64, 64);
  setrlimit(RLIMIT_AS, &before);

  Expect(!rendered, "refused");
  Expect(observer->GetErrorMessage().find("not enough memory") != std::string::npos,
    "the error names memory, but is: " + observer->GetErrorMessage());
  Expect(AreIdentical(color, scene.Color), "the images are left alone");
  Expect(scene.Mapper->PickPixel(32, 32, nullptr, nullptr, nullptr) ||
      scene.Mapper->PickPixel(24, 24, nullptr, nullptr, nullptr) ||
      scene.Mapper->PickPixel(40, 40, nullptr, nullptr, nullptr),
    "the last picture can still be picked");
  scene.Mapper->SetInputData(Volumes::FourSpheres(32));
  Expect(scene.Render(64, 64) && AreIdentical(color, scene.Color), "and rendered again");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
#else
  return Skip("no limit on memory can be set on this system");
#endif
}
