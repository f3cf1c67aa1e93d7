// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>

#include <cmath>

namespace Fuzz
{
namespace Changes
{
namespace
{

/// Mostly where the samples are.
double AnIsovalue(World& world)
{
  Bytes& from = world.From;
  const double range = world.High - world.Low;
  const double value = world.Low + from.Between(-0.05, 1.05) * range;
  if (from.IsWild())
  {
    return from.Wild();
  }
  switch (from.Pick(6))
  {
    case 0:
      return std::round(value);
    case 1:
      return world.Low;
    case 2:
      return world.High;
    default:
      return value;
  }
}

std::vector<double> Now(World& world)
{
  vtkContourValues* list = world.Property()->GetIsoSurfaceValues();
  std::vector<double> isovalues;
  for (int i = 0; i < list->GetNumberOfContours(); ++i)
  {
    isovalues.push_back(list->GetValue(i));
  }
  return isovalues;
}

void OneIsovalue(World& world)
{
  world.SetIsovalues({ AnIsovalue(world) });
}

void SmallStep(World& world)
{
  std::vector<double> isovalues = Now(world);
  const double steps[] = { 0.01, 0.03, 1e-6, 0.1, 1e-15 };
  const double step = world.From.OneOf(steps) * (world.High - world.Low);
  for (double& isovalue : isovalues)
  {
    isovalue += world.From.OneIn(2) ? -step : step;
    if (!world.From.OneIn(3))
    {
      break;
    }
  }
  world.SetIsovalues(isovalues);
}

void NextNumber(World& world)
{
  std::vector<double> isovalues = Now(world);
  if (!isovalues.empty())
  {
    isovalues[0] = std::nextafter(isovalues[0], world.From.OneIn(2) ? world.Low : world.High);
    world.SetIsovalues(isovalues);
  }
}

void MakeOpaque(World& world)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 1.0);
  world.Property()->SetScalarOpacity(opacity);
  world.Property()->DisableGradientOpacityOn();
  Story::Tell("  opaque");
}

/// Many layers in a pixel, if there are many isovalues.
void MakeHaze(World& world)
{
  const double opacities[] = { 0.01, 0.05, 0.2 };
  const double opacity = world.From.OneOf(opacities);
  vtkNew<vtkPiecewiseFunction> same;
  same->AddPoint(0.0, opacity);
  world.Property()->SetScalarOpacity(same);
  world.Property()->DisableGradientOpacityOn();
  Story::Tell("  haze of opacity ", opacity);
}

void SeveralIsovalues(World& world)
{
  std::vector<double> isovalues;
  int many = world.From.Pick(5);
  if (world.From.OneIn(40))
  {
    many = world.From.OneIn(20) ? 40000 : 100;
  }
  for (int i = 0; i < many && i < 8; ++i)
  {
    isovalues.push_back(AnIsovalue(world));
  }
  for (int i = 8; i < many; ++i)
  {
    isovalues.push_back(world.Low + i * (world.High - world.Low) / many);
  }
  if (many == 100 && world.From.OneIn(2))
  {
    MakeHaze(world);
  }
  if (many > 1 && world.From.OneIn(3))
  {
    isovalues.push_back(isovalues[0]);
  }
  world.SetIsovalues(isovalues);
}

/// Keep most isovalues: drop or move one, or add another; perhaps in another order.
void OneOfSeveral(World& world)
{
  std::vector<double> isovalues = Now(world);
  if (!isovalues.empty() && world.From.OneIn(4))
  {
    std::rotate(isovalues.begin(), isovalues.begin() + 1, isovalues.end());
  }
  if (isovalues.size() > 1 && !world.From.OneIn(4))
  {
    isovalues.pop_back();
  }
  if (!world.From.OneIn(4))
  {
    isovalues.push_back(AnIsovalue(world));
  }
  world.SetIsovalues(isovalues);
}

void SetOpacities(World& world)
{
  Bytes& from = world.From;
  vtkNew<vtkPiecewiseFunction> opacity;
  const int many = from.Pick(6);
  const double usual[] = { 1.0, 0.5, 0.0, 0.1, 0.9, 0.02 };
  for (int i = 0; i < many; ++i)
  {
    const double at = world.Low + from.Between(-0.2, 1.2) * (world.High - world.Low);
    const double value = from.IsWild() ? from.Number(-1.0, 2.0) : from.OneOf(usual);
    if (from.OneIn(8))
    {
      opacity->AddPoint(at, value, from.Between(0.0, 1.0), from.Between(0.0, 1.0));
    }
    else
    {
      opacity->AddPoint(at, value);
    }
    Story::Tell("  opacity at ", at, ": ", value);
  }
  world.Property()->SetScalarOpacity(opacity);
}

void SetGradientOpacities(World& world)
{
  Bytes& from = world.From;
  vtkVolumeProperty* property = world.Property();
  if (from.OneIn(3))
  {
    property->SetDisableGradientOpacity(from.Pick(2));
    return;
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  const double steep = (world.High - world.Low) * from.Between(0.0, 1.0);
  for (int i = from.Pick(4); i > 0; --i)
  {
    const double at = from.Number(0.0, 1.0) * steep;
    const double value = from.Number(0.0, 1.0);
    if (from.OneIn(4))
    {
      opacity->AddPoint(at, value, from.Between(0.0, 1.0), from.Between(0.0, 1.0));
    }
    else
    {
      opacity->AddPoint(at, value);
    }
    Story::Tell("  opacity at gradient magnitude ", at, ": ", value);
  }
  property->SetGradientOpacity(opacity);
  property->DisableGradientOpacityOff();
}

void SetColors(World& world)
{
  Bytes& from = world.From;
  vtkVolumeProperty* property = world.Property();
  const int component = from.OneIn(5) ? from.Pick(4) : 0;
  if (from.OneIn(5))
  {
    vtkNew<vtkPiecewiseFunction> gray;
    gray->AddPoint(world.Low, from.Between(0.0, 1.0));
    gray->AddPoint(world.High, from.Number(0.0, 1.0));
    property->SetColor(component, gray);
    return;
  }
  vtkNew<vtkColorTransferFunction> color;
  for (int i = from.Pick(4); i > 0; --i)
  {
    const double at = world.Low + from.Between(0.0, 1.0) * (world.High - world.Low);
    color->AddRGBPoint(at, from.Number(0.0, 1.0), from.Between(0.0, 1.0), 0.5);
  }
  color->SetColorSpace(from.Pick(4));
  property->SetColor(component, color);
}

void SetMaterial(World& world)
{
  Bytes& from = world.From;
  vtkVolumeProperty* property = world.Property();
  const int component = from.OneIn(5) ? from.Pick(4) : 0;
  property->SetShade(component, from.Pick(4) != 0);
  property->SetAmbient(component, from.Number(0.0, 1.0));
  property->SetDiffuse(component, from.Number(0.0, 1.0));
  property->SetSpecular(component, from.Number(0.0, 1.0));
  property->SetSpecularPower(component, from.Number(0.0, 80.0));
  Story::Tell("  shade ", property->GetShade(component), ", ambient ",
    property->GetAmbient(component), ", diffuse ", property->GetDiffuse(component), ", specular ",
    property->GetSpecular(component), " ^ ", property->GetSpecularPower(component));
}

void SetComponents(World& world)
{
  Bytes& from = world.From;
  vtkVolumeProperty* property = world.Property();
  property->SetIndependentComponents(from.Pick(2));
  const int component = from.Pick(4);
  property->SetComponentWeight(component, from.Number(0.0, 1.0));
  Story::Tell("  independent ", property->GetIndependentComponents(), ", weight ", component, ": ",
    property->GetComponentWeight(component));
}

void SetInterpolation(World& world)
{
  const int types[] = { VTK_LINEAR_INTERPOLATION, VTK_NEAREST_INTERPOLATION };
  world.Property()->SetInterpolationType(world.From.OneOf(types));
  Story::Tell("  interpolation ", world.Property()->GetInterpolationType());
}

void NewProperty(World& world)
{
  vtkNew<vtkVolumeProperty> property;
  property->DeepCopy(world.Property());
  property->SetIndependentComponents(world.From.Pick(2));
  property->SetScalarOpacityUnitDistance(world.From.Number(0.1, 4.0));
  property->SetTransferFunctionMode(world.From.Pick(2));
  world.Volume()->SetProperty(property);
}

}

const std::vector<ChangeKind>& OfIsovalues()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "one isovalue", { 8, 40, 3, 3, 2, 8, 6 }, OneIsovalue },
    { "a small step of isovalues", { 8, 60, 3, 2, 1, 4, 24 }, SmallStep },
    { "the next number as isovalue", { 2, 12, 1, 1, 1, 2, 3 }, NextNumber },
    { "several isovalues", { 5, 10, 2, 2, 2, 8, 14 }, SeveralIsovalues },
    { "one of several isovalues", { 5, 20, 2, 2, 8, 8, 40 }, OneOfSeveral },
  };
  return kinds;
}

const std::vector<ChangeKind>& OfAppearance()
{
  static const std::vector<ChangeKind> kinds = {
    { "opacities", { 4, 2, 2, 1, 12, 6, 20 }, SetOpacities },
    { "opaque", { 3, 2, 2, 2, 6, 3, 4 }, MakeOpaque },
    { "opacities of gradient magnitude", { 3, 1, 1, 1, 6, 4, 6 }, SetGradientOpacities },
    { "colours", { 4, 2, 2, 1, 30, 4, 8 }, SetColors },
    { "material", { 4, 2, 2, 1, 30, 6, 6 }, SetMaterial },
    { "components", { 2, 1, 1, 1, 2, 4, 1 }, SetComponents },
    { "interpolation", { 3, 2, 1, 2, 1, 2, 1 }, SetInterpolation },
    { "a new property", { 1, 0, 0, 0, 2, 1, 1 }, NewProperty },
  };
  return kinds;
}

}
}
