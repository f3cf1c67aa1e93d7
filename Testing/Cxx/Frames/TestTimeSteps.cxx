// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A time step with equal numbers is no change. One that changes a part of them traces only what
// shows that part. Every picture is that of a mapper without a past.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomChanges.h"
#include "Walks/Sweep.h"

#include <vtkDataArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr int Samples = 64; ///< along each axis
constexpr int Width = 200, Height = 160;

/// A blob that moves through a scene that stands still; in whole numbers of some type.
vtkSmartPointer<vtkImageData> StepAt(double time, int type)
{
  return Volumes::FromFormula(Samples, type,
    [=](double x, double y, double z)
    {
      const double still = 60.0 * std::exp(-8.0 * (std::hypot(x + 0.5, y - 0.4, z) - 0.1)) +
        50.0 * std::exp(-3.0 * std::hypot(x - 0.6, y - 0.6, z + 0.6));
      const double distance = std::hypot(x - 0.1, y + 0.5, z - 0.9 + 0.3 * time);
      const double blob = distance < 0.25 ? 100.0 * (1.0 - distance / 0.25) : 0.0;
      return std::floor(std::min(still + blob, 120.0));
    });
}

/// A source whose every execution gives another image object in other memory.
class StepSource : public vtkImageAlgorithm
{
public:
  static StepSource* New();
  vtkTypeMacro(StepSource, vtkImageAlgorithm);
  void SetTime(double time)
  {
    this->Time = time;
    this->Modified();
  }

  int ScalarType = VTK_UNSIGNED_CHAR;

protected:
  StepSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    const int extent[6] = { 0, Samples - 1, 0, Samples - 1, 0, Samples - 1 };
    out->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    vtkImageData::GetData(out)->ShallowCopy(StepAt(this->Time, this->ScalarType));
    return 1;
  }

  double Time = 0.0;
};
vtkStandardNewMacro(StepSource);

/// A scene with the steps of a source for data, from which other scenes differ.
struct Series
{
  explicit Series(const std::vector<double>& isovalues = { 40.0 })
    : Shown(nullptr, isovalues)
  {
    this->Shown.Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Shown.LookFrom(1.0, -2.0, 0.6);
  }

  /// Render, expecting the picture that the data give without a past.
  void Expect(const std::string& route, const std::string& what)
  {
    ::Expect(this->Shown.Render(Width, Height), what + ": rendered");
    ::Expect(route.empty() || IsRoute(this->Shown, route),
      what + ": " + this->Shown.Mapper->GetStatistics()->GetRouteAsString() + " instead of " +
        route);
    ::Expect(this->Cold.Draw(this->Shown), what + ": rendered cold");
    ::Expect(this->Cold.IsIdentical(this->Shown), what + ": not the cold picture");
  }

  /// The same for the step of a time.
  void Step(double time, const std::string& route, const std::string& what)
  {
    this->Source->SetTime(time);
    this->Expect(route, what + ", time " + std::to_string(time));
  }

  vtkNew<StepSource> Source;
  Scene Shown;
  ColdWitness Cold;
};

/// Steps with the same numbers are no change, whatever comes next.
void TestSameNumbers()
{
  Series series;
  Scene& scene = series.Shown;
  const std::string what = "the same numbers";
  series.Step(0.0, "Cold", what);
  series.Step(0.0, "Cold", what + ", for the first time");
  for (int i = 0; i < 3; ++i)
  {
    series.Step(0.0, "Redisplay", what);
    Expect(
      scene.Mapper->GetStatistics()->GetNumberOfTracedRays() == 0, what + ": nothing is traced");
  }
  scene.Volume->GetProperty()->SetAmbient(0.4);
  series.Step(0.0, "Reshade", what + ", other shading");
  scene.Mapper->SetIsomapRange(39.0, 42.0);
  scene.SetIsovalues({ 41.0 });
  series.Step(0.0, "IsomapBuild", what + ", other isovalue");
  scene.SetIsovalues({ 41.25 });
  series.Step(0.0, "IsomapLookup", what + ", other isovalue again");
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  series.Step(0.0, "Cold", what + ", moved on");
  series.Step(0.0, "Redisplay", what + ", still again");
  scene.Volume->RotateZ(3.0);
  series.Step(0.0, "Cold", what + ", turned");
  scene.Mapper->ReuseFramesOff();
  series.Step(0.0, "Redisplay", what + ", image cache off");

  // Samples that are written anew where they are.
  const auto image = StepAt(0.0, VTK_SHORT);
  scene.Mapper->SetInputData(image);
  series.Expect("Cold", what + ", other type");
  image->GetPointData()->GetScalars()->Modified();
  series.Expect("Cold", what + ", written anew for the first time");
  image->GetPointData()->GetScalars()->Modified();
  series.Expect("Redisplay", what + ", written anew");
}

