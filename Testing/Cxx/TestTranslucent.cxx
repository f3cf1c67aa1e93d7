// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces through which others are seen: every pixel against a compositor that lays all crossings
// of all isovalues, found by brute force, over one another; and every route.

#include "ColdWitness.h"
#include "Expect.h"
#include "Ghosts.h"
#include "Sweep.h"
#include "Volumes.h"

#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <tuple>

namespace
{

using Point = std::array<double, 3>;
using Mapper = vtkTemporalCoherenceVolumeMapper;

Point PointOn(const BruteForceTracer::Line& line, double t)
{
  Point p;
  for (std::size_t a = 0; a < 3; ++a)
  {
    p[a] = line.Origin[a] + t * line.Direction[a];
  }
  return p;
}

/// A surface on a line of sight.
struct Layer
{
  double T;
  int Rank; ///< among those at one distance: caps first, then what is entered, then what is left
  double Isovalue;

  bool operator<(const Layer& other) const
  {
    const auto place = [](const Layer& layer)
    { return std::tuple(layer.T, layer.Rank, layer.Rank == 1 ? layer.Isovalue : -layer.Isovalue); };
    return place(*this) < place(other);
  }
};

/// Lays surfaces over one another by itself.
class Compositor
{
public:
  /// \param data a vtkImageData or a vtkRectilinearGrid
  template <typename DataSet>
  Compositor(Scene& scene, DataSet* data)
    : Of(scene)
    , Truth(data, scene.Volume)
  {
    vtkContourValues* list = scene.Volume->GetProperty()->GetIsoSurfaceValues();
    for (int i = 0; i < list->GetNumberOfContours(); ++i)
    {
      this->Isovalues.push_back(list->GetValue(i));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Last[static_cast<std::size_t>(axis)] = data->GetDimensions()[axis] - 1.0;
    }
  }

  /// Red, green, blue, multiplied by alpha; and alpha.
  std::array<double, 4> ColorAt(int x, int y, int width, int height)
  {
    BruteForceTracer::Line line =
      BruteForceTracer::LineThrough(this->Of.Renderer, x, y, width, height);
    vtkPlaneCollection* planes = this->Of.Mapper->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      Cut(planes->GetItem(i), line);
    }
    std::array<double, 4> sum{};
    for (const Layer& layer : this->LayersOf(line))
    {
      const std::array<double, 4> color = this->ColorOf(layer, line);
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[c] += (1.0 - sum[3]) * color[3] * color[c];
      }
      sum[3] += (1.0 - sum[3]) * color[3];
    }
    return sum;
  }

  /// Steepness of the field and what comes of it, if not 1.
  std::function<double(double)> OpacityBySteepness = [](double) { return 1.0; };

