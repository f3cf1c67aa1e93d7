// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/FeatureChanges.h"

#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include <array>
#include <cmath>

using Mapper = vtkTemporalCoherenceVolumeMapper;

namespace FeatureChanges
{
namespace
{

std::array<double, 3> Anywhere(RandomViews& views, double size)
{
  const double x = views.Between(-size, size), y = views.Between(-size, size);
  return { x, y, views.Between(-size, size) };
}

/// The flags that have names, and others: most of them keep much.
int Flags(RandomViews& views)
{
  constexpr int All = 0x7ffffff;
  const std::array<int, 5> named = { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE,
    VTK_CROP_CROSS, VTK_CROP_INVERTED_CROSS };
  const int choice = views.Pick(9);
  if (choice < 5)
  {
    return named[static_cast<std::size_t>(choice)];
  }
  const int some = views.Pick(All + 1), others = views.Pick(All + 1);
  return choice == 5 ? some : choice == 6 ? All ^ 1 << views.Pick(27) : some | others;
}

void CropAnywhere(Mapper* mapper, RandomViews& views)
{
  std::array<double, 6> planes;
  for (std::size_t i = 0; i < 6; i += 2)
  {
    planes[i] = views.Between(-0.8, 0.3);
    planes[i + 1] = views.Between(planes[i], 0.9);
  }
  mapper->SetCroppingRegionPlanes(planes.data());
}

void ClipAnywhere(Mapper* mapper, RandomViews& views)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(Anywhere(views, 0.3).data());
  plane->SetNormal(Anywhere(views, 1.0).data());
  mapper->AddClippingPlane(plane);
}

/// A plane that is there moves, without the mapper being told.
void MoveClip(Mapper* mapper, RandomViews& views)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const int many = planes ? planes->GetNumberOfItems() : 0;
  if (many > 0)
  {
    planes->GetItem(views.Pick(many))->SetOrigin(Anywhere(views, 0.3).data());
  }
}

void SetOpacities(vtkVolumeProperty* property, RandomViews& views)
{
  const std::array<double, 6> usual = { 0.0, 0.05, 0.3, 0.5, 0.9, 1.0 };
  vtkNew<vtkPiecewiseFunction> opacity;
  for (double value = -2000.0; value <= 2000.0; value += 500.0)
  {
    opacity->AddPoint(value, usual[static_cast<std::size_t>(views.Pick(6))]);
  }
  property->SetScalarOpacity(opacity);
}

void SetGradientOpacities(vtkVolumeProperty* property, RandomViews& views)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  const double steep = std::pow(10.0, views.Between(1.5, 3.0));
  const bool isOfGentle = views.Pick(2) == 0;
  opacity->AddPoint(0.5 * steep, isOfGentle ? 1.0 : 0.0);
  opacity->AddPoint(steep, isOfGentle ? 0.2 : 1.0);
  property->SetGradientOpacity(opacity);
  property->DisableGradientOpacityOff();
}

void AddLight(Scene& scene, RandomViews& views)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(Anywhere(views, 3.0).data());
  light->SetPositional(views.Pick(2));
  light->SetConeAngle(views.Between(20.0, 100.0));
  light->SetIntensity(0.6);
  if (views.Pick(2) == 0)
  {
    scene.Renderer->RemoveAllLights();
  }
  scene.Renderer->AddLight(light);
}

}

std::vector<Change> OfRegion(Scene& scene, RandomViews& views)
{
  Mapper* mapper = scene.Mapper;
  return {
    { true,
      [=, &views]
      {
        mapper->CroppingOn();
        mapper->SetCroppingRegionFlags(Flags(views));
        CropAnywhere(mapper, views);
      } },
    { true,
      [=, &views]
      {
        mapper->CroppingOn();
        mapper->SetCroppingRegionFlagsToSubVolume();
        CropAnywhere(mapper, views);
      } },
    { true, [=, &views] { mapper->SetCroppingRegionFlags(Flags(views)); } },
    { true, [=, &views] { CropAnywhere(mapper, views); } },
    { true, [=] { mapper->CroppingOff(); } },
    { true, [=, &views] { ClipAnywhere(mapper, views); } },
    { true, [=, &views] { MoveClip(mapper, views); } },
    { true, [=] { mapper->RemoveAllClippingPlanes(); } },
  };
}

std::vector<Change> OfOpacity(Scene& scene, RandomViews& views)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  const auto opaque = [=]
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 1.0);
    property->SetScalarOpacity(opacity);
  };
  return {
    { false, [=, &views] { SetOpacities(property, views); } },
    { false, [=, &views] { SetOpacities(property, views); } },
    { false,
      [=, &views]
      { property->GetScalarOpacity()->AddPoint(views.Between(-1500.0, 1500.0), 0.4); } },
    { false, opaque },
    { false, [=, &views] { SetGradientOpacities(property, views); } },
    { false, [=] { property->DisableGradientOpacityOn(); } },
  };
}

