// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Every route makes the cold picture of data with samples that are not numbers.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "MissingSamples.h"
#include "Walks/RandomChanges.h"
#include "Walks/Sweep.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace
{

using namespace MissingSamples;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// Steps in which samples appear or vanish, in data of a sort.
void ExpectSteps(const std::string& what, const Sort& sort, bool areCells)
{
  const Missing some = [](int i, int j, int k) { return (i + 2 * j + 3 * k) % 37 == 0; };
  const Missing other = [](int i, int j, int) { return i > 11 && j < 9; };
  const Missing none = [](int, int, int) { return false; };
  Image image = WithHoles(VTK_FLOAT, none);
  const vtkSmartPointer<vtkDataArray> points = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> values;
  values->SetName("values");
  values->SetNumberOfTuples(areCells ? image->GetNumberOfCells() : image->GetNumberOfPoints());
  image->GetPointData()->SetScalars(nullptr);
  areCells ? image->GetCellData()->SetScalars(values) : image->GetPointData()->SetScalars(values);
  const int n = areCells ? N - 1 : N;
  vtkSmartPointer<vtkDataSet> data;
  Scene scene(nullptr, { 55.0 });
  int step = 0;
  for (const Missing& isMissing : { none, some, some, other, none, other, some, none })
  {
    ++step;
    for (int i = 0; i < n * n * n; ++i)
    {
      const int x = i % n, y = i / n % n, z = i / n / n;
      const double value = points->GetComponent((z * N + y) * N + x, 0) + (step == 3 ? 1.0 : 0.0);
      values->SetValue(i, static_cast<float>(isMissing(x, y, z) ? NaN : value));
    }
    if (!data)
    {
      data = sort.Of(image);
      scene.Mapper->SetInputDataObject(data);
      scene.LookFrom(1.0, 0.5, 0.7);
    }
    auto* kept = vtkFloatArray::SafeDownCast(
      areCells ? data->GetCellData()->GetScalars() : data->GetPointData()->GetScalars());
    if (kept && kept != values && areCells)
    {
      const auto again = sort.Of(image);
      kept->DeepCopy(again->GetCellData()->GetScalars());
    }
    values->Modified();
    kept->Modified();
    for (const double isovalue : { 55.0, 56.0, 55.0 })
    {
      scene.SetIsovalues({ isovalue });
      ColdWitness cold;
      Expect(scene.Render(70, 60) && cold.Draw(scene) && cold.IsIdentical(scene),
        what + ", step " + std::to_string(step) + ": not the cold picture, but that of " +
          scene.Mapper->GetStatistics()->GetRouteAsString());
    }
  }
}

void TestTimeSteps()
{
  for (const Sort& sort : AllSorts())
  {
    for (const bool areCells : { false, true })
    {
      ExpectSteps(sort.Name + (areCells ? ", cells" : ", points"), sort, areCells);
    }
  }
}

/// Isovalues that change, and a range of them that is built at once.
void TestSweeps()
{
  for (const auto& [name, isMissing] : AllMissing())
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      for (const bool isGrid : { false, true })
      {
        Subject subject = { "sweep, " + name, WithHoles(VTK_FLOAT, isMissing), {}, mode };
        subject.IsGrid = isGrid;
        Scene scene(subject.Image, {});
        subject.Prepare(scene);
        scene.LookFrom(1.0, 2.0, 0.7);
        Sweep::Routes routes =
          Sweep::ExpectCold(scene, Sweep::Up(subject, 10), 60, 45, subject.Describe() + ", up");
        scene.Mapper->SetIsomapRange(0.0, 100.0);
        for (const auto& [route, count] : Sweep::ExpectCold(
               scene, Sweep::Jumps(subject, 12, 5), 60, 45, subject.Describe() + ", jumps"))
        {
          routes[route] += count;
        }
        Expect(routes["IsomapLookup"] > 0, subject.Describe() + ": nothing is looked up");
        // Several isovalues, translucent.
        vtkPiecewiseFunction* opacity = scene.Volume->GetProperty()->GetScalarOpacity();
        opacity->AddPoint(0.0, 0.3);
        opacity->AddPoint(100.0, 0.6);
        Sweep::ExpectCold(scene,
          std::vector<std::vector<double>>{ { 55.0, 40.0 }, { 56.0, 40.0 }, { 55.0, 30.0, 70.0 } },
          60, 45, subject.Describe() + ", translucent");
      }
    }
  }
}

/// Changes of all kinds in random order.
void TestRandomChanges()
{
  for (const unsigned seed : { 5u, 6u })
  {
    Image image = Volumes::Waves();
    vtkNew<vtkFloatArray> samples;
    samples->DeepCopy(image->GetPointData()->GetScalars());
    for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); i += 41)
    {
      samples->SetValue(i, static_cast<float>(NaN));
    }
    image->GetPointData()->SetScalars(samples);
    Scene scene(image, { 0.0 });
    RandomViews views(scene, seed, 80);
    const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
    const std::string what = "random changes, seed " + std::to_string(seed);
    Sweep::Tell(what, Wander(scene, views, KindsOfChange(scene, image, views), what, 300));
  }
}

}

int TestMissingFrames(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestTimeSteps();
  TestSweeps();
  TestRandomChanges();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
