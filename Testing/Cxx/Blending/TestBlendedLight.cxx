// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Ambient light of blended volumes is that of vtkGPUVolumeRayCastMapper: the volume's own colour
// under a plain headlight, else the ambient colours of the lights.

#include "BlendedScene.h"
#include "Checks/Expect.h"

#include <vtkLight.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr double Ambient = 0.5;
const std::array<double, 3> Own = { 0.8, 0.6, 0.4 }; ///< the volume's colour
constexpr double Opacity = 0.75;                     ///< of the way through the volume

/// A cube of one value, which has no gradient: nothing but ambient light is seen of it.
struct FlatScene : Scene
{
  FlatScene()
    : Scene(Volumes::FromFormula(4, VTK_DOUBLE, [](double, double, double) { return 0.0; }), {})
  {
    this->Mapper->SetBlendModeToComposite();
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, Own[0], Own[1], Own[2]);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.5);
    vtkVolumeProperty* property = this->Volume->GetProperty();
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
    property->ShadeOn();
    property->SetAmbient(Ambient);
    this->LookFrom(0.0, 0.0, 5.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5);
    this->Renderer->RemoveAllLights();
  }

  vtkSmartPointer<vtkLight> AddLight()
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetAmbientColor(0.1, 0.2, 0.6);
    this->Renderer->AddLight(light);
    return light;
  }

  void ExpectShown(const std::string& what, const std::array<double, 3>& light)
  {
    Expect(this->Render(8, 8), "a frame");
    const unsigned char* color = this->Scene::ColorAt(4, 4);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double expected = 255.0 * Opacity * Ambient * light[c];
      Expect(std::abs(color[c] - expected) <= 1.1,
        what + ", channel " + std::to_string(c) + ": " + std::to_string(color[c]) + ", expected " +
          std::to_string(expected));
    }
  }
};

void TestHeadlight()
{
  FlatScene scene;
  scene.ExpectShown("the automatic light", Own);
  scene.Renderer->RemoveAllLights();
  const auto light = scene.AddLight();
  light->SetLightTypeToHeadlight();
  scene.ExpectShown("a plain headlight", Own);
  light->SetIntensity(0.5);
  scene.ExpectShown("a weaker headlight", { 0.05, 0.1, 0.3 });
  light->SetIntensity(1.0);
  light->PositionalOn();
  scene.ExpectShown("a positional headlight", { 0.1, 0.2, 0.6 });
}

void TestSceneLights()
{
  FlatScene scene;
  const auto light = scene.AddLight();
  light->SetLightTypeToSceneLight();
  scene.ExpectShown("a scene light", { 0.1, 0.2, 0.6 });
  light->SetAmbientColor(0.3, 0.2, 0.1);
  scene.ExpectShown("another ambient colour", { 0.3, 0.2, 0.1 });
  scene.AddLight()->SetLightTypeToHeadlight();
  scene.ExpectShown("two lights", { 0.4, 0.4, 0.7 });
  light->SwitchOff();
  scene.ExpectShown("a headlight beside a light that is off", Own);
  light->SwitchOn();
  light->SetAmbientColor(0.0, 0.0, 0.0);
  light->SetIntensity(7.0);
  scene.ExpectShown("a light without ambient colour", { 0.1, 0.2, 0.6 });
}

}

int TestBlendedLight(int, char*[])
{
  TestHeadlight();
  TestSceneLights();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
