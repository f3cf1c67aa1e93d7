// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/Sweep.h"

#include "Checks/Expect.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkShortArray.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>

namespace Sweep
{
namespace
{

double WavesAt(double x, double y, double z)
{
  return 120.0 + 70.0 * std::sin(5.0 * x + 0.3) * std::cos(4.0 * y) + 45.0 * z;
}

/// Waves with holes that are not numbers and infinite peaks.
vtkSmartPointer<vtkImageData> NotFinite(int type)
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(14, type, WavesAt);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const double infinity = std::numeric_limits<double>::infinity();
  std::mt19937 engine(3);
  for (const double value : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity })
  {
    for (int i = 0; i < 25; ++i)
    {
      scalars->SetComponent(static_cast<vtkIdType>(engine() % 2744u), 0, value);
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> Slab(int x, int y, int z)
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(30, VTK_FLOAT, WavesAt);
  image->SetDimensions(x, y, z);
  image->SetSpacing(2.0 / x, 2.0 / y, 2.0 / z);
  image->GetPointData()->GetScalars()->SetNumberOfTuples(image->GetNumberOfPoints());
  return image;
}

/// Component 1 of three.
vtkSmartPointer<vtkImageData> OfSeveral(vtkDataArray* array)
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(18, VTK_SHORT, WavesAt);
  vtkDataArray* one = image->GetPointData()->GetScalars();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(one->GetNumberOfTuples());
  for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
  {
    array->SetTuple3(i, 500.0, one->GetComponent(i, 0), -static_cast<double>(i % 7));
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

vtkSmartPointer<vtkImageData> Oriented()
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(20, VTK_SHORT, WavesAt);
  image->SetSpacing(0.3, 0.7, 0.11);
  image->SetOrigin(10.0, -20.0, 3.0);
  // A rotation about (1, 1, 1) by 120 degrees, then one about z, then a mirror.
  image->SetDirectionMatrix(0.0, -0.6, 0.8, 0.0, 0.8, 0.6, -1.0, 0.0, 0.0);
  return image;
}

bool IsOfWholeNumbers(const Subject& subject)
{
  const int type = subject.Image->GetScalarType();
  return type != VTK_FLOAT && type != VTK_DOUBLE;
}

/// Clip at a share of the way through the volume.
void ClipByNearPlane(Scene& scene, double share)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  double range[2];
  camera->GetClippingRange(range);
  camera->SetClippingRange(range[0] + share * (range[1] - range[0]), range[1]);
}

void GoInside(Scene& scene)
{
  const double* bounds = scene.Volume->GetBounds();
  double place[2][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis], size = bounds[2 * axis + 1] - low;
    place[0][axis] = low + (0.45 + 0.1 * axis) * size;
    place[1][axis] = low + (0.9 - 0.35 * axis) * size;
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(place[0]);
  camera->SetFocalPoint(place[1]);
  camera->SetViewUp(0.1, 0.2, 1.0);
  camera->SetViewAngle(80.0);
  camera->SetClippingRange(0.01 * camera->GetDistance(), 20.0 * camera->GetDistance());
}

}

std::vector<Placing> AllPlacings()
{
  return {
    { "perspective", [](Scene& scene) { scene.LookFrom(1.0, 2.0, 0.5); } },
    { "inside", GoInside },
    { "parallel",
      [](Scene& scene)
      {
        scene.LookFrom(-1.0, 0.3, 0.4);
        scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      } },
    { "near plane",
      [](Scene& scene)
      {
        scene.LookFrom(-1.0, -0.3, 2.0);
        ClipByNearPlane(scene, 0.45);
      } },
    { "parallel along an axis",
      [](Scene& scene)
      {
        scene.LookFrom(0.0, 0.0, 1.0);
        scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      } },
  };
}

std::vector<Subject> AllFields()
{
  const auto plateaus = [](double x, double y, double z)
  { return 20.0 * std::floor(WavesAt(x, y, z) / 20.0); };
  const auto constant = [](double, double, double) { return 7.0; };
  std::vector<Subject> fields = {
    { "bytes", Volumes::FromFormula(24, VTK_UNSIGNED_CHAR, WavesAt), {} },
    { "shorts", Volumes::FromFormula(21, VTK_SHORT, WavesAt), {} },
    { "floats", Volumes::FromFormula(20, VTK_FLOAT, WavesAt), {} },
    { "doubles", Volumes::FromFormula(20, VTK_DOUBLE, WavesAt), {} },
    { "noise of bytes", Volumes::Noise(10, VTK_UNSIGNED_CHAR, 0.0, 200.0), {} },
    { "noise of doubles", Volumes::Noise(9, VTK_DOUBLE, 0.0, 200.0), {} },
    { "Marschner-Lobb", Volumes::MarschnerLobb(30), {} },
    { "plateaus of bytes", Volumes::FromFormula(20, VTK_UNSIGNED_CHAR, plateaus), {} },
    { "plateaus of floats", Volumes::FromFormula(20, VTK_FLOAT, plateaus), {} },
    { "floats, not all finite", NotFinite(VTK_FLOAT), {} },
    { "doubles, not all finite", NotFinite(VTK_DOUBLE), {} },
    { "constant bytes", Volumes::FromFormula(9, VTK_UNSIGNED_CHAR, constant), {} },
    { "constant floats", Volumes::FromFormula(9, VTK_FLOAT, constant), {} },
    { "slab across z", Slab(30, 30, 2), {} },
    { "slab across x", Slab(2, 30, 30), {} },
    { "oriented", Oriented(), {} },
    { "one of three", OfSeveral(vtkNew<vtkShortArray>()), {} },
    { "one of three, separate", OfSeveral(vtkNew<vtkSOADataArrayTemplate<float>>()), {} },
  };
  for (Subject& field : fields)
  {
    field.Component = field.Image->GetNumberOfScalarComponents() > 1 ? 1 : 0;
  }
  return fields;
}

