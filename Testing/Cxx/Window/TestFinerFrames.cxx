// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// More rays than pixels (ImageSampleDistance below 1): a window shows the means of the rays of the
// cold picture that has as many pixels, and depths, picks and selections of the ray in the middle.

#include "Checks/Expect.h"
#include "Render/SampleDistance.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Window/WindowRays.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"

#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkHardwareSelector.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace
{

/// A window, and how many rays it has: as many along both axes for each pixel.
struct Kind
{
  std::string Name;
  int Width, Height; ///< of the window
  int Columns, Rows; ///< of rays
  float Distance;    ///< that asks for them
  double Opacity = 1.0;
  std::array<double, 4> Viewport = { 0.0, 0.0, 1.0, 1.0 };

  double ColumnsOfPixel() const { return static_cast<double>(this->Columns) / this->Width; }
  double RowsOfPixel() const { return static_cast<double>(this->Rows) / this->Height; }
};

std::vector<Kind> AllKinds()
{
  return {
    { "4 rays a pixel", 120, 90, 240, 180, 0.5f },
    { "100 rays a pixel", 60, 45, 600, 450, 0.1f },
    { "not a whole number", 100, 60, 125, 75, 0.8f },
    { "not a whole number, more", 90, 60, 300, 200, 0.3f },
    { "translucent", 100, 60, 250, 150, 0.4f, 0.4 },
    { "a part of the window", 120, 90, 240, 180, 0.5f, 1.0, { 0.25, 0.1, 0.75, 0.6 } },
  };
}

/// Part of a ray that a pixel has along an axis.
double ShareOf(int ray, int pixel, double raysOfPixel)
{
  return std::max(
    std::min(ray + 1.0, (pixel + 1) * raysOfPixel) - std::max<double>(ray, pixel * raysOfPixel),
    0.0);
}

struct Stage : Scene
{
  explicit Stage(const Kind& kind)
    : Scene(Volumes::FourSpheres(40), { 100.0 })
    , Of(kind)
  {
    const std::array<double, 4>& part = kind.Viewport;
    this->LookFrom(1.0, 2.0, 0.5);
    this->Renderer->SetViewport(part[0], part[1], part[2], part[3]);
    this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, kind.Opacity);
    this->Volume->GetProperty()->SetScalarOpacity(opacity);
    this->Mapper->SetImageSampleDistance(kind.Distance);
    OpenWindow(this->Window, this->Renderer,
      static_cast<int>(std::lround(kind.Width / (part[2] - part[0]))),
      static_cast<int>(std::lround(kind.Height / (part[3] - part[1]))));
  }

  void Draw()
  {
    this->Window->Render();
    const int* first = this->Renderer->GetOrigin();
    const int last[2] = { first[0] + this->Of.Width - 1, first[1] + this->Of.Height - 1 };
    this->Window->GetRGBACharPixelData(first[0], first[1], last[0], last[1], 0, this->Pixels);
    this->Window->GetZbufferData(first[0], first[1], last[0], last[1], this->Buffer);
  }

  static constexpr double Background[3] = { 0.2, 0.4, 0.6 };

  Kind Of;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkUnsignedCharArray> Pixels;
  vtkNew<vtkFloatArray> Buffer;
};

/// What a window shows of a picture of rays, computed from these.
class Truth
{
public:
  /// \param rays have been rendered
  explicit Truth(const Stage& stage, const Scene& rays)
    : Of(stage.Of)
    , Rays(rays)
  {
  }

  /// The colour of a pixel, before a background.
  std::array<double, 4> MeanAt(int x, int y) const
  {
    std::array<double, 4> mean{};
    this->ForRays(x, y,
      [&](int column, int row, double share)
      {
        for (std::size_t c = 0; c < 4; ++c)
        {
          mean[c] += share * this->Rays.ColorAt(column, row)[c];
        }
      });
    return mean;
  }

