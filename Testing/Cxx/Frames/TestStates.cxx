// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// One mapper and several viewers: windows, renderers, volumes, cameras, eyes. Each re-uses what was
// made for it, sees its own picture, and disturbs none of the others.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkContourValues.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 120;

std::string RouteOf(const Scene& scene)
{
  return scene.Mapper->GetStatistics()->GetRouteAsString();
}

/// A scene in a window of its own, whose volume has a given mapper.
struct View
{
  explicit View(const Scene& shared, double x, double y, double z)
    : Own(nullptr, { 100.0 })
  {
    this->Own.Volume->SetMapper(shared.Mapper);
    this->Own.LookFrom(x, y, z);
    OpenWindow(this->Window, this->Own.Renderer, Size, Size);
  }

  Scene Own; ///< its mapper is not used
  vtkNew<vtkRenderWindow> Window;
};

/// True if a window shows what a mapper of its own would.
bool ShowsTheTruth(const View& view, vtkImageData* image)
{
  Scene alone(image, { 100.0 });
  alone.Renderer->SetActiveCamera(view.Own.Renderer->GetActiveCamera());
  alone.Volume->SetProperty(view.Own.Volume->GetProperty());
  if (!alone.Render(Size, Size))
  {
    return false;
  }
  const auto pixels = PixelsOf(view.Window);
  const PictureDifference difference = CompareWithImage(pixels, Size, alone);
  return difference.Different == 0 && difference.Hits > 500;
}

int CountPicks(const Scene& scene)
{
  int picks = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    picks += scene.Mapper->PickPixel(i % Size, i / Size, nullptr, nullptr, nullptr);
  }
  return picks;
}

void TestWindowsThatShareAMapper()
{
  const auto image = Volumes::FourSpheres(48);
  const Scene shared(image, { 100.0 });
  shared.Mapper->SetReuseAccuracyToPaper();
  View front(shared, 1.0, 2.0, 0.5), side(shared, 2.0, -0.4, 0.7);
  for (View* view : { &front, &side })
  {
    view->Window->Render();
    Expect(RouteOf(shared) == "Cold", "each window begins with a cold frame");
    Expect(ShowsTheTruth(*view, image), "the first picture");
  }
  for (int step = 0; step < 3; ++step)
  {
    for (View* view : { &front, &side })
    {
      view->Own.Renderer->GetActiveCamera()->Azimuth(2.0);
      view->Own.Renderer->ResetCameraClippingRange();
      view->Window->Render();
      Expect(RouteOf(shared) == "ImageCache", "each window goes on from its own picture");
    }
  }
  for (View* view : { &front, &side })
  {
    view->Window->Render(); // completed
    view->Window->Render();
    Expect(RouteOf(shared) == "Redisplay", "nothing changed");
    Expect(ShowsTheTruth(*view, image), "the picture after some turns");
  }

  // New samples are seen in both.
  const auto other = Volumes::FourSpheres(40);
  shared.Mapper->SetInputData(other);
  for (View* view : { &front, &side })
  {
    view->Window->Render();
    Expect(RouteOf(shared) == "Cold" && ShowsTheTruth(*view, other), "other data in each window");
  }
  front.Window->Render();
  const int hits = CountPicks(shared);

  // Counters and picks are those of the last frame.
  side.Window->SetSize(Size / 2, Size);
  side.Window->Render();
  Expect(
    shared.Mapper->GetStatistics()->GetNumberOfRays() == Size * Size / 2, "rays of the last frame");
  Expect(CountPicks(shared) < hits, "and its hits");
  front.Window->Render();
  Expect(shared.Mapper->GetStatistics()->GetNumberOfRays() == Size * Size &&
      RouteOf(shared) == "Redisplay",
    "another window's resize does not matter");
  Expect(CountPicks(shared) == hits, "its surfaces are picked");

  shared.Mapper->ClearCache();
  Expect(CountPicks(shared) == 0, "forgotten");
  front.Window->Render();
  Expect(RouteOf(shared) == "Cold" && ShowsTheTruth(front, other), "made again");
}

