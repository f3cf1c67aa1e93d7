// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Windows of all kinds show the picture of MakeImage, pixel by pixel. What was made for one
// frame is used for the next.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr int Width = 150, Height = 110;

std::string RouteOf(const Scene& scene)
{
  return scene.Mapper->GetStatistics()->GetRouteAsString();
}

/// Four spheres, which no symmetry helps.
struct Spheres : Scene
{
  Spheres()
    : Scene(Volumes::FourSpheres(48), { 100.0 })
  {
    this->LookFrom(1.0, 2.0, 0.5);
  }
};

void ExpectPicture(Scene& scene, vtkUnsignedCharArray* pixels, int width, int height,
  const std::string& name, int allowed = 0)
{
  Expect(scene.Render(width, height), name + ": MakeImage");
  const PictureDifference difference = CompareWithImage(pixels, width, scene);
  Expect(difference.Hits > 1000 && difference.Different <= allowed,
    name + ": " + std::to_string(difference.Different) + " pixels differ");
}

void TestOffScreenAndResize()
{
  Spheres scene;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  OpenWindow(window, scene.Renderer, Width, Height);
  for (const int scale : { 1, 2, 1 })
  {
    window->SetSize(scale * Width, scale * Height);
    window->Render();
    Expect(RouteOf(scene) == "Cold", "another size is another picture");
    const auto pixels = PixelsOf(window);
    ExpectPicture(scene, pixels, scale * Width, scale * Height, "off screen");
    Expect(RouteOf(scene) == "Redisplay", "the same picture");
  }
}

/// Samples between pixels belong to polygons: a picture covers whole pixels.
void TestMultisampled()
{
  for (const int samples : { 4, 8 })
  {
    Spheres scene;
    vtkNew<vtkRenderWindow> window;
    OpenWindow(window, scene.Renderer, Width, Height);
    window->SetMultiSamples(samples);
    window->Render();
    window->Render();
    Expect(RouteOf(scene) == "Redisplay", "frames of a multisampled window");
    const auto pixels = PixelsOf(window);
    ExpectPicture(scene, pixels, Width, Height, "multisampled");
  }
}

void TestLayers()
{
  Spheres below, above;
  above.Volume->SetPosition(10.0, 0.0, 5.0);
  above.Renderer->SetActiveCamera(below.Renderer->GetActiveCamera());
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, below.Renderer, Width, Height);
  window->SetNumberOfLayers(2);
  above.Renderer->SetLayer(1);
  window->AddRenderer(above.Renderer);
  window->Render();
  below.Renderer->ResetCameraClippingRange();
  window->Render();
  window->Render();
  Expect(RouteOf(above) == "Redisplay" && RouteOf(below) == "Redisplay", "frames of layers");
  const auto pixels = PixelsOf(window);
  Expect(below.Render(Width, Height) && above.Render(Width, Height), "MakeImage");
  int wrong = 0, over = 0, under = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      // The upper layer is transparent where it shows nothing.
      const bool isAbove = above.ColorAt(x, y)[3] != 0;
      const unsigned char* expected = isAbove ? above.ColorAt(x, y) : below.ColorAt(x, y);
      const unsigned char* shown = pixels->GetPointer(4 * (y * Width + x));
      wrong += std::abs(expected[0] - shown[0]) > 1 || std::abs(expected[1] - shown[1]) > 1;
      over += isAbove && below.ColorAt(x, y)[3] != 0;
      under += !isAbove && below.ColorAt(x, y)[3] != 0;
    }
  }
  Expect(wrong == 0, std::to_string(wrong) + " pixels of layers differ");
  Expect(over > 300 && under > 300, "layers overlap");
}

