// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures of a moved camera keep the promise of their accuracy: each one is compared with the cold
// picture.

#include "Checks/Expect.h"
#include "Checks/Skip.h"
#include "Scenes/Subject.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomViews.h"

#include <vtkSMPTools.h>

#include <cstdlib>

namespace
{

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
          scene.Mapper->GetStatistics()->GetNumberOfFieldSamples() <
            reshaded.Mapper->GetStatistics()->GetNumberOfFieldSamples(),
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
    WalkExactly(subject, 100 + seed, 15);
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
  TestInterpolation();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