/// A window that closes takes its own textures along, not those of the others.
void TestWindowsThatClose()
{
  const auto image = Volumes::FourSpheres(48);
  const Scene shared(image, { 100.0 });
  View stays(shared, 1.0, 2.0, 0.5);
  stays.Window->Render();
  {
    View closes(shared, 2.0, -0.4, 0.7);
    closes.Window->Render();
    closes.Window->Finalize();
    stays.Window->Render();
    Expect(RouteOf(shared) == "Redisplay" && ShowsTheTruth(stays, image), "after Finalize");
    closes.Window->Render();
    Expect(RouteOf(shared) == "Redisplay" && ShowsTheTruth(closes, image), "opened again");
  }
  stays.Window->Render();
  Expect(RouteOf(shared) == "Redisplay" && ShowsTheTruth(stays, image), "after its end");

  // The renderer moves to another window.
  vtkNew<vtkRenderWindow> next;
  stays.Window->RemoveRenderer(stays.Own.Renderer);
  OpenWindow(next, stays.Own.Renderer, Size, Size);
  next->Render();
  Expect(RouteOf(shared) == "Redisplay", "the picture moves along");
  stays.Own.Mapper->SetInputData(image);
  Expect(stays.Own.Render(Size, Size), "MakeImage");
  const auto pixels = PixelsOf(next);
  Expect(CompareWithImage(pixels, Size, stays.Own).Different == 0, "and is uploaded again");
}

/// More viewers than are remembered are served all the same.
void TestManyViewers()
{
  const auto image = Volumes::FourSpheres(32);
  Scene shared(image, { 100.0 });
  std::vector<vtkSmartPointer<vtkCamera>> cameras;
  for (int i = 0; i < 6; ++i)
  {
    shared.LookFrom(1.0 + i, 2.0 - i, 0.5);
    const auto camera = vtkSmartPointer<vtkCamera>::New();
    camera->DeepCopy(shared.Renderer->GetActiveCamera());
    cameras.push_back(camera);
  }
  const auto render = [&](int camera)
  {
    shared.Renderer->SetActiveCamera(cameras[static_cast<std::size_t>(camera)]);
    Expect(shared.Render(Size, Size), "MakeImage");
    return RouteOf(shared);
  };
  for (int round = 0; round < 2; ++round)
  {
    for (int i = 0; i < 4; ++i)
    {
      Expect(render(i) == (round == 0 ? "Cold" : "Redisplay"), "four cameras");
    }
  }
  Expect(render(4) == "Cold" && render(1) == "Redisplay", "the fifth");
  Expect(render(0) == "Cold", "takes the place of the one served longest ago");
  Expect(render(1) == "Redisplay", "not of others");

  // A camera that is new in every frame goes on from the one before, which is gone.
  shared.Renderer->SetActiveCamera(cameras[5]);
  cameras.clear();
  shared.Mapper->SetReuseAccuracyToPaper();
  shared.Mapper->ClearCache();
  Expect(shared.Render(Size, Size), "MakeImage");
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkCamera> next;
    next->DeepCopy(shared.Renderer->GetActiveCamera());
    next->Azimuth(1.0);
    shared.Renderer->SetActiveCamera(next);
    Expect(shared.Render(Size, Size) && RouteOf(shared) == "ImageCache", "a new camera each time");
  }
}

/// More windows than are remembered: what was made in a window is freed in that window.
void TestManyWindows()
{
  const auto image = Volumes::FourSpheres(32);
  const Scene shared(image, { 100.0 });
  std::vector<std::unique_ptr<View>> views;
  for (int i = 0; i < 6; ++i)
  {
    views.push_back(std::make_unique<View>(shared, 1.0 + i, 2.0 - i, 0.5));
  }
  for (int round = 0; round < 2; ++round)
  {
    for (const auto& view : views)
    {
      view->Window->Render();
      Expect(RouteOf(shared) == "Cold", "forgotten in between");
      Expect(ShowsTheTruth(*view, image), "one of many windows");
    }
  }
  views.erase(views.begin() + 1, views.begin() + 4);
  for (const auto& view : views)
  {
    view->Window->Render();
    Expect(ShowsTheTruth(*view, image), "one of those that are left");
  }
}

