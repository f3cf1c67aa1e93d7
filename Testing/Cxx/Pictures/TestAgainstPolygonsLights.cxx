// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Lights of every kind light a volume as they light the same surface of polygons, also in the
// scenes of VTK's TestGPURayCastPositionalLights and VolumeLightKit.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/PolygonPeer.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkLight.h>
#include <vtkLightKit.h>
#include <vtkTransform.h>

#include <cmath>
#include <cstdlib>

namespace
{

/// A bumpy ball of radius 0.6 or so.
vtkSmartPointer<vtkImageData> BumpyBall()
{
  return Volumes::FromFormula(71, VTK_FLOAT,
    [](double x, double y, double z)
    {
      return 0.6 - std::hypot(x, y, z) +
        0.04 * std::sin(9.0 * x) * std::sin(9.0 * y) * std::sin(9.0 * z);
    });
}

/// A bumpy ball without a light, and polygons beside it.
struct Stage
{
  Stage()
    : Ball(BumpyBall(), { 0.0 })
    , Peer(Ball.Volume, Ball.Renderer)
  {
    vtkVolumeProperty* property = this->Ball.Volume->GetProperty();
    property->SetAmbient(0.15);
    property->SetDiffuse(0.6);
    property->SetSpecular(0.4);
    property->SetSpecularPower(12.0);
    this->Peer.SetContours(this->Ball.Mapper->GetInput());
    this->Peer.LookFrom(1.0, -2.0, 0.7);
    this->Ball.Renderer->GetActiveCamera()->Zoom(1.8);
    this->Ball.Renderer->RemoveAllLights();
    this->Ball.Renderer->AutomaticLightCreationOff();
  }

  /// Compare in the light of one that may be changed first.
  template <typename Change>
  void ExpectAlike(const std::string& what, Change&& change)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(2.0, -2.5, 3.0);
    light->SetColor(1.0, 0.8, 0.6);
    change(light);
    this->Ball.Renderer->AddLight(light);
    this->Peer.ExpectAgreement(what, 10000);
    this->Ball.Renderer->RemoveLight(light);
  }

  Scene Ball;
  PolygonPeer Peer;
};

void TestKinds()
{
  Stage stage;
  stage.Peer.ExpectAgreement("no light", 10000);
  stage.ExpectAlike("a light that is off", [](vtkLight* light) { light->SwitchOff(); });
  stage.ExpectAlike("a light of the scene", [](vtkLight*) {});
  stage.ExpectAlike("a light of half intensity", [](vtkLight* light) { light->SetIntensity(0.5); });
  stage.ExpectAlike("ambient light, which polygons have no use for",
    [](vtkLight* light) { light->SetAmbientColor(0.5, 0.5, 0.5); });
  stage.ExpectAlike("a light of the camera",
    [](vtkLight* light)
    {
      light->SetLightTypeToCameraLight();
      light->SetPosition(0.5, 0.7, 1.0);
    });
  stage.ExpectAlike("a light that is moved by a matrix",
    [](vtkLight* light)
    {
      vtkNew<vtkTransform> turn;
      turn->RotateX(30.0);
      turn->RotateZ(-40.0);
      turn->Translate(0.3, 0.0, 0.5);
      light->SetTransformMatrix(turn->GetMatrix());
    });

  // VTK gives a lone headlight's highlights to polygons by another formula: (N.L)^power.
  stage.Ball.Volume->GetProperty()->SetSpecular(0.0);
  stage.Peer.UpdatePolygons();
  const auto headlight = [](vtkLight* light) { light->SetLightTypeToHeadlight(); };
  stage.ExpectAlike("a headlight", headlight);
  stage.Ball.Renderer->LightFollowCameraOff();
  stage.ExpectAlike("a headlight that does not follow", headlight);
  stage.Ball.Renderer->LightFollowCameraOn();
  stage.Ball.Renderer->AutomaticLightCreationOn();
  stage.Peer.ExpectAgreement("the headlight that the renderer creates", 10000);
}

void TestPositional()
{
  Stage stage;
  const auto positional = [&](const std::string& what, double cone, double exponent,
                            std::array<double, 3> attenuation = { 1.0, 0.0, 0.0 })
  {
    stage.ExpectAlike(what,
      [&](vtkLight* light)
      {
        light->PositionalOn();
        light->SetPosition(0.6, -1.6, 0.9);
        light->SetConeAngle(cone);
        light->SetExponent(exponent);
        light->SetAttenuationValues(attenuation.data());
      });
  };
  positional("a lamp, cone of 180 degrees", 180.0, 1.0);
  positional("a lamp, cone of 90 degrees", 90.0, 3.0);
  positional("a spot, cone of 89 degrees", 89.0, 3.0);
  positional("a spot, cone of 14 degrees", 14.0, 1.0);
  positional("a spot of exponent 40", 60.0, 40.0);
  positional("a spot of exponent 0", 20.0, 0.0);
  positional("a lamp that fades with distance", 180.0, 1.0, { 0.2, 0.4, 0.0 });
  positional("a lamp that fades with its square", 180.0, 1.0, { 0.0, 0.0, 0.9 });
  positional("a spot that fades", 25.0, 5.0, { 0.1, 0.2, 0.3 });
}

/// One red spot, lighting not two-sided, on a volume that is moved aside.
void TestPositionalLights()
{
  Stage stage;
  stage.Ball.Renderer->TwoSidedLightingOff();
  stage.Ball.Volume->SetScale(40.0);
  stage.Ball.Volume->SetPosition(-30.0, 0.0, 0.0);
  stage.Peer.UpdatePolygons();
  stage.Peer.LookFrom(0.3, -0.5, 1.0);
  stage.Ball.Renderer->GetActiveCamera()->Zoom(1.8);
  stage.ExpectAlike("PositionalLights",
    [](vtkLight* light)
    {
      light->SetPositional(true);
      light->SetColor(1.0, 0.0, 0.0);
      light->SetConeAngle(60.0);
      light->SetPosition(0.0, 0.0, 100.0);
      light->SetFocalPoint(0.0, 0.0, 0.0);
    });
}

/// A kit of five lights, some of the camera and one at it.
void TestLightKit()
{
  Stage stage;
  stage.Ball.Renderer->TwoSidedLightingOff();
  vtkNew<vtkLightKit> kit;
  kit->SetKeyLightWarmth(1.0);
  kit->SetFillLightWarmth(0.0);
  kit->SetBackLightWarmth(0.0);
  kit->AddLightsToRenderer(stage.Ball.Renderer);
  stage.Peer.ExpectAgreement("VolumeLightKit, shining", 10000);
  vtkVolumeProperty* property = stage.Ball.Volume->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  stage.Peer.UpdatePolygons();
  stage.Peer.ExpectAgreement("VolumeLightKit", 10000);
  stage.Ball.Renderer->GetActiveCamera()->Azimuth(140.0);
  stage.Peer.ExpectAgreement("VolumeLightKit, turned", 10000);
}

}

int TestAgainstPolygonsLights(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestKinds();
  TestPositional();
  TestPositionalLights();
  TestLightKit();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
