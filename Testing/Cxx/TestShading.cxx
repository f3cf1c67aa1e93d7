// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Normals against brute force under transforms that treat them unlike points, and colours against
// the Phong formula written out once more, light by light.

#include "Expect.h"
#include "Scene.h"
#include "Volumes.h"

#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

using Vector = std::array<double, 3>;

Vector Minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Unit(Vector v)
{
  vtkMath::Normalize(v.data());
  return v;
}

double Dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(50, VTK_FLOAT,
    [](double x, double y, double z) { return 1.0 - std::hypot(x, 1.3 * y, 0.9 * z); });
}

/// What the light adds to a pixel, by VTK's formula.
Vector LightOf(vtkLight* light, vtkVolumeProperty* property, const Vector& color,
  const Vector& point, const Vector& normal, const Vector& toViewer)
{
  Vector position, focus;
  light->GetTransformedPosition(position.data());
  light->GetTransformedFocalPoint(focus.data());
  const Vector axis = Unit(Minus(focus, position));
  Vector toLight = { -axis[0], -axis[1], -axis[2] };
  double share = light->GetSwitch() ? light->GetIntensity() : 0.0;
  if (light->GetPositional())
  {
    toLight = Unit(Minus(position, point));
    const double distance =
      std::sqrt(vtkMath::Distance2BetweenPoints(position.data(), point.data()));
    const double* a = light->GetAttenuationValues();
    share /= a[0] + a[1] * distance + a[2] * distance * distance;
    const double cosine = -Dot(toLight, axis);
    if (light->GetConeAngle() <= 90.0)
    {
      const bool isInCone = cosine >= std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()));
      share *= isInCone ? std::pow(cosine, light->GetExponent()) : 0.0;
    }
  }
  const double cosine = Dot(normal, toLight);
  Vector sum{};
  for (std::size_t c = 0; c < 3 && cosine > 0.0; ++c)
  {
    Vector mirrored;
    for (std::size_t i = 0; i < 3; ++i)
    {
      mirrored[i] = 2.0 * cosine * normal[i] - toLight[i];
    }
    const double gloss =
      std::pow(std::max(0.0, Dot(mirrored, toViewer)), property->GetSpecularPower());
    sum[c] = share *
      (property->GetDiffuse() * cosine * light->GetDiffuseColor()[c] * color[c] +
        property->GetSpecular() * gloss * light->GetSpecularColor()[c]);
  }
  return sum;
}

/// Every lit pixel of the scene's picture against the formula.
void ExpectPhong(Scene& scene, const std::vector<vtkLight*>& lights, const std::string& what)
{
  Expect(scene.Render(120, 120), what + ": rendered");
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  Vector eye, color;
  scene.Renderer->GetActiveCamera()->GetPosition(eye.data());
  property->GetRGBTransferFunction()->GetColor(0.3, color.data());
  int wrong = 0, hits = 0, lit = 0;
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      Vector point, normal;
      if (!scene.Mapper->PickPixel(x, y, point.data(), normal.data(), nullptr))
      {
        continue;
      }
      Vector expected;
      for (std::size_t c = 0; c < 3; ++c)
      {
        expected[c] = property->GetAmbient() * color[c];
      }
      for (vtkLight* light : lights)
      {
        const Vector part = LightOf(light, property, color, point, normal, Unit(Minus(eye, point)));
        lit += part[0] + part[1] + part[2] > 0.05;
        for (std::size_t c = 0; c < 3; ++c)
        {
          expected[c] += part[c];
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        const double value = 255.0 * std::min(expected[static_cast<std::size_t>(c)], 1.0);
        wrong += std::abs(value - scene.ColorAt(x, y)[c]) > 0.6;
      }
      ++hits;
    }
  }
  Expect(hits > 1000 && (lights.empty() || lit > 100), what + ": there is something to see");
  Expect(wrong == 0, what + ": " + std::to_string(wrong) + " channels differ from the formula");
}

