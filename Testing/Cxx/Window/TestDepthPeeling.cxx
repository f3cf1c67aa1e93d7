// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Among translucent polygons, depth peeling shows volumes in their place: each pixel is what
// arithmetic says.

#include "Scenes/PlateStack.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkObjectFactory.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>
#include <random>

namespace
{

using namespace PlateStack;

constexpr double Bound = 2.0; ///< of 255, that a pixel may be off

/// Random plates.
class Painter
{
public:
  explicit Painter(unsigned seed)
    : Engine(seed)
  {
  }

  double Number(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() % 10001u) / 10000.0);
  }

  int Count(int most) { return static_cast<int>(this->Engine() % static_cast<unsigned>(most + 1)); }

  Plate Any(double opacity)
  {
    const double x = this->Number(-1.2, 0.2), y = this->Number(-1.2, 0.2);
    return { this->Number(-0.95, 0.95),
      { x, x + this->Number(0.5, 1.4), y, y + this->Number(0.5, 1.4) },
      { this->Number(0.0, 1.0), this->Number(0.0, 1.0), this->Number(0.0, 1.0) }, opacity };
  }

  /// Plates of one place, of which all are opaque or none.
  std::vector<Plate> AnyPile(bool isOpaque)
  {
    std::vector<Plate> plates;
    const Plate first = this->Any(1.0);
    const int count = 1 + this->Count(3);
    for (int i = 0; i < count; ++i)
    {
      plates.push_back(this->Any(isOpaque ? 1.0 : this->Number(0.2, 0.9)));
      plates.back().Place = first.Place;
      // Apart from the others, and from the planes between samples.
      plates.back().Height = -0.93 + 0.4 * i + this->Number(0.0, 0.3);
    }
    return plates;
  }

private:
  std::mt19937 Engine;
};

/// Any number of volumes and polygons in any order.
void TestAnyOrder(Peeler peeler, const std::string& name)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    Painter painter(seed);
    const bool isOpaque = seed % 2 == 0, isOwnProp = seed / 2 % 2 == 0;
    StackScene scene(peeler,
      seed % 5 == 0 ? std::array<double, 4>{ 0.25, 0.5, 1.0, 1.0 }
                    : std::array<double, 4>{ 0.0, 0.0, 1.0, 1.0 });
    const int volumes = 1 + painter.Count(2), polygons = 1 + painter.Count(4);
    for (int i = 0; i < polygons; ++i)
    {
      scene.AddPolygon(painter.Any(painter.Number(0.2, 0.9)));
    }
    if (seed % 3 == 0)
    {
      scene.AddPolygon(painter.Any(1.0));
    }
    for (int i = 0; i < volumes; ++i)
    {
      scene.AddPile(painter.AnyPile(isOpaque), isOwnProp);
    }
    const std::string what = name + ", seed " + std::to_string(seed) + ", " +
      std::to_string(volumes) + (isOpaque ? " opaque" : " translucent") + " volume(s)" +
      (isOwnProp ? " as vtkTemporalCoherenceVolume, " : ", ") + std::to_string(polygons) +
      " polygon(s)";
    scene.ExpectOrder(what, Bound);
    scene.Renderer->GetActiveCamera()->Modified();
    scene.ExpectOrder(what + ", again", Bound);
  }
}

/// Where only polygons are peeled, volumes are drawn as ever: a plain vtkVolume after them, an
/// opaque vtkTemporalCoherenceVolume in its place.
void TestOnlyPolygonsPeeled(Peeler peeler, const std::string& name)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    Painter painter(seed);
    const bool isOpaque = seed % 2 == 0, isOwnProp = seed % 4 == 0;
    StackScene scene(peeler);
    scene.AreVolumesLast = !isOwnProp;
    for (int i = 0; i < 3; ++i)
    {
      scene.AddPolygon(painter.Any(painter.Number(0.2, 0.9)));
    }
    scene.AddPolygon(painter.Any(1.0));
    scene.AddPile(painter.AnyPile(isOpaque), isOwnProp);
    scene.ExpectOrder(name + ", seed " + std::to_string(seed) +
        (isOpaque ? ", opaque" : ", translucent") + (isOwnProp ? ", own prop" : ", vtkVolume"),
      Bound);
  }
}

/// One opaque surface between two panes.
void AddSandwich(StackScene& scene, double opacity = 1.0)
{
  scene.AddPolygon({ 0.5, { -0.7, 0.4, -0.7, 0.7 }, { 1.0, 0.0, 0.0 }, 0.5 });
  scene.AddPolygon({ -0.5, { -0.4, 0.9, -0.7, 0.7 }, { 0.0, 0.0, 1.0 }, 0.5 });
  scene.AddPile({ { 0.03, { -0.8, 0.7, -0.9, 0.5 }, { 0.1, 0.9, 0.2 }, opacity } }, false);
}

