// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Picks hit what is seen. They agree with the pixels, with brute force, and with vtkVolumePicker
// where that can find the same surface.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherencePicker.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkLODProp3D.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace
{

using Point = std::array<double, 3>;

double DistanceOf(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The part of a pixel's ray between the clipping planes, straight from the camera's matrix.
struct PixelLine
{
  PixelLine(vtkRenderer* renderer, int x, int y, int width, int height)
  {
    vtkNew<vtkMatrix4x4> world;
    vtkMatrix4x4::Invert(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                           static_cast<double>(width) / height, -1.0, 1.0),
      world);
    const double atX = (2.0 * x + 1.0) / width - 1.0, atY = (2.0 * y + 1.0) / height - 1.0;
    const auto toWorld = [&](double depth)
    {
      const double clip[4] = { atX, atY, depth, 1.0 };
      double point[4];
      world->MultiplyPoint(clip, point);
      return Point{ point[0] / point[3], point[1] / point[3], point[2] / point[3] };
    };
    this->Near = toWorld(-1.0);
    this->Far = toWorld(1.0);
  }
  Point Near, Far;
};

/// Lines through the pixels of a picture meet what the pixels show, and what brute force finds; the
/// lines are traced by a mapper that has no frame.
void ExpectLinesHitPixels(const std::string& what, Scene& scene, const BruteForceTracer& truth)
{
  constexpr int Width = 83, Height = 61;
  scene.Mapper->ClearCache();
  Expect(scene.Render(Width, Height), what + ": rendered");
  vtkNew<vtkTemporalCoherenceVolumeMapper> bare;
  bare->SetInputData(vtkImageData::SafeDownCast(scene.Mapper->GetInput()));
  bare->SetSurfaceMode(scene.Mapper->GetSurfaceMode());
  int hits = 0, differentHits = 0, differentTruth = 0, distant = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const PixelLine line(scene.Renderer, x, y, Width, Height);
      double t = -1.0, position[3], normal[3], seenPosition[3], seenNormal[3];
      int index = -1, seenIndex = -1;
      const bool isHit = bare->IntersectWithLine(
        scene.Volume, line.Near.data(), line.Far.data(), t, position, normal, &index);
      const bool isSeen = scene.Mapper->PickPixel(x, y, seenPosition, seenNormal, &seenIndex);
      const BruteForceTracer::Hit hit = truth.Trace(scene.Renderer, x, y, Width, Height);
      differentHits += isHit != isSeen || index != seenIndex;
      differentTruth += index != hit.Isovalue;
      if (isHit && isSeen && index == hit.Isovalue)
      {
        ++hits;
        const double length = DistanceOf(line.Near.data(), line.Far.data());
        const double near = 1e-3 * truth.Field.VoxelSize();
        distant += DistanceOf(position, seenPosition) > near ||
          DistanceOf(position, hit.Position.data()) > near ||
          DistanceOf(normal, seenNormal) > 1e-3 ||
          std::abs(DistanceOf(line.Near.data(), position) - t * length) > 1e-9 * length;
      }
    }
  }
  Expect(hits > 250, what + ": " + std::to_string(hits) + " hits");
  // A ray in a few thousand grazes a surface, or passes from cell to cell at an edge.
  Expect(differentHits <= 2, what + ": " + std::to_string(differentHits) + " differ from pixels");
  Expect(differentTruth <= 2, what + ": " + std::to_string(differentTruth) + " from brute force");
  Expect(distant <= 2, what + ": " + std::to_string(distant) + " lie elsewhere");
}

void TestLines()
{
  const vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 500.0, 9000.0, -300.0, 0.0 });
  vtkNew<vtkPiecewiseFunction> opacity; // leaves 0.0 out
  for (const auto& [value, at] : { std::pair{ -300.0, 1.0 }, { 0.0, 0.0 }, { 500.0, 1.0 } })
  {
    opacity->AddPoint(value, at);
  }
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  image->SetDirectionMatrix(0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, -1.0);
  scene.Volume->SetScale(1.0, 1.4, 0.7);
  scene.Volume->RotateX(25.0);
  scene.LookFrom(1.0, 2.0, 0.7);
  scene.Renderer->GetActiveCamera()->Zoom(1.6);
  for (const bool isThreshold : { false, true })
  {
    for (const bool isParallel : { false, true })
    {
      for (const bool isNearest : { false, true })
      {
        scene.Mapper->SetSurfaceMode(isThreshold);
        scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
        scene.Volume->GetProperty()->SetInterpolationType(
          isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
        BruteForceTracer truth(image, scene.Volume);
        // The one that is left out is where nothing is.
        truth.Isovalues = { 500.0, 9000.0, -300.0, 1e9 };
        truth.IsThreshold = isThreshold;
        ExpectLinesHitPixels(std::string(isThreshold ? "threshold" : "crossing") +
            (isParallel ? ", parallel" : ", perspective") + (isNearest ? ", nearest" : ", linear"),
          scene, truth);
      }
    }
  }
  // The near plane cuts solids open: lines that begin there are capped as pixels are.
  const double* range = scene.Renderer->GetActiveCamera()->GetClippingRange();
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5 * (range[0] + range[1]), range[1]);
  BruteForceTracer truth(image, scene.Volume);
  truth.Isovalues = { 500.0, 9000.0, -300.0, 1e9 };
  truth.IsThreshold = true;
  ExpectLinesHitPixels("cut by the near plane", scene, truth);
}