  /// The ray that tells where the pixel's surface is: its row and column; -1 if there is none.
  std::array<int, 2> RayAt(int x, int y) const
  {
    std::array<int, 2> found = { static_cast<int>((x + 0.5) * this->Of.ColumnsOfPixel() + 1e-9),
      static_cast<int>((y + 0.5) * this->Of.RowsOfPixel() + 1e-9) };
    if (!std::isfinite(this->Rays.DepthAt(found[0], found[1])))
    {
      found = { -1, -1 };
      float nearest = std::numeric_limits<float>::infinity();
      this->ForRays(x, y,
        [&](int column, int row, double)
        {
          if (this->Rays.DepthAt(column, row) < nearest)
          {
            nearest = this->Rays.DepthAt(column, row);
            found = { column, row };
          }
        });
    }
    return found;
  }

private:
  template <typename Work>
  void ForRays(int x, int y, const Work& work) const
  {
    const double columns = this->Of.ColumnsOfPixel(), rows = this->Of.RowsOfPixel();
    for (int row = 0; row < this->Of.Rows; ++row)
    {
      const double ofRow = ShareOf(row, y, rows) / rows;
      for (int column = 0; ofRow > 1e-9 && column < this->Of.Columns; ++column)
      {
        const double share = ofRow * ShareOf(column, x, columns) / columns;
        if (share > 1e-9)
        {
          work(column, row, share);
        }
      }
    }
  }

  const Kind& Of;
  const Scene& Rays;
};

/// Where a point of the world is in the depth buffer.
double DepthOf(const Stage& stage, const double position[3])
{
  vtkRenderer* renderer = stage.Renderer;
  renderer->SetWorldPoint(position[0], position[1], position[2], 1.0);
  renderer->WorldToDisplay();
  return renderer->GetDisplayPoint()[2];
}

void ExpectMeans(Stage& stage, const std::string& what)
{
  const Kind& kind = stage.Of;
  Scene rays(vtkImageData::SafeDownCast(stage.Mapper->GetInput()), { 0.0 });
  rays.Renderer->SetActiveCamera(stage.Renderer->GetActiveCamera());
  rays.Volume->SetProperty(stage.Volume->GetProperty());
  Expect(rays.Render(kind.Columns, kind.Rows), what + ": rendered");
  vtkNew<vtkImageData> color;
  Expect(stage.Mapper->GetLastFrame(color, vtkTemporalCoherenceVolumeMapper::FRAME_COLOR) &&
      AreIdentical(color, rays.Color) &&
      stage.Mapper->GetStatistics()->GetNumberOfRays() == kind.Columns * kind.Rows,
    what + ": the frame is the cold picture with as many pixels as rays");
  const Truth truth(stage, rays);
  int wrongColors = 0, wrongDepths = 0, wrongPicks = 0, hits = 0, edges = 0;
  for (int y = 0; y < kind.Height; ++y)
  {
    for (int x = 0; x < kind.Width; ++x)
    {
      const auto mean = truth.MeanAt(x, y);
      const unsigned char* shown = stage.Pixels->GetPointer(4 * (y * kind.Width + x));
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double expected = mean[c] + (255.0 - mean[3]) * Stage::Background[c];
        wrongColors += std::abs(shown[c] - expected) > 1.6; // what is rounded three times
      }
      const std::array<int, 2> ray = truth.RayAt(x, y);
      double position[3] = {}, there[3] = {};
      const bool isHit = stage.Mapper->PickPixel(x, y, position, nullptr, nullptr);
      const bool isExpected = ray[0] >= 0;
      wrongPicks += isHit != isExpected ||
        (isHit &&
          !(rays.Mapper->PickPixel(ray[0], ray[1], there, nullptr, nullptr) &&
            std::equal(position, position + 3, there)));
      const bool isOpaque = mean[3] > 254.999;
      const double depth = static_cast<double>(stage.Buffer->GetValue(y * kind.Width + x));
      wrongDepths += std::abs(depth - (isOpaque ? DepthOf(stage, position) : 1.0)) > 1e-6;
      hits += isExpected;
      edges += mean[3] > 0.0 && !isOpaque;
    }
  }
  Expect(wrongColors == 0 && wrongDepths == 0 && wrongPicks == 0,
    what + ": " + std::to_string(wrongColors) + " colours, " + std::to_string(wrongDepths) +
      " depths and " + std::to_string(wrongPicks) + " picks are wrong");
  const bool hasEdges = edges > 30 || kind.Columns == kind.Width;
  Expect(hits > 250 && hasEdges,
    what + ": something is seen, but there are " + std::to_string(hits) + " hits and " +
      std::to_string(edges) + " edges");
}

