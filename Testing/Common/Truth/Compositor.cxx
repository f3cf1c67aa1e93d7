// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/Compositor.h"

#include "Checks/Expect.h"

#include <vtkContourValues.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

using Mapper = vtkTemporalCoherenceVolumeMapper;

/// A surface on a line of sight.
struct Compositor::Layer
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

Compositor::Compositor(Scene& scene, const BruteForceTracer& truth, const int samples[3])
  : Of(scene)
  , Truth(truth)
  , Region(scene.Mapper, scene.Volume)
{
  vtkContourValues* list = scene.Volume->GetProperty()->GetIsoSurfaceValues();
  for (int i = 0; i < list->GetNumberOfContours(); ++i)
  {
    this->Isovalues.push_back(list->GetValue(i));
  }
  // Equal ones are one.
  std::sort(this->Isovalues.begin(), this->Isovalues.end());
  this->Isovalues.erase(
    std::unique(this->Isovalues.begin(), this->Isovalues.end()), this->Isovalues.end());
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Last[static_cast<std::size_t>(axis)] = samples[axis] - 1.0;
  }
}

std::vector<Compositor::Sheet> Compositor::SheetsAt(int x, int y, int width, int height)
{
  const BruteForceTracer::Line line =
    BruteForceTracer::LineThrough(this->Of.Renderer, x, y, width, height);
  std::vector<Sheet> sheets;
  for (const BruteForceTracer::Line& part : this->Region.Of(line))
  {
    for (const Layer& layer : this->LayersOf(part))
    {
      sheets.push_back({ layer.T, this->ColorOf(layer, line) });
    }
  }
  return sheets;
}

std::array<double, 4> Compositor::ColorAt(int x, int y, int width, int height)
{
  std::array<double, 4> sum{};
  for (const Sheet& sheet : this->SheetsAt(x, y, width, height))
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += (1.0 - sum[3]) * sheet.Color[3] * sheet.Color[c];
    }
    sum[3] += (1.0 - sum[3]) * sheet.Color[3];
  }
  return sum;
}

std::vector<Compositor::Layer> Compositor::LayersOf(const BruteForceTracer::Line& line)
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
          this->Truth.Field.IndexOf(line.PointAt(hit.Distance + 2e3 * step)), isovalue) >= 0.0;
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
bool Compositor::IsCap(const BruteForceTracer::Hit& hit, const BruteForceTracer::Line& line) const
{
  this->Truth.IsThreshold = false;
  return hit.Isovalue >= 0 && this->Truth.Trace(line).Distance != hit.Distance;
}

std::array<double, 4> Compositor::ColorOf(
  const Layer& layer, const BruteForceTracer::Line& line) const
{
  vtkVolumeProperty* property = this->Of.Volume->GetProperty();
  std::array<double, 4> color;
  property->GetRGBTransferFunction()->GetColor(layer.Isovalue, color.data());
  color[3] = property->GetScalarOpacity()->GetValue(layer.Isovalue);
  const Point point = line.PointAt(layer.T);
  this->ChangeLook(point, color);
  Point normal = this->GradientAt(point);
  color[3] *= this->OpacityByGradient(vtkMath::Normalize(normal.data()));
  if (property->GetShade())
  {
    // A headlight.
    Point forward;
    this->Of.Renderer->GetActiveCamera()->GetDirectionOfProjection(forward.data());
    const double toRay = vtkMath::Dot(normal.data(), line.Direction.data());
    const double cosine = (toRay < 0.0 ? -1.0 : 1.0) * vtkMath::Dot(normal.data(), forward.data());
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
Compositor::Point Compositor::GradientAt(const Point& world) const
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

void ExpectComposite(
  const std::string& name, Scene& scene, Compositor compositor, int width, int height)
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