/// What translucency, modes and types make of steps.
struct Kind
{
  std::string Name;
  int ScalarType;
  std::vector<double> Isovalues;
  std::function<void(Scene&)> Prepare;
};

void MakeTranslucent(Scene& scene)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(20.0, 0.3);
  opacity->AddPoint(70.0, 0.8);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
}

void MakeGradientOpacity(Scene& scene)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.2);
  opacity->AddPoint(10.0, 0.9);
  scene.Volume->GetProperty()->SetGradientOpacity(opacity);
  scene.Volume->GetProperty()->DisableGradientOpacityOff();
}

void Crop(Scene& scene)
{
  scene.Mapper->SetCropping(true);
  scene.Mapper->SetCroppingRegionPlanes(-0.7, 0.9, -0.8, 0.5, -0.9, 0.8);
  scene.Mapper->SetCroppingRegionFlags(0x2000 | 0x0010 | 0x0001);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, -0.6, 0.0);
  plane->SetNormal(0.2, 1.0, 0.1);
  scene.Mapper->AddClippingPlane(plane);
}

std::vector<Kind> AllKinds()
{
  const auto solid = [](Scene& scene) { scene.Mapper->SetSurfaceModeToThreshold(); };
  const auto nearest = [](Scene& scene)
  { scene.Volume->GetProperty()->SetInterpolationTypeToNearest(); };
  const auto parallel = [](Scene& scene)
  { scene.Renderer->GetActiveCamera()->ParallelProjectionOn(); };
  const auto plainCells = [](Scene& scene) { scene.Mapper->SpaceLeapingOff(); };
  return {
    { "one isovalue", VTK_UNSIGNED_CHAR, { 40.0 }, [](Scene&) {} },
    { "three isovalues", VTK_SHORT, { 20.5, 40.0, 70.0 }, [](Scene&) {} },
    { "threshold", VTK_FLOAT, { 40.0, 60.0 }, solid },
    { "nearest, parallel", VTK_DOUBLE, { 40.0 },
      [=](Scene& scene)
      {
        nearest(scene);
        parallel(scene);
      } },
    { "translucent", VTK_FLOAT, { 20.0, 40.0, 70.0 }, MakeTranslucent },
    { "translucent threshold, no leaping", VTK_INT, { 20.0, 60.0 },
      [=](Scene& scene)
      {
        MakeTranslucent(scene);
        solid(scene);
        plainCells(scene);
      } },
    { "gradient opacity", VTK_UNSIGNED_SHORT, { 30.0, 60.0 }, MakeGradientOpacity },
    { "cropped", VTK_UNSIGNED_CHAR, { 30.0, 60.0 }, Crop },
    { "cropped solid", VTK_SHORT, { 30.0 },
      [=](Scene& scene)
      {
        Crop(scene);
        solid(scene);
      } },
  };
}

/// A blob moves: most of the picture is copied, and all of it is right.
void TestMovingBlob(const Kind& kind)
{
  Series series(kind.Isovalues);
  series.Source->ScalarType = kind.ScalarType;
  Scene& scene = series.Shown;
  scene.LookFrom(1.0, -2.0, 0.6);
  kind.Prepare(scene);
  Mapper* mapper = scene.Mapper;
  series.Step(0.0, "Cold", kind.Name);
  series.Step(0.25, "Cold", kind.Name + ", before hashes");
  for (int step = 2; step < 10; ++step)
  {
    series.Step(0.25 * step, "TimeStep", kind.Name);
    const vtkIdType copied = mapper->GetStatistics()->GetNumberOfDefiniteHits() +
      mapper->GetStatistics()->GetNumberOfDefiniteMisses();
    Expect(2 * copied >= mapper->GetStatistics()->GetNumberOfRays(),
      kind.Name + ": most pixels are copied");
    Expect(mapper->GetStatistics()->GetNumberOfPossibleHits() + copied ==
        mapper->GetStatistics()->GetNumberOfRays(),
      kind.Name + ": every pixel is counted");
    Expect(mapper->GetStatistics()->GetNumberOfDefiniteHits() > 0 &&
        mapper->GetStatistics()->GetNumberOfTracedRays() > 0,
      kind.Name + ": some are traced, some are not");
  }
  // What was copied serves as any other picture.
  scene.Volume->GetProperty()->SetDiffuse(0.4);
  series.Expect("Reshade", kind.Name + ", shaded again");
  series.Step(2.5, "TimeStep", kind.Name + ", moved on after that");
  series.Step(2.5, "Redisplay", kind.Name + ", stays");
  mapper->ReuseFramesOff();
  series.Step(2.75, "Cold", kind.Name + ", image cache off");
  mapper->ReuseFramesOn();
  series.Step(3.0, "TimeStep", kind.Name + ", and on");
  mapper->SetReuseAccuracyToExact();
  series.Step(3.25, "TimeStep", kind.Name + ", exact");
  scene.Volume->GetProperty()->SetAmbient(0.3);
  series.Step(3.5, "Cold", kind.Name + ", other colours");
  scene.SetIsovalues({ 50.0 });
  series.Step(3.75, "Cold", kind.Name + ", other isovalues");
  scene.Renderer->GetActiveCamera()->Azimuth(2.0);
  series.Step(4.0, "Cold", kind.Name + ", other view");
  // What is copied to replaces a picture of another view.
  series.Step(4.25, "TimeStep", kind.Name + ", in that view");
  scene.Volume->GetProperty()->SetAmbient(0.2);
  series.Expect("Reshade", kind.Name + ", shaded again in that view");
}

