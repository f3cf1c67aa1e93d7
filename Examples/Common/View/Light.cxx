// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Light.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkVolumeProperty.h>

void AddStudioLights(vtkRenderer* renderer)
{
  vtkNew<vtkLight> key;
  key->SetLightTypeToCameraLight();
  key->SetPosition(-0.5, 0.6, 1.0);
  key->SetFocalPoint(0.0, 0.0, 0.0);
  key->SetIntensity(0.9);
  renderer->AddLight(key);

  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.25);
  renderer->AddLight(fill);
}

void SetSatinShading(vtkVolumeProperty* property)
{
  property->ShadeOn();
  property->SetAmbient(0.15);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.25);
  property->SetSpecularPower(20.0);
}
