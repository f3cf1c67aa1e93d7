// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A mistake gets one error with its value and remedy, the last valid picture stays, nothing
// crashes.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/Scene.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"

#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkHyperTreeGrid.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiVolume.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>

namespace
{

vtkSmartPointer<vtkImageData> Ball(int n = 20)
{
  return Volumes::FromFormula(n, VTK_UNSIGNED_CHAR,
    [](double x, double y, double z) { return 200.0 - 100.0 * std::hypot(x, y, z); });
}

/// Spoil a scene that has a valid picture: one error that contains `word`, the old picture stays,
/// and after `mend` the scene renders again.
void ExpectError(const std::string& word, const std::function<void(Scene&)>& spoil,
  const std::function<void(Scene&)>& mend = {}, int width = 60, int height = 60)
{
  vtkSmartPointer<vtkImageData> image = Ball();
  Scene scene(image, { 130.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Mistake mistake(scene, word);
  spoil(scene);
  mistake.ExpectRefused(width, height);
  if (mend)
  {
    mend(scene);
    mistake.ExpectMended();
  }
}

void TestInputs()
{
  ExpectError(
    "no input",
    [](Scene& scene) { scene.Mapper->SetInputData(static_cast<vtkImageData*>(nullptr)); },
    [](Scene& scene) { scene.Mapper->SetInputData(Ball()); });
  ExpectError(
    "no scalars",
    [](Scene& scene)
    { vtkImageData::SafeDownCast(scene.Mapper->GetInput())->GetPointData()->Initialize(); },
    [](Scene& scene) { scene.Mapper->SetInputData(Ball()); });
  ExpectError(
    "'pressure'",
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectScalarArray("pressure");
    },
    [](Scene& scene) { scene.Mapper->SetScalarModeToDefault(); });
  ExpectError(
    "VectorComponent is 3",
    [](Scene& scene)
    {
      scene.Mapper->SetVectorMode(vtkTemporalCoherenceVolumeMapper::COMPONENT);
      scene.Mapper->SetVectorComponent(3);
    },
    [](Scene& scene) { scene.Mapper->SetVectorMode(vtkTemporalCoherenceVolumeMapper::DISABLED); });
  ExpectError("VectorComponent is -1",
    [](Scene& scene)
    {
      scene.Mapper->SetVectorMode(vtkTemporalCoherenceVolumeMapper::COMPONENT);
      scene.Mapper->SetVectorComponent(-1);
    });
  ExpectError("tuples",
    [](Scene& scene)
    {
      vtkNew<vtkDoubleArray> few;
      few->SetNumberOfTuples(17);
      vtkNew<vtkImageData> image;
      image->SetDimensions(20, 20, 20);
      image->GetPointData()->SetScalars(few);
      scene.Mapper->SetInputData(image);
    });
  ExpectError("19 tuples, but 6859 cells",
    [](Scene& scene)
    {
      vtkNew<vtkDoubleArray> few;
      few->SetNumberOfTuples(19);
      vtkNew<vtkImageData> image;
      image->SetDimensions(20, 20, 20);
      image->GetCellData()->SetScalars(few);
      scene.Mapper->SetInputData(image);
    });
  ExpectError("8000 tuples, but 6859 cells",
    [](Scene& scene)
    {
      vtkNew<vtkDoubleArray> ofPoints;
      ofPoints->SetNumberOfTuples(8000);
      vtkNew<vtkImageData> image;
      image->SetDimensions(20, 20, 20);
      image->GetCellData()->SetScalars(ofPoints);
      scene.Mapper->SetInputData(image);
    });
  for (const vtkIdType flags : { 19, 8000 })
  {
    ExpectError(std::to_string(flags) + " tuples of 1 component(s), but 6859 cells",
      [&](Scene& scene)
      {
        const auto image = Ball(20);
        Ghosts::AddFlags(image->GetCellData(), flags);
        scene.Mapper->SetInputData(image);
      });
  }
  // So many points that VTK's number of them overflows.
  ExpectError("400 tuples, but 9223372036854775807 points",
    [](Scene& scene)
    {
      vtkNew<vtkDoubleArray> few;
      few->SetNumberOfTuples(400);
      vtkNew<vtkImageData> image;
      image->SetDimensions((1 << 21) + 1, (1 << 21) + 1, (1 << 22) + 2);
      image->GetPointData()->SetScalars(few);
      scene.Mapper->SetInputData(image);
    });
  ExpectError(
    "vtkPolyData",
    [](Scene& scene) { scene.Mapper->SetInputDataObject(vtkNew<vtkPolyData>().Get()); },
    [](Scene& scene) { scene.Mapper->SetInputData(Ball()); });
  // Nor has the pipeline anything to say.
  for (const vtkSmartPointer<vtkDataObject>& object :
    { vtkSmartPointer<vtkDataObject>(vtkSmartPointer<vtkTable>::New()),
      vtkSmartPointer<vtkDataObject>(vtkSmartPointer<vtkHyperTreeGrid>::New()) })
  {
    vtkNew<vtkTest::ErrorObserver> pipeline;
    ExpectError(
      object->GetClassName(),
      [&](Scene& scene)
      {
        scene.Mapper->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
        scene.Mapper->SetInputDataObject(object);
      },
      [](Scene& scene) { scene.Mapper->SetInputData(Ball()); });
    Expect(!pipeline->GetError(), "said twice: " + pipeline->GetErrorMessage());
  }
  ExpectError(
    "Blend mode", [](Scene& scene) { scene.Mapper->SetBlendModeToSlice(); },
    [](Scene& scene) { scene.Mapper->SetBlendModeToIsoSurface(); });
}

void TestGeometries()
{
  ExpectError("spacing (0, ",
    [](Scene& scene)
    { vtkImageData::SafeDownCast(scene.Mapper->GetInput())->SetSpacing(0.0, 0.1, 0.1); });
  ExpectError(
    "scale is 1, 0, 1", [](Scene& scene) { scene.Volume->SetScale(1.0, 0.0, 1.0); },
    [](Scene& scene) { scene.Volume->SetScale(1.0); });
  ExpectError(
    "scale is 0, 1, 1",
    [](Scene& scene)
    {
      vtkNew<vtkMatrix4x4> flat;
      flat->SetElement(0, 0, 0.0);
      scene.Volume->SetUserMatrix(flat);
    },
    [](Scene& scene) { scene.Volume->SetUserMatrix(nullptr); });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  ExpectError("camera",
    [infinity](Scene& scene)
    { scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, infinity); });
  ExpectError("camera",
    [](Scene& scene) { scene.Renderer->GetActiveCamera()->SetClippingRange(-9.0, -1.0); });
  ExpectError("camera",
    [nan](Scene& scene) { scene.Renderer->GetActiveCamera()->SetPosition(nan, 0.0, 0.0); });
  ExpectError(
    "0 x 60", [](Scene&) {}, [](Scene&) {}, 0, 60);
  ExpectError(
    "60 x -5", [](Scene&) {}, [](Scene&) {}, 60, -5);
}

void TestIsovalues()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, infinity, -infinity })
  {
    ExpectError(
      "Isovalue 1 is",
      [bad](Scene& scene) {
        scene.SetIsovalues({ 130.0, bad });
      },
      [](Scene& scene) { scene.SetIsovalues({ 130.0 }); });
  }
  ExpectError("more than",
    [](Scene& scene)
    {
      std::vector<double> isovalues(40000);
      std::iota(isovalues.begin(), isovalues.end(), 0.0);
      scene.SetIsovalues(isovalues);
    });
  ExpectError(
    "1025 translucent isovalues",
    [](Scene& scene)
    {
      std::vector<double> isovalues(1025);
      std::iota(isovalues.begin(), isovalues.end(), 0.0);
      scene.SetIsovalues(isovalues);
      scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.5);
    },
    [](Scene& scene)
    {
      scene.Volume->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
      scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 1.0);
      scene.SetIsovalues({ 130.0 });
    });
}