private:
  static void Cut(vtkPlane* plane, BruteForceTracer::Line& line)
  {
    Point begin = PointOn(line, line.Begin), end = PointOn(line, line.End);
    const double atBegin = plane->EvaluateFunction(begin.data());
    const double atEnd = plane->EvaluateFunction(end.data());
    if (atBegin < 0.0 && atEnd < 0.0)
    {
      line.End = line.Begin;
    }
    else if ((atBegin < 0.0) != (atEnd < 0.0))
    {
      const double t = line.Begin + atBegin / (atBegin - atEnd) * (line.End - line.Begin);
      (atBegin < 0.0 ? line.Begin : line.End) = t;
    }
  }

  std::vector<Layer> LayersOf(const BruteForceTracer::Line& line)
  {
    const bool isSolid = this->Of.Mapper->GetSurfaceMode() == Mapper::THRESHOLD;
    const double step = 1e-9 * this->Truth.Field.VoxelSize();
    std::vector<Layer> layers;
    for (const double isovalue : this->Isovalues)
    {
      this->Truth.Isovalues = { isovalue };
      this->Truth.IsThreshold = isSolid;
      BruteForceTracer::Line rest = line;
      BruteForceTracer::Hit hit = this->Truth.Trace(rest);
      if (isSolid && this->IsCap(hit, rest))
      {
        layers.push_back({ hit.Distance, 0, isovalue });
      }
      this->Truth.IsThreshold = false;
      hit = this->Truth.Trace(rest);
      while (hit.Isovalue >= 0)
      {
        const bool enters =
          this->Truth.Field.DifferenceAt(
            this->Truth.Field.IndexOf(PointOn(line, hit.Distance + 2e3 * step)), isovalue) >= 0.0;
        if (enters || !isSolid)
        {
          layers.push_back({ hit.Distance, enters ? 1 : 2, isovalue });
        }
        rest.Begin = hit.Distance + step;
        hit = this->Truth.Trace(rest);
      }
    }
    std::sort(layers.begin(), layers.end());
    return layers;
  }

  /// True if a hit of THRESHOLD is no crossing.
  bool IsCap(const BruteForceTracer::Hit& hit, const BruteForceTracer::Line& line) const
  {
    this->Truth.IsThreshold = false;
    return hit.Isovalue >= 0 && this->Truth.Trace(line).Distance != hit.Distance;
  }

  std::array<double, 4> ColorOf(const Layer& layer, const BruteForceTracer::Line& line) const
  {
    vtkVolumeProperty* property = this->Of.Volume->GetProperty();
    std::array<double, 4> color;
    property->GetRGBTransferFunction()->GetColor(layer.Isovalue, color.data());
    color[3] = property->GetScalarOpacity()->GetValue(layer.Isovalue);
    const Point point = PointOn(line, layer.T);
    Point normal = this->GradientAt(point);
    color[3] *= this->OpacityBySteepness(vtkMath::Normalize(normal.data()));
    if (property->GetShade())
    {
      // A headlight.
      Point forward;
      this->Of.Renderer->GetActiveCamera()->GetDirectionOfProjection(forward.data());
      const double toRay = vtkMath::Dot(normal.data(), line.Direction.data());
      const double cosine =
        (toRay < 0.0 ? -1.0 : 1.0) * vtkMath::Dot(normal.data(), forward.data());
      double mirrored =
        -vtkMath::Dot(forward.data(), line.Direction.data()) + 2.0 * cosine * std::abs(toRay);
      mirrored = cosine > 0.0 ? std::max(mirrored, 0.0) : 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        color[c] = property->GetAmbient() * color[c] +
          property->GetDiffuse() * std::max(cosine, 0.0) * color[c] +
          property->GetSpecular() * std::pow(mirrored, property->GetSpecularPower());
        color[c] = std::min(color[c], 1.0);
      }
    }
    return color;
  }

  /// Central differences at the samples, one-sided at the boundary, mixed as the field is; for a
  /// volume whose axes are those of the world, with samples as far apart along all of them.
  Point GradientAt(const Point& world) const
  {
    const Point index = this->Truth.Field.IndexOf(world);
    Point gradient{};
    for (int corner = 0; corner < 8; ++corner)
    {
      Point sample;
      double weight = 1.0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        const double low = std::clamp(std::floor(index[a]), 0.0, this->Last[a] - 1.0);
        const bool isHigh = corner >> a & 1;
        sample[a] = low + (isHigh ? 1.0 : 0.0);
        weight *= isHigh ? index[a] - low : 1.0 - (index[a] - low);
      }
      for (std::size_t a = 0; a < 3; ++a)
      {
        Point before = sample, behind = sample;
        before[a] = std::max(sample[a] - 1.0, 0.0);
        behind[a] = std::min(sample[a] + 1.0, this->Last[a]);
        gradient[a] += weight *
          (this->Truth.Field.DifferenceAt(behind, 0.0) -
            this->Truth.Field.DifferenceAt(before, 0.0)) /
          (behind[a] - before[a]);
      }
    }
    return gradient;
  }

  Scene& Of;
  mutable BruteForceTracer Truth;
  std::vector<double> Isovalues;
  Point Last; ///< sample along each axis
};

