// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Numbers that no surface can look like are refused by name: one error, and the last valid picture
// stays. Numbers without effect are not checked. The largest allowed ones still give colours.

#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkColorTransferFunction.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(20, VTK_UNSIGNED_CHAR,
    [](double x, double y, double z) { return 200.0 - 100.0 * std::hypot(x, y, z); });
}

/// A shaded ball in the light of one lamp, which is a spot of its own.
struct Stage
{
  Stage()
    : Drawn(Ball(), { 130.0 })
  {
    this->Drawn.LookFrom(1.0, 2.0, 0.5);
    this->Property->ShadeOn();
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->PositionalOn();
    this->Lamp->SetPosition(4.0, 8.0, 2.0);
    this->Lamp->SetConeAngle(60.0);
    this->Drawn.Renderer->AddLight(this->Lamp);
  }

  Scene Drawn;
  vtkVolumeProperty* Property = this->Drawn.Volume->GetProperty();
  vtkNew<vtkLight> Lamp;
};

/// Each of the values is refused; `set` with `good` mends.
void ExpectRefused(const std::string& setting, const std::vector<double>& values, double good,
  const std::function<void(Stage&, double)>& set, const std::string& remedy)
{
  for (const double value : values)
  {
    Stage stage;
    set(stage, good);
    Mistake mistake(stage.Drawn, setting);
    set(stage, value);
    mistake.ExpectRefused();
    std::ostringstream got;
    got << "got " << value << ';';
    for (const std::string& part :
      { std::string("must be a finite number between"), got.str(), remedy })
    {
      Expect(mistake.Message.find(part) != std::string::npos,
        setting + ": the message has '" + part + "', but is: " + mistake.Message);
    }
    set(stage, good);
    mistake.ExpectMended();
  }
}

/// A number just outside is told apart from the bound.
void TestDigits()
{
  Stage stage;
  Mistake mistake(stage.Drawn, "Diffuse colour of light 0");
  stage.Lamp->SetDiffuseColor(1.0, 1000.0001, 1.0);
  mistake.ExpectRefused();
  Expect(mistake.Message.find("between -1000 and 1000, got 1000.0001;") != std::string::npos,
    "the message has the digits that matter, but is: " + mistake.Message);
}

void TestShading()
{
  const std::vector<double> bad = { NotANumber, Infinity, -Infinity, 1e300, -1e300 };
  ExpectRefused(
    "Ambient of the volume's property", bad, 0.2,
    [](Stage& stage, double value) { stage.Property->SetAmbient(value); }, "SetAmbient");
  ExpectRefused(
    "Diffuse of the volume's property", bad, 0.7,
    [](Stage& stage, double value) { stage.Property->SetDiffuse(value); }, "SetDiffuse");
  ExpectRefused(
    "Specular of the volume's property", bad, 0.5,
    [](Stage& stage, double value) { stage.Property->SetSpecular(value); }, "SetSpecular");
  ExpectRefused(
    "Specular power of the volume's property", { NotANumber, Infinity, -Infinity, 1e300, -1.0 },
    20.0, [](Stage& stage, double value) { stage.Property->SetSpecularPower(value); },
    "SetSpecularPower");
}

void TestLights()
{
  const std::vector<double> bad = { NotANumber, Infinity, -Infinity, 1e300 };
  ExpectRefused(
    "Intensity of light 0 of the renderer", bad, 0.9,
    [](Stage& stage, double value) { stage.Lamp->SetIntensity(value); }, "SetIntensity");
  ExpectRefused(
    "Diffuse colour of light 0", bad, 0.9,
    [](Stage& stage, double value) { stage.Lamp->SetDiffuseColor(1.0, value, 1.0); },
    "SetDiffuseColor");
  ExpectRefused(
    "Specular colour of light 0", bad, 0.9,
    [](Stage& stage, double value) { stage.Lamp->SetSpecularColor(1.0, 1.0, value); },
    "SetSpecularColor");
  ExpectRefused(
    "Position of light 0", bad, 8.0,
    [](Stage& stage, double value) { stage.Lamp->SetPosition(4.0, value, 2.0); }, "SetPosition");
  ExpectRefused(
    "Position of light 0", { NotANumber }, 1.0,
    [](Stage& stage, double value)
    {
      vtkNew<vtkMatrix4x4> moved;
      moved->SetElement(1, 1, value);
      stage.Lamp->SetTransformMatrix(moved);
    },
    "SetTransformMatrix");
  ExpectRefused(
    "Focal point of light 0", bad, 0.0,
    [](Stage& stage, double value) { stage.Lamp->SetFocalPoint(value, 0.0, 0.0); },
    "SetFocalPoint");
  ExpectRefused(
    "Cone angle of light 0", bad, 30.0,
    [](Stage& stage, double value) { stage.Lamp->SetConeAngle(value); }, "SetConeAngle");
  // Others than NaN it clamps itself.
  ExpectRefused(
    "Exponent of light 0", { NotANumber }, 2.0,
    [](Stage& stage, double value) { stage.Lamp->SetExponent(value); }, "SetExponent");
  ExpectRefused(
    "Attenuation of light 0", bad, 0.1,
    [](Stage& stage, double value) { stage.Lamp->SetAttenuationValues(1.0, 0.0, value); },
    "SetAttenuationValues");
}

