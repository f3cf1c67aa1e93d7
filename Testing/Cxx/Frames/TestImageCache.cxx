// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What frames made from the image cache promise: every picture is compared with the cold one.

#include "Checks/Expect.h"
#include "Checks/Skip.h"
#include "Scenes/Subject.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomViews.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdlib>

namespace
{

constexpr double MedianShare = 1e-4; ///< of the pixels: 0.01 %
constexpr double WorstShare = 5e-4;  ///< 0.05 %

std::vector<Subject> InBothModes(const std::vector<Subject>& volumes)
{
  std::vector<Subject> subjects;
  for (Subject subject : volumes)
  {
    subject.Mode = vtkTemporalCoherenceVolumeMapper::CROSSING;
    subjects.push_back(subject);
    subject.Mode = vtkTemporalCoherenceVolumeMapper::THRESHOLD;
    subjects.push_back(subject);
  }
  return subjects;
}

std::vector<Subject> AllSubjects()
{
  return InBothModes({
    { "Waves", Volumes::Waves(), { 200.0 } },
    { "Waves", Volumes::Waves(), { 200.0, -300.0, 650.0 } },
    { "spheres64", Volumes::Load("spheres64"), { 100.0 } },
    { "marschner-lobb100", Volumes::Load("marschner-lobb100"), { 128.0 } },
    { "Noise", Volumes::Noise(12, VTK_SHORT, -1000.0, 1001.0), { 500.0 } },
  });
}

/// The same, where BOUNDED starts from cached images.
std::vector<Subject> AllBlocks()
{
  std::vector<Subject> subjects = AllSubjects();
  for (Subject& subject : subjects)
  {
    subject.IsNearest = true;
  }
  return subjects;
}

/// The differing share of the pixels, frame by frame.
class Shares
{
public:
  void Add(const Scene& scene, const ColdWitness& cold)
  {
    const vtkIdType pixels = scene.Depth->GetNumberOfPoints();
    const vtkIdType different = cold.CountDifferent(scene);
    this->All.push_back(static_cast<double>(different) / static_cast<double>(pixels));
    // In small pictures a single pixel can be more than the share.
    this->Excess = std::max(
      this->Excess, static_cast<double>(different) - WorstShare * static_cast<double>(pixels));
  }

  std::size_t Count() const { return this->All.size(); }

  double Median(std::size_t begin, std::size_t end) const
  {
    std::vector<double> part(this->All.begin() + static_cast<std::ptrdiff_t>(begin),
      this->All.begin() + static_cast<std::ptrdiff_t>(end));
    std::sort(part.begin(), part.end());
    return part.empty() ? 0.0 : part[part.size() / 2];
  }

