// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Without memory for its structures a frame is refused with one error, and the last picture stays.

#include "Checks/Sanitized.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkTesting.h>

#include <cstdlib>
#include <iostream>

#ifdef __linux__
#include <fstream>
#include <sys/resource.h>
#endif

int TestMemory(int, char*[])
{
#ifdef __linux__
  if (IsMemorySanitized)
  {
    std::cout << "SKIPPED: this is a build with a sanitizer, where memory cannot be limited\n";
    return VTK_SKIP_RETURN_CODE;
  }
  bool passed = true;
  const auto expect = [&passed](bool condition, const char* what)
  {
    if (!condition)
    {
      std::cerr << "FAILED: " << what << '\n';
      passed = false;
    }
  };

  Scene scene(Volumes::FourSpheres(32), { 100.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  expect(scene.Render(64, 64), "a small volume");
  vtkNew<vtkImageData> color;
  color->DeepCopy(scene.Color);

  // The block ranges of this image take 16 MiB.
  vtkNew<vtkImageData> large;
  large->SetDimensions(513, 513, 513);
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

  expect(!rendered, "refused");
  expect(observer->GetError() &&
      observer->GetErrorMessage().find("not enough memory") != std::string::npos,
    "the error names memory");
  expect(AreIdentical(color, scene.Color), "the images are left alone");
  expect(scene.Mapper->PickPixel(32, 32, nullptr, nullptr, nullptr) ||
      scene.Mapper->PickPixel(24, 24, nullptr, nullptr, nullptr) ||
      scene.Mapper->PickPixel(40, 40, nullptr, nullptr, nullptr),
    "the last picture can still be picked");
  scene.Mapper->SetInputData(Volumes::FourSpheres(32));
  expect(scene.Render(64, 64) && AreIdentical(color, scene.Color), "and rendered again");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
#else
  std::cout << "SKIPPED: no limit on memory can be set on this system\n";
  return VTK_SKIP_RETURN_CODE;
#endif
}