void TestMeans()
{
  for (const Kind& kind : AllKinds())
  {
    Stage stage(kind);
    stage.Draw();
    ExpectMeans(stage, kind.Name);
    stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
    stage.Draw();
    stage.Draw(); // the second is exact
    ExpectMeans(stage, kind.Name + ", parallel");
  }
}

/// What is selected is what is picked.
void TestSelection()
{
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    Stage stage(AllKinds()[3]);
    stage.Draw();
    const Kind& kind = stage.Of;
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(stage.Renderer);
    selector->SetArea(
      0, 0, static_cast<unsigned>(kind.Width - 1), static_cast<unsigned>(kind.Height - 1));
    selector->SetFieldAssociation(association);
    Expect(selector->CaptureBuffers(), "captured");
    auto* image = vtkImageData::SafeDownCast(stage.Mapper->GetInput());
    int wrong = 0, found = 0;
    for (unsigned y = 0; y < static_cast<unsigned>(kind.Height); ++y)
    {
      for (unsigned x = 0; x < static_cast<unsigned>(kind.Width); ++x)
      {
        const unsigned place[2] = { x, y };
        const auto pixel = selector->GetPixelInformation(place);
        double at[3];
        const bool isHit =
          stage.Mapper->PickPixel(static_cast<int>(x), static_cast<int>(y), at, nullptr, nullptr);
        wrong += pixel.Valid != isHit;
        found += isHit;
        wrong += isHit && association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
          pixel.AttributeID != image->FindPoint(at);
      }
    }
    Expect(found > 400 && wrong == 0, "selected: " + std::to_string(wrong) + " pixels are wrong");
  }
}

/// Frames use one another again as others do, and images have the pixels that are asked for.
void TestRoutes()
{
  Stage stage(AllKinds()[0]);
  stage.Mapper->SetReuseAccuracyToPaper();
  const auto expect = [&](const std::string& route)
  {
    stage.Draw();
    Expect(IsRoute(stage, route) && stage.Mapper->GetStatistics()->GetNumberOfRays() == 240 * 180,
      route + ": the route is " + stage.Mapper->GetStatistics()->GetRouteAsString());
  };
  expect("Cold");
  Expect(stage.Mapper->BuildIsomap(stage.Renderer, stage.Volume), "an isomap is built ahead");
  stage.SetIsovalues({ 100.5 });
  expect("IsomapLookup");
  expect("Redisplay");
  ExpectMeans(stage, "from an isomap");
  stage.Renderer->GetActiveCamera()->Azimuth(1.0);
  expect("ImageCache");
  expect("Cold");
  ExpectMeans(stage, "refined");
  stage.Volume->GetProperty()->SetAmbient(0.4);
  expect("Reshade");
  ExpectMeans(stage, "shaded again");

  Expect(stage.Render(70, 50) && stage.Mapper->GetStatistics()->GetNumberOfRays() == 70 * 50,
    "an image has the pixels that are asked for");
  Expect(!stage.Mapper->PickPixel(70, 3, nullptr, nullptr, nullptr), "which are picked");
  stage.Draw();
  ExpectMeans(stage, "the window again");

  // Back and forth between as many rays as pixels, more and fewer.
  for (const float distance : { 1.0f, 0.5f, 3.0f, 0.5f, 1.0f })
  {
    stage.Mapper->SetImageSampleDistance(distance);
    stage.Draw();
    if (distance == 0.5f)
    {
      ExpectMeans(stage, "after another distance");
    }
  }
}