/// Each eye's picture is that of MakeImage with the camera set to that eye, and each eye goes
/// on from its own last frame.
void TestStereo()
{
  for (const int type : { VTK_STEREO_ANAGLYPH, VTK_STEREO_INTERLACED, VTK_STEREO_LEFT,
         VTK_STEREO_RIGHT, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    const std::string name = "stereo of type " + std::to_string(type);
    Spheres scene;
    scene.Mapper->SetReuseAccuracyToPaper();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetEyeAngle(4.0);
    scene.Renderer->ResetCameraClippingRange();
    vtkNew<vtkRenderWindow> window;
    OpenWindow(window, scene.Renderer, Width, Height);
    window->StereoRenderOn();
    window->SetStereoType(type);
    window->SetAnaglyphColorSaturation(1.0f);
    window->SetAnaglyphColorMask(4, 3); // red left, green and blue right
    window->Render();
    Expect(RouteOf(scene) == "Cold", name + ": the first frame");
    window->Render();
    Expect(RouteOf(scene) == "Redisplay", name + ": the second frame");
    const auto pixels = PixelsOf(window);

    // The mapper remembers both eyes.
    vtkNew<vtkImageData> left;
    camera->SetLeftEye(1);
    Expect(scene.Render(Width, Height), name + ": left eye");
    Expect(type == VTK_STEREO_RIGHT || RouteOf(scene) == "Redisplay", name + ": left eye again");
    left->DeepCopy(scene.Color);
    camera->SetLeftEye(0);
    Expect(scene.Render(Width, Height), name + ": right eye");
    Expect(type == VTK_STEREO_LEFT || RouteOf(scene) == "Redisplay", name + ": right eye again");
    Expect(!AreIdentical(left, scene.Color), name + ": the eyes see different pictures");
    int wrong = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const auto* ofLeft = static_cast<unsigned char*>(left->GetScalarPointer(x, y, 0));
        const unsigned char* ofRight = scene.ColorAt(x, y);
        const unsigned char* shown = pixels->GetPointer(4 * (y * Width + x));
        const auto differs = [&](const unsigned char* eye, int c)
        { return std::abs(eye[c] - shown[c]) > 1; };
        if (type == VTK_STEREO_ANAGLYPH)
        {
          wrong += differs(ofLeft, 0) || differs(ofRight, 1) || differs(ofRight, 2);
        }
        else if (type == VTK_STEREO_LEFT || type == VTK_STEREO_RIGHT)
        {
          wrong += differs(type == VTK_STEREO_LEFT ? ofLeft : ofRight, 0);
        }
        else if (type == VTK_STEREO_INTERLACED)
        {
          wrong += differs(ofLeft, 0) && differs(ofRight, 0);
        }
      }
    }
    Expect(wrong == 0, name + ": " + std::to_string(wrong) + " pixels differ");

    // While the camera turns, each eye starts from its own picture.
    for (int step = 0; step < 2; ++step)
    {
      camera->Azimuth(1.0);
      scene.Renderer->ResetCameraClippingRange();
      window->Render();
      Expect(RouteOf(scene) == "ImageCache", name + ": a turn");
    }
  }
}

/// Large pictures of small windows, in tiles, without seams.
void TestScreenshots()
{
  for (const int scale : { 2, 3 })
  {
    for (const bool isParallel : { false, true })
    {
      for (const bool fixesBoundary : { false, true })
      {
        const std::string name = "scale " + std::to_string(scale) +
          (isParallel ? ", parallel" : "") + (fixesBoundary ? ", boundary" : "");
        Spheres scene;
        scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
        scene.Renderer->GetActiveCamera()->Zoom(1.3);
        vtkNew<vtkRenderWindow> window;
        OpenWindow(window, scene.Renderer, Width, Height);
        window->Render();
        vtkNew<vtkWindowToImageFilter> filter;
        filter->SetInput(window);
        filter->SetScale(scale);
        filter->SetFixBoundary(fixesBoundary);
        filter->SetInputBufferTypeToRGBA();
        filter->ReadFrontBufferOff();
        filter->Update();
        vtkImageData* large = filter->GetOutput();
        auto* pixels = vtkUnsignedCharArray::SafeDownCast(large->GetPointData()->GetScalars());
        int dimensions[3];
        large->GetDimensions(dimensions);
        Expect(dimensions[0] == scale * Width && dimensions[1] == scale * Height, name);
        ExpectPicture(scene, pixels, scale * Width, scale * Height, name);

        window->Render();
        const auto small = PixelsOf(window);
        ExpectPicture(scene, small, Width, Height, name + ", the window afterwards");
      }
    }
  }
}

