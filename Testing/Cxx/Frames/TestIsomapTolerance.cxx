// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// With a tolerance, no surface is farther from the cold one than that, and a larger tolerance takes
// less memory. With INTERPOLATE, surfaces stay where they are, and colours are near those of the
// field.

#include "Checks/Expect.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Walks/Sweep.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr int Width = 61, Height = 47; ///< with tiles that are not full

/// Knots are kept in single precision: an isovalue is not told from others so near to it, as a
/// share of all values.
constexpr double Rounding = 1e-7;

/// Cold frames of an isovalue and of two that are hardly other ones. A ray that grazes a surface
/// shows it in some of them only.
class ColdNeighbors
{
public:
  explicit ColdNeighbors(double apart)
    : Apart(apart)
  {
  }

  void Draw(Scene& scene, double isovalue)
  {
    for (int i = 0; i < 3; ++i)
    {
      scene.SetIsovalues({ isovalue + (i - 1) * this->Apart });
      Expect(this->Frames[static_cast<std::size_t>(i)].Draw(scene), "rendered cold");
    }
    scene.SetIsovalues({ isovalue });
  }

  /// Pixels of the scene's picture that are farther than `distance` from all three.
  vtkIdType CountFarther(const Scene& scene, double distance) const
  {
    const auto* made = static_cast<const float*>(scene.Depth->GetScalarPointer());
    std::array<const float*, 3> cold{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      cold[i] = static_cast<const float*>(this->Frames[i].Depth->GetScalarPointer());
    }
    vtkIdType count = 0;
    for (vtkIdType pixel = 0; pixel < scene.Depth->GetNumberOfPoints(); ++pixel)
    {
      const double t = static_cast<double>(made[pixel]);
      count += std::none_of(cold.begin(), cold.end(),
        [&](const float* frame)
        {
          const double truth = static_cast<double>(frame[pixel]);
          return std::isinf(t) || std::isinf(truth) ? t == truth : std::abs(t - truth) <= distance;
        });
    }
    return count;
  }

private:
  double Apart;
  std::array<ColdWitness, 3> Frames;
};

double ShortestEdge(const Scene& scene)
{
  // Tests below scale nothing: spacing is that of the world.
  const double* spacing = vtkImageData::SafeDownCast(scene.Mapper->GetInput())->GetSpacing();
  return std::min({ spacing[0], spacing[1], spacing[2] });
}

void SweepField(
  const Subject& subject, const Sweep::Placing& placing, double tolerance, unsigned seed)
{
  std::ostringstream name;
  name << "tolerance " << tolerance << ", " << subject.Describe() << ", " << placing.Name;
  const std::vector<double> samples = Sweep::FiniteSamplesOf(subject);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  Scene scene(subject.Image, { *low - 1.0 });
  subject.Prepare(scene);
  placing.SetCamera(scene);
  scene.Mapper->SetIsomapTolerance(tolerance);
  Expect(scene.Render(Width, Height), name.str() + ": rendered");
  std::vector<double> isovalues = Sweep::Up(subject, 60);
  const std::vector<double> more = Sweep::Jumps(subject, 30, seed);
  isovalues.insert(isovalues.end(), more.begin(), more.end());
  ColdNeighbors cold(Rounding * std::max(*high - *low, 1.0));
  int wrong = 0;
  vtkIdType pixels = 0;
  std::ostringstream first;
  first.precision(17);
  for (const double isovalue : isovalues)
  {
    scene.SetIsovalues({ isovalue });
    Expect(scene.Render(Width, Height), name.str() + ": rendered");
    cold.Draw(scene, isovalue);
    // The depth image is in single precision.
    const double distance = 1.0001 * tolerance * ShortestEdge(scene) +
      2e-7 * scene.Renderer->GetActiveCamera()->GetClippingRange()[1];
    const vtkIdType farther = cold.CountFarther(scene, distance);
    if (farther > 0 && wrong++ == 0)
    {
      first << isovalue << ", " << scene.Mapper->GetStatistics()->GetRouteAsString();
    }
    pixels += farther;
  }
  Expect(wrong == 0,
    name.str() + ": " + std::to_string(wrong) + " of " + std::to_string(isovalues.size()) +
      " frames have pixels too far from the cold frame, " + std::to_string(pixels) +
      " in all; the first is of isovalue " + first.str());
}