/// Samples that are not finite count as far from the isovalue as the farthest finite one: where
/// that changes, so may every surface beside them.
void TestNotFinite()
{
  Scene scene(nullptr, { 40.0 });
  const auto show = [&](double largest, double hole)
  {
    const auto image = StepAt(0.0, VTK_FLOAT);
    vtkDataArray* samples = image->GetPointData()->GetScalars();
    for (int i = 0; i < 12; ++i)
    {
      samples->SetComponent((28 * Samples + 40 + i % 3) * Samples + 20 + i, 0, hole);
    }
    samples->SetComponent(0, 0, largest);
    scene.Mapper->SetInputData(image);
    scene.LookFrom(1.0, -2.0, 0.6);
    ColdWitness cold;
    Expect(scene.Render(Width, Height) && cold.Draw(scene) && cold.IsIdentical(scene),
      "not finite: the cold picture");
  };
  const double infinity = std::numeric_limits<double>::infinity();
  show(1.0, infinity);
  show(2.0, infinity);
  show(3.0, infinity);
  Expect(IsRoute(scene, "TimeStep"), "a change within the range is copied around");
  show(500.0, infinity);
  Expect(IsRoute(scene, "Cold"), "one of the range is not");
  show(4.0, 5.0);
  Expect(IsRoute(scene, "Cold"), "nor is one from what is not finite");
  show(4.0, std::numeric_limits<double>::quiet_NaN());
  Expect(IsRoute(scene, "TimeStep"), "what is no number is hidden, and affects nothing else");
  show(6.0, std::numeric_limits<double>::quiet_NaN());
  show(6.0, 5.0);
  Expect(IsRoute(scene, "TimeStep"), "and is seen again");
  show(500.0, 5.0);
  Expect(IsRoute(scene, "TimeStep"), "of finite samples, the range does not matter");
}

