// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In a render window, the picture of MakeImage hides other props, and is hidden by them, pixel
// by pixel.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkActor.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>

namespace
{

constexpr int Size = 300;

/// A ball of radius 0.5 as a distance field.
vtkSmartPointer<vtkImageData> Ball(int n)
{
  return Volumes::FromFormula(
    n, VTK_FLOAT, [](double x, double y, double z) { return -std::hypot(x, y, z); });
}

void TestSamePicture()
{
  Scene scene(Volumes::FourSpheres(48), { 100.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(scene.Renderer);
  window->Render();
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Cold",
    "first frame is cold");
  Expect(scene.Mapper->GetStatistics()->GetPresentTime() > 0.0, "it was shown");
  window->Render();
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    "second frame is shown again");
  const auto pixels = PixelsOf(window);

  Expect(scene.Render(Size, Size), "MakeImage");
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    "is the same picture");
  int different = 0, hits = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const unsigned char* expected = scene.ColorAt(x, y);
      const unsigned char* shown = pixels->GetPointer(4 * (y * Size + x));
      const bool isHit = expected[3] != 0;
      hits += isHit;
      for (int c = 0; c < 3; ++c)
      {
        different += std::abs((isHit ? expected[c] : 0) - shown[c]) > 1;
      }
    }
  }
  Expect(hits > 1000 && different == 0, std::to_string(different) + " channels differ");

  // Another picture is shown when there is one.
  scene.SetIsovalues({ 250.0 });
  window->Render();
  const auto later = PixelsOf(window);
  long changed = 0;
  for (vtkIdType i = 0; i < later->GetNumberOfValues(); ++i)
  {
    changed += later->GetValue(i) != pixels->GetValue(i);
  }
  Expect(changed > 1000, "a new isovalue is seen in the window");
  scene.SetIsovalues({ 100.0 });

  // A picture of another shape than the window's has the shape it is asked for.
  Scene alone(Volumes::FourSpheres(48), { 100.0 });
  alone.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(Size, Size / 2) && alone.Render(Size, Size / 2), "MakeImage");
  Expect(AreIdentical(scene.Depth, alone.Depth), "the window does not shape the picture");
}

/// A polygonal sphere half inside an isosurface sphere: at each pixel the nearer one is seen, up to
/// the facets of the polygons.
void TestMutualHiding()
{
  constexpr double Radius = 0.5, Shift = 0.45;
  for (const bool parallel : { false, true })
  {
    Scene scene(Ball(81), { -Radius });
    scene.Volume->GetProperty()->ShadeOff();
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(Radius);
    sphere->SetCenter(Shift, 0.1, 0.0);
    sphere->SetThetaResolution(400);
    sphere->SetPhiResolution(400);
    vtkNew<vtkPolyDataMapper> polygons;
    polygons->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(polygons);
    actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    actor->GetProperty()->LightingOff();
    scene.Renderer->AddActor(actor);
    scene.LookFrom(0.2, -2.0, 0.5);
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    scene.Renderer->GetActiveCamera()->Zoom(1.5);
    scene.Renderer->ResetCameraClippingRange();
    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->SetSize(Size, Size);
    window->AddRenderer(scene.Renderer);
    window->Render();
    const auto pixels = PixelsOf(window);

    // The truth: two spheres met by the same ray.
    Expect(scene.Render(Size, Size), "MakeImage");
    int wrong = 0, isosurface = 0, polygon = 0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        double position[3], t[2];
        if (!scene.Mapper->PickPixel(x, y, position, nullptr, nullptr))
        {
          continue;
        }
        double eye[3], direction[3];
        scene.Renderer->GetActiveCamera()->GetPosition(eye);
        scene.Renderer->GetActiveCamera()->GetDirectionOfProjection(direction);
        double length = 0.0;
        for (int a = 0; a < 3 && !parallel; ++a)
        {
          direction[a] = position[a] - eye[a];
          length += direction[a] * direction[a];
        }
        // Where the ray through the hit meets the polygonal sphere, measured from the hit.
        const double centre[3] = { Shift, 0.1, 0.0 };
        double b = 0.0, c = -Radius * Radius;
        for (int a = 0; a < 3; ++a)
        {
          direction[a] /= parallel ? 1.0 : std::sqrt(length);
          b += direction[a] * (position[a] - centre[a]);
          c += (position[a] - centre[a]) * (position[a] - centre[a]);
        }
        const double discriminant = b * b - c;
        t[0] = discriminant > 0.0 ? -b - std::sqrt(discriminant) : 1e9;
        if (std::abs(t[0]) < 2e-3 || std::abs(discriminant) < 5e-3)
        {
          continue; // facets and samples decide
        }
        const unsigned char* shown = pixels->GetPointer(4 * (y * Size + x));
        const bool showsPolygon = shown[2] > 250 && shown[0] < 5;
        const bool expectsPolygon = t[0] < 0.0;
        wrong += showsPolygon != expectsPolygon;
        (expectsPolygon ? polygon : isosurface)++;
      }
    }
    Expect(isosurface > 1000 && polygon > 1000, "both are seen");
    Expect(wrong == 0,
      std::to_string(wrong) + " pixels show the farther one" + (parallel ? ", parallel" : ""));
  }
}