void TestTransferFunctions()
{
  const std::vector<double> bad = { NotANumber, Infinity, -Infinity, 1e300 };
  ExpectRefused(
    "Colour at isovalue 130", bad, 0.5,
    [](Stage& stage, double value)
    {
      vtkNew<vtkColorTransferFunction> colors;
      colors->AddRGBPoint(130.0, 0.2, value, 0.2);
      stage.Property->SetColor(colors);
    },
    "AddRGBPoint");
  ExpectRefused(
    "Colour at isovalue 130", bad, 0.5,
    [](Stage& stage, double value)
    {
      vtkNew<vtkPiecewiseFunction> gray;
      gray->AddPoint(130.0, value);
      stage.Property->SetColor(gray);
    },
    "GetGrayTransferFunction()->AddPoint");
  ExpectRefused(
    "Scalar opacity at isovalue 130", bad, 0.5,
    [](Stage& stage, double value)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(130.0, value);
      stage.Property->SetScalarOpacity(opacity);
    },
    "GetScalarOpacity()->AddPoint");
  const auto gradientOpacity = [](const std::array<double, 4>& node)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.5);
    opacity->AddPoint(10.0, 0.7);
    std::array<double, 4> written = node;
    opacity->SetNodeValue(1, written.data());
    return vtkSmartPointer<vtkPiecewiseFunction>(opacity);
  };
  const auto expectNode =
    [&](const std::string& name, std::size_t part, const std::vector<double>& values, double good)
  {
    ExpectRefused(
      name + " of node 1 of the gradient opacity", values, good,
      [&](Stage& stage, double value)
      {
        std::array<double, 4> node = { 10.0, 0.7, 0.5, 0.0 };
        node[part] = value;
        stage.Property->SetGradientOpacity(gradientOpacity(node));
      },
      "GetGradientOpacity()");
  };
  expectNode("Position", 0, { NotANumber, Infinity }, 12.0);
  expectNode("Value", 1, bad, 0.6);
  expectNode("Midpoint", 2, { NotANumber, Infinity }, 0.3);
  expectNode("Sharpness", 3, { NotANumber, Infinity }, 0.4);
}

/// The appearance of the component that is drawn counts, and of no other.
void TestWithoutEffect()
{
  const auto expectDrawn = [](const std::string& what, const std::function<void(Stage&)>& arrange)
  {
    Stage stage;
    vtkNew<vtkTest::ErrorObserver> observer;
    stage.Drawn.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
    arrange(stage);
    Expect(stage.Drawn.Render(60, 60) && !observer->GetError(),
      what + " has no effect, but: " + observer->GetErrorMessage());
    Expect(stage.Drawn.ColorAt(30, 30)[3] == 255, what + ": a picture");
  };
  expectDrawn("what no light is for",
    [](Stage& stage)
    {
      stage.Property->ShadeOff();
      stage.Property->SetSpecular(NotANumber);
      stage.Lamp->SetIntensity(NotANumber);
    });
  expectDrawn("a light that is off",
    [](Stage& stage)
    {
      stage.Lamp->SwitchOff();
      stage.Lamp->SetIntensity(NotANumber);
    });
  expectDrawn("the cone of a light without a place",
    [](Stage& stage)
    {
      stage.Lamp->PositionalOff();
      stage.Lamp->SetConeAngle(NotANumber);
    });
  expectDrawn(
    "another component", [](Stage& stage) { stage.Property->SetSpecular(1, NotANumber); });
}

