// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// With lengths far beyond those of any volume, leaping finds what is found without it.

#include "Checks/Expect.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace
{

vtkIdType CountHits(vtkImageData* depth)
{
  vtkIdType hits = 0;
  for (vtkIdType i = 0; i < depth->GetNumberOfPoints(); ++i)
  {
    hits += std::isfinite(static_cast<float*>(depth->GetScalarPointer())[i]);
  }
  return hits;
}

/// The scene as it stands, by a mapper that leaps and one that does not.
/// \return hits
vtkIdType ExpectSameByLeaping(Scene& scene, const std::string& what)
{
  ColdWitness plain;
  plain.Mapper->SpaceLeapingOff();
  scene.Mapper->ClearCache();
  Expect(scene.Render(33, 28) && plain.Draw(scene), what + ": rendered");
  Expect(plain.IsIdentical(scene), what + ": another picture by leaping");
  return CountHits(plain.Depth);
}

/// One edge of the cells, or all, of any length.
void TestLongEdges()
{
  const std::array<std::array<double, 3>, 9> spacings = { { { 1.0, 1e34, 1.0 }, { 1.0, -1e34, 1.0 },
    { 1e60, 1.0, 1.0 }, { 1.0, 1e154, 1.0 }, { 1.0, 1.0, 1e-20 }, { 1e18, 1e18, 1e18 },
    { 1e40, 1e40, 1e40 }, { 1e-40, 1e-40, 1e-40 }, { 1e-44, 1e-44, 1e-44 } } };
  vtkIdType hits = 0;
  for (const std::array<double, 3>& spacing : spacings)
  {
    const vtkSmartPointer<vtkImageData> image = Volumes::Noise(9, VTK_UNSIGNED_CHAR, 0.0, 200.0);
    image->SetOrigin(0.0, 0.0, 0.0);
    image->SetSpacing(spacing.data());
    Scene scene(image, { 100.0 });
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    for (const bool isParallel : { false, true })
    {
      camera->SetParallelProjection(isParallel);
      const std::string what = "spacing " + std::to_string(std::log10(std::abs(spacing[0]))) +
        ", " + std::to_string(std::log10(std::abs(spacing[1]))) + (isParallel ? ", parallel" : "");
      // From nearby, along the long edges and across them.
      const double unit = std::min(std::min(spacing[0], std::abs(spacing[1])), spacing[2]);
      for (const auto& [x, y] : { std::array{ -6.0, 3.0 }, { -6.0, -6.0 }, { 4.0, -9.0 } })
      {
        camera->SetPosition(x * unit, y * unit, 3.0 * unit);
        camera->SetFocalPoint(3.0 * unit, 3.0 * unit, 3.0 * unit);
        camera->SetViewUp(0.0, 0.0, 1.0);
        camera->SetParallelScale(5.0 * unit);
        camera->SetClippingRange(0.1 * unit, 100.0 * unit);
        hits += ExpectSameByLeaping(scene, what);
      }
    }
  }
  Expect(hits > 10000, "something is seen: " + std::to_string(hits));
}

/// The volume and the camera are far from the origin.
void TestFarAway()
{
  vtkIdType hits = 0;
  for (const double far : { 1e6, 1e10, 1e13 })
  {
    const vtkSmartPointer<vtkImageData> image = Volumes::Noise(9, VTK_UNSIGNED_CHAR, 0.0, 200.0);
    image->SetSpacing(1.0, 1.0, 1.0);
    image->SetOrigin(far, -far, far);
    Scene scene(image, { 100.0 });
    scene.LookFrom(1.0, -2.0, 0.4);
    for (const double degrees : { 7.0, 60.0, 95.0 })
    {
      scene.Renderer->GetActiveCamera()->Azimuth(degrees);
      scene.Renderer->ResetCameraClippingRange();
      hits += ExpectSameByLeaping(scene, std::to_string(far) + " away");
    }
  }
  Expect(hits > 1000, "something is seen far away: " + std::to_string(hits));
}

/// Where products of lengths are no numbers any more nothing need be seen, but nothing breaks.
void TestBeyondNumbers()
{
  for (const double far : { 1e120, 1e200, 1e300, 1.7976931348623157e308 })
  {
    const vtkSmartPointer<vtkImageData> image = Volumes::Noise(9, VTK_UNSIGNED_CHAR, 0.0, 200.0);
    image->SetSpacing(1.0, 1.0, 1.0);
    Scene scene(image, { 100.0 });
    scene.LookFrom(1.0, -2.0, 0.4);
    for (const bool isParallel : { false, true })
    {
      scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
      image->SetOrigin(0.0, far, 0.0);
      ExpectSameByLeaping(scene, std::to_string(std::log10(far)) + " away");
      image->SetOrigin(-far, far, 0.5 * far);
      ExpectSameByLeaping(scene, std::to_string(std::log10(far)) + " away along all axes");
    }
  }
}

/// A clipping range that begins behind the eye shows nothing behind it.
void TestBehindTheEye()
{
  Scene scene(Volumes::Noise(9, VTK_UNSIGNED_CHAR, 0.0, 200.0), { 100.0 });
  scene.LookFrom(1.0, -2.0, 0.4);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(camera->GetFocalPoint()); // inside
  camera->SetFocalPoint(0.9, 0.1, 0.2);
  camera->SetClippingRange(-1e196, 100.0);
  Expect(ExpectSameByLeaping(scene, "from behind the eye on") > 100, "something is seen inside");
  const auto* depths = static_cast<const float*>(scene.Depth->GetScalarPointer());
  Expect(std::all_of(depths, depths + scene.Depth->GetNumberOfPoints(),
           [](float depth) { return depth >= 0.0f; }),
    "nothing is behind the eye");
}

/// Surfaces that are too faint to be seen have no colour, not even that of their answer.
void TestTooFaint()
{
  Scene scene(Volumes::Noise(12, VTK_UNSIGNED_CHAR, 0.0, 200.0), { 100.0 });
  scene.LookFrom(1.0, -2.0, 0.4);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 1e-38);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  scene.Mapper->ColorByAnswerOn();
  scene.Mapper->SetReuseAccuracyToPaper();
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(1.0);
    Expect(scene.Render(60, 60), "rendered");
  }
  Expect(IsRoute(scene, "ImageCache"), "from a cached image");
  const auto* colors = static_cast<const unsigned char*>(scene.Color->GetScalarPointer());
  Expect(std::count(colors, colors + 4 * scene.Color->GetNumberOfPoints(), 0) ==
      4 * scene.Color->GetNumberOfPoints(),
    "nothing is painted where nothing is seen");
}

}

int TestExtremes(int, char*[])
{
  // The Debug driver traps overflow, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestLongEdges();
  TestFarAway();
  TestBeyondNumbers();
  TestBehindTheEye();
  TestTooFaint();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