void TestAllFields()
{
  const std::vector<Sweep::Placing> placings = Sweep::AllPlacings();
  std::size_t turn = 0;
  for (Subject subject : Sweep::AllFields())
  {
    for (subject.Mode = 0; subject.Mode < 2; ++subject.Mode)
    {
      for (const double tolerance : { 0.02, 0.5 })
      {
        const Sweep::Placing& placing = placings[++turn % 5];
        SweepField(subject, placing, tolerance, static_cast<unsigned>(turn));
      }
    }
    ++turn;
  }
}

/// Two sheets behind one another, the nearer of the lower maximum, which is another one for each
/// ray: what does not come up to an isovalue is leapt over, and no surface is shown between them.
void TestNothingAcrossAJump()
{
  const vtkSmartPointer<vtkImageData> sheets = Volumes::FromFormula(40, VTK_FLOAT,
    [](double x, double y, double z)
    {
      const auto sheet = [z](double at) { return std::exp(-std::pow((z - at) / 0.15, 2.0)); };
      return (100.0 + 20.0 * x + 5.0 * y) * sheet(0.5) + 200.0 * sheet(-0.5);
    });
  for (const double tolerance : { 0.1, 2.0, 30.0 })
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      const std::string what = "two sheets, tolerance " + std::to_string(tolerance);
      Scene scene(sheets, { 20.0 });
      scene.Mapper->SetSurfaceMode(mode);
      scene.Mapper->SetIsomapTolerance(tolerance);
      scene.Mapper->SetIsomapRange(20.0, 150.0);
      scene.LookFrom(0.0, 0.0, 1.0);
      Expect(scene.Render(80, 80), what + ": rendered");
      int near = 0, far = 0, between = 0;
      for (double isovalue = 21.0; isovalue < 150.0; isovalue += 0.7)
      {
        scene.SetIsovalues({ isovalue });
        Expect(scene.Render(80, 80), what + ": rendered");
        Expect(IsRoute(scene, "IsomapBuild") || IsRoute(scene, "IsomapLookup"), what + ": route");
        for (int pixel = 0; pixel < 6400; ++pixel)
        {
          double position[3];
          if (scene.Mapper->PickPixel(pixel % 80, pixel / 80, position, nullptr, nullptr))
          {
            // Of the nearer sheet, its front side or (a large tolerance) its middle.
            const bool isBetween = position[2] > 0.0 && position[2] < 0.45;
            between += isBetween;
            near += position[2] >= 0.45;
            far += position[2] <= 0.0;
          }
        }
      }
      Expect(near > 10000 && far > 10000, what + ": not both are seen");
      Expect(between == 0, what + ": " + std::to_string(between) + " pixels lie between");
    }
  }
}

/// A larger tolerance takes less memory.
void TestMemory()
{
  for (const char* name : { "spheres48", "marschner-lobb40" })
  {
    vtkIdType before = 0;
    for (const double tolerance : { 0.0, 0.02, 0.2, 1.0 })
    {
      Scene scene(Volumes::Load(name), { 100.0 });
      scene.LookFrom(1.0, 2.0, 0.5);
      scene.Mapper->SetIsomapRange(0.0, 255.0);
      scene.Mapper->SetIsomapTolerance(tolerance);
      Expect(scene.Render(160, 120) && scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume),
        "memory: built");
      const vtkIdType memory = scene.Mapper->GetStatistics()->GetIsomapMemory();
      // Knots of tolerance 0 are of another kind.
      Expect(before == 0 || tolerance == 0.02 || memory < before,
        std::string(name) + ": tolerance " + std::to_string(tolerance) + " takes " +
          std::to_string(memory) + " bytes, a smaller one " + std::to_string(before));
      before = memory;
    }
  }
}

/// Faces between nearest samples are where they are, whatever the tolerance.
void TestNearest()
{
  Subject subject{ "waves", Volumes::Waves(), {} };
  subject.IsNearest = true;
  for (subject.Mode = 0; subject.Mode < 2; ++subject.Mode)
  {
    Scene scene(subject.Image, { 0.0 });
    subject.Prepare(scene);
    scene.LookFrom(1.0, 2.0, 0.5);
    scene.Mapper->SetIsomapTolerance(0.5);
    Sweep::ExpectCold(scene, Sweep::Up(subject, 40), Width, Height, subject.Describe());
  }
}