/// Changes that no pixel shows: nothing is traced.
void TestOutsideOfTheView()
{
  const auto image = StepAt(0.0, VTK_SHORT);
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  Scene scene(image, { 40.0 });
  scene.LookFrom(0.0, -2.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(-0.5, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->Zoom(4.0);
  ColdWitness cold;
  for (int step = 0; step < 5; ++step)
  {
    samples->SetComponent(samples->GetNumberOfTuples() - 3 * step - 1, 0, 90.0);
    samples->Modified();
    Expect(scene.Render(Width, Height) && cold.Draw(scene) && cold.IsIdentical(scene),
      "outside of the view: the cold picture");
    Expect(IsRoute(scene, step < 2 ? "Cold" : "TimeStep"),
      std::string("outside of the view: ") + scene.Mapper->GetStatistics()->GetRouteAsString());
    Expect(
      step < 2 || scene.Mapper->GetStatistics()->GetNumberOfTracedRays() == 0, "nothing is traced");
  }
  Expect(scene.Mapper->GetStatistics()->GetNumberOfDefiniteHits() > 0, "something is seen");
}

/// Single samples at random, at random times: in one place, to old values and to new ones.
struct Writer
{
  void Write(RandomViews& views)
  {
    const vtkIdType count = this->Array->GetNumberOfTuples();
    for (int i = views.Pick(3); i >= 0; --i)
    {
      const vtkIdType at = views.Pick(static_cast<int>(count));
      this->Array->SetComponent(at, 0, views.Pick(121));
    }
    this->Array->Modified();
  }

  /// The same numbers in other memory. Where they were is nothing of worth any more.
  void Move()
  {
    vtkNew<vtkImageData> other;
    other->DeepCopy(this->Image);
    this->Array->Fill(39.5);
    this->Left = this->Image;
    this->Image = other;
    this->Array = other->GetPointData()->GetScalars();
    this->Shown.Mapper->SetInputData(other);
  }

  Scene& Shown;
  vtkSmartPointer<vtkImageData> Image;
  vtkDataArray* Array = Image->GetPointData()->GetScalars();
  vtkSmartPointer<vtkImageData> Left = nullptr;
};

Sweep::Routes Wander(const Kind& kind, unsigned seed, int steps)
{
  Scene scene(nullptr, kind.Isovalues);
  Writer writer{ scene, StepAt(1.0, kind.ScalarType) };
  scene.Mapper->SetInputData(writer.Image);
  RandomViews views(scene, seed, 100);
  views.Move();
  kind.Prepare(scene);
  ColdWitness cold;
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  const std::vector<Change> cache = ChangesOfImageCache(scene, views);
  Sweep::Routes routes;
  for (int step = 0; step < steps; ++step)
  {
    const std::string what =
      kind.Name + ", seed " + std::to_string(seed) + ", step " + std::to_string(step);
    const int action = views.Pick(16);
    const bool writes = action < 9;
    if (writes)
    {
      writer.Write(views);
    }
    if (action == 2 || action > 12)
    {
      writer.Move();
    }
    if (action == 9)
    {
      views.Move();
    }
    if (action == 10 || action == 1)
    {
      scene.SetIsovalues({ 25.0 + views.Pick(60) });
    }
    if (action == 11)
    {
      cache[static_cast<std::size_t>(views.Pick(static_cast<int>(cache.size())))].Make();
    }
    Expect(views.Render(), what + ": rendered");
    ExpectPromise(scene, cold, what);
    Expect(!writes || cold.IsDepthIdentical(scene), what + ": stale");
    Expect(!writes || scene.Mapper->GetColorByAnswer() || cold.IsColorIdentical(scene),
      what + ": stale colours");
    ++routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
    if (views.Pick(3) == 0)
    {
      ExpectRefined(scene, views, cold, what);
    }
  }
  return routes;
}

/// Two windows of one mapper, one of which sees every step and the other every third.
void TestTwoViewers()
{
  Series series;
  Scene& scene = series.Shown;
  vtkNew<vtkRenderer> other;
  vtkNew<vtkCamera> camera;
  other->SetActiveCamera(camera);
  camera->SetPosition(-2.0, -5.0, 3.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  other->AddVolume(scene.Volume);
  other->ResetCameraClippingRange(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  vtkNew<vtkImageData> color, depth;
  ColdWitness cold;
  int copies = 0;
  for (int step = 0; step < 12; ++step)
  {
    series.Step(0.125 * (step / 2), "", "the first viewer");
    copies += IsRoute(scene, "TimeStep");
    if (step % 3 == 0)
    {
      Expect(scene.Mapper->MakeImage(other, scene.Volume, Width, Height, color, depth),
        "rendered for the second viewer");
      copies += IsRoute(scene, "TimeStep");
      cold.Mapper->SetInputDataObject(scene.Mapper->GetInputDataObject(0, 0));
      cold.Mapper->ClearCache();
      Expect(cold.Mapper->MakeImage(other, scene.Volume, Width, Height, cold.Color, cold.Depth) &&
          AreIdentical(color, cold.Color) && AreIdentical(depth, cold.Depth),
        "the second viewer: not the cold picture");
    }
  }
  Expect(copies > 6, "both copy: " + std::to_string(copies));
}

}

int TestTimeSteps(int, char*[])
{
  vtkFloatingPointExceptions::Disable(); // as programs have it
  TestSameNumbers();
  TestNotFinite();
  TestOutsideOfTheView();
  TestTwoViewers();
  Sweep::Routes routes;
  unsigned seed = 30;
  for (const Kind& kind : AllKinds())
  {
    TestMovingBlob(kind);
    for (const auto& [route, count] : Wander(kind, ++seed, 120))
    {
      routes[route] += count;
    }
  }
  Sweep::Tell("all kinds", routes);
  Expect(routes["TimeStep"] > 150, "parts of pictures are copied");
  Expect(routes["Redisplay"] > 50, "pictures are shown again");
  Expect(routes["IsomapLookup"] + routes["IsomapBuild"] > 10, "isovalues are looked up");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
