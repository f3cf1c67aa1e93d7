// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The distance between samples counts only where fixed steps are asked for: then ever smaller ones
// lead to the converged picture.

#include "BlendedScene.h"
#include "Checks/Expect.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 48;

std::vector<unsigned char> Colors(Scene& scene)
{
  vtkNew<vtkImageData> color, depth;
  Expect(scene.Mapper->MakeImage(scene.Renderer, scene.Volume, Size, Size, color, depth),
    "the picture is made");
  auto* const bytes = vtkUnsignedCharArray::SafeDownCast(color->GetPointData()->GetArray("Color"));
  return { bytes->Begin(), bytes->End() };
}

/// The mean difference of two pictures.
double Distance(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
  }
  return sum / static_cast<double>(a.size());
}

void TestMode(int mode)
{
  const std::string name = NameOfMode(mode);
  BlendedScene scene(mode);
  const std::vector<unsigned char> converged = Colors(scene);
  for (const float distance : { 0.01f, 1.0f, 7.0f, -1.0f })
  {
    scene.Mapper->SetSampleDistance(distance);
    Expect(Colors(scene) == converged, name + ": a distance alone changes no byte");
  }

  scene.Mapper->FixedStepSamplingOn();
  scene.Mapper->SetSampleDistance(5.0f);
  const double coarse = Distance(Colors(scene), converged);
  scene.Mapper->SetSampleDistance(0.05f);
  const double fine = Distance(Colors(scene), converged);
  Expect(coarse > 0.1 && fine < 0.3 && fine < 0.2 * coarse,
    name + ": steps converge: " + std::to_string(coarse) + ", " + std::to_string(fine));
  scene.Mapper->SetSampleDistance(0.0f);
  Expect(Colors(scene) == converged, name + ": a distance of 0 is no step");

  scene.Mapper->SetSampleDistance(5.0f);
  scene.Mapper->FixedStepSamplingOff();
  Expect(Colors(scene) == converged, name + ": switched off");
}

}

int TestBlendedSteps(int, char*[])
{
  for (const int mode : BlendModes)
  {
    TestMode(mode);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
