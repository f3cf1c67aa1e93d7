// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A window shows a blended volume as MakeImage does, over what is behind it. What is opaque
// ends it.

#include "BlendedScene.h"
#include "Checks/Expect.h"
#include "vtkTemporalCoherencePicker.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPropPicker.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr int Size = 150;
const std::array<double, 3> Centre{ 15.5, 15.5, 15.5 };
const std::array<double, 3> ToViewer{ 0.5, 1.0, 0.2 };

/// Count the pixels of a window that differ from the scene's last MakeImage over a colour.
PictureDifference CompareOver(vtkUnsignedCharArray* pixels, const Scene& scene,
  const std::array<double, 3>& behind, double most = 1.6)
{
  PictureDifference result;
  int size[3];
  scene.Color->GetDimensions(size);
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    const unsigned char* color = scene.ColorAt(i % size[0], i / size[0]);
    const unsigned char* shown = pixels->GetPointer(4 * i);
    bool isDifferent = false;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double expected = color[c] + (255.0 - color[3]) * behind[c];
      isDifferent |= std::abs(expected - shown[c]) > most;
    }
    result.Different += isDifferent;
    result.Hits += color[3] != 0;
  }
  return result;
}

/// MakeImage of only what lies before a plane.
void RenderBefore(BlendedScene& scene, const std::array<double, 3>& centre, int size = Size)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(centre.data());
  plane->SetNormal(ToViewer[0], ToViewer[1], ToViewer[2]);
  scene.Mapper->AddClippingPlane(plane);
  Expect(scene.Render(size, size), "MakeImage of a part");
  scene.Mapper->RemoveAllClippingPlanes();
}

void ExpectSame(const PictureDifference& found, const std::string& what, int allowed = 0)
{
  Expect(found.Hits > 2000 && found.Different <= allowed,
    what + ": " + std::to_string(found.Different) + " of " + std::to_string(found.Hits) +
      " pixels differ");
}

void TestAlone(int mode)
{
  const std::string name = NameOfMode(mode);
  BlendedScene scene(mode);
  scene.Renderer->SetBackground(0.0, 0.5, 0.0);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Cold",
    name + ": the first is cold");
  const auto pixels = PixelsOf(window);
  window->Render();
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    name + ": shown again");
  Expect(scene.Render(Size, Size), "MakeImage");
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    name + ": the same picture");
  ExpectSame(CompareOver(pixels, scene, { 0.0, 128.0 / 255.0, 0.0 }), name + " alone");
}

/// An opaque plane in the volume, behind it and in front of it.
void TestPlane(int mode, bool isParallel)
{
  const std::string name = NameOfMode(mode) + (isParallel ? " parallel" : "");
  BlendedScene scene(mode);
  scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
  scene.Renderer->GetActiveCamera()->SetParallelScale(22.0);
  BluePlane plane(Centre, ToViewer);
  scene.Renderer->AddActor(plane.Actor);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  window->Render();
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    name + ": nothing changed");
  const auto inside = PixelsOf(window);
  RenderBefore(scene, Centre);
  ExpectSame(CompareOver(inside, scene, { 0.0, 0.0, 1.0 }), name + ", plane inside", 5);

  const std::array<double, 3> farther{ 9.0, 3.0, 13.0 };
  plane.Source->SetCenter(farther[0], farther[1], farther[2]);
  window->Render();
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Cold",
    name + ": the plane moved");
  const auto moved = PixelsOf(window);
  RenderBefore(scene, farther);
  ExpectSame(CompareOver(moved, scene, { 0.0, 0.0, 1.0 }), name + ", plane moved", 5);

  plane.Source->SetCenter(0.0, -40.0, 0.0);
  window->Render();
  const auto behind = PixelsOf(window);
  Expect(scene.Render(Size, Size), "MakeImage");
  ExpectSame(CompareOver(behind, scene, { 0.0, 0.0, 1.0 }), name + ", plane behind");

  plane.Source->SetCenter(25.0, 50.0, 20.0);
  window->Render();
  const auto hidden = PixelsOf(window);
  int seen = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    seen += hidden->GetValue(4 * i) != 0 || hidden->GetValue(4 * i + 2) != 255;
  }
  Expect(seen == 0, name + ": nothing is seen through an opaque plane");
}