/// As many rays in a window with other pixels are another picture.
void TestOtherPixels()
{
  Stage stage(AllKinds()[0]);
  stage.Draw();
  for (const int scale : { 2, 1 })
  {
    stage.Of.Width = 120 * scale;
    stage.Of.Height = 90 * scale;
    stage.Window->SetSize(stage.Of.Width, stage.Of.Height);
    stage.Mapper->SetImageSampleDistance(0.5f * static_cast<float>(scale));
    stage.Draw();
    Expect(IsRoute(stage, "Redisplay"), "the rays are the same");
    ExpectMeans(stage, "other pixels");
  }
}

/// Frames that are finer than pixels have fewer rays while there is no time.
void TestAutomatic()
{
  Stage stage(AllKinds()[0]);
  stage.Mapper->SetImageSampleDistance(0.5f);
  stage.Window->SetDesiredUpdateRate(1e9);
  stage.Draw();
  Expect(IsRoute(stage, "FewerRays") &&
      stage.Mapper->GetStatistics()->GetNumberOfTracedRays() < 120 * 90,
    "no time: fewer");
  stage.Window->SetDesiredUpdateRate(1e-4);
  stage.Draw();
  Expect(IsRoute(stage, "Refine"), "then the others");
  ExpectMeans(stage, "a still picture");
}

/// The mapper behind VTK's name shows the same.
void TestDoorOne()
{
  const Kind kind = AllKinds()[0];
  Stage stage(kind);
  stage.Draw();
  vtkNew<vtkUnsignedCharArray> expected;
  expected->DeepCopy(stage.Pixels);
  vtkNew<vtkTemporalCoherenceGPUVolumeRayCastMapper> door;
  door->SetInputData(vtkImageData::SafeDownCast(stage.Mapper->GetInput()));
  door->SetBlendModeToIsoSurface();
  door->AutoAdjustSampleDistancesOff();
  door->SetImageSampleDistance(kind.Distance);
  stage.Volume->SetMapper(door);
  stage.Draw();
  Expect(door->GetDrewIsosurfaces() &&
      door->GetIsosurfaceMapper()->GetStatistics()->GetNumberOfRays() == kind.Columns * kind.Rows &&
      std::memcmp(expected->GetPointer(0), stage.Pixels->GetPointer(0),
        static_cast<std::size_t>(expected->GetNumberOfValues())) == 0,
    std::string("behind VTK's name: another picture, since ") + door->GetReason());
}

/// A frame has no more rays than fit into memory, which is told once.
void TestLimit()
{
  using namespace TemporalCoherence;
  vtkNew<vtkVolume> volume;
  WindowRays rays;
  std::string warning;
  const glm::ivec2 window(2000, 1000);
  const auto ask = [&](double distance)
  {
    warning.clear();
    return rays.For(window, distance, volume, warning);
  };
  Expect(ask(0.5) == 2 * window && warning.empty(), "as many as asked for");
  const glm::ivec2 most = ask(0.1);
  Expect(std::abs(most.x * 1.0 * most.y - MostRays) < 0.01 * MostRays &&
      warning.find("ImageSampleDistance 0.1 needs 200000000 rays") != std::string::npos &&
      warning.find("SetImageSampleDistance") != std::string::npos,
    "the most: " + warning);
  Expect(ask(0.1) == most && warning.empty(), "told once");
  Expect(rays.For(window / 10, 0.1, volume, warning) == window && warning.empty() &&
      ask(0.1) == most && warning.empty(),
    "not told again after a frame in a smaller window of the same mapper");
  Expect(ask(1.0) == window && warning.empty(), "a ray a pixel");
  Expect(ask(0.1) == most && !warning.empty(), "told again after a frame without it");
  const glm::ivec2 huge(10000, 10000);
  Expect(rays.For(huge, 0.5, volume, warning) == huge &&
      rays.For(huge, 2.0, volume, warning) == huge / 2,
    "windows are never coarser for that");
}

}

int TestFinerFrames(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestMeans();
  TestSelection();
  TestRoutes();
  TestOtherPixels();
  TestAutomatic();
  TestDoorOne();
  TestLimit();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