/// However often a picture is drawn, it is made once: or a moved view would be completed at once.
void TestOneFrame()
{
  StackScene scene(Peeler::Renderer);
  AddSandwich(scene);
  vtkTemporalCoherenceVolumeMapper* mapper = scene.Piles.front()->Mapper;
  mapper->SetReuseAccuracyToPaper();
  const EventCounter starts(mapper, vtkCommand::VolumeMapperRenderStartEvent);
  const EventCounter ends(mapper, vtkCommand::VolumeMapperRenderEndEvent);
  scene.ExpectOrder("a sandwich", Bound);
  scene.Renderer->GetActiveCamera()->Azimuth(2.0);
  scene.Window->Render();
  Expect(std::string(mapper->GetStatistics()->GetRouteAsString()) == "ImageCache",
    std::string("a moved view: the route is ") + mapper->GetStatistics()->GetRouteAsString());
  scene.Window->Render();
  Expect(std::string(mapper->GetStatistics()->GetRouteAsString()) == "Cold",
    std::string("a still view: the route is ") + mapper->GetStatistics()->GetRouteAsString());
  scene.Renderer->GetActiveCamera()->Azimuth(-2.0);
  scene.ExpectOrder("back again", Bound);
  Expect(starts.Count == 4 && ends.Count == 4,
    std::to_string(starts.Count) + " frames were begun and " + std::to_string(ends.Count) +
      " ended for 4 pictures");
}

void TestSpecialCases()
{
  // Without translucent polygons nothing is peeled.
  StackScene alone(Peeler::Renderer);
  alone.AddPile({ { 0.03, { -0.8, 0.7, -0.9, 0.5 }, { 0.1, 0.9, 0.2 }, 0.5 } }, false);
  alone.ExpectOrder("no polygons", Bound);

  StackScene coarse(Peeler::Renderer);
  coarse.Edge = 12.0 / Size;
  AddSandwich(coarse, 0.6);
  coarse.Piles.front()->Mapper->SetImageSampleDistance(3.0f);
  coarse.ExpectOrder("a coarse picture", Bound);

  StackScene fine(Peeler::Renderer);
  AddSandwich(fine, 0.6);
  fine.Piles.front()->Mapper->SetImageSampleDistance(0.5f);
  fine.ExpectOrder("a finer picture has a ray a pixel", Bound);
  Expect(
    fine.Piles.front()->Mapper->GetStatistics()->GetNumberOfRays() == Size * Size, "a ray a pixel");

  // More surfaces and panes than peels: those that are left are blended in some order.
  StackScene few(Peeler::Renderer);
  AddSandwich(few);
  few.AddPolygon({ 0.7, { -0.7, 0.4, -0.7, 0.7 }, { 1.0, 1.0, 0.0 }, 0.5 });
  few.Renderer->SetMaximumNumberOfPeels(1);
  few.ExpectOrder("one peel, panes before the surface", Bound);

  // A mistake: the last picture stays.
  StackScene spoilt(Peeler::Renderer);
  AddSandwich(spoilt);
  spoilt.ExpectOrder("before a mistake", Bound);
  const EventCounter errors(spoilt.Piles.front()->Mapper.Get(), vtkCommand::ErrorEvent);
  spoilt.Piles.front()->Mapper->SetBlendModeToSlice();
  spoilt.Window->Render();
  spoilt.Window->Render();
  Expect(errors.Count == 1, "a mistake: " + std::to_string(errors.Count) + " errors");
  spoilt.Piles.front()->Mapper->SetBlendModeToIsoSurface();
  spoilt.ForgetErrors();
  spoilt.ExpectOrder("after a mistake", Bound);

  // What is held in a window is let go, and made again; also in another window.
  StackScene moved(Peeler::Renderer);
  AddSandwich(moved, 0.5);
  moved.ExpectOrder("held", Bound);
  moved.Piles.front()->Mapper->ReleaseGraphicsResources(moved.Window);
  moved.ExpectOrder("released", Bound);
  moved.Window->Finalize();
  moved.ExpectOrder("a new context", Bound);
}

/// A volume of VTK's own mapper, seen from above.
vtkSmartPointer<vtkVolume> FogBelow(double height)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 9);
  image->SetSpacing(0.2, 0.2, 0.05);
  image->SetOrigin(-0.8, -0.8, height - 0.4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(100.0);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.1, 0.9, 0.4);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.7);
  const auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.2);
  return volume;
}