std::vector<Change> OfLists(Scene& scene, RandomViews& views)
{
  const auto several = [&scene, &views](double size)
  {
    std::vector<double> isovalues;
    for (int i = views.Pick(4); i >= 0; --i)
    {
      isovalues.push_back(views.Between(-size, size));
    }
    if (views.Pick(3) == 0)
    {
      isovalues.push_back(isovalues.front());
    }
    scene.SetIsovalues(isovalues);
  };
  return {
    { false, [=] { several(900.0); } },
    { false, [=] { several(1500.0); } },
    { false, [&] { scene.SetIsovalues({ views.Between(-900.0, 900.0) }); } },
    { false, [&] { scene.SetIsovalues({ 100.0 * views.Pick(12) }); } },
  };
}

std::vector<Change> OfAppearance(Scene& scene, RandomViews& views)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return {
    { false, [=, &views] { property->SetAmbient(views.Between(0.0, 0.6)); } },
    { false, [=, &views] { property->SetSpecular(views.Between(0.0, 0.6)); } },
    { false, [=, &views] { property->SetShade(views.Pick(3) != 0); } },
    { false,
      [=, &views]
      {
        property->GetRGBTransferFunction()->AddRGBPoint(
          views.Between(-1000.0, 1000.0), 0.1, views.Between(0.0, 1.0), 0.9);
      } },
    { false, [&] { AddLight(scene, views); } },
    { false, [&] { scene.Renderer->SetTwoSidedLighting(views.Pick(2)); } },
    { false, [&] { scene.Mapper->SetShadows(1 - scene.Mapper->GetShadows()); } },
  };
}

std::vector<Change> OfVolume(Scene& scene, RandomViews& views)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return {
    { true, [&] { scene.Volume->RotateX(views.Between(1.0, 30.0)); } },
    { true, [&] { scene.Volume->SetScale(1.0, views.Between(0.8, 1.2), 1.0); } },
    { true, [&] { scene.Volume->SetScale(views.Between(-1.2, -0.8), 1.0, 1.0); } },
    { true, [=] { property->SetInterpolationType(1 - property->GetInterpolationType()); } },
    { false, [&] { scene.Mapper->SetSurfaceMode(1 - scene.Mapper->GetSurfaceMode()); } },
  };
}

void SwitchOff(Scene& scene)
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> made;
  Mapper* mapper = scene.Mapper;
  mapper->SetCropping(made->GetCropping());
  mapper->RemoveAllClippingPlanes();
  mapper->SetSurfaceMode(made->GetSurfaceMode());
  mapper->SetShadows(made->GetShadows());
  mapper->SetVectorMode(made->GetVectorMode());
  mapper->SetColorArrayName(made->GetColorArrayName());
  mapper->SetColorArrayOpacity(made->GetColorArrayOpacity());
  mapper->SetMaskInput(nullptr);
  mapper->SetAntialiasingToOff();
  mapper->SetReuseFrames(made->GetReuseFrames());
  mapper->SetIsomap(made->GetIsomap());
  mapper->SetSpaceLeaping(made->GetSpaceLeaping());
  mapper->SetColorByAnswer(made->GetColorByAnswer());
  mapper->SetReuseAccuracy(made->GetReuseAccuracy());
  mapper->SetImageCachePolicy(made->GetImageCachePolicy());
  mapper->SetNumberOfCachedImages(made->GetNumberOfCachedImages());
  mapper->SetKeyImageInterval(made->GetKeyImageInterval());
  mapper->SetImageCacheShading(made->GetImageCacheShading());
  mapper->SetIsomapTolerance(made->GetIsomapTolerance());
  mapper->SetIsomapRange(made->GetIsomapRange());
  mapper->SetIsomapMemoryLimit(made->GetIsomapMemoryLimit());
  mapper->SetIsomapShading(made->GetIsomapShading());
  scene.Renderer->RemoveAllLights();
  scene.Renderer->TwoSidedLightingOn();

  const Scene fresh(nullptr, { 0.0 });
  vtkVolumeProperty* plain = fresh.Volume->GetProperty();
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetInterpolationType(plain->GetInterpolationType());
  property->SetShade(plain->GetShade());
  property->SetAmbient(plain->GetAmbient());
  property->SetSpecular(plain->GetSpecular());
  property->SetColor(plain->GetRGBTransferFunction());
  property->SetScalarOpacity(static_cast<vtkPiecewiseFunction*>(nullptr));
  property->SetGradientOpacity(static_cast<vtkPiecewiseFunction*>(nullptr));
  for (int component = 0; component < 3; ++component)
  {
    property->SetComponentWeight(component, 1.0);
  }
  scene.Volume->SetScale(1.0);
  scene.Volume->SetOrientation(0.0, 0.0, 0.0);
  scene.Volume->SetPosition(0.0, 0.0, 0.0);
}

}