/// Two viewports of one window; the picture of each is where it belongs.
void TestViewports()
{
  Scene left(Ball(31), { -0.5 }), right(Ball(31), { -0.5 });
  left.LookFrom(1.0, 2.0, 0.5);
  right.LookFrom(1.0, 2.0, 0.5);
  left.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right.Renderer->SetViewport(0.5, 0.25, 1.0, 0.75);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(2 * Size, Size);
  window->AddRenderer(left.Renderer);
  window->AddRenderer(right.Renderer);
  window->Render();
  const auto pixels = PixelsOf(window);
  const auto isLit = [&](int x, int y)
  { return pixels->GetPointer(4 * (y * 2 * Size + x))[0] > 40; };
  Expect(left.Mapper->GetStatistics()->GetNumberOfRays() == Size * Size, "left viewport");
  Expect(right.Mapper->GetStatistics()->GetNumberOfRays() == Size * Size / 2, "right viewport");
  Expect(isLit(Size / 2, Size / 2) && isLit(3 * Size / 2, Size / 2), "both balls are seen");
  Expect(!isLit(Size + 5, 5) && !isLit(5, 5), "nothing beside them");
  Expect(
    left.Mapper->PickPixel(Size / 2, Size / 2, nullptr, nullptr, nullptr), "picked at the left");

  // Another size of the same window, then another window.
  window->SetSize(Size, Size / 2);
  window->Render();
  Expect(left.Mapper->GetStatistics()->GetNumberOfRays() == Size * Size / 4, "smaller window");
  window->RemoveRenderer(left.Renderer);
  vtkNew<vtkRenderWindow> other;
  other->SetSize(100, 80);
  left.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  other->AddRenderer(left.Renderer);
  other->Render();
  Expect(left.Mapper->GetStatistics()->GetNumberOfRays() == 8000, "other window");
  window->Render();
}

/// What is held in the context of a window goes when it is asked to, or when the window is closed,
/// for all viewers, and comes back with the next picture.
void TestRelease()
{
  Scene left(Ball(31), { -0.5 }), right(nullptr, { -0.5 });
  right.Volume->SetMapper(left.Mapper);
  left.LookFrom(1.0, 2.0, 0.5);
  right.LookFrom(-1.0, 1.0, 2.0);
  left.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderWindow> window, other;
  window->SetMultiSamples(0);
  window->SetSize(2 * Size, Size);
  window->AddRenderer(left.Renderer);
  window->AddRenderer(right.Renderer);
  const auto countHeld = [&]
  { return vtkOpenGLRenderWindow::SafeDownCast(window)->Resources.size(); };
  left.Volume->VisibilityOff();
  right.Volume->VisibilityOff();
  window->Render();
  const std::size_t without = countHeld();
  left.Volume->VisibilityOn();
  window->Render();
  const std::size_t withOne = countHeld();
  right.Volume->VisibilityOn();
  window->Render();
  const std::size_t withTwo = countHeld();
  Expect(without < withOne && withOne < withTwo, "each viewer holds something");
  const auto before = PixelsOf(window);
  Expect(before->GetPointer(4 * (Size / 2 * 2 * Size + Size / 2))[0] > 40, "a ball at the left");
  Expect(before->GetPointer(4 * (Size / 2 * 2 * Size + 3 * Size / 2))[0] > 40, "and at the right");
  const auto expectSame = [&](const std::string& after)
  {
    window->Render();
    Expect(std::string(left.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
      "no ray is traced " + after);
    const auto pixels = PixelsOf(window);
    long different = 0;
    for (vtkIdType i = 0; i < before->GetNumberOfValues(); ++i)
    {
      different += before->GetValue(i) != pixels->GetValue(i);
    }
    Expect(different == 0, std::to_string(different) + " values differ " + after);
  };

  left.Mapper->ReleaseGraphicsResources(other);
  Expect(countHeld() == withTwo, "another window's are not this one's");
  left.Mapper->ReleaseGraphicsResources(window);
  Expect(countHeld() == without, "nothing is held after it was released");
  expectSame("after it was released");
  Expect(countHeld() == withTwo, "what is needed comes back");
  left.Mapper->ReleaseGraphicsResources(nullptr);
  Expect(countHeld() == without, "nothing is held in any window");
  expectSame("after all was released");
  window->Finalize();
  expectSame("after the window was closed");
}

}

int TestWindow(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestSamePicture();
  TestMutualHiding();
  TestViewports();
  TestRelease();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
