// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Masks that change, and mistakes in them: every frame is the cold one of the mask that is there,
// by all routes, also behind the mapper that takes the place of VTK's.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Subject.h"
#include "Truth/Agreement.h"
#include "Truth/ImageBlocks.h"
#include "Truth/MaskedTruth.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Masks.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomChanges.h"
#include "Walks/Sweep.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"

#include <vtkDataArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <cstdlib>
#include <cstring>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;
using Image = vtkSmartPointer<vtkImageData>;

constexpr int N = 32; ///< samples along each axis of the waves

/// Whatever becomes of a mask is seen in the next frame, also when it comes back.
void TestChanges()
{
  const Image image = Volumes::Waves();
  const Image first = Masks::For(image, Masks::Random(0.9, 1));
  const Image second = Masks::For(image, [](int i, int, int) { return i < 13; });
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  const auto expectChange = [&](const std::string& what, vtkImageData* mask)
  {
    Expect(scene.Render(80, 60) && IsRoute(scene, "Cold"),
      what + ": the route is " + scene.Mapper->GetStatistics()->GetRouteAsString());
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 200.0 };
    if (mask)
    {
      Masks::Hide(mask, truth.Field);
    }
    const Agreement agreement = CompareWithTruth(scene, truth);
    Expect(
      agreement.Hits > 100 && agreement.DifferentHits == 0, what + ": " + agreement.Describe());
    Expect(scene.Render(80, 60) && IsRoute(scene, "Redisplay"), what + ": again");
  };
  expectChange("none", nullptr);
  Masks::SetBinary(scene.Mapper, first);
  expectChange("set", first);
  Masks::SetBinary(scene.Mapper, second);
  expectChange("another", second);
  Masks::SetBinary(scene.Mapper, first);
  expectChange("the first again", first);
  vtkDataArray* values = first->GetPointData()->GetScalars();
  const double before = values->GetComponent(0, 0);
  for (vtkIdType i = 0; i < 15000; ++i)
  {
    values->SetComponent(i, 0, 0.0);
  }
  values->Modified();
  expectChange("written, the array told", first);
  for (vtkIdType i = 0; i < 8000; ++i)
  {
    values->SetComponent(i, 0, 1.0 + before);
  }
  first->Modified();
  expectChange("written, the image told", first);
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(first);
  first->GetPointData()->SetScalars(second->GetPointData()->GetScalars());
  expectChange("another array", second);
  first->GetPointData()->SetScalars(copy->GetPointData()->GetScalars());
  expectChange("and back", copy);
  scene.Mapper->SetMaskInput(nullptr);
  expectChange("removed", nullptr);

  // A line of sight meets what is shown.
  double t, p1[3] = { -3.0, 0.1, 0.2 }, p2[3] = { 3.0, 0.1, 0.2 }, at[3], shown[3];
  Expect(scene.Mapper->IntersectWithLine(scene.Volume, p1, p2, t, at, nullptr, nullptr),
    "a line meets the surface");
  Masks::SetBinary(scene.Mapper, Masks::For(image, [](int i, int, int) { return i > 20; }));
  Expect(scene.Mapper->IntersectWithLine(scene.Volume, p1, p2, t, shown, nullptr, nullptr) &&
      shown[0] > at[0] && shown[0] > -1.0 + 20 * 2.0 / (N - 1) - 1e-9,
    "but not where it is masked");
}

void TestMistakes()
{
  const Image image = Volumes::Waves();
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  const auto expectRefused = [&](const std::string& word, vtkImageData* mask)
  {
    Mistake mistake(scene, word);
    Masks::SetBinary(scene.Mapper, mask);
    mistake.ExpectRefused();
    Masks::SetBinary(scene.Mapper, nullptr);
    mistake.ExpectMended();
  };
  const auto all = [](int, int, int) { return 255; };
  const int fewer[3] = { N, N - 1, N };
  expectRefused("The mask has 32 x 31 x 32 values", Masks::Make(fewer, VTK_UNSIGNED_CHAR, all));
  expectRefused("have the type float", Masks::For(image, all, VTK_FLOAT));
  vtkNew<vtkImageData> empty;
  expectRefused("The mask has no scalars", empty);
  vtkNew<vtkImageData> two;
  two->SetDimensions(N, N, N);
  two->AllocateScalars(VTK_UNSIGNED_CHAR, 2);
  expectRefused("of the mask has 2 components", two);
  const Image shorter = Masks::For(image, all);
  shorter->GetPointData()->GetScalars()->SetNumberOfTuples(7);
  expectRefused("of the mask has 7 values", shorter);

  // Blocks have no samples in common.
  const auto blocks = ImageBlocks::Blocks(
    image, { { 0, 16, 0, N - 1, 0, N - 1 }, { 16, N - 1, 0, N - 1, 0, N - 1 } });
  scene.Mapper->SetInputDataObject(blocks);
  Expect(scene.Render(80, 60), "blocks: rendered");
  Masks::SetBinary(scene.Mapper, Masks::For(image, all));
  const EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  Expect(!scene.Render(80, 60) && !scene.Render(80, 60) && errors.Count == 1, "blocks: refused");
  scene.Mapper->SetMaskTypeToLabelMap();
  Expect(scene.Render(80, 60), "a label map that hides nothing may be anything");
}