void TestNullArguments()
{
  Scene scene(Ball(), { 130.0 });
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  Expect(!scene.Mapper->PickPixel(0, 0, nullptr, nullptr, nullptr), "no frame yet");
  Expect(!scene.Mapper->MakeImage(nullptr, scene.Volume, 9, 9, nullptr, nullptr), "no renderer");
  Expect(!scene.Mapper->MakeImage(scene.Renderer, nullptr, 9, 9, nullptr, nullptr), "no volume");
  Expect(observer->GetError(), "said");
  observer->Clear();
  scene.Mapper->Render(nullptr, scene.Volume);
  Expect(observer->GetError(), "said that a window needs a renderer");
  observer->Clear();
  double t;
  const double end[3] = { 1.0, 2.0, 3.0 };
  Expect(
    !scene.Mapper->IntersectWithLine(scene.Volume, nullptr, end, t, nullptr, nullptr, nullptr) &&
      observer->GetError(),
    "no line");
  Expect(scene.Mapper->IsOpaque(nullptr), "nothing hides nothing");
  Expect(scene.Mapper->MakeImage(scene.Renderer, scene.Volume, 9, 9, nullptr, nullptr),
    "images are optional");
  observer->Clear();
  vtkNew<vtkImageData> frame;
  Expect(!scene.Mapper->MakeImage(scene.Renderer, scene.Volume, 9, 9, nullptr) &&
      observer->GetErrorMessage().find("MakeImage got null for the frame; give") !=
        std::string::npos,
    "no image for a frame");
  observer->Clear();
  Expect(!scene.Mapper->MakeImage(scene.Renderer, scene.Volume, 9, 9, frame, frame) &&
      observer->GetErrorMessage().find(
        "MakeImage got the same image for colors and depths; give") != std::string::npos,
    "one image for two");
  observer->Clear();
  Expect(!scene.Mapper->GetVisibleSurface(nullptr) &&
      observer->GetErrorMessage().find("GetVisibleSurface got null for the points; give") !=
        std::string::npos,
    "no points");
  observer->Clear();
  Expect(!scene.Mapper->GetLastFrame(nullptr) &&
      observer->GetErrorMessage().find("GetLastFrame got null for the frame; give") !=
        std::string::npos,
    "no image for the last frame");
  for (const int arrays : { -1, 32, 33 })
  {
    observer->Clear();
    Expect(!scene.Mapper->GetLastFrame(frame, arrays) && frame->GetNumberOfPoints() == 0 &&
        observer->GetErrorMessage().find(
          "got " + std::to_string(arrays) + " for the arrays; give") != std::string::npos,
      "no such arrays: " + observer->GetErrorMessage());
  }
  observer->Clear();
  Expect(!scene.Mapper->GetLastFrame(frame, 33) && !observer->GetError(), "said once");
  Expect(scene.Mapper->GetLastFrame(frame) && frame->GetNumberOfPoints() == 81,
    "the last frame is still there");
  for (const int outside : { -1, 9, 1000000 })
  {
    Expect(!scene.Mapper->PickPixel(outside, 3, nullptr, nullptr, nullptr), "no such pixel");
    Expect(!scene.Mapper->PickPixel(3, outside, nullptr, nullptr, nullptr), "no such pixel");
  }
}

