// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChangedScene.h"

#include "SurfacePolygons.h"

#include <vtkCollection.h>
#include <vtkContourValues.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVersion.h>
#include <vtkVolumeCollection.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <limits>

namespace
{

/// Ask a volume for one opaque surface, in the middle of its samples.
void MakeSurface(vtkVolume* volume)
{
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (vtkDataSet* part : PartsOf(volume))
  {
    if (const ScalarField field = FieldOf(volume, part); field.Samples)
    {
      const double* range = field.Samples->GetScalarRange();
      lowest = std::min(lowest, range[0]);
      highest = std::max(highest, range[1]);
    }
  }
  vtkVolumeProperty* property = volume->GetProperty();
  property->GetIsoSurfaceValues()->SetNumberOfContours(1);
  property->GetIsoSurfaceValues()->SetValue(0, lowest / 2 + highest / 2);
  property->SetInterpolationTypeToLinear();
  property->DisableGradientOpacityOn();
  for (int component = 0; component < VTK_MAX_VRCOMP; ++component)
  {
    vtkNew<vtkPiecewiseFunction> opaque;
    opaque->AddPoint(lowest, 1.0);
    property->SetScalarOpacity(component, opaque);
  }
  vtkVolumeMapper::SafeDownCast(volume->GetMapper())->SetBlendModeToIsoSurface();
}

/// Changes volumes while it draws.
class ChangingRenderer : public vtkOpenGLRenderer
{
public:
  static ChangingRenderer* New();
  vtkTypeMacro(ChangingRenderer, vtkOpenGLRenderer);

  static bool MakesSurfaces, HidesVolumes, AddsPolygons;

  void Render() override
  {
    this->GetActiveCamera(); // made, if need be, for all that is seen
    std::vector<vtkVolume*> hidden;
    std::vector<vtkSmartPointer<vtkActor>> polygons;
    vtkVolumeCollection* volumes = this->GetVolumes();
    vtkCollectionSimpleIterator at;
    volumes->InitTraversal(at);
    while (vtkVolume* volume = volumes->GetNextVolume(at))
    {
      if (!volume->GetVisibility() || !vtkVolumeMapper::SafeDownCast(volume->GetMapper()))
      {
        continue;
      }
      if (MakesSurfaces)
      {
        MakeSurface(volume);
      }
      if (AddsPolygons)
      {
        const auto more = MakePolygons(volume);
        polygons.insert(polygons.end(), more.begin(), more.end());
      }
      if (HidesVolumes)
      {
        hidden.push_back(volume);
      }
    }
    for (vtkVolume* volume : hidden)
    {
      volume->VisibilityOff();
    }
    for (vtkActor* actor : polygons)
    {
      this->AddActor(actor);
    }
    this->Superclass::Render();
    for (vtkActor* actor : polygons)
    {
      this->RemoveActor(actor);
    }
    for (vtkVolume* volume : hidden)
    {
      volume->VisibilityOn();
    }
  }

protected:
  ChangingRenderer() = default;
};
bool ChangingRenderer::MakesSurfaces = false;
bool ChangingRenderer::HidesVolumes = false;
bool ChangingRenderer::AddsPolygons = false;
vtkStandardNewMacro(ChangingRenderer);

VTK_CREATE_CREATE_FUNCTION(ChangingRenderer)

class Factory : public vtkObjectFactory
{
public:
  static Factory* New();
  vtkTypeMacro(Factory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Renderers that change volumes"; }

protected:
  Factory()
  {
    this->RegisterOverride("vtkRenderer", "ChangingRenderer", "Changes volumes", 1,
      vtkObjectFactoryCreateChangingRenderer);
  }
};
vtkStandardNewMacro(Factory);

}

vtkSmartPointer<vtkObjectFactory> MakeFactoryOfChangedScenes(const std::string& change)
{
  ChangingRenderer::MakesSurfaces = change == "surfaces" || change == "surfaces-polygons";
  ChangingRenderer::AddsPolygons = change == "polygons" || change == "surfaces-polygons";
  ChangingRenderer::HidesVolumes = ChangingRenderer::AddsPolygons || change == "hidden";
  return vtkSmartPointer<Factory>::New();
}