void TestLights()
{
  Scene scene(Ball(), { 0.3 });
  scene.LookFrom(1.0, -2.0, 0.5);
  scene.Renderer->GetActiveCamera()->Zoom(1.8);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetAmbient(0.15);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.5);
  property->SetSpecularPower(15.0);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.3, 0.9, 0.6, 0.2);
  property->SetColor(color);

  vtkNew<vtkLight> headlight;
  headlight->SetPosition(scene.Renderer->GetActiveCamera()->GetPosition());
  headlight->SetFocalPoint(scene.Renderer->GetActiveCamera()->GetFocalPoint());
  ExpectPhong(scene, { headlight }, "the headlight that a renderer would create");
  scene.Renderer->AutomaticLightCreationOff();
  ExpectPhong(scene, {}, "no light");

  vtkNew<vtkLight> sun, lamp, spot, off;
  for (vtkLight* light : { sun.Get(), lamp.Get(), spot.Get(), off.Get() })
  {
    light->SetLightTypeToSceneLight();
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPosition(1.5, -2.5, 2.0);
  }
  sun->SetColor(1.0, 0.7, 0.4);
  sun->SetIntensity(0.8);
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(2.0, -1.0, 0.0);
  lamp->SetAttenuationValues(0.2, 0.3, 0.1);
  spot->PositionalOn();
  spot->SetPosition(0.5, -3.0, 0.0);
  spot->SetConeAngle(9.0);
  spot->SetExponent(30.0);
  spot->SetSpecularColor(0.2, 1.0, 0.3);
  off->SwitchOff();
  scene.Renderer->AddLight(sun);
  ExpectPhong(scene, { sun }, "a sun");
  scene.Renderer->AddLight(lamp);
  scene.Renderer->AddLight(off);
  ExpectPhong(scene, { sun, lamp }, "and a lamp");
  scene.Renderer->AddLight(spot);
  ExpectPhong(scene, { sun, lamp, spot }, "and a spot");
  Expect(std::string(scene.Mapper->GetRouteAsString()) == "Reshade", "lights only shade again");
}

void TestNormals()
{
  Scene scene(Ball(), { 0.3 });
  vtkNew<vtkMatrix4x4> shear;
  shear->SetElement(0, 1, 0.4);
  shear->SetElement(2, 0, -0.7);
  scene.Volume->SetUserMatrix(shear);
  scene.Volume->SetScale(0.5, -2.0, 3.0);
  scene.Volume->RotateX(40.0);
  scene.LookFrom(1.0, -2.0, 0.5);
  scene.Renderer->GetActiveCamera()->Zoom(1.8);
  Expect(scene.Render(120, 120), "rendered");
  BruteForceTracer truth(vtkImageData::SafeDownCast(scene.Mapper->GetInput()), scene.Volume);
  Vector eye;
  scene.Renderer->GetActiveCamera()->GetPosition(eye.data());
  int wrong = 0, hits = 0;
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      Vector point, normal;
      if (scene.Mapper->PickPixel(x, y, point.data(), normal.data(), nullptr))
      {
        wrong += std::abs(Dot(normal, truth.WorldNormalAt(point))) < 0.99999;
        wrong += Dot(normal, Minus(eye, point)) < -1e-6;
        ++hits;
      }
    }
  }
  Expect(hits > 1000 && wrong == 0, std::to_string(wrong) + " normals are wrong");
}

/// The isovalue that is picked has its place in the property's list, whatever is left out before
/// it.
void TestPlaces()
{
  Scene scene(Ball(), { 0.9, 0.3 });
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.3, 1.0);
  opacity->AddPoint(0.8, 0.0);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  scene.LookFrom(1.0, -2.0, 0.5);
  Expect(scene.Render(120, 120), "rendered");
  int isovalue = -1;
  Expect(scene.Mapper->PickPixel(60, 60, nullptr, nullptr, &isovalue) && isovalue == 1,
    "the second isovalue is picked behind the invisible first one");
}

}

int TestShading(int, char*[])
{
  TestLights();
  TestNormals();
  TestPlaces();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