/// Hold a scene's picture against the compositor.
void ExpectComposite(
  const std::string& name, Scene& scene, Compositor compositor, int width = 100, int height = 80)
{
  Expect(scene.Render(width, height), name + ": rendered");
  int wrong = 0, several = 0;
  double worst = 0.0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::array<double, 4> expected = compositor.ColorAt(x, y, width, height);
      double difference = 0.0;
      for (int c = 0; c < 4; ++c)
      {
        difference = std::max(difference,
          std::abs(255.0 * expected[static_cast<std::size_t>(c)] - scene.ColorAt(x, y)[c]));
      }
      worst = std::max(worst, difference);
      wrong += difference > 2.0;
      several += expected[3] > 0.0 && expected[3] < 0.99;
    }
  }
  std::cout << name << ": " << several << " translucent pixels, " << wrong
            << " more than 2/255 off, worst " << worst << '\n';
  // A grazing ray may meet two surfaces more or less.
  Expect(wrong <= width * height / 2000, name + ": " + std::to_string(wrong) + " pixels differ");
  Expect(several > width * height / 50, name + ": something is translucent");
}

void SetColors(Scene& scene, const std::vector<std::array<double, 5>>& nodes)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const std::array<double, 5>& node : nodes)
  {
    color->AddRGBPoint(node[0], node[1], node[2], node[3]);
    opacity->AddPoint(node[0], node[4]);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
}

/// Three contours of VTK's wavelet, with opacities 1, 0.6 and 0.2.
void TestWavelet()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-12, 12, -12, 12, -12, 12);
  wavelet->Update();
  const std::vector<std::array<double, 5>> nodes = { { 100.0, 0.2, 0.4, 1.0, 0.2 },
    { 150.0, 0.9, 0.9, 0.1, 0.6 }, { 200.0, 1.0, 0.2, 0.1, 1.0 } };
  for (const bool shade : { false, true })
  {
    for (const bool threshold : { false, true })
    {
      Scene scene(wavelet->GetOutput(), { 100.0, 150.0, 200.0 });
      SetColors(scene, nodes);
      scene.Volume->GetProperty()->SetShade(shade);
      scene.Mapper->SetSurfaceMode(threshold);
      scene.LookFrom(1.0, 0.8, 0.5);
      const std::string name = std::string("wavelet, ") + (threshold ? "THRESHOLD" : "CROSSING") +
        (shade ? ", shaded" : "");
      // With caps, the brute-force normal is not that of the face.
      if (!(threshold && shade))
      {
        ExpectComposite(name, scene, Compositor(scene, wavelet->GetOutput()));
      }
      // Order carries no meaning, and nothing is drawn twice.
      vtkNew<vtkImageData> before;
      scene.Render(100, 80);
      before->DeepCopy(scene.Color);
      scene.SetIsovalues({ 200.0, 100.0, 150.0, 100.0 });
      scene.Mapper->ReleaseReuse();
      Expect(scene.Render(100, 80) && AreIdentical(before, scene.Color),
        name + ": another order of the list");
      int index = -1;
      Expect(scene.Mapper->PickPixel(50, 40, nullptr, nullptr, &index) && index >= 0 && index < 3,
        name + ": the first of two equal isovalues is picked");
    }
  }
}