std::vector<double> FiniteSamplesOf(const Subject& subject)
{
  vtkDataArray* scalars = subject.Image->GetPointData()->GetScalars();
  std::vector<double> samples;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double sample = scalars->GetComponent(i, subject.Component);
    if (std::isfinite(sample))
    {
      samples.push_back(sample);
    }
  }
  return samples;
}

std::vector<double> Up(const Subject& subject, int steps)
{
  const std::vector<double> samples = FiniteSamplesOf(subject);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double beyond = std::max(0.05 * (*high - *low), 1.0);
  std::vector<double> isovalues;
  for (int i = 0; i < steps; ++i)
  {
    const double share = static_cast<double>(i) / (steps - 1);
    const double isovalue = *low - beyond + share * (*high - *low + 2.0 * beyond);
    isovalues.push_back(IsOfWholeNumbers(subject) ? std::round(isovalue) : isovalue);
  }
  return isovalues;
}

std::vector<double> Jumps(const Subject& subject, int steps, unsigned seed)
{
  const std::vector<double> samples = FiniteSamplesOf(subject);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double range = std::max(*high - *low, 1.0);
  std::mt19937 engine(seed);
  const auto pick = [&engine](std::size_t n) { return static_cast<std::size_t>(engine()) % n; };
  const auto share = [&pick] { return 1e-3 * static_cast<double>(pick(1001)); };
  std::vector<double> isovalues = { *low };
  while (isovalues.size() < static_cast<std::size_t>(steps))
  {
    const double sample = samples[pick(samples.size())];
    const double last = isovalues.back();
    const std::vector<double> next = { sample, std::nextafter(sample, *low - 1.0),
      std::nextafter(sample, *high + 1.0), *low + share() * range,
      last + 0.02 * (share() - 0.5) * range, std::nextafter(last, *high + 1.0), last - 1e-7 * range,
      *low + (2.0 * share() - 0.5) * range, *high, *low };
    isovalues.push_back(next[pick(next.size())]);
    if (pick(25) == 0)
    {
      isovalues.push_back(pick(2) ? 1e20 : -1e20);
    }
  }
  return isovalues;
}

void Tell(const std::string& what, const Routes& routes)
{
  std::cout << what << ":";
  for (const auto& [route, count] : routes)
  {
    std::cout << ' ' << route << ' ' << count;
  }
  std::cout << '\n';
}

void ExpectOnly(
  const std::vector<std::string>& allowed, const Routes& routes, const std::string& what)
{
  int others = 0;
  for (const auto& [route, count] : routes)
  {
    const bool isAllowed = std::find(allowed.begin(), allowed.end(), route) != allowed.end();
    others += isAllowed || route == "Redisplay" ? 0 : count;
  }
  Expect(others <= 1, what + ": " + std::to_string(others) + " frames are of other routes");
  for (const std::string& route : allowed)
  {
    Expect(routes.count(route) > 0, what + ": no frame is of the route " + route);
  }
}

Routes ExpectCold(Scene& scene, const std::vector<double>& isovalues, int width, int height,
  const std::string& what)
{
  std::vector<std::vector<double>> lists;
  for (const double isovalue : isovalues)
  {
    lists.push_back({ isovalue });
  }
  return ExpectCold(scene, lists, width, height, what);
}

Routes ExpectCold(Scene& scene, const std::vector<std::vector<double>>& lists, int width,
  int height, const std::string& what)
{
  ColdWitness cold;
  Routes routes;
  int wrong = 0;
  vtkIdType seen = 0;
  std::ostringstream first;
  first.precision(17);
  for (std::size_t i = 0; i < lists.size(); ++i)
  {
    scene.SetIsovalues(lists[i]);
    Expect(scene.Render(width, height) && cold.Draw(scene), what + ": rendered");
    ++routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
    seen += scene.Mapper->GetStatistics()->GetNumberOfDefiniteHits() +
      scene.Mapper->GetStatistics()->GetNumberOfPossibleHits();
    if (!cold.IsIdentical(scene))
    {
      // One line tells of a whole sweep: the first of its wrong frames.
      if (wrong++ == 0)
      {
        first << "step " << i << ", " << scene.Mapper->GetStatistics()->GetRouteAsString()
              << ", isovalue(s)";
        for (const double isovalue : lists[i])
        {
          first << ' ' << isovalue;
        }
        first << (cold.IsDepthIdentical(scene) ? ", colours only" : "") << ", "
              << cold.CountDifferent(scene) << " pixels by more than a voxel";
      }
    }
  }
  // Frames that show nothing prove nothing.
  const double* range =
    vtkDataSet::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0))->GetScalarRange();
  Expect(seen > 0 || range[0] == range[1], what + ": nothing is seen");
  Expect(wrong == 0,
    what + ": " + std::to_string(wrong) + " of " + std::to_string(lists.size()) +
      " frames are not the cold picture; the first: " + first.str());
  return routes;
}

}
