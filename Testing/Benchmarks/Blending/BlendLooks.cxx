// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendLooks.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>

namespace BlendLooks
{
namespace
{

/// In parts of the range of values.
constexpr double RampWidth = 0.08, PeakWidth = 0.01;

constexpr std::array<double, 3> Skin{ 0.85, 0.55, 0.4 }, Bone{ 1.0, 0.95, 0.85 },
  Dark{ 0.4, 0.2, 0.1 };

Point At(double value, const std::array<double, 3>& color, double opacity)
{
  return { value, { color[0], color[1], color[2], opacity } };
}

}

const std::vector<Subject>& Subjects()
{
  static const std::vector<Subject> subjects = { { "engine.vti", 70, 180 },
    { "bonsai.vti", 40, 150 }, { "aneurism.vti", 60, 140 }, { "heptane.vti", 60, 120 },
    { "cthead.vti", 600, 1500 } };
  return subjects;
}

std::vector<Look> Of(const Subject& subject, const std::array<double, 2>& range)
{
  const double low = range[0], high = range[1], all = high - low;
  const double soft = subject.Soft, hard = subject.Hard;
  const double ramp = RampWidth * all, peak = PeakWidth * all;
  const Look bone{ "bone",
    { At(low, Dark, 0.0), At(hard - ramp, Dark, 0.0), At(hard + ramp, Bone, 0.72),
      At(high, Bone, 0.8) } };
  const Look veil{ "skin and bone",
    { At(low, Dark, 0.0), At(soft - 0.5 * ramp, Skin, 0.0), At(soft, Skin, 0.1),
      At(soft + ramp, Skin, 0.03), At(hard - ramp, Skin, 0.03), At(hard, Bone, 0.6),
      At(high, Bone, 0.8) } };
  const Look peaks{ "thin peaks",
    { At(low, Skin, 0.0), At(soft - peak, Skin, 0.0), At(soft, Skin, 0.3),
      At(soft + peak, Skin, 0.0), At(hard - peak, Bone, 0.0), At(hard, Bone, 0.9),
      At(hard + peak, Bone, 0.0), At(high, Bone, 0.0) } };
  return { bone, veil, peaks };
}

Look Dragged(Look look, double by)
{
  // The last point of those without opacity, from the lowest value on.
  auto end = look.Points.begin();
  while (end + 1 != look.Points.end() && (end + 1)->Color[3] == 0.0)
  {
    ++end;
  }
  end->Value = std::min(end->Value + by, (end + 1)->Value - 1e-3 * by);
  return look;
}

Look Recolored(Look look)
{
  for (Point& point : look.Points)
  {
    std::rotate(point.Color.begin(), point.Color.begin() + 1, point.Color.begin() + 3);
  }
  return look;
}

void Apply(const Look& look, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const Point& point : look.Points)
  {
    color->AddRGBPoint(point.Value, point.Color[0], point.Color[1], point.Color[2]);
    opacity->AddPoint(point.Value, point.Color[3]);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
}

}