/// Noise, inside it, all types of samples, both interpolations, clipped.
void TestFields()
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const bool nearest : { false, true })
    {
      for (const bool threshold : { false, true })
      {
        vtkSmartPointer<vtkImageData> image = Volumes::Noise(9, type, 0.0, 100.0);
        Scene scene(image, { 50.5, 80.25, 30.75 });
        SetColors(scene,
          { { 30.75, 0.1, 0.3, 0.9, 0.15 }, { 50.5, 0.8, 0.3, 0.2, 0.3 },
            { 80.25, 0.2, 0.9, 0.1, 0.5 } });
        scene.Volume->GetProperty()->ShadeOff();
        scene.Volume->GetProperty()->SetInterpolationType(nearest ? 0 : 1);
        scene.Mapper->SetSurfaceMode(threshold);
        scene.LookFrom(0.9, 0.7, 0.4);
        const std::string name = "noise of type " + std::to_string(type) +
          (nearest ? ", nearest" : "") + (threshold ? ", THRESHOLD" : ", CROSSING");
        ExpectComposite(name, scene, Compositor(scene, image.Get()), 60, 50);
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.1, 0.0, 0.0);
        plane->SetNormal(-1.0, -0.3, 0.2);
        scene.Mapper->AddClippingPlane(plane);
        ExpectComposite(name + ", clipped", scene, Compositor(scene, image.Get()), 60, 50);
      }
    }
  }
}

/// Cells of all sizes, some of them hidden.
void TestGrids()
{
  for (const bool nearest : { false, true })
  {
    for (const bool threshold : { false, true })
    {
      vtkSmartPointer<vtkImageData> noise = Volumes::Noise(9, VTK_SHORT, 0.0, 100.0);
      vtkNew<vtkRectilinearGrid> grid;
      grid->SetDimensions(9, 9, 9);
      vtkNew<vtkDoubleArray> coordinates;
      for (int i = 0; i < 9; ++i)
      {
        coordinates->InsertNextValue(0.01 * (i * i * i + 10 * i));
      }
      grid->SetXCoordinates(coordinates);
      grid->SetYCoordinates(coordinates);
      grid->SetZCoordinates(coordinates);
      grid->GetPointData()->SetScalars(noise->GetPointData()->GetScalars());
      Scene scene(grid, { 50.5, 80.25, 30.75 });
      SetColors(scene,
        { { 30.75, 0.1, 0.3, 0.9, 0.15 }, { 50.5, 0.8, 0.3, 0.2, 0.3 },
          { 80.25, 0.2, 0.9, 0.1, 0.5 } });
      scene.Volume->GetProperty()->ShadeOff();
      scene.Volume->GetProperty()->SetInterpolationType(nearest ? 0 : 1);
      scene.Mapper->SetSurfaceMode(threshold);
      scene.LookFrom(0.9, 0.7, 0.4);
      const std::string name = std::string("grid") + (nearest ? ", nearest" : "") +
        (threshold ? ", THRESHOLD" : ", CROSSING");
      ExpectComposite(name, scene, Compositor(scene, grid.Get()), 60, 50);
      if (!threshold)
      {
        Ghosts::HideCells(noise, 0.1, 5);
        grid->GetCellData()->ShallowCopy(noise->GetCellData());
        ExpectComposite(name + ", cells hidden", scene, Compositor(scene, grid.Get()), 60, 50);
      }
    }
  }
}