/// FinalColorWindow and FinalColorLevel, on opaque and on translucent surfaces.
void TestColorWindow()
{
  ExpectRefused(
    "FinalColorWindow of the mapper", { NotANumber, Infinity, 65536.0 }, 1.0,
    [](Stage& stage, double value)
    { stage.Drawn.Mapper->SetFinalColorWindow(static_cast<float>(value)); },
    "SetFinalColorWindow");
  ExpectRefused(
    "FinalColorLevel of the mapper", { NotANumber, -Infinity, 65536.0 }, 0.5,
    [](Stage& stage, double value)
    { stage.Drawn.Mapper->SetFinalColorLevel(static_cast<float>(value)); },
    "SetFinalColorLevel");

  for (const float narrow : { 0.0f, 1e-20f, -1e-6f })
  {
    Stage stage;
    Mistake mistake(stage.Drawn, "FinalColorWindow of the mapper must be at least 0.0001");
    stage.Drawn.Mapper->SetFinalColorWindow(narrow);
    mistake.ExpectRefused();
    stage.Drawn.Mapper->SetFinalColorWindow(1.0f);
    mistake.ExpectMended();
  }

  Stage stage;
  stage.Property->ShadeOff();
  stage.Property->GetRGBTransferFunction()->RemoveAllPoints();
  stage.Property->GetRGBTransferFunction()->AddRGBPoint(130.0, 0.2, 0.3, 0.9);
  const auto expect = [&](const std::array<int, 4>& color, const std::string& name)
  {
    Expect(stage.Drawn.Render(60, 60), name + ": rendered");
    const unsigned char* shown = stage.Drawn.ColorAt(30, 30);
    for (std::size_t c = 0; c < 4; ++c)
    {
      Expect(std::abs(shown[c] - color[c]) <= 1,
        name + ": channel " + std::to_string(c) + " is " + std::to_string(shown[c]));
    }
  };
  expect({ 51, 77, 230, 255 }, "all colours");
  stage.Drawn.Mapper->SetFinalColorWindow(0.5f);
  stage.Drawn.Mapper->SetFinalColorLevel(0.25f);
  expect({ 102, 153, 255, 255 }, "the darker half of them");
  Expect(std::string(stage.Drawn.Mapper->GetStatistics()->GetRouteAsString()) == "Reshade",
    "traced again");
  stage.Drawn.Mapper->SetFinalColorWindow(-1.0f);
  stage.Drawn.Mapper->SetFinalColorLevel(0.5f);
  expect({ 204, 179, 26, 255 }, "turned round");
  stage.Drawn.Mapper->SetSurfaceModeToThreshold();
  stage.Property->GetScalarOpacity()->RemoveAllPoints();
  stage.Property->GetScalarOpacity()->AddPoint(130.0, 0.5);
  expect({ 102, 89, 13, 128 }, "turned round, translucent");
}

/// Where the brightest light that there may be does not shine, ambient light is seen; where it
/// does, its colour.
void TestLargestNumbers()
{
  Stage stage;
  stage.Drawn.Volume->GetProperty()->GetRGBTransferFunction()->RemoveAllPoints();
  stage.Drawn.Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(130.0, 0.5, 0.5, 0.5);
  stage.Property->SetAmbient(0.4);
  stage.Property->SetDiffuse(0.0);
  stage.Property->SetSpecular(0.0);
  Expect(stage.Drawn.Render(60, 60), "ambient light alone");
  const int ambient = stage.Drawn.ColorAt(30, 30)[0];
  Expect(ambient == 51, "a dark ball");

  stage.Property->SetDiffuse(1e6);
  stage.Property->SetSpecular(1e6);
  stage.Lamp->SetIntensity(1e18);
  stage.Lamp->SetDiffuseColor(1e3, 1e3, 1e3);
  stage.Lamp->SetAttenuationValues(0.0, 0.0, 1e-300);
  stage.Lamp->SetConeAngle(180.0);
  Expect(stage.Drawn.Render(60, 60), "the brightest light");
  Expect(stage.Drawn.ColorAt(30, 30)[0] == 255, "it shines");
  // From behind, the ball hides the light from itself.
  stage.Lamp->SetPosition(-4.0, -8.0, -2.0);
  Expect(stage.Drawn.Render(60, 60), "the brightest light, behind");
  Expect(stage.Drawn.ColorAt(30, 30)[0] == ambient, "it does not shine there");
  // Translucent surfaces are summed up elsewhere.
  stage.Property->GetScalarOpacity()->RemoveAllPoints();
  stage.Property->GetScalarOpacity()->AddPoint(130.0, 0.999);
  stage.Drawn.Mapper->SetSurfaceModeToThreshold();
  Expect(stage.Drawn.Render(60, 60), "the same, translucent");
  Expect(std::abs(stage.Drawn.ColorAt(30, 30)[0] - ambient) <= 1, "nor there");
}

}

int TestAppearance(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestDigits();
  TestShading();
  TestLights();
  TestTransferFunctions();
  TestWithoutEffect();
  TestColorWindow();
  TestLargestNumbers();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