/// What another mapper draws behind a pane stays there if there are isosurfaces before the pane.
void TestOtherMapper(bool isOursLast)
{
  const std::string name =
    std::string("VTK's mapper ") + (isOursLast ? "before" : "after") + " ours";
  const Plate ours{ 0.57, { -0.9, 0.5, -0.6, 0.7 }, { 0.9, 0.3, 0.2 }, 0.6 };
  StackScene scene(Peeler::Renderer);
  scene.AddPolygon({ 0.2, { -0.5, 0.9, -0.7, 0.7 }, { 0.2, 0.4, 1.0 }, 0.5 });
  const vtkSmartPointer<vtkVolume> fog = FogBelow(0.0);
  if (isOursLast)
  {
    scene.Renderer->AddVolume(fog);
  }
  vtkVolume* prop = scene.AddPile({ ours }, false).Prop;
  if (!isOursLast)
  {
    scene.Renderer->AddVolume(fog);
  }
  const auto draw = [&](bool hasFog, bool hasOurs)
  {
    fog->SetVisibility(hasFog);
    prop->SetVisibility(hasOurs);
    scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> kept;
    kept->DeepCopy(PixelsOf(scene.Window));
    return vtkSmartPointer<vtkUnsignedCharArray>(kept.Get());
  };
  const auto neither = draw(false, false), below = draw(true, false), both = draw(true, true);
  int wrong = 0, foggy = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const double x = 2.0 * (pixel % Size + 0.5) / Size - 1.0,
                 y = 2.0 * (pixel / Size + 0.5) / Size - 1.0;
    // Only where there is a pane between the two.
    if (!ours.Covers(x, y) || ours.IsBeside(x, y, scene.Edge) || x < -0.45)
    {
      continue;
    }
    bool isWrong = false, isFoggy = false;
    for (int c = 0; c < 3; ++c)
    {
      const double expected = 255.0 * ours.Opacity * ours.Paint[static_cast<std::size_t>(c)] +
        (1.0 - ours.Opacity) * below->GetValue(4 * pixel + c);
      isWrong |= std::abs(both->GetValue(4 * pixel + c) - expected) > 2.0;
      isFoggy |= std::abs(below->GetValue(4 * pixel + c) - neither->GetValue(4 * pixel + c)) > 20;
    }
    wrong += isWrong;
    foggy += isFoggy;
  }
  Expect(foggy > Size * Size / 8 && wrong == 0,
    name + ": " + std::to_string(wrong) + " pixels are wrong, " + std::to_string(foggy) +
      " show its volume");
}

/// A pass that leaves the shaders of volumes alone, as one might that is not known.
class UnknownPass : public vtkDualDepthPeelingPass
{
public:
  static UnknownPass* New();
  vtkTypeMacro(UnknownPass, vtkDualDepthPeelingPass);

  bool PreReplaceShaderValues(
    std::string&, std::string&, std::string&, vtkAbstractMapper*, vtkProp*) override
  {
    return true;
  }
};
vtkStandardNewMacro(UnknownPass);

/// It gets one message, which tells what to use.
void TestUnknownPass()
{
  StackScene scene(Peeler::Renderer);
  AddSandwich(scene);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkTranslucentPass> polygons;
  vtkNew<vtkVolumetricPass> volumes;
  vtkNew<UnknownPass> unknown;
  unknown->SetTranslucentPass(polygons);
  unknown->SetVolumetricPass(volumes);
  steps->SetTranslucentPass(unknown);
  steps->SetVolumetricPass(nullptr);
  scene.Renderer->SetPass(steps);
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkTemporalCoherenceVolumeMapper* mapper = scene.Piles.front()->Mapper;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  const EventCounter errors(mapper, vtkCommand::ErrorEvent);
  for (int i = 0; i < 3; ++i)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(1.0);
    scene.Window->Render();
  }
  const std::string message = observer->GetErrorMessage();
  Expect(errors.Count == 1, "an unknown pass: " + std::to_string(errors.Count) + " errors");
  Expect(message.find("vtkTemporalCoherenceVolume with") != std::string::npos,
    "an unknown pass: " + message);
  scene.Renderer->GetActiveCamera()->Azimuth(-3.0);
  scene.Renderer->SetPass(nullptr);
  scene.ForgetErrors();
  scene.ExpectOrder("after an unknown pass", Bound);
}

}

int TestDepthPeeling(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestAnyOrder(Peeler::Renderer, "UseDepthPeelingForVolumes");
  TestAnyOrder(Peeler::OwnDualPass, "vtkDualDepthPeelingPass");
  TestOnlyPolygonsPeeled(Peeler::PolygonsOnly, "without UseDepthPeelingForVolumes");
  TestOnlyPolygonsPeeled(Peeler::OwnSinglePass, "vtkDepthPeelingPass");
  TestOneFrame();
  TestSpecialCases();
  TestOtherMapper(false);
  TestOtherMapper(true);
  TestUnknownPass();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