void TestLineArguments()
{
  Scene scene(Volumes::FourSpheres(24), { 100.0 });
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  const double outside[3] = { -5.0, 8.0, 8.0 }, inside[3] = { 30.0, 8.0, 8.0 };
  const double bad[3] = { std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 };
  double t = -7.0;
  const auto meets = [&](const double* p1, const double* p2)
  { return scene.Mapper->IntersectWithLine(scene.Volume, p1, p2, t, nullptr, nullptr, nullptr); };
  const auto says = [&](const std::string& word)
  {
    const bool said =
      observer->GetError() && observer->GetErrorMessage().find(word) != std::string::npos;
    observer->Clear();
    return said;
  };
  Expect(meets(outside, inside) && t > 0.0 && t < 1.0, "what is told is optional");
  t = -7.0;
  const double before[3] = { -1.0, 8.0, 8.0 };
  Expect(!meets(outside, before) && t == -7.0, "a line that ends before the surface");
  scene.SetIsovalues({});
  Expect(!meets(outside, inside) && !observer->GetError(), "no isovalues, nothing to meet");
  scene.SetIsovalues({ 100.0 });
  Expect(!meets(outside, outside) && says("two different points"), "one point is no line");
  Expect(!meets(bad, inside) && says("two different points"), "what is not a number");
  Expect(!scene.Mapper->IntersectWithLine(nullptr, outside, inside, t, nullptr, nullptr, nullptr) &&
      says("volume"),
    "no volume");
  scene.Mapper->SetInputData(static_cast<vtkImageData*>(nullptr));
  Expect(!meets(outside, inside) && says("no input"), "no input");
}

constexpr int Size = 200;

/// A scene in a window that is never drawn, for the size that pickers need.
struct PickScene : Scene
{
  PickScene(vtkImageData* image, const std::vector<double>& isovalues)
    : Scene(image, isovalues)
  {
    this->Window->SetSize(Size, Size);
    this->Window->AddRenderer(this->Renderer);
  }
  bool Pick(vtkAbstractPicker* picker, int x, int y)
  {
    return picker->Pick(x + 0.5, y + 0.5, 0.0, this->Renderer) != 0;
  }
  vtkNew<vtkRenderWindow> Window;
};

/// Through a field that is linear along every line vtkVolumePicker finds the surface by opacity,
/// if it is told the opacity of the isovalue: both tell the same of it.
void TestAgainstVolumePicker()
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(
    12, VTK_DOUBLE, [](double x, double y, double z) { return x + 0.3 * y - 0.2 * z; });
  image->SetExtent(3, 14, -5, 6, 0, 11);
  PickScene scene(image, { 0.1 });
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-2.0, 0.0);
  opacity->AddPoint(2.0, 1.0);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  scene.Volume->SetPosition(3.0, -1.0, 2.0);
  scene.Volume->SetScale(1.0, 2.0, 0.5);
  scene.Volume->RotateY(20.0);
  scene.LookFrom(-2.0, 0.4, 0.7); // from where the field is low
  vtkNew<vtkVolumePicker> byOpacity;
  byOpacity->SetVolumeOpacityIsovalue((0.1 + 2.0) / 4.0);
  vtkNew<vtkTemporalCoherencePicker> picker;
  const auto same = [](const double* a, const double* b) { return DistanceOf(a, b) < 1e-6; };
  int picks = 0, different = 0;
  for (int y = 0; y < Size; y += 7)
  {
    for (int x = 0; x < Size; x += 7)
    {
      const bool isHit = scene.Pick(picker, x, y);
      const bool isExpected = scene.Pick(byOpacity, x, y);
      if (!isHit || !isExpected)
      {
        continue;
      }
      bool isOnBoundary = false; // which is hit by opacity, where the volume cuts a solid
      for (int i = 0; i < 3; ++i)
      {
        const double p = byOpacity->GetPCoords()[i];
        const int cell = byOpacity->GetCellIJK()[i] - image->GetExtent()[2 * i];
        isOnBoundary |= (cell == 0 && p < 1e-6) || (cell == 10 && p > 1.0 - 1e-6);
      }
      if (isOnBoundary)
      {
        continue;
      }
      ++picks;
      const bool agrees = same(picker->GetPickPosition(), byOpacity->GetPickPosition()) &&
        same(picker->GetMapperPosition(), byOpacity->GetMapperPosition()) &&
        same(picker->GetPickNormal(), byOpacity->GetPickNormal()) &&
        same(picker->GetMapperNormal(), byOpacity->GetMapperNormal()) &&
        same(picker->GetPCoords(), byOpacity->GetPCoords()) &&
        picker->GetPointId() == byOpacity->GetPointId() &&
        picker->GetCellId() == byOpacity->GetCellId() &&
        picker->GetSubId() == byOpacity->GetSubId() &&
        std::equal(picker->GetCellIJK(), picker->GetCellIJK() + 3, byOpacity->GetCellIJK()) &&
        std::equal(picker->GetPointIJK(), picker->GetPointIJK() + 3, byOpacity->GetPointIJK()) &&
        picker->GetDataSet() == byOpacity->GetDataSet() &&
        picker->GetMapper() == byOpacity->GetMapper() &&
        picker->GetVolume() == byOpacity->GetVolume() &&
        picker->GetViewProp() == byOpacity->GetViewProp() && picker->GetIsovalueIndex() == 0;
      different += !agrees;
    }
  }
  Expect(picks > 30, "picks of both: " + std::to_string(picks));
  Expect(different == 0, std::to_string(different) + " picks differ from vtkVolumePicker's");
}

