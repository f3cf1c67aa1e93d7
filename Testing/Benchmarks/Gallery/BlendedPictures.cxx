// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendedPictures.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <vector>

namespace BlendedPictures
{
namespace
{

/// What a value looks like.
struct Node
{
  double Value;
  Style::Color Color;
  double Opacity;
};

void Blend(FeatureScene& scene, const std::vector<Node>& nodes, double unitDistance)
{
  scene.Mapper->SetBlendModeToComposite();
  vtkVolumeProperty* const property = scene.Volume->GetProperty();
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const Node& node : nodes)
  {
    colors->AddRGBPoint(node.Value, node.Color[0], node.Color[1], node.Color[2]);
    opacities->AddPoint(node.Value, node.Opacity);
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
}

}

Shot Tree(GallerySettings& settings)
{
  const Subject subject = FirstOf(
    { { "bonsai.vti", "CT bonsai 256^3", {}, { { -1.0, 0.35, 1.6 }, { 0.0, 1.0, 0.0 }, 1.35 } },
      SpheresInstead({}) },
    settings);
  FeatureScene scene(settings, subject);
  constexpr Style::Color leaf = { 0.38, 0.62, 0.22 }, edge = { 0.6, 0.75, 0.35 };
  constexpr Style::Color bark = { 0.62, 0.42, 0.26 }, soil = { 0.8, 0.6, 0.4 };
  Blend(scene,
    { { 0.0, leaf, 0.0 }, { 22.0, leaf, 0.0 }, { 34.0, leaf, 0.05 }, { 48.0, edge, 0.25 },
      { 70.0, bark, 0.6 }, { 120.0, soil, 0.9 }, { 255.0, Style::Bone, 0.98 } },
    1.0);
  vtkVolumeProperty* const property = scene.Volume->GetProperty();
  property->ShadeOn();
  property->SetDiffuse(0.9);
  property->SetSpecular(0.2);
  property->SetSpecularPower(20.0);
  return scene.Take("blended", "Composite volumes",
    "`SetBlendModeToComposite()`, converged without a distance between samples; shaded");
}

Shot Fire(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "heptane.vti", "simulated fire 302^3", {},
                                      { { 0.4, -1.6, 0.7 }, { -1.0, 0.0, 0.0 }, 1.6 } },
                                    SpheresInstead({}) },
    settings);
  FeatureScene scene(settings, subject);
  constexpr Style::Color smoke = { 0.15, 0.2, 0.5 }, ember = { 0.5, 0.15, 0.3 };
  constexpr Style::Color red = { 0.9, 0.3, 0.1 }, orange = { 1.0, 0.65, 0.15 };
  constexpr Style::Color yellow = { 1.0, 0.95, 0.6 }, white = { 1.0, 1.0, 0.9 };
  Blend(scene,
    { { 0.0, smoke, 0.0 }, { 14.0, smoke, 0.0 }, { 30.0, ember, 0.015 }, { 60.0, red, 0.05 },
      { 120.0, orange, 0.15 }, { 200.0, yellow, 0.4 }, { 255.0, white, 0.6 } },
    2.0);
  scene.Volume->GetProperty()->ShadeOff();
  return scene.Take("glow", "A fire that glows",
    "the same without shading: what the fire emits, and what its smoke takes away");
}

}
