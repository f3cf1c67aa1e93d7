// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include <algorithm>
#include <cmath>

namespace Fuzz
{
namespace Changes
{
namespace
{

void SurfaceMode(World& world)
{
  // The oracle does not know labels.
  const int mode = world.From.IsWild() ? world.From.WildInt() : world.From.Pick(2);
  world.Subject->SetSurfaceMode(mode == vtkTemporalCoherenceVolumeMapper::LABELS
      ? vtkTemporalCoherenceVolumeMapper::CROSSING
      : mode);
  Story::Tell("  surface mode ", world.Subject->GetSurfaceMode());
}

void Vectors(World& world)
{
  world.Subject->SetVectorMode(world.From.Pick(3) - 1);
  world.Subject->SetVectorComponent(
    world.From.IsWild() ? world.From.WildInt() : world.From.Pick(3));
  Story::Tell("  vector mode ", world.Subject->GetVectorMode(), ", component ",
    world.Subject->GetVectorComponent());
}

void Scalars(World& world)
{
  Bytes& from = world.From;
  const char* names[] = { "Scalars", "pressure", "", "vtkGhostType" };
  world.Subject->SetScalarMode(from.IsWild() ? from.WildInt() : from.Pick(5));
  if (from.OneIn(2))
  {
    world.Subject->SelectScalarArray(from.IsWild() ? from.WildInt() : from.Pick(2));
  }
  else if (from.IsWild() && from.OneIn(4))
  {
    world.Subject->SelectScalarArray(static_cast<const char*>(nullptr));
  }
  else
  {
    world.Subject->SelectScalarArray(from.OneOf(names));
  }
  Story::Tell("  scalar mode ", world.Subject->GetScalarMode(), ", array ",
    world.Subject->GetArrayId(), " ",
    world.Subject->GetArrayName() ? world.Subject->GetArrayName() : "(null)");
}

void DefaultScalars(World& world)
{
  world.Subject->SetScalarModeToDefault();
  world.Subject->SetVectorMode(Mapper::DISABLED);
  Story::Tell("  default scalars");
}

void BlendMode(World& world)
{
  Bytes& from = world.From;
  Mapper* mapper = world.Subject;
  const int modes[] = { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
    vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
    vtkVolumeMapper::ADDITIVE_BLEND };
  mapper->SetBlendMode(from.IsWild() ? from.Pick(7)
      : from.OneIn(2)                ? from.OneOf(modes)
                                     : vtkVolumeMapper::ISOSURFACE_BLEND);
  if (from.OneIn(4))
  {
    const double low = world.Low + from.Between(-0.1, 1.0) * (world.High - world.Low);
    const double high = low + from.Between(-0.1, 0.6) * (world.High - world.Low);
    mapper->SetAverageIPScalarRange(
      from.IsWild() ? from.Wild() : low, from.IsWild() ? from.Wild() : high);
  }
  const double* range = mapper->GetAverageIPScalarRange();
  Story::Tell("  blend mode ", mapper->GetBlendMode(), ", average of ", range[0], " to ", range[1]);
}

void ImageCache(World& world)
{
  Bytes& from = world.From;
  Mapper* mapper = world.Subject;
  switch (from.Pick(6))
  {
    case 0:
      mapper->SetReuseFrames(!from.OneIn(4));
      break;
    case 1:
      mapper->SetReuseAccuracy(from.IsWild() ? from.WildInt()
          : from.Pick(3) == 2                ? Mapper::PAPER
                                             : Mapper::EXACT);
      break;
    case 2:
      mapper->SetImageCachePolicy(from.Pick(2));
      mapper->SetKeyImageInterval(from.IsWild() ? from.WildInt() : 1 + from.Pick(6));
      break;
    case 3:
      mapper->SetNumberOfCachedImages(from.IsWild() ? from.WildInt() : 1 + from.Pick(5));
      break;
    case 4:
      mapper->SetImageCacheShading(from.Pick(2));
      break;
    default:
      mapper->SetRefineWhenStill(!from.OneIn(5));
      break;
  }
  Story::Tell("  image cache ", mapper->GetReuseFrames(), ", accuracy ", mapper->GetReuseAccuracy(),
    ", policy ", mapper->GetImageCachePolicy(), " ", mapper->GetKeyImageInterval(), ", images ",
    mapper->GetNumberOfCachedImages(), ", shading ", mapper->GetImageCacheShading(), ", refine ",
    mapper->GetRefineWhenStill());
}

double ATolerance(World& world)
{
  Bytes& from = world.From;
  const double usual[] = { 0.0, 0.0, 0.0, 0.1, 0.5, 2.0 };
  return from.IsWild() ? from.Wild() : from.OneOf(usual);
}

void Isomap(World& world)
{
  Bytes& from = world.From;
  Mapper* mapper = world.Subject;
  switch (from.Pick(5))
  {
    case 0:
      mapper->SetIsomap(!from.OneIn(3));
      break;
    case 1:
    {
      const double low = world.Low + from.Between(-0.2, 1.0) * (world.High - world.Low);
      const double high = low + from.Between(-0.1, 0.5) * (world.High - world.Low);
      const bool isWild = from.IsWild();
      mapper->SetIsomapRange(isWild ? from.Wild() : low, isWild ? from.Wild() : high);
      break;
    }
    case 2:
      mapper->SetIsomapMemoryLimit(from.IsWild() ? from.WildInt()
          : from.OneIn(3)                        ? from.Pick(3)
                                                 : 256);
      break;
    case 3:
      mapper->SetIsomapShading(from.OneIn(4));
      break;
    default:
    {
      const double tolerance = ATolerance(world);
      if (std::isfinite(tolerance)) // others are refused: see Acts
      {
        mapper->SetIsomapTolerance(tolerance);
      }
      break;
    }
  }
  Story::Tell("  isomap ", mapper->GetIsomap(), ", range ", mapper->GetIsomapRange()[0], " to ",
    mapper->GetIsomapRange()[1], ", limit ", mapper->GetIsomapMemoryLimit(), ", shading ",
    mapper->GetIsomapShading(), ", tolerance ", mapper->GetIsomapTolerance());
}

void Leaping(World& world)
{
  world.Subject->SetSpaceLeaping(world.From.Pick(2));
  Story::Tell("  leaping ", world.Subject->GetSpaceLeaping());
}

void ColorByAnswer(World& world)
{
  world.Subject->SetColorByAnswer(world.From.OneIn(3));
  Story::Tell("  colour by answer ", world.Subject->GetColorByAnswer());
}

void Coarseness(World& world)
{
  Bytes& from = world.From;
  const auto distance = [&]
  {
    const double number = from.Number(0.4, 4.0);
    return std::isnan(number) ? 1.0f : static_cast<float>(std::min(std::max(number, -1e30), 1e30));
  };
  world.Subject->SetImageSampleDistance(distance());
  world.Subject->SetMinimumImageSampleDistance(distance());
  world.Subject->SetMaximumImageSampleDistance(distance());
  world.Subject->SetAutoAdjustSampleDistances(!from.OneIn(4));
  Story::Tell("  a ray every ", world.Subject->GetImageSampleDistance(), " pixels");
}

void Defaults(World& world)
{
  Mapper* mapper = world.Subject;
  mapper->ReuseFramesOn();
  mapper->IsomapOn();
  mapper->SpaceLeapingOn();
  mapper->ColorByAnswerOff();
  mapper->SetReuseAccuracyToExact();
  mapper->RefineWhenStillOn();
  mapper->SetIsomapTolerance(0.0);
  mapper->SetIsomapRange(1.0, 0.0);
  mapper->SetIsomapMemoryLimit(256);
  mapper->SetIsomapShadingToReshade();
  Story::Tell("  default settings of re-use");
}

}

const std::vector<ChangeKind>& OfSettings()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "the surface mode", { 4, 2, 2, 2, 1, 2, 2 }, SurfaceMode },
    { "vectors", { 2, 1, 1, 1, 1, 5, 1 }, Vectors },
    { "the choice of scalars", { 1, 0, 0, 0, 0, 6, 0 }, Scalars },
    { "default scalars", { 2, 1, 1, 1, 1, 12, 1 }, DefaultScalars },
    { "the blend mode", { 3, 1, 1, 1, 6, 4, 1 }, BlendMode },
    { "the image cache", { 5, 2, 12, 2, 1, 3, 3 }, ImageCache },
    { "the isomap", { 5, 12, 1, 1, 1, 3, 8 }, Isomap },
    { "leaping", { 3, 3, 3, 2, 1, 1, 3 }, Leaping },
    { "colours by answer", { 1, 1, 3, 1, 1, 1, 1 }, ColorByAnswer },
    { "coarseness", { 1, 1, 1, 1, 1, 1, 1 }, Coarseness },
    { "default settings", { 3, 4, 4, 4, 2, 2, 4 }, Defaults },
  };
  return kinds;
}

}
}