/// Isovalues that change: the picture is the cold one.
void TestSweeps()
{
  for (const Masks::Named& named : Masks::All())
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      const Subject subject = { "Waves, " + named.Name, Volumes::Waves(), {}, mode };
      Scene scene(subject.Image, {});
      subject.Prepare(scene);
      Masks::SetBinary(scene.Mapper, Masks::For(subject.Image, named.Value));
      scene.LookFrom(1.0, 2.0, 0.5);
      const std::string what = subject.Describe();
      Sweep::Routes routes =
        Sweep::ExpectCold(scene, Sweep::Jumps(subject, 20, 5), 60, 45, what + ", jumps");
      scene.Mapper->SetIsomapRange(-1000.0, 1000.0);
      for (const auto& [route, count] :
        Sweep::ExpectCold(scene, Sweep::Up(subject, 12), 60, 45, what + ", up"))
      {
        routes[route] += count;
      }
      Expect(routes["IsomapBuild"] > 0 && routes["IsomapLookup"] > 0, what + ": other routes");
    }
  }
}

/// Changes of all kinds in random order, of masks among them.
void TestRandomChanges(unsigned seed, int steps)
{
  const Image image = Volumes::Waves();
  Scene scene(image, { 0.0 });
  RandomViews views(scene, seed, 80);
  const Image kept = Masks::For(image, Masks::Random(0.85, seed));
  const auto chance = [&] { return views.Between(0.7, 0.97); };
  const auto another = [&]
  { return Masks::For(image, Masks::Random(chance(), static_cast<unsigned>(views.Pick(1000)))); };
  const std::vector<Change> ofMask = {
    { true, [&] { Masks::SetBinary(scene.Mapper, another()); } },
    { false, [&] { Masks::SetBinary(scene.Mapper, kept); } }, // it may be there already
    { false,
      [&]
      {
        vtkDataArray* values = kept->GetPointData()->GetScalars();
        const vtkIdType from = views.Pick(30000);
        for (vtkIdType i = from; i < from + 2000; ++i)
        {
          values->SetComponent(i, 0, views.Pick(10) == 0);
        }
        values->Modified();
      } },
    { false, [&] { scene.Mapper->SetMaskInput(nullptr); } },
    { false, [&] { scene.Mapper->SetMaskType(views.Pick(2)); } },
  };
  std::vector<KindOfChange> kinds = KindsOfChange(scene, image, views);
  kinds.emplace_back(1, ChangesOfGhosts(image, views));
  kinds.emplace_back(1, ofMask);
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  const std::string what = "random changes, seed " + std::to_string(seed);
  Sweep::Tell(what, Wander(scene, views, kinds, what, steps));
}

/// The mapper behind VTK's name hands masks over.
void TestDoorOne()
{
  const Image image = Volumes::FourSpheres(40);
  const Image mask = Masks::For(image, [](int i, int, int) { return i < 20; });
  vtkNew<vtkTemporalCoherenceGPUVolumeRayCastMapper> door;
  door->SetInputData(image);
  door->SetBlendModeToIsoSurface();
  door->GetIsosurfaceMapper()->SetAntialiasingToOff();
  Scene scene(image, { 100.0 });
  scene.LookFrom(0.3, -1.0, 0.5);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, 100, 100);
  const auto draw = [&](vtkVolumeMapper* mapper)
  {
    scene.Volume->SetMapper(mapper);
    window->Render();
    return PixelsOf(window);
  };
  const auto areSame = [](vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
  {
    return std::memcmp(a->GetPointer(0), b->GetPointer(0),
             static_cast<std::size_t>(a->GetNumberOfValues())) == 0;
  };
  const auto whole = draw(scene.Mapper);
  const auto expectSame = [&](const std::string& what)
  {
    const auto expected = draw(scene.Mapper);
    const auto shown = draw(door);
    Expect(door->GetDrewIsosurfaces() && areSame(shown, expected), what + ": another picture");
    return !areSame(expected, whole);
  };
  for (vtkGPUVolumeRayCastMapper* mapper : { static_cast<vtkGPUVolumeRayCastMapper*>(door),
         static_cast<vtkGPUVolumeRayCastMapper*>(scene.Mapper) })
  {
    mapper->SetMaskTypeToBinary();
    mapper->SetMaskInput(mask);
  }
  Expect(expectSame("a binary mask"), "a binary mask hides a part");
  door->SetMaskTypeToLabelMap();
  scene.Mapper->SetMaskTypeToLabelMap();
  Expect(!expectSame("a label map"), "a label map without opacities hides nothing");
  vtkNew<vtkPiecewiseFunction> none;
  none->AddPoint(0.0, 0.0);
  scene.Volume->GetProperty()->SetLabelScalarOpacity(1, none);
  Expect(expectSame("labels"), "a label is hidden");
  door->SetMaskBlendFactor(0.5f);
  scene.Mapper->SetMaskBlendFactor(0.5f);
  Expect(!expectSame("half a label's own"), "it is shown again");

  // What ours refuses is VTK's to draw, or to refuse.
  vtkNew<vtkImageData> small;
  small->SetDimensions(4, 4, 4);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::memset(small->GetScalarPointer(), 255, 64);
  door->SetMaskTypeToBinary();
  door->SetMaskInput(small);
  draw(door);
  Expect(!door->GetDrewIsosurfaces() &&
      std::string(door->GetReason()).find("The mask has 4 x 4 x 4 values") != std::string::npos,
    std::string("a mask of another size is left to VTK, since ") + door->GetReason());
  door->SetMaskInput(nullptr);
  scene.Mapper->SetMaskInput(nullptr);
  Expect(!expectSame("no mask"), "all is shown without a mask");
}

}

int TestMaskFrames(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestChanges();
  TestMistakes();
  TestSweeps();
  for (const unsigned seed : { 5u, 6u })
  {
    TestRandomChanges(seed, 300);
  }
  TestDoorOne();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