  /// \param slack pixels that may differ in the worst frame besides
  void ExpectBounded(const std::string& what, double slack, double medianShare = MedianShare) const
  {
    const double median = this->Median(0, this->All.size());
    Expect(median <= medianShare,
      what + ": " + std::to_string(100.0 * median) + " % of the pixels differ in the median");
    Expect(this->Excess <= slack,
      what + ": the worst frame has " + std::to_string(this->Excess) +
        " pixels more that differ than 0.05 %");
  }

private:
  std::vector<double> All;
  double Excess = 0.0;
};

void WalkExactly(const Subject& subject, unsigned seed, int steps)
{
  Scene scene(subject.Image, subject.Isovalues);
  subject.Prepare(scene);
  scene.Mapper->SetReuseAccuracyToExact();
  RandomViews views(scene, seed, 70);
  ColdWitness cold;
  for (int step = 0; step < steps; ++step)
  {
    const std::string what = "EXACT, " + subject.Describe() + ", step " + std::to_string(step);
    Expect(views.RenderNext() && cold.Draw(scene), what + ": rendered");
    Expect(cold.IsIdentical(scene), what + ": not the cold picture");
    Expect(!IsRoute(scene, "ImageCache"), what + ": told to be from the cache");
  }
}

void TestExact()
{
  unsigned seed = 1;
  for (Subject subject : AllSubjects())
  {
    WalkExactly(subject, seed, 200);
    subject.IsNearest = true;
    WalkExactly(subject, seed, 50);
    ++seed;
  }
}

void TestExactWithThreads()
{
  // The backend of plain threads starts as many as it is told, whatever the machine has.
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    for (const int mode : { 0, 1 })
    {
      WalkExactly(
        { std::to_string(threads) + " thread(s)", Volumes::Waves(), { 200.0, -300.0 }, mode }, 9,
        30);
    }
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// Frames made from one another for two turns and more, each from the latest.
void Orbit(Subject subject, double degrees, int size)
{
  subject.IsNearest = true;
  const std::string what =
    "BOUNDED, " + subject.Describe() + ", orbit of " + std::to_string(degrees) + " degrees";
  Scene scene(subject.Image, subject.Isovalues);
  subject.Prepare(scene);
  scene.Mapper->SetReuseAccuracyToBounded();
  scene.LookFrom(-1.0, -2.0, 0.8);
  ColdWitness cold;
  Shares shares;
  Expect(scene.Render(size, size), what + ": rendered");
  int elsewhere = 0;
  for (int frame = 1; frame <= 720; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(degrees);
    scene.Renderer->ResetCameraClippingRange();
    Expect(scene.Render(size, size), what + ": rendered");
    elsewhere += !IsRoute(scene, "ImageCache");
    if (frame <= 20 || frame % 10 == 0)
    {
      Expect(cold.Draw(scene), what + ": rendered cold");
      shares.Add(scene, cold);
    }
  }
  Expect(elsewhere == 0, what + ": frames are not made from the cache");
  shares.ExpectBounded(what, 0.0);
  const std::size_t count = shares.Count();
  Expect(shares.Median(count - 20, count) <= shares.Median(0, 20) + MedianShare,
    what + ": more pixels differ in the end");
}

void TestBoundedOrbits()
{
  for (const int mode : { 0, 1 })
  {
    Orbit({ "spheres64", Volumes::Load("spheres64"), { 100.0 }, mode }, 0.5, 150);
    Orbit({ "Waves", Volumes::Waves(), { 200.0, -300.0 }, mode }, 1.0, 150);
    Orbit({ "marschner-lobb100", Volumes::Load("marschner-lobb100"), { 128.0 }, mode }, 5.0, 180);
  }
}

/// \param size of the smaller pictures, in pixels
void WalkBounded(const Subject& subject, unsigned seed, int size, int steps)
{
  Scene scene(subject.Image, subject.Isovalues);
  subject.Prepare(scene);
  scene.Mapper->SetReuseAccuracyToBounded();
  RandomViews views(scene, seed, size);
  ColdWitness cold;
  Shares shares;
  const std::string what = "BOUNDED, " + subject.Describe() + ", random views";
  for (int step = 0; step < steps; ++step)
  {
    Expect(views.RenderNext() && cold.Draw(scene), what + ": rendered");
    if (IsRoute(scene, "ImageCache"))
    {
      shares.Add(scene, cold);
    }
    else
    {
      Expect(cold.IsIdentical(scene), what + ": a frame of another route is not cold");
    }
  }
  // After large turns, and close by, frames are cold.
  Expect(shares.Count() > static_cast<std::size_t>(steps / 4),
    what + ": only " + std::to_string(shares.Count()) + " frames are made from the cache");
  shares.ExpectBounded(what, 2.0);
}

void TestBoundedWalks()
{
  unsigned seed = 100;
  for (const Subject& subject : AllBlocks())
  {
    WalkBounded(subject, ++seed, 160, 120);
  }
}

/// What PAPER made does not harm the frames that BOUNDED makes after it.
void TestBoundedAfterPaper()
{
  for (const Subject& subject : AllBlocks())
  {
    Scene scene(subject.Image, subject.Isovalues);
    subject.Prepare(scene);
    scene.LookFrom(-1.0, -2.0, 0.8);
    ColdWitness cold;
    Shares shares;
    const std::string what = "BOUNDED after PAPER, " + subject.Describe();
    for (int frame = 0; frame < 40; ++frame)
    {
      const bool isBounded = frame % 10 > 4;
      scene.Mapper->SetReuseAccuracy(isBounded ? vtkTemporalCoherenceVolumeMapper::BOUNDED
                                               : vtkTemporalCoherenceVolumeMapper::PAPER);
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      scene.Renderer->ResetCameraClippingRange();
      Expect(scene.Render(200, 200) && cold.Draw(scene), what + ": rendered");
      Expect(IsRoute(scene, frame == 0 || frame % 10 == 5 ? "Cold" : "ImageCache"),
        what + ": frame " + std::to_string(frame) + " is " + scene.Mapper->GetRouteAsString());
      if (isBounded)
      {
        shares.Add(scene, cold);
      }
    }
    // White noise is full of films thinner than any pixel: 0.016 % where 0.01 % is promised
    // (Documentation/Performance.md tells so).
    shares.ExpectBounded(what, 0.0, subject.Name == "Noise" ? 2.0 * MedianShare : MedianShare);
  }
}

/// PAPER with the colours of the cached picture: near the cold picture, with fewer samples read.
void TestInterpolation()
{
  for (const Subject& subject : AllSubjects())
  {
    if (subject.Name != "spheres64" && subject.Name != "marschner-lobb100")
    {
      continue;
    }
    Scene scene(subject.Image, subject.Isovalues);
    Scene reshaded(subject.Image, subject.Isovalues);
    reshaded.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    scene.Mapper->SetImageCacheShadingToInterpolate();
    for (Scene* each : { &scene, &reshaded })
    {
      subject.Prepare(*each);
      each->Mapper->SetReuseAccuracyToPaper();
    }
    scene.LookFrom(-1.0, -2.0, 0.8);
    ColdWitness cold;
    const std::string what = "PAPER, " + subject.Describe();
    for (int frame = 0; frame < 30; ++frame)
    {
      Expect(scene.Render(200, 200) && reshaded.Render(200, 200) && cold.Draw(scene),
        what + ": rendered");
      Expect(IsRoute(scene, frame == 0 ? "Cold" : "ImageCache"), what + ": the route");
      for (Scene* each : { &scene, &reshaded })
      {
        const vtkIdType different = cold.CountOtherSilhouettes(*each);
        Expect(20 * different <= cold.Depth->GetNumberOfPoints(),
          what + ": " + std::to_string(different) + " pixels of the silhouette differ");
      }
      Expect(frame == 0 ||
          scene.Mapper->GetNumberOfFieldSamples() < reshaded.Mapper->GetNumberOfFieldSamples(),
        what + ": interpolation saves no samples");
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      scene.Renderer->ResetCameraClippingRange();
    }
  }
}

void TestRealVolume(const Subject& volume)
{
  unsigned seed = 11;
  for (Subject subject : InBothModes({ volume }))
  {
    WalkExactly(subject, seed, 15);
    subject.IsNearest = true;
    WalkBounded(subject, 100 + seed, 800, 24); // finer than voxels
    ++seed;
  }
}

}

/// With volumes made by formula; or with a real one and an isovalue, which are the arguments.
int TestImageCache(int argc, char* argv[])
{
  if (argc == 3)
  {
    const Subject volume = { argv[1], Volumes::Load(argv[1]), { std::stod(argv[2]) } };
    if (!volume.Image)
    {
      return SkipWithout(volume.Name);
    }
    TestRealVolume(volume);
    return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  TestExact();
  TestExactWithThreads();
  TestBoundedOrbits();
  TestBoundedAfterPaper();
  TestBoundedWalks();
  TestInterpolation();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