/// Opacity by steepness; what cannot be seen is not picked.
void TestGradientOpacity()
{
  // Steep at the left, gentle at the right.
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(25, VTK_FLOAT,
    [](double x, double y, double z)
    { return 10.0 * (0.3 + 0.6 * x * x - z + 0.2 * y) * (1.5 - x); });
  image->SetSpacing(0.5, 0.5, 0.5);
  Scene scene(image, { 0.0 });
  SetColors(scene, { { 0.0, 0.9, 0.5, 0.2, 0.8 } });
  vtkNew<vtkPiecewiseFunction> bySteepness;
  bySteepness->AddPoint(0.8, 0.0);
  bySteepness->AddPoint(1.2, 1.0);
  scene.Volume->GetProperty()->SetGradientOpacity(bySteepness);
  scene.LookFrom(0.1, 0.2, 1.0);
  Compositor compositor(scene, image.Get());
  compositor.OpacityBySteepness = [](double g) { return std::clamp((g - 0.8) / 0.4, 0.0, 1.0); };
  ExpectComposite("gradient opacity", scene, compositor);
  int clear = 0;
  for (int y = 0; y < 80; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      const bool isSeen = compositor.ColorAt(x, y, 100, 80)[3] > 1e-3;
      const bool isPicked = scene.Mapper->PickPixel(x, y, nullptr, nullptr, nullptr);
      clear += !isSeen;
      Expect(!isSeen || isPicked, "what is seen is picked");
      Expect(isPicked == !std::isinf(scene.DepthAt(x, y)), "as the depth says");
      Expect(isPicked || scene.ColorAt(x, y)[3] == 0, "what is not picked is not seen");
    }
  }
  Expect(clear > 500, "some of the surface is not seen");
  scene.Volume->GetProperty()->DisableGradientOpacityOn();
  compositor.OpacityBySteepness = [](double) { return 1.0; };
  ExpectComposite("gradient opacity disabled", scene, compositor);
}

/// The picture of every route is the cold picture (within the bounds of the image cache).
void TestRoutes()
{
  for (const bool threshold : { false, true })
  {
    vtkSmartPointer<vtkImageData> image = Volumes::Waves();
    Scene scene(image, { 0.0, 500.0, -600.0 });
    SetColors(scene,
      { { -900.0, 0.1, 0.3, 0.9, 0.3 }, { 0.0, 0.8, 0.3, 0.2, 0.4 },
        { 900.0, 0.2, 0.9, 0.1, 0.9 } });
    scene.Mapper->SetSurfaceMode(threshold);
    scene.LookFrom(0.7, -1.0, 0.5);
    ColdWitness cold;
    Sweep::Routes routes;
    const auto step = [&](const std::string& what, bool isExact)
    {
      Expect(scene.Render(160, 120) && cold.Draw(scene), what + ": rendered");
      ++routes[scene.Mapper->GetRouteAsString()];
      Expect(isExact ? cold.IsIdentical(scene) : cold.CountDifferent(scene) <= 10,
        what + ": not the cold picture, by " + scene.Mapper->GetRouteAsString());
    };
    step("first", true);
    for (int i = 0; i < 10; ++i)
    {
      scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      step("orbit", false);
    }
    step("still", true);
    for (int i = 0; i < 6; ++i)
    {
      scene.SetIsovalues({ 0.0, 500.0 + 5.0 * (i % 4), -600.0 });
      step("one isovalue of three", true);
    }
    scene.Volume->GetProperty()->SetAmbient(0.4);
    step("another light", true);
    Expect(IsRoute(scene, "Reshade"), "only colours changed");
    scene.Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.1, 0.9, 0.4);
    step("other colours", true);
    Expect(IsRoute(scene, "Reshade"), "only colours changed");
    scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.1);
    step("another opacity", true);
    scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.0);
    step("one left out", true);
    SetColors(scene, { { 0.0, 0.8, 0.3, 0.2, 1.0 } });
    step("opaque", true);
    SetColors(scene, { { 0.0, 0.8, 0.3, 0.2, 0.4 } });
    step("translucent again", true);
    scene.Mapper->SetReuseAccuracyToExact();
    scene.Renderer->GetActiveCamera()->Elevation(3.0);
    step("EXACT", true);
    scene.Mapper->SpaceLeapingOff();
    scene.Mapper->ReleaseReuse();
    step("no leaping", true);
    scene.Mapper->SpaceLeapingOn();
    step("leaping again", true);
    Expect(routes["ImageCache"] >= 8, "the image cache serves translucent surfaces");
    Expect(routes["IsomapLookup"] + routes["IsomapBuild"] >= 4, "the isomap does");
  }
}

}

int TestTranslucent(int, char*[])
{
  TestWavelet();
  TestFields();
  TestGrids();
  TestGradientOpacity();
  TestRoutes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
