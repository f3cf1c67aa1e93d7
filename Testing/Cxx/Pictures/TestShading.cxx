// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Normals agree with brute force under transforms that treat them unlike points, and colours with
// the Phong formula written out once more, light by light.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"
#include "Volumes/Volumes.h"

#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

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
    if (light->GetConeAngle() < 90.0)
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
      // Without a light, surfaces are lit evenly, as polygons are.
      const double even = lights.empty() ? property->GetDiffuse() : 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        expected[c] = (property->GetAmbient() + even) * color[c];
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

/// Lights that are all off are none: then too a headlight is created, or surfaces are lit evenly.
void TestLightsThatAreOff(Scene& scene, vtkLight* headlight)
{
  vtkNew<vtkLight> off;
  off->SetLightTypeToSceneLight();
  off->PositionalOn();
  off->SwitchOff();
  scene.Renderer->AddLight(off);
  ExpectPhong(scene, {}, "a light that is off");
  scene.Renderer->AutomaticLightCreationOn();
  ExpectPhong(scene, { headlight }, "a light that is off, and the headlight created instead");
  scene.Renderer->AutomaticLightCreationOff();
  scene.Renderer->RemoveLight(off);
}

/// A headlight alone is at the camera, even if it does not follow it; beside another light it is
/// not.
void TestLonelyHeadlight(Scene& scene)
{
  vtkNew<vtkLight> left, atCamera, other;
  left->SetLightTypeToHeadlight();
  left->SetPosition(0.0, 0.0, 5.0);
  left->SetIntensity(0.9);
  left->SetColor(1.0, 0.9, 0.8);
  atCamera->DeepCopy(left);
  atCamera->SetPosition(scene.Renderer->GetActiveCamera()->GetPosition());
  atCamera->SetFocalPoint(scene.Renderer->GetActiveCamera()->GetFocalPoint());
  other->SetLightTypeToSceneLight();
  other->SetPosition(3.0, 0.0, 0.0);
  other->SetIntensity(0.3);
  scene.Renderer->LightFollowCameraOff();
  scene.Renderer->AddLight(left);
  ExpectPhong(scene, { atCamera }, "a headlight left behind");
  scene.Renderer->AddLight(other);
  ExpectPhong(scene, { left, other }, "a headlight left behind, and another light");
  scene.Renderer->LightFollowCameraOn();
  ExpectPhong(scene, { atCamera, other }, "a headlight that follows, and another light");
  scene.Renderer->RemoveAllLights();
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
  TestLightsThatAreOff(scene, headlight);
  TestLonelyHeadlight(scene);

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
  lamp->SetConeAngle(90.0);
  ExpectPhong(scene, { sun, lamp }, "a lamp with a cone of 90 degrees");
  scene.Renderer->AddLight(spot);
  ExpectPhong(scene, { sun, lamp, spot }, "and a spot");
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Reshade",
    "lights only shade again");
}

/// Without two-sided lighting a ball is lit by its outside: unlit where it is seen from inside by a
/// headlight, and by a light behind its wall as from outside.
void TestOneSided()
{
  Scene scene(Ball(), { 0.3 });
  scene.Volume->GetProperty()->SetAmbient(0.2);
  scene.Volume->GetProperty()->SetDiffuse(0.7);
  scene.Volume->GetProperty()->SetSpecular(0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetClippingRange(0.01, 10.0);
  const auto red = [&]
  {
    Expect(scene.Render(40, 40), "rendered");
    return static_cast<double>(scene.ColorAt(20, 20)[0]);
  };
  const auto isNear = [](double a, double b) { return std::abs(a - b) < 1.0; };
  const double full = 255.0 * 0.9;
  Expect(isNear(red(), 0.9 * full), "two-sided: lit from inside");
  scene.Renderer->TwoSidedLightingOff();
  Expect(isNear(red(), 0.2 * full), "one-sided: not lit from inside");
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Reshade",
    "only shaded again");
  vtkNew<vtkLight> behind;
  behind->SetLightTypeToSceneLight();
  behind->SetPosition(0.0, 0.0, -5.0);
  behind->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Renderer->AddLight(behind);
  Expect(isNear(red(), 0.9 * full), "one-sided: lit by what shines on the outside");
  scene.Renderer->TwoSidedLightingOn();
  Expect(isNear(red(), 0.2 * full), "two-sided: in the shade");
  double normal[3];
  Expect(scene.Mapper->PickPixel(20, 20, nullptr, normal, nullptr) && normal[2] > 0.99,
    "the normal that is picked faces the viewer always");

  // From outside there is no difference, nor is there for the cap of a solid.
  for (const int mode :
    { vtkTemporalCoherenceVolumeMapper::CROSSING, vtkTemporalCoherenceVolumeMapper::THRESHOLD })
  {
    Scene outside(Ball(), { mode == vtkTemporalCoherenceVolumeMapper::CROSSING ? 0.3 : -0.2 });
    outside.Mapper->SetSurfaceMode(mode);
    outside.LookFrom(1.0, -2.0, 0.5);
    Expect(outside.Render(100, 100), "rendered");
    vtkNew<vtkImageData> twoSided;
    twoSided->DeepCopy(outside.Color);
    outside.Renderer->TwoSidedLightingOff();
    Expect(outside.Render(100, 100) && AreIdentical(twoSided, outside.Color), "seen from outside");
  }
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
        wrong += std::abs(Dot(normal, truth.Field.WorldNormalAt(point))) < 0.99999;
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
  TestOneSided();
  TestNormals();
  TestPlaces();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