/// Pixel by pixel a pick is what the picture shows, in a scene that is never rendered before.
void TestAgainstPixels()
{
  PickScene scene(Volumes::FourSpheres(32), { 160.0, 100.0 });
  scene.Volume->RotateZ(30.0);
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkNew<vtkTemporalCoherencePicker> picker;
  vtkNew<vtkCellPicker> plain;
  scene.Pick(picker, Size / 2, Size / 2);
  Expect(scene.Mapper->GetStatistics()->GetNumberOfRays() == 0, "picked without a frame");
  Expect(scene.Render(Size, Size), "rendered");
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetInput());
  int hits = 0, different = 0, plainHits = 0;
  for (int y = 0; y < Size; y += 5)
  {
    for (int x = 0; x < Size; x += 5)
    {
      double position[3], normal[3];
      int index = -1;
      const bool isSeen = scene.Mapper->PickPixel(x, y, position, normal, &index);
      const bool isHit = scene.Pick(picker, x, y);
      bool agrees = isHit == isSeen && picker->GetIsovalueIndex() == index;
      if (isHit && isSeen)
      {
        ++hits;
        agrees &= DistanceOf(picker->GetPickPosition(), position) < 1e-5 &&
          DistanceOf(picker->GetPickNormal(), normal) < 1e-3 &&
          picker->GetPointId() == image->FindPoint(picker->GetMapperPosition());
        double local[4];
        vtkNew<vtkMatrix4x4> toMapper;
        vtkMatrix4x4::Invert(scene.Volume->GetMatrix(), toMapper);
        const double world[4] = { position[0], position[1], position[2], 1.0 };
        toMapper->MultiplyPoint(world, local);
        agrees &= DistanceOf(picker->GetMapperPosition(), local) < 1e-5;
      }
      different += !agrees;
      plainHits += !isSeen && scene.Pick(plain, x, y);
    }
  }
  Expect(hits > 100, "hits: " + std::to_string(hits));
  Expect(different <= 1, std::to_string(different) + " picks are not what is seen");
  Expect(plainHits > 100, "vtkCellPicker picks where nothing is seen");
}

/// Other props are picked as ever, and the nearest of all wins.
void TestOtherProps()
{
  PickScene scene(Volumes::FromFormula(24, VTK_FLOAT,
                    [](double x, double y, double z) { return -std::hypot(x, y, z); }),
    { -0.5 });
  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.2);
  vtkNew<vtkPolyDataMapper> polygons;
  polygons->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(polygons);
  scene.Renderer->AddActor(actor);
  scene.LookFrom(0.0, -1.0, 0.0);
  vtkNew<vtkTemporalCoherencePicker> picker;
  const auto picks = [&](double y) -> vtkProp*
  {
    actor->SetPosition(0.0, y, 0.0);
    scene.Renderer->ResetCameraClippingRange();
    return scene.Pick(picker, Size / 2, Size / 2) ? picker->GetViewProp() : nullptr;
  };
  Expect(picks(-0.9) == actor && picker->GetIsovalueIndex() == -1 && picker->GetCellId() >= 0,
    "an actor before the volume");
  Expect(picks(-0.5) == actor, "an actor half inside the surface");
  Expect(picks(0.0) == scene.Volume && picker->GetIsovalueIndex() == 0 &&
      std::abs(picker->GetPickPosition()[1] + 0.5) < 0.01,
    "an actor behind the surface");
  scene.Volume->PickableOff();
  Expect(picks(0.0) == actor, "a volume that cannot be picked");
  scene.Volume->PickableOn();
  scene.SetIsovalues({ -5.0 });
  Expect(picks(0.0) == actor && picks(-0.9) == actor, "no surface, the box is not picked");
  scene.Renderer->RemoveActor(actor);
  Expect(!scene.Pick(picker, Size / 2, Size / 2) && !picker->GetViewProp() &&
      picker->GetCellId() == -1 && picker->GetIsovalueIndex() == -1,
    "nothing");
}