/// Several volumes in one prop are refused in one sentence, which tells how it is done.
void TestMultiVolume()
{
  Scene scene(Ball(), { 130.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(60, 60), "before a vtkMultiVolume");
  vtkNew<vtkMultiVolume> several;
  several->SetMapper(scene.Mapper);
  EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  for (const bool hasVolume : { false, true }) // without, it has no property either
  {
    several->SetVolume(hasVolume ? scene.Volume.Get() : nullptr, 0);
    for (int i = 0; i < 2; ++i)
    {
      Expect(!scene.Mapper->MakeImage(scene.Renderer, several, 60, 60, nullptr, nullptr),
        "vtkMultiVolume: drawn");
    }
    Expect(scene.Mapper->IsOpaque(several), "vtkMultiVolume: nothing hides nothing");
  }
  Expect(errors.Count == 1, "vtkMultiVolume: " + std::to_string(errors.Count) + " errors");
  const std::string message = observer->GetErrorMessage();
  Expect(message.find("vtkMultiVolume") != std::string::npos &&
      message.find("a vtkVolume and a mapper of its own") != std::string::npos,
    "vtkMultiVolume: " + message);
  Expect(scene.Render(60, 60), "after a vtkMultiVolume");
}

/// What is empty, but no mistake.
void TestEmptyPictures()
{
  const auto isEmpty = [](const std::string& what, const std::function<void(Scene&)>& arrange)
  {
    Scene scene(Ball(), { 130.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    vtkNew<vtkTest::ErrorObserver> observer;
    scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
    arrange(scene);
    Expect(scene.Render(40, 30), what + ": rendered");
    Expect(!observer->GetError(), what + ": no error, but: " + observer->GetErrorMessage());
    bool empty = true;
    for (int y = 0; y < 30; ++y)
    {
      for (int x = 0; x < 40; ++x)
      {
        empty &= scene.ColorAt(x, y)[3] == 0 && std::isinf(scene.DepthAt(x, y));
      }
    }
    Expect(empty, what + ": an empty picture");
  };
  isEmpty("no isovalues", [](Scene& scene) { scene.SetIsovalues({}); });
  isEmpty("isovalue beyond the data", [](Scene& scene) { scene.SetIsovalues({ 1e6 }); });
  isEmpty("invisible isovalue",
    [](Scene& scene)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.0);
      scene.Volume->GetProperty()->SetScalarOpacity(opacity);
    });
  isEmpty(
    "empty image", [](Scene& scene) { scene.Mapper->SetInputData(vtkNew<vtkImageData>().Get()); });
  for (const auto& [x, y, z] : { std::array{ 1, 1, 1 }, { 9, 9, 1 }, { 1, 9, 9 }, { 9, 1, 1 } })
  {
    isEmpty("one slice or voxel",
      [size = std::array{ x, y, z }](Scene& scene)
      {
        vtkNew<vtkImageData> image;
        image->SetDimensions(size.data());
        image->AllocateScalars(VTK_FLOAT, 1);
        image->GetPointData()->GetScalars()->Fill(200.0);
        scene.Mapper->SetInputData(image);
        scene.Mapper->SetSurfaceModeToThreshold();
      });
  }
  isEmpty("behind the camera",
    [](Scene& scene)
    {
      scene.Renderer->GetActiveCamera()->SetPosition(50.0, 0.0, 0.0);
      scene.Renderer->GetActiveCamera()->SetFocalPoint(60.0, 0.0, 0.0);
    });
}

}