/// A pass that draws into something larger than the window gets a picture as large as that.
void TestSupersampling()
{
  Spheres scene;
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Width, Height);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> pass;
  pass->SetDelegatePass(steps);
  scene.Renderer->SetPass(pass);
  window->Render();
  window->Render();
  Expect(RouteOf(scene) == "Redisplay", "frames of a pass");
  const int width = static_cast<int>(Width * std::sqrt(5.0));
  const int height = static_cast<int>(Height * std::sqrt(5.0));
  Expect(scene.Mapper->GetStatistics()->GetNumberOfRays() == width * height, "five rays a pixel");
  const auto pixels = PixelsOf(window);
  Expect(scene.Render(width, height), "MakeImage");
  // The pass weighs pixels in its own way, but none is beyond those that it may see.
  int lit = 0, wrong = 0;
  for (int y = 2; y < Height - 2; ++y)
  {
    for (int x = 2; x < Width - 2; ++x)
    {
      int least = 255, most = 0;
      for (int i = 0; i < 81; ++i)
      {
        const int color = scene.ColorAt((2 * x + 1) * width / (2 * Width) - 4 + i % 9,
          (2 * y + 1) * height / (2 * Height) - 4 + i / 9)[0];
        least = std::min(least, color);
        most = std::max(most, color);
      }
      const int shown = pixels->GetValue(4 * (y * Width + x));
      lit += least > 0;
      wrong += shown < least - 1 || shown > most + 1;
    }
  }
  Expect(lit > 300 && wrong == 0, std::to_string(wrong) + " pixels outside of their range");
}

/// A display of tiles: each window shows its part of the whole.
void TestTiledDisplay()
{
  Spheres scene;
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Width, Height);
  window->SetTileScale(2);
  // What vtkWindowToImageFilter and tiled displays do: the camera looks at a part of its picture.
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double angle = camera->GetViewAngle();
  vtkNew<vtkImageData> whole;
  Expect(scene.Render(2 * Width, 2 * Height), "MakeImage");
  whole->DeepCopy(scene.Color);
  camera->SetViewAngle(2.0 *
    vtkMath::DegreesFromRadians(
      std::atan(0.5 * std::tan(vtkMath::RadiansFromDegrees(angle) / 2.0))));
  int wrong = 0, hits = 0;
  for (int tile = 0; tile < 4; ++tile)
  {
    const int column = tile % 2, row = tile / 2;
    window->SetTileViewport(0.5 * column, 0.5 * row, 0.5 * (column + 1), 0.5 * (row + 1));
    camera->SetWindowCenter(2.0 * column - 1.0, 2.0 * row - 1.0);
    window->Render();
    Expect(scene.Mapper->GetStatistics()->GetNumberOfRays() == Width * Height, "rays of a tile");
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const auto* expected = static_cast<unsigned char*>(
          whole->GetScalarPointer(column * Width + x, row * Height + y, 0));
        wrong += std::abs(expected[0] - pixels->GetValue(4 * (y * Width + x))) > 1;
        hits += expected[3] != 0;
      }
    }
  }
  Expect(hits > 4000 && wrong == 0, std::to_string(wrong) + " pixels of tiles differ");
}

}

int TestScene(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestOffScreenAndResize();
  TestMultisampled();
  TestLayers();
  TestStereo();
  TestScreenshots();
  TestSupersampling();
  TestTiledDisplay();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
