// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/RandomChanges.h"

#include "Checks/Expect.h"
#include "Volumes/Ghosts.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkLight.h>
#include <vtkPointData.h>

using Mapper = vtkTemporalCoherenceVolumeMapper;

namespace
{

void AddLight(Scene& scene, RandomViews& views)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(views.Between(-3.0, 3.0), views.Between(-3.0, 3.0), 3.0);
  light->SetIntensity(0.3);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
}

}

std::vector<Change> ChangesOfScene(Scene& scene, vtkImageData* image, RandomViews& views)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return {
    { true,
      [=, &views]
      {
        vtkDataArray* scalars = image->GetPointData()->GetScalars();
        const vtkIdType at = views.Pick(31000);
        for (vtkIdType i = at; i < at + 400; ++i)
        {
          scalars->SetComponent(i, 0, 1000.0 * views.Pick(3) - 500.0);
        }
        scalars->Modified();
      } },
    { true, [=, &views] { image->SetOrigin(views.Between(-2.0, 0.0), -1.0, -1.0); } },
    { true, [=, &views] { image->SetSpacing(views.Between(0.05, 0.08), 0.065, 0.065); } },
    { true, [&] { scene.Volume->RotateX(views.Between(1.0, 30.0)); } },
    { true, [&] { scene.Volume->SetScale(1.0, views.Between(0.8, 1.2), 1.0); } },
    { true, [=] { property->SetInterpolationType(1 - property->GetInterpolationType()); } },
    // A picture of the same mode may still be kept.
    { false, [&] { scene.Mapper->SetSurfaceMode(1 - scene.Mapper->GetSurfaceMode()); } },
    { false, [&] { scene.SetIsovalues({ views.Between(-900.0, 900.0) }); } },
    { false,
      [&] {
        scene.SetIsovalues({ views.Between(0.0, 500.0), views.Between(-500.0, 0.0) });
      } },
    { false, [=] { property->SetAmbient(property->GetAmbient() > 0.3 ? 0.1 : 0.5); } },
    { false,
      [=, &views]
      {
        property->GetRGBTransferFunction()->AddRGBPoint(
          views.Between(-500.0, 500.0), 0.1, views.Between(0.0, 1.0), 0.9);
      } },
    { false, [&] { AddLight(scene, views); } },
    { false, [&] { scene.Renderer->SetTwoSidedLighting(views.Pick(2)); } },
  };
}

std::vector<Change> ChangesOfView(Scene& scene, RandomViews& views)
{
  const auto move = [&] { views.Move(); };
  const auto project = [&scene]
  {
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(1 - camera->GetParallelProjection());
  };
  return { { false, move }, { false, move }, { false, move }, { false, move }, { false, move },
    { false, move }, { false, project }, { false, [&] { views.Resize(); } }, { false, [] {} } };
}

std::vector<Change> ChangesOfImageCache(Scene& scene, RandomViews& views)
{
  Mapper* mapper = scene.Mapper;
  return {
    { false, [=] { mapper->SetSpaceLeaping(1 - mapper->GetSpaceLeaping()); } },
    { false, [=, &views] { mapper->SetReuseFrames(views.Pick(4) != 0); } },
    { false, [=, &views] { mapper->SetReuseAccuracy(Mapper::EXACT + views.Pick(2)); } },
    { false, [=, &views] { mapper->SetImageCachePolicy(views.Pick(2)); } },
    { false, [=, &views] { mapper->SetNumberOfCachedImages(1 + views.Pick(4)); } },
    { false, [=, &views] { mapper->SetKeyImageInterval(1 + views.Pick(6)); } },
    { false, [=, &views] { mapper->SetImageCacheShading(views.Pick(2)); } },
    { false, [=] { mapper->SetColorByAnswer(1 - mapper->GetColorByAnswer()); } },
  };
}

std::vector<Change> ChangesOfIsovalues(Scene& scene, RandomViews& views)
{
  const auto now = [&scene]
  {
    vtkContourValues* list = scene.Volume->GetProperty()->GetIsoSurfaceValues();
    std::vector<double> isovalues;
    for (int i = 0; i < list->GetNumberOfContours(); ++i)
    {
      isovalues.push_back(list->GetValue(i));
    }
    return isovalues;
  };
  const auto moveBy = [&scene, &views, now](double distance)
  {
    std::vector<double> isovalues = now();
    if (!isovalues.empty())
    {
      isovalues[static_cast<std::size_t>(views.Pick(static_cast<int>(isovalues.size())))] +=
        views.Between(-distance, distance);
      scene.SetIsovalues(isovalues);
    }
  };
  return {
    { false, [=] { moveBy(5.0); } },
    { false, [=] { moveBy(40.0); } },
    { false, [=] { moveBy(0.01); } },
    { false, [&] { scene.SetIsovalues({ views.Between(-1700.0, 1700.0) }); } },
    { false, [&] { scene.SetIsovalues({ static_cast<double>(views.Pick(1000) - 500) }); } },
    { false, [&] { scene.SetIsovalues({ views.Pick(2) ? 1e5 : -1e5 }); } },
    { false,
      [=, &scene, &views]
      {
        std::vector<double> isovalues = now();
        isovalues.push_back(views.Between(-900.0, 900.0));
        scene.SetIsovalues(isovalues);
      } },
    { false,
      [=, &scene]
      {
        std::vector<double> isovalues = now();
        if (isovalues.size() > 1)
        {
          isovalues.pop_back();
          scene.SetIsovalues(isovalues);
        }
      } },
  };
}