/// Two volumes of one renderer, with isovalues of their own, share a mapper.
void TestVolumes()
{
  const auto image = Volumes::FourSpheres(48);
  Scene scene(image, { 100.0 });
  vtkNew<vtkVolume> second;
  second->SetMapper(scene.Mapper);
  second->SetPosition(30.0, 0.0, 0.0);
  second->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 150.0);
  scene.Renderer->AddVolume(second);
  scene.LookFrom(0.3, 2.0, 0.5);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  const auto first = PixelsOf(window);
  window->Render();
  Expect(RouteOf(scene) == "Redisplay", "both volumes are known");
  const auto again = PixelsOf(window);
  Expect(std::equal(first->GetPointer(0), first->GetPointer(0) + first->GetNumberOfValues(),
           again->GetPointer(0)),
    "both are seen again");
  Expect(scene.Render(Size, Size) && RouteOf(scene) == "Redisplay", "the first of them alone");
  vtkNew<vtkImageData> color, depth;
  Expect(scene.Mapper->MakeImage(scene.Renderer, second, Size, Size, color, depth) &&
      RouteOf(scene) == "Redisplay",
    "the second alone");
}

/// A mistake in one viewer leaves the others as they are.
void TestErrors()
{
  const auto image = Volumes::FourSpheres(32);
  const Scene shared(image, { 100.0 });
  View good(shared, 1.0, 2.0, 0.5), bad(shared, 2.0, -0.4, 0.7);
  vtkNew<vtkTest::ErrorObserver> observer;
  shared.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  good.Window->Render();
  bad.Window->Render();
  bad.Own.Volume->SetScale(1.0, 0.0, 1.0);
  bad.Window->Render();
  Expect(observer->GetError(), "an error");
  Expect(ShowsTheTruth(good, image), "the other window");
  good.Window->Render();
  Expect(RouteOf(shared) == "Redisplay", "goes on");
  bad.Own.Volume->SetScale(1.0);
  bad.Window->Render();
  Expect(RouteOf(shared) == "Redisplay" && ShowsTheTruth(bad, image), "mended");
}

/// The isomap of each viewer stays while the other's isovalues move.
void TestIsomaps()
{
  const auto image = Volumes::FourSpheres(48);
  const Scene shared(image, { 100.0 });
  View front(shared, 1.0, 2.0, 0.5), side(shared, 2.0, -0.4, 0.7);
  shared.Mapper->SetIsomapRange(90.0, 110.0);
  for (const double isovalue : { 100.0, 101.0, 102.0, 103.0 })
  {
    for (View* view : { &front, &side })
    {
      view->Own.SetIsovalues({ isovalue });
      view->Window->Render();
      Expect(isovalue == 100.0 ? RouteOf(shared) == "Cold" : RouteOf(shared).find("Isomap") == 0,
        "a route of isomaps");
      Expect(isovalue == 100.0 || shared.Mapper->GetStatistics()->GetNumberOfIsomapKnots() > 0,
        "its knots");
      Expect(ShowsTheTruth(*view, image), "its picture");
    }
  }
  for (View* view : { &front, &side })
  {
    view->Own.SetIsovalues({ 102.0 });
    view->Window->Render();
    Expect(RouteOf(shared) == "IsomapLookup", "bands are kept for both");
  }
}

}

int TestStates(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestWindowsThatShareAMapper();
  TestWindowsThatClose();
  TestManyViewers();
  TestManyWindows();
  TestVolumes();
  TestErrors();
  TestIsomaps();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