/// Props that hold the mapper in other ways: parts of assemblies, levels of detail.
void TestOtherHolders()
{
  const vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(
    24, VTK_FLOAT, [](double x, double y, double z) { return -std::hypot(x, y, z); });
  vtkNew<vtkTemporalCoherencePicker> picker;
  const auto expectBall = [&](const std::string& what, double x)
  {
    Expect(std::abs(picker->GetPickPosition()[0] - x) < 1e-3 &&
        std::abs(picker->GetPickPosition()[1] + 1.0) < 0.02 &&
        std::abs(picker->GetPickNormal()[1] + 1.0) < 1e-3 &&
        std::abs(picker->GetMapperPosition()[1] + 0.5) < 0.01,
      what + ": the ball of radius 0.5, twice as large, is hit where it is");
  };
  {
    PickScene scene(image, { -0.5 });
    scene.Renderer->RemoveVolume(scene.Volume);
    scene.Volume->SetScale(2.0);
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(scene.Volume);
    assembly->SetPosition(7.0, 0.0, 0.0);
    scene.Renderer->AddViewProp(assembly);
    scene.LookFrom(0.0, -1.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetParallelProjection(true);
    scene.Renderer->ResetCameraClippingRange();
    Expect(scene.Pick(picker, Size / 2, Size / 2), "assembly: picked");
    // The pixel's centre is half a pixel from the middle.
    double world[4] = { 0.0, 0.0, 0.0, 1.0 };
    vtkNew<vtkMatrix4x4> toWorld;
    vtkMatrix4x4::Invert(
      scene.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0),
      toWorld);
    const double clip[4] = { 1.0 / Size, 1.0 / Size, 0.0, 1.0 };
    toWorld->MultiplyPoint(clip, world);
    expectBall("assembly", world[0]);
    Expect(std::abs(world[0] - 7.0) < 0.1, "assembly: it is seen in the middle");
  }
  {
    PickScene scene(image, { -0.5 });
    scene.Renderer->RemoveVolume(scene.Volume);
    vtkNew<vtkLODProp3D> levels;
    levels->AddLOD(scene.Mapper, scene.Volume->GetProperty(), 1.0);
    levels->SetScale(2.0);
    scene.Renderer->AddViewProp(levels);
    scene.LookFrom(0.0, -1.0, 0.0);
    scene.Renderer->ResetCameraClippingRange();
    Expect(scene.Pick(picker, Size / 2, Size / 2) && picker->GetProp3D() == levels.Get() &&
        std::abs(picker->GetPickPosition()[1] + 1.0) < 0.02,
      "a level of detail is picked");
  }
}

/// The plane that the line comes through is told, and picked if that is wished.
void TestCroppingPlanes()
{
  PickScene scene(Volumes::FromFormula(24, VTK_FLOAT,
                    [](double x, double y, double z) { return -std::hypot(x, y, z); }),
    { -0.5 });
  scene.LookFrom(0.0, -1.0, 0.0);
  vtkNew<vtkTemporalCoherencePicker> picker;
  Expect(scene.Pick(picker, Size / 2, Size / 2) && picker->GetCroppingPlaneId() == -1,
    "no cropping, no plane");
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(-0.9, 0.9, -0.8, 0.8, -0.9, 0.9);
  Expect(scene.Pick(picker, Size / 2, Size / 2) && picker->GetCroppingPlaneId() == 2 &&
      std::abs(picker->GetPickPosition()[1] + 0.5) < 0.01,
    "the lower y plane is on the way to the surface");
  picker->PickCroppingPlanesOn();
  Expect(scene.Pick(picker, Size / 2, Size / 2) && picker->GetCroppingPlaneId() == 2 &&
      std::abs(picker->GetPickPosition()[1] + 0.8) < 1e-6 && picker->GetIsovalueIndex() == -1,
    "the plane itself is picked");
}

}

int TestPicking(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestLines();
  TestLineArguments();
  TestAgainstVolumePicker();
  TestAgainstPixels();
  TestOtherProps();
  TestOtherHolders();
  TestCroppingPlanes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