std::vector<Change> ChangesOfIsomap(Scene& scene, RandomViews& views)
{
  Mapper* mapper = scene.Mapper;
  return {
    { false, [=, &views] { mapper->SetIsomap(views.Pick(4) != 0); } },
    { false,
      [=, &views]
      {
        const double low = views.Between(-1500.0, 1000.0);
        mapper->SetIsomapRange(low, low + views.Between(-300.0, 1500.0));
      } },
    { false, [=, &views] { mapper->SetIsomapMemoryLimit(views.Pick(3)); } },
    { false, [=] { mapper->SetIsomapMemoryLimit(256); } },
    { false, [=, &views] { mapper->SetIsomapTolerance(views.Pick(2) ? 0.0 : 0.2); } },
    { false, [=, &views] { mapper->SetIsomapShading(views.Pick(2)); } },
    { false, [mapper, &scene] { mapper->BuildIsomap(scene.Renderer, scene.Volume); } },
  };
}

std::vector<Change> ChangesOfGhosts(vtkImageData* image, RandomViews& views)
{
  const auto seed = [&views] { return static_cast<unsigned>(views.Pick(1000)); };
  return {
    { true, [=, &views] { Ghosts::HideCells(image, views.Between(0.01, 0.6), seed()); } },
    { true, [=, &views] { Ghosts::HidePoints(image, views.Between(0.001, 0.05), seed()); } },
    { true,
      [=, &views]
      {
        const int beyond = views.Pick(20);
        Ghosts::FlagCells(image,
          [=](int i, int j, int) { return i + j < beyond ? vtkDataSetAttributes::HIDDENCELL : 0; });
      } },
    { false, [=] { Ghosts::Remove(image); } },
  };
}

void ExpectPromise(Scene& scene, ColdWitness& cold, const std::string& what)
{
  Mapper* mapper = scene.Mapper;
  Expect(cold.Draw(scene), what + ": rendered cold");
  const bool isFromCache = IsRoute(scene, "ImageCache");
  const bool isLookedUp = IsRoute(scene, "IsomapLookup") || IsRoute(scene, "IsomapBuild");
  const double tolerance = isLookedUp ? mapper->GetIsomapTolerance() : 0.0;
  // In small pictures a single pixel can be more than the share.
  const double allowed = 5e-4 * static_cast<double>(scene.Depth->GetNumberOfPoints()) + 3.0;
  if (isFromCache)
  {
    return; // PAPER promises nothing of a single picture
  }
  if (tolerance > 0.0)
  {
    const vtkIdType different = cold.CountDifferent(scene, 1.001 * tolerance);
    Expect(static_cast<double>(different) <= allowed,
      what + ", " + mapper->GetStatistics()->GetRouteAsString() + ": " + std::to_string(different) +
        " pixels differ");
    return;
  }
  const bool hasOtherColors =
    mapper->GetColorByAnswer() || (isLookedUp && mapper->GetIsomapShading() == Mapper::INTERPOLATE);
  Expect(cold.IsDepthIdentical(scene), what + ": not the cold depths");
  Expect(hasOtherColors || cold.IsColorIdentical(scene), what + ": not the cold colours");
}

void ExpectRefined(Scene& scene, RandomViews& views, ColdWitness& cold, const std::string& what)
{
  Expect(views.Render(), what + ": rendered again");
  Expect(cold.IsDepthIdentical(scene) &&
      (scene.Mapper->GetColorByAnswer() || cold.IsColorIdentical(scene)),
    what + ": not the cold picture when rendered again");
}

std::vector<KindOfChange> KindsOfChange(
  Scene& scene, vtkImageData* image, RandomViews& views, const Twelfths& often)
{
  return {
    { often.View, ChangesOfView(scene, views) },
    { often.Scene, ChangesOfScene(scene, image, views) },
    { often.Isovalues, ChangesOfIsovalues(scene, views) },
    { often.ImageCache, ChangesOfImageCache(scene, views) },
    { often.Isomap, ChangesOfIsomap(scene, views) },
  };
}

Sweep::Routes Wander(Scene& scene, RandomViews& views, const std::vector<KindOfChange>& kinds,
  const std::string& name, int steps)
{
  ColdWitness cold;
  Sweep::Routes routes;
  Expect(views.Render(), "rendered first");
  for (int step = 0; step < steps; ++step)
  {
    const std::string what = name + ", step " + std::to_string(step);
    bool isOfData = false;
    for (const auto& [often, changes] : kinds)
    {
      if (views.Pick(12) < often)
      {
        const auto which = static_cast<std::size_t>(views.Pick(static_cast<int>(changes.size())));
        changes[which].Make();
        isOfData = isOfData || changes[which].IsOfData;
      }
    }
    Expect(views.Render(), what + ": rendered");
    // What is as it was before the last frame may have an isomap still. Where other samples are not
    // seen, the last picture is copied.
    const bool isCopied = isOfData && IsRoute(scene, "TimeStep");
    Expect(!isOfData || isCopied || IsRoute(scene, "Cold") || IsRoute(scene, "IsomapLookup"),
      what + ": other data are drawn by " + scene.Mapper->GetStatistics()->GetRouteAsString());
    ExpectPromise(scene, cold, what);
    Expect(!isCopied || cold.IsIdentical(scene), what + ": copied, but not the cold picture");
    ++routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
    if (views.Pick(8) == 0)
    {
      ExpectRefined(scene, views, cold, what);
    }
  }
  return routes;
}