/// Fewer and more rays than pixels.
void TestSampleDistances(int mode)
{
  for (const double distance : { 2.0, 0.5 })
  {
    const std::string name = NameOfMode(mode) + ", rays " + std::to_string(distance) + " apart";
    BlendedScene scene(mode);
    BluePlane plane(Centre, ToViewer);
    scene.Renderer->AddActor(plane.Actor);
    scene.Mapper->SetImageSampleDistance(static_cast<float>(distance));
    vtkNew<vtkRenderWindow> window;
    OpenWindow(window, scene.Renderer, Size, Size);
    window->Render();
    const auto pixels = PixelsOf(window);
    vtkNew<vtkPlane> cut;
    cut->SetOrigin(Centre.data());
    cut->SetNormal(ToViewer[0], ToViewer[1], ToViewer[2]);
    scene.Mapper->AddClippingPlane(cut);
    const int rays = static_cast<int>(std::lround(Size / distance));
    Expect(scene.Render(rays, rays), "MakeImage");
    int different = 0;
    for (int i = 0; i < Size * Size; ++i)
    {
      const int x = i % Size, y = i / Size;
      double expected[3] = { 0.0, 0.0, 0.0 };
      const int first = static_cast<int>(1.0 / std::min(1.0, distance));
      for (int ray = 0; ray < first * first; ++ray)
      {
        const int column = static_cast<int>(x / distance) + ray % first;
        const int row = static_cast<int>(y / distance) + ray / first;
        const unsigned char* color = scene.ColorAt(column, row);
        for (int c = 0; c < 3; ++c)
        {
          expected[c] += (color[c] + (c == 2 ? 255.0 - color[3] : 0.0)) / (first * first);
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        different += std::abs(expected[c] - pixels->GetValue(4 * i + c)) > 3.0;
      }
    }
    Expect(different < 20, name + ": " + std::to_string(different) + " channels differ");
  }
}

/// Two viewports of a window, each with a camera and a plane of its own.
void TestViewports(int mode)
{
  BlendedScene left(mode), right(mode);
  right.Renderer->GetActiveCamera()->Azimuth(20.0);
  BluePlane inLeft(Centre, ToViewer), inRight(Centre, ToViewer);
  left.Renderer->AddActor(inLeft.Actor);
  right.Renderer->AddActor(inRight.Actor);
  left.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, left.Renderer, 2 * Size, Size);
  window->AddRenderer(right.Renderer);
  window->Render();
  const auto leftPixels = PixelsOf(window, 0, 0, Size - 1, Size - 1);
  const auto rightPixels = PixelsOf(window, Size, 0, 2 * Size - 1, Size - 1);
  RenderBefore(left, Centre);
  RenderBefore(right, Centre);
  const std::string name = NameOfMode(mode);
  ExpectSame(CompareOver(leftPixels, left, { 0.0, 0.0, 1.0 }), name + ", left viewport", 5);
  ExpectSame(CompareOver(rightPixels, right, { 0.0, 0.0, 1.0 }), name + ", right viewport", 5);
}

/// A prop of our own class, and volumes that are peeled, look the same.
void TestOtherProps(int mode)
{
  const std::string name = NameOfMode(mode);
  BlendedScene scene(mode);
  BluePlane plane(Centre, ToViewer);
  scene.Renderer->AddActor(plane.Actor);
  vtkNew<vtkTemporalCoherenceVolume> own;
  own->SetMapper(scene.Mapper);
  own->SetProperty(scene.Volume->GetProperty());
  scene.Renderer->RemoveVolume(scene.Volume);
  scene.Renderer->AddVolume(own);
  Expect(!own->HasOpaqueGeometry() && !scene.Mapper->IsOpaque(own), name + ": it is not opaque");
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  const auto pixels = PixelsOf(window);
  RenderBefore(scene, Centre);
  ExpectSame(CompareOver(pixels, scene, { 0.0, 0.0, 1.0 }), name + ", our volume", 5);

  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  window->Render();
  ExpectSame(
    CompareOver(PixelsOf(window), scene, { 0.0, 0.0, 1.0 }), name + ", peeled, nothing else", 5);
  // A translucent pane in front: what lies behind it is seen through it.
  BluePlane pane({ 25.0, 50.0, 20.0 }, ToViewer);
  pane.Actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  pane.Actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(pane.Actor);
  window->Render();
  const auto through = PixelsOf(window);
  int different = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double expected = 0.5 * pixels->GetValue(4 * i + c) + (c == 0 ? 127.5 : 0.0);
      different += std::abs(expected - through->GetValue(4 * i + c)) > 3.0;
    }
  }
  Expect(
    different < 20, name + ", behind a pane: " + std::to_string(different) + " channels differ");
  // In the midst of it: some picture.
  pane.Source->SetCenter(17.0, 18.0, 16.0);
  window->Render();
}