/// Mean difference of the colours where both show a surface.
double ColorDifference(const Scene& scene, const ColdWitness& cold)
{
  const auto* a = static_cast<const unsigned char*>(scene.Color->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(cold.Color->GetScalarPointer());
  double sum = 0.0;
  int count = 0;
  for (vtkIdType i = 0; i < 4 * scene.Color->GetNumberOfPoints(); ++i)
  {
    const vtkIdType alpha = i | 3;
    if (i != alpha && a[alpha] != 0 && b[alpha] != 0)
    {
      sum += std::abs(a[i] - b[i]);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

/// With INTERPOLATE surfaces stay where they are, normals have unit length and face the viewer, and
/// colours are near those of the field.
void TestInterpolation()
{
  for (const double tolerance : { 0.0, 0.1 })
  {
    const std::string what = "INTERPOLATE, tolerance " + std::to_string(tolerance);
    Scene scene(Volumes::Load("spheres64"), { 80.0 });
    Scene reshaded(Volumes::Load("spheres64"), { 80.0 });
    reshaded.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    scene.LookFrom(1.0, 2.0, 0.5);
    scene.Mapper->SetIsomapShadingToInterpolate();
    for (Scene* each : { &scene, &reshaded })
    {
      each->Mapper->SetIsomapTolerance(tolerance);
      Expect(each->Render(120, 100), what + ": rendered");
    }
    ColdWitness cold;
    const double* eye = scene.Renderer->GetActiveCamera()->GetPosition();
    for (const double isovalue : { 81.0, 90.0, 120.0, 60.0, 81.5, 200.0 })
    {
      for (Scene* each : { &scene, &reshaded })
      {
        each->SetIsovalues({ isovalue });
        Expect(each->Render(120, 100), what + ": rendered");
      }
      Expect(AreIdentical(scene.Depth, reshaded.Depth), what + ": colours move surfaces");
      Expect(cold.Draw(scene), what + ": rendered cold");
      const double difference = ColorDifference(scene, cold);
      // On a surface with a radius of a few voxels, as that of the highest isovalue, the normals of
      // neighbouring knots differ much.
      Expect(difference < (isovalue == 200.0 ? 13.0 : 6.0),
        what + ", isovalue " + std::to_string(isovalue) + ": colours differ by " +
          std::to_string(difference));
      int bad = 0;
      for (int pixel = 0; pixel < 12000; ++pixel)
      {
        double position[3], normal[3];
        if (scene.Mapper->PickPixel(pixel % 120, pixel / 120, position, normal, nullptr))
        {
          const double toEye[3] = { eye[0] - position[0], eye[1] - position[1],
            eye[2] - position[2] };
          bad += std::abs(vtkMath::Norm(normal) - 1.0) > 1e-5 || vtkMath::Dot(normal, toEye) < 0.0;
        }
      }
      Expect(bad == 0, what + ": " + std::to_string(bad) + " bad normals");
    }
  }
}

/// A picture that may be wrong is completed when the view repeats, and harms no later one.
void TestAfterwards()
{
  for (const bool isInterpolated : { false, true })
  {
    const std::string what = isInterpolated ? "after INTERPOLATE" : "after a tolerance";
    Scene scene(Volumes::Waves(), { 200.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    scene.Mapper->SetIsomapTolerance(isInterpolated ? 0.0 : 0.5);
    scene.Mapper->SetIsomapShading(isInterpolated);
    ColdWitness cold;
    const auto render = [&] { return scene.Render(150, 120) && cold.Draw(scene); };
    Expect(render() && cold.IsIdentical(scene), what + ": first");
    for (int step = 0; step < 20; ++step)
    {
      scene.SetIsovalues({ 210.0 + 10.0 * (step % 7) });
      Expect(render(), what + ": another isovalue");
      if (step % 2)
      {
        Expect(render() && cold.IsIdentical(scene), what + ": not completed when still");
      }
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      scene.Renderer->ResetCameraClippingRange();
      Expect(render() && 2000 * cold.CountDifferent(scene) <= scene.Depth->GetNumberOfPoints(),
        what + ": moved, " + scene.Mapper->GetStatistics()->GetRouteAsString() + ", " +
          std::to_string(cold.CountDifferent(scene)) + " pixels differ");
    }
    // Exact ones are not mixed with others.
    scene.SetIsovalues({ 300.0 });
    Expect(render(), what + ": once more");
    scene.Mapper->SetIsomapTolerance(0.0);
    scene.Mapper->SetIsomapShadingToReshade();
    scene.SetIsovalues({ 301.0 });
    Expect(render() && cold.IsIdentical(scene), what + ": exact again");
  }
}

}

int TestIsomapTolerance(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which are among the samples.
  vtkFloatingPointExceptions::Disable();
  TestAllFields();
  TestNothingAcrossAJump();
  TestMemory();
  TestNearest();
  TestInterpolation();
  TestAfterwards();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
