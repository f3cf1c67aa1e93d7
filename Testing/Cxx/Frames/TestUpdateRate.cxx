// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Frames are coarser where a distance between rays is set. Where the time that a frame is given
// asks for it, it has fewer rays.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"

#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr int Width = 240, Height = 180;
constexpr double Interactive = 1e9, Still = 1e-4; ///< frames a second

struct Stage : Scene
{
  Stage()
    : Scene(Volumes::FourSpheres(40), { 100.0 })
  {
    this->LookFrom(1.0, 2.0, 0.5);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
  }
  void Turn() { this->Renderer->GetActiveCamera()->Azimuth(0.5); }
  vtkIdType Rays() { return this->Mapper->GetStatistics()->GetNumberOfRays(); }
  vtkNew<vtkRenderWindow> Window;
};

void TestDefaults()
{
  Stage stage;
  Expect(stage.Mapper->GetAutoAdjustSampleDistances() &&
      stage.Mapper->GetImageSampleDistance() == 1.0f &&
      stage.Mapper->GetMinimumImageSampleDistance() == 1.0f &&
      stage.Mapper->GetMaximumImageSampleDistance() == 10.0f,
    "defaults");
  stage.Mapper->AutoAdjustSampleDistancesOff();
  stage.Window->SetDesiredUpdateRate(Interactive);
  for (int frame = 0; frame < 3; ++frame)
  {
    stage.Window->Render();
    Expect(IsRoute(stage, "Cold") && stage.Mapper->GetFrameIsFinal(),
      "off: every frame has all rays, however short the time");
    stage.Turn();
  }
}

/// The window shows each ray of a coarse frame as a block of pixels, colour and depth.
void TestBlocks()
{
  constexpr int Distance = 3;
  Stage stage, coarse;
  stage.Mapper->SetImageSampleDistance(Distance);
  stage.Window->Render();
  Expect(stage.Rays() == Width / Distance * Height / Distance, "a ray for each block");
  Expect(coarse.Render(Width / Distance, Height / Distance), "rendered");

  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkFloatArray> depths;
  stage.Window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 0, colors);
  stage.Window->GetZbufferData(0, 0, Width - 1, Height - 1, depths);
  int different = 0, hits = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const int blockX = x / Distance, blockY = y / Distance;
      const unsigned char* expected = coarse.ColorAt(blockX, blockY);
      const unsigned char* shown = colors->GetPointer(4 * (y * Width + x));
      for (int c = 0; c < 3; ++c)
      {
        different += std::abs(expected[c] - shown[c]) > 1;
      }
      different += (depths->GetValue(y * Width + x) < 1.0f) != (expected[3] != 0);
      different += depths->GetValue(y * Width + x) !=
        depths->GetValue(blockY * Distance * Width + blockX * Distance);

      double position[3], truth[3], normal[3], trueNormal[3];
      int index = -1, trueIndex = -1;
      const bool isHit = stage.Mapper->PickPixel(x, y, position, normal, &index);
      const bool isExpected =
        coarse.Mapper->PickPixel(blockX, blockY, truth, trueNormal, &trueIndex);
      different += isHit != isExpected || index != trueIndex;
      if (isHit && isExpected)
      {
        ++hits;
        different +=
          std::hypot(position[0] - truth[0], position[1] - truth[1], position[2] - truth[2]) > 1e-9;
      }
    }
  }
  Expect(hits > 1000, "something is seen");
  Expect(different == 0, std::to_string(different) + " values differ");
  Expect(!stage.Mapper->PickPixel(Width, 3, nullptr, nullptr, nullptr) &&
      !stage.Mapper->PickPixel(3, Height, nullptr, nullptr, nullptr) &&
      !stage.Mapper->PickPixel(-1, 3, nullptr, nullptr, nullptr),
    "no such pixels");

  // Images are never coarse, and a window is again after one.
  Expect(stage.Render(90, 70) && stage.Rays() == 90 * 70, "an image has a ray a pixel");
  Expect(coarse.Render(90, 70) && AreIdentical(stage.Color, coarse.Color), "it is the same");
  Expect(!stage.Mapper->PickPixel(90, 3, nullptr, nullptr, nullptr), "its pixels are picked");
  stage.Window->Render();
  vtkNew<vtkUnsignedCharArray> again;
  stage.Window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 0, again);
  int changed = 0;
  for (vtkIdType i = 0; i < colors->GetNumberOfValues(); ++i)
  {
    changed += colors->GetValue(i) != again->GetValue(i);
  }
  Expect(changed == 0, "the window shows what it showed");
}