/// A volume that is drawn after another one lies over it.
void TestTwoVolumes(int mode)
{
  BlendedScene first(mode), second(mode);
  second.Volume->SetPosition(5.0, 0.0, 3.0);
  second.Renderer->SetActiveCamera(first.Renderer->GetActiveCamera());
  first.Renderer->AddVolume(second.Volume);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, first.Renderer, Size, Size);
  window->Render();
  const auto pixels = PixelsOf(window);
  Expect(first.Render(Size, Size) && second.Render(Size, Size), "MakeImage");
  int different = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    const unsigned char* below = first.ColorAt(i % Size, i / Size);
    const unsigned char* above = second.ColorAt(i % Size, i / Size);
    for (int c = 0; c < 3; ++c)
    {
      const double expected = above[c] + (255.0 - above[3]) / 255.0 * below[c];
      different += std::abs(expected - pixels->GetValue(4 * i + c)) > 2.0;
    }
  }
  Expect(different == 0,
    NameOfMode(mode) + ", two volumes: " + std::to_string(different) + " channels differ");
}

/// A picture that is larger than the window, made tile by tile.
void TestTiles(int mode)
{
  BlendedScene scene(mode);
  BluePlane plane(Centre, ToViewer);
  scene.Renderer->AddActor(plane.Actor);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  vtkNew<vtkWindowToImageFilter> shot;
  shot->SetInput(window);
  shot->SetScale(2);
  shot->SetInputBufferTypeToRGBA();
  shot->ReadFrontBufferOff();
  shot->Update();
  auto* pixels =
    vtkUnsignedCharArray::SafeDownCast(shot->GetOutput()->GetPointData()->GetScalars());
  RenderBefore(scene, Centre, 2 * Size);
  ExpectSame(CompareOver(pixels, scene, { 0.0, 0.0, 1.0 }), NameOfMode(mode) + ", in tiles", 30);
}

/// Hardware selection and picks find a volume where it is seen.
void TestPicks(int mode)
{
  const std::string name = NameOfMode(mode);
  BlendedScene scene(mode);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  vtkNew<vtkPropPicker> props;
  const auto isPicked = [&](int x, int y)
  { return props->PickProp(x, y, scene.Renderer) && props->GetViewProp() == scene.Volume; };
  int wrong = 0, seen = 0;
  for (int i = 0; i < 100; ++i)
  {
    const int x = Size / 10 * (i % 10) + 5, y = Size / 10 * (i / 10) + 5;
    double position[3];
    const bool isSeen = scene.Mapper->PickPixel(x, y, position, nullptr, nullptr);
    wrong += isSeen != isPicked(x, y);
    seen += isSeen;
  }
  Expect(wrong == 0 && seen > 10 && seen < 100,
    name + ": " + std::to_string(wrong) + " wrong picks, seen " + std::to_string(seen));
  vtkNew<vtkTemporalCoherencePicker> picker;
  picker->SetVolumeOpacityIsovalue(0.01);
  Expect(picker->Pick(Size / 2.0, Size / 2.0, 0.0, scene.Renderer) &&
      picker->GetIsovalueIndex() == -1 && picker->GetVolume() == scene.Volume,
    name + ": our picker picks as VTK's");
}

}

int TestBlendedWindow(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  for (const int mode : BlendModes)
  {
    TestAlone(mode);
    TestPlane(mode, false);
    TestPlane(mode, true);
    TestSampleDistances(mode);
    TestViewports(mode);
    TestOtherProps(mode);
    TestTwoVolumes(mode);
    TestTiles(mode);
    TestPicks(mode);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
