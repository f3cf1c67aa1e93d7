// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

namespace Fuzz
{
namespace Changes
{
namespace
{

void SetUp(World& world, vtkLight* light)
{
  Bytes& from = world.From;
  light->SetLightType(1 + from.Pick(3));
  light->SetPosition(from.Number(-5.0, 5.0), from.Number(-5.0, 5.0), 3.0);
  light->SetFocalPoint(from.Number(-1.0, 1.0), 0.0, 0.0);
  light->SetIntensity(from.Number(0.0, 1.0));
  light->SetPositional(from.Pick(2));
  light->SetConeAngle(from.Number(5.0, 100.0));
  light->SetExponent(from.Number(0.0, 5.0));
  light->SetAttenuationValues(from.Number(0.0, 1.0), from.Number(0.0, 1.0), from.Number(0.0, 0.2));
  light->SetDiffuseColor(from.Number(0.0, 1.0), 1.0, 0.5);
  light->SetSpecularColor(1.0, from.Number(0.0, 1.0), 0.5);
  if (from.OneIn(8))
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->SetElement(from.Pick(4), from.Pick(4), from.Number(-1.0, 2.0));
    light->SetTransformMatrix(matrix);
  }
  light->SetSwitch(!from.OneIn(6));
  Story::Tell("  a light, intensity ", light->GetIntensity(), ", positional ",
    light->GetPositional(), ", cone ", light->GetConeAngle(), ", exponent ", light->GetExponent());
}

void AddLight(World& world)
{
  vtkNew<vtkLight> light;
  SetUp(world, light);
  if (world.From.OneIn(2))
  {
    world.Renderer()->RemoveAllLights();
  }
  world.Renderer()->AddLight(light);
}

void ChangeLight(World& world)
{
  vtkLightCollection* lights = world.Renderer()->GetLights();
  if (auto* light = vtkLight::SafeDownCast(lights->GetItemAsObject(0)))
  {
    SetUp(world, light);
  }
}

void NoLights(World& world)
{
  world.Renderer()->RemoveAllLights();
  world.Renderer()->SetAutomaticLightCreation(world.From.Pick(2));
  Story::Tell("  no lights, automatic ", world.Renderer()->GetAutomaticLightCreation());
}

void Sides(World& world)
{
  world.Renderer()->SetTwoSidedLighting(world.From.Pick(2));
  world.Renderer()->SetLightFollowCamera(world.From.Pick(2));
  // No byte of its own: stored seeds keep their meaning.
  world.Subject->SetShadows(world.Renderer()->GetLightFollowCamera());
  Story::Tell("  two-sided ", world.Renderer()->GetTwoSidedLighting(), ", following ",
    world.Renderer()->GetLightFollowCamera(), ", shadows ", world.Subject->GetShadows());
}

}

const std::vector<ChangeKind>& OfLights()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "a light", { 3, 1, 1, 1, 14, 3, 1 }, AddLight },
    { "a light changed", { 3, 1, 1, 1, 14, 3, 1 }, ChangeLight },
    { "no lights", { 2, 1, 1, 1, 3, 1, 1 }, NoLights },
    { "sides of light", { 2, 1, 1, 1, 6, 1, 1 }, Sides },
  };
  return kinds;
}

}
}