/// Sizes that are no multiple of the distance: every pixel picks the surface within a block of it.
void TestOddSizes()
{
  for (const float distance : { 1.5f, 2.7f, 7.0f, 100.0f })
  {
    const std::string what = "distance " + std::to_string(distance);
    Stage stage, full;
    stage.Window->SetSize(211, 97);
    stage.Mapper->SetImageSampleDistance(distance);
    stage.Window->Render();
    const auto columns = static_cast<int>(std::ceil(211.0 / static_cast<double>(distance)));
    const auto rows = static_cast<int>(std::ceil(97.0 / static_cast<double>(distance)));
    Expect(stage.Rays() == columns * rows, what + ": rays");
    vtkNew<vtkImageData> indices;
    Expect(
      stage.Mapper->GetLastFrame(indices, vtkTemporalCoherenceVolumeMapper::FRAME_ISOVALUE_INDEX) &&
        indices->GetDimensions()[0] == columns && indices->GetDimensions()[1] == rows,
      what + ": a value for each ray");
    int different = 0;
    for (int y = 0; y < 97; ++y)
    {
      for (int x = 0; x < 211; ++x)
      {
        int index = -1;
        stage.Mapper->PickPixel(x, y, nullptr, nullptr, &index);
        const int atX = (2 * x + 1) * columns / (2 * 211), atY = (2 * y + 1) * rows / (2 * 97);
        different += index != *static_cast<int*>(indices->GetScalarPointer(atX, atY, 0));
      }
    }
    Expect(different == 0, what + ": " + std::to_string(different) + " pixels pick another ray");
  }
}

void TestAutomatic()
{
  Stage stage;
  const auto traced = [&]() { return stage.Mapper->GetStatistics()->GetNumberOfTracedRays(); };
  stage.Window->SetDesiredUpdateRate(Interactive);
  stage.Window->Render();
  Expect(IsRoute(stage, "FewerRays") && stage.Rays() == Width * Height && traced() > 100 &&
      traced() <= (Width / 6) * (Height / 6),
    "nothing is known: few rays");
  Expect(!stage.Mapper->GetFrameIsFinal(), "rendering again makes it better");

  stage.Turn();
  stage.Window->Render();
  Expect(traced() <= (Width / 10) * (Height / 10), "no time: as few as is allowed");
  int hits = 0;
  for (int x = 0; x < Width; x += 7)
  {
    hits += stage.Mapper->PickPixel(x, Height / 2, nullptr, nullptr, nullptr);
  }
  Expect(hits > 5, "pixels are picked");
  stage.Window->Render();
  Expect(IsRoute(stage, "Refine") && traced() == 0 && !stage.Mapper->GetFrameIsFinal(),
    "the same view, and no time");

  stage.Mapper->SetMaximumImageSampleDistance(2.0f);
  stage.Turn();
  stage.Window->Render();
  Expect(traced() > 500 && traced() <= Width * Height / 4, "the limit that is set");

  // The still picture.
  stage.Window->SetDesiredUpdateRate(Still);
  stage.Window->Render();
  Expect(IsRoute(stage, "Refine") && stage.Mapper->GetFrameIsFinal(), "a still frame is whole");
  ColdWitness witness;
  Expect(stage.Render(Width, Height) && IsRoute(stage, "Redisplay") && witness.Draw(stage) &&
      witness.IsIdentical(stage),
    "and exact");

  // Images are not part of it.
  stage.Window->SetDesiredUpdateRate(Interactive);
  stage.Turn();
  stage.Window->Render();
  Expect(IsRoute(stage, "FewerRays"), "the window has fewer");
  Expect(stage.Render(Width, Height) && IsRoute(stage, "Refine") && witness.Draw(stage) &&
      witness.IsIdentical(stage),
    "an image of the same view has all rays");
  stage.Turn();
  stage.Mapper->RenderToImageOn();
  stage.Window->Render();
  Expect(IsRoute(stage, "Cold"), "and so has one that is drawn for images alone");
  stage.Mapper->RenderToImageOff();

  stage.Mapper->SetReuseAccuracyToPaper();
  stage.Turn();
  stage.Window->Render();
  Expect(!IsRoute(stage, "FewerRays"), "PAPER is a method of its own");
}

/// An isomap that is built ahead is that of the window's frames.
void TestIsomapAhead()
{
  Stage stage;
  stage.Mapper->SetImageSampleDistance(2.0f);
  stage.Window->Render();
  Expect(stage.Mapper->BuildIsomap(stage.Renderer, stage.Volume), "built");
  stage.SetIsovalues({ 100.5 });
  stage.Window->Render();
  Expect(IsRoute(stage, "IsomapLookup"), "used");
}

}

int TestUpdateRate(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestDefaults();
  TestBlocks();
  TestOddSizes();
  TestAutomatic();
  TestIsomapAhead();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