/// Settings that are not numbers are refused, and stay as they are.
void TestSettings()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene(Ball(), { 130.0 });
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto expectRefused = [&](const std::string& name, const std::string& range)
  {
    Expect(observer->GetError() &&
        observer->GetErrorMessage().find(
          name + " must be a finite number " + range + ", got nan") != std::string::npos,
      name + ": said so");
    observer->Clear();
  };
  scene.Mapper->SetIsomapTolerance(0.5);
  scene.Mapper->SetIsomapTolerance(nan);
  expectRefused("IsomapTolerance", ">= 0");
  scene.Mapper->SetIsomapTolerance(std::numeric_limits<double>::infinity());
  Expect(observer->GetErrorMessage().find(
           "IsomapTolerance must be a finite number >= 0, got inf") != std::string::npos,
    "an infinite tolerance");
  observer->Clear();
  Expect(scene.Mapper->GetIsomapTolerance() == 0.5, "the tolerance stays");
  scene.Mapper->SetImageSampleDistance(200.0f);
  scene.Mapper->SetImageSampleDistance(static_cast<float>(nan));
  expectRefused("ImageSampleDistance", "from 0.1 to 100");
  Expect(scene.Mapper->GetImageSampleDistance() == 100.0f, "the distance stays");
}

/// A value that is none of a setting's choices is an error that names them, and the setting stays.
void TestChoices()
{
  using Mapper = vtkTemporalCoherenceVolumeMapper;
  using Door = vtkTemporalCoherenceGPUVolumeRayCastMapper;
  vtkNew<Mapper> mapper;
  vtkNew<Door> door;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  door->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto expectChoices =
    [&](vtkObject* object, auto set, auto get, int last, const std::string& sentence)
  {
    set(last);
    Expect(get() == last && !observer->GetError(), sentence + " A choice is none.");
    for (const int wrong : { -99, last + 1, 99 })
    {
      const vtkMTimeType before = object->GetMTime();
      set(wrong);
      const std::string value = ", not " + std::to_string(wrong) + "; it stays ";
      std::string expected = sentence;
      expected.replace(expected.find("; it stays "), 11, value);
      Expect(observer->GetErrorMessage().find("): " + expected) != std::string::npos,
        expected + " But it is: " + observer->GetErrorMessage());
      Expect(get() == last && object->GetMTime() == before, sentence + " It does stay.");
      observer->Clear();
    }
  };
  const auto expectOfMapper =
    [&](void (Mapper::*set)(int), int (Mapper::*get)(), int last, const std::string& sentence)
  {
    expectChoices(
      mapper, [&](int value) { (mapper->*set)(value); }, [&] { return (mapper->*get)(); }, last,
      sentence);
  };
  expectOfMapper(&Mapper::SetSurfaceMode, &Mapper::GetSurfaceMode, Mapper::LABELS,
    "SurfaceMode must be CROSSING (0), THRESHOLD (1) or LABELS (2); it stays LABELS (2).");
  expectOfMapper(&Mapper::SetVectorMode, &Mapper::GetVectorMode, Mapper::COMPONENT,
    "VectorMode must be DISABLED (-1), MAGNITUDE (0) or COMPONENT (1); it stays COMPONENT (1).");
  expectOfMapper(&Mapper::SetAntialiasing, &Mapper::GetAntialiasing, Mapper::ANTIALIASING_ALWAYS,
    "Antialiasing must be ANTIALIASING_OFF (0), ANTIALIASING_WHEN_STILL (1) or ANTIALIASING_ALWAYS "
    "(2); it stays ANTIALIASING_ALWAYS (2).");
  expectOfMapper(&Mapper::SetReuseAccuracy, &Mapper::GetReuseAccuracy, Mapper::PAPER,
    "ReuseAccuracy must be EXACT (1) or PAPER (2); it stays PAPER (2).");
  expectOfMapper(&Mapper::SetImageCachePolicy, &Mapper::GetImageCachePolicy, Mapper::KEY_IMAGE,
    "ImageCachePolicy must be LATEST (0) or KEY_IMAGE (1); it stays KEY_IMAGE (1).");
  expectOfMapper(&Mapper::SetImageCacheShading, &Mapper::GetImageCacheShading, Mapper::INTERPOLATE,
    "ImageCacheShading must be RESHADE (0) or INTERPOLATE (1); it stays INTERPOLATE (1).");
  expectOfMapper(&Mapper::SetIsomapShading, &Mapper::GetIsomapShading, Mapper::INTERPOLATE,
    "IsomapShading must be RESHADE (0) or INTERPOLATE (1); it stays INTERPOLATE (1).");
  expectChoices(
    door, [&](int value) { door->SetBlendVolumes(value); }, [&] { return door->GetBlendVolumes(); },
    Door::BLEND_ALWAYS,
    "BlendVolumes must be BLEND_NEVER (0), BLEND_ON_SOFTWARE_OPENGL (1) or BLEND_ALWAYS (2); it "
    "stays BLEND_ALWAYS (2).");
}

int TestErrors(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestInputs();
  TestGeometries();
  TestIsovalues();
  TestNullArguments();
  TestMultiVolume();
  TestEmptyPictures();
  TestSettings();
  TestChoices();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
