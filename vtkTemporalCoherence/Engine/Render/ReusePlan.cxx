// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/ReusePlan.h"

#include "Volumes/Projections/MetValues.h"

namespace TemporalCoherence
{
namespace
{

/// If changed samples affect a larger share of the tiles, copying the rest does not pay. Not tuned:
/// copies cost little and save little.
constexpr double MostToTrace = 0.5;

/// True if parts of the last picture can be copied exactly. With ColorByAnswer they cannot: a
/// copied pixel would need the colour of its new answer. With ambient occlusion they cannot,
/// either: changed surfaces darken others.
bool CanCopy(const FrameChange& change, const FrameKey& next, const HeldForReuse& held)
{
  return change.Samples && !change.View && !change.Surfaces && !change.Opacity &&
    !change.Appearance && !next.Appearance.ColorByAnswer && !next.Appearance.HasMutualLight() &&
    held.IsExact && held.ShareToTrace <= MostToTrace;
}

/// True if the last picture knows the first layers of the next one, and where the search for others
/// begins.
bool KnowsLayers(const FrameChange& change, const FrameKey& next, const HeldForReuse& held)
{
  return change.Opacity && !change.Data && !change.View && held.IsExact &&
    !next.Isosurfaces().Isovalues.empty();
}

/// True if rays may keep the labels that they met, as other labels are drawn. Behind translucent
/// ones they would meet more.
bool KeepsLabels(
  const FrameChange& change, const FrameKey& last, const FrameKey& next, const HeldForReuse& held)
{
  const bool areSamplesKnown = !change.Data || (change.Samples && held.ShareToTrace <= MostToTrace);
  return change.Surfaces && areSamplesKnown && !change.View && held.IsExact &&
    next.Samples.Labels && last.Isosurfaces().Mode == next.Isosurfaces().Mode &&
    !last.Isosurfaces().IsTranslucent() && !next.Isosurfaces().IsTranslucent() &&
    !next.Isosurfaces().Isovalues.empty();
}

/// The route from one blended volume to another.
Route PlanVolume(const FrameChange& change, const FrameKey& last, const FrameKey& next,
  const ReuseSwitches& switches, const HeldForReuse& held)
{
  const bool isOther = change.Data || change.View || change.Surfaces || change.Opacity;
  if (!isOther && !change.Appearance && !change.Blending)
  {
    return held.IsSmooth ? Route::Redisplay : Route::Antialias;
  }
  const bool isKnown =
    switches.Frames && held.Values && MeetSameValues(last.Blended(), next.Blended());
  return !isOther && isKnown ? Route::KeepValues : Route::Cold;
}

/// The route if every pixel gets a ray.
Route PlanWhole(const FrameKey& last, const FrameKey& next, const ReuseSwitches& switches,
  const HeldForReuse& held)
{
  const FrameChange change = CompareFrames(last, next);
  if (last.IsBlended() != next.IsBlended())
  {
    return switches.FewerRays ? Route::FewerRays : Route::Cold;
  }
  if (next.IsBlended())
  {
    return PlanVolume(change, last, next, switches, held);
  }
  const bool isSame = !change.Data && !change.View && !change.Surfaces && !change.Opacity;
  const bool refines = switches.RefineWhenStill || held.IsBetweenRays;
  if (isSame && (held.IsExact || !refines))
  {
    const Route asItIs = held.IsSmooth ? Route::Redisplay : Route::Antialias;
    return change.Appearance || !held.IsLightFinal ? Route::Reshade : asItIs;
  }
  if (switches.Frames && KnowsLayers(change, next, held))
  {
    return Route::Recomposite;
  }
  if (switches.Frames && KeepsLabels(change, last, next, held))
  {
    return Route::KeepLabels;
  }
  // An isomap serves whatever the last frame was. But with a tolerance it cannot refine a picture
  // that is not exact.
  if (switches.Isomap && held.Isomap && !next.Isosurfaces().Isovalues.empty() &&
    (!isSame || held.IsIsomapExact))
  {
    return Route::IsomapLookup;
  }
  if (change.Data || isSame)
  {
    return switches.Frames && CanCopy(change, next, held) ? Route::TimeStep : Route::Cold;
  }
  if (change.View)
  {
    return switches.Frames && held.Image ? Route::ImageCache : Route::Cold;
  }
  const std::size_t isovalues = next.Isosurfaces().Isovalues.size();
  if (last.Isosurfaces().Mode != next.Isosurfaces().Mode || isovalues == 0 || change.Opacity)
  {
    return Route::Cold;
  }
  return switches.Isomap && held.CanBuildIsomap ? Route::IsomapBuild : Route::Cold;
}

/// True if a route can take about as long as tracing every ray. Of translucent surfaces, an isomap
/// tells only the first on each ray.
bool TracesAll(Route route, const FrameKey& next)
{
  const bool looksUp = route == Route::IsomapLookup || route == Route::IsomapBuild;
  return route == Route::Cold || route == Route::KeepLabels ||
    (looksUp && next.Isosurfaces().IsTranslucent());
}

}

bool GiveSamePicture(const FrameKey& last, const FrameKey& next)
{
  const FrameChange change = CompareFrames(last, next);
  return last.IsBlended() == next.IsBlended() && !change.Data && !change.View && !change.Surfaces &&
    !change.Opacity && !change.Appearance && !change.Blending;
}

const char* NameOf(Route route)
{
  switch (route)
  {
    case Route::Cold:
      return "Cold";
    case Route::Redisplay:
      return "Redisplay";
    case Route::Reshade:
      return "Reshade";
    case Route::IsomapLookup:
      return "IsomapLookup";
    case Route::IsomapBuild:
      return "IsomapBuild";
    case Route::ImageCache:
      return "ImageCache";
    case Route::TimeStep:
      return "TimeStep";
    case Route::Recomposite:
      return "Recomposite";
    case Route::KeepValues:
      return "KeepValues";
    case Route::Antialias:
      return "Antialias";
    case Route::FewerRays:
      return "FewerRays";
    case Route::Refine:
      return "Refine";
    case Route::KeepLabels:
      return "KeepLabels";
  }
  return "";
}

Route PlanRoute(const FrameKey& last, const FrameKey& next, const ReuseSwitches& switches,
  const HeldForReuse& held)
{
  if (held.IsBetweenRays && GiveSamePicture(last, next))
  {
    return Route::Refine;
  }
  const Route route = PlanWhole(last, next, switches, held);
  return switches.FewerRays && TracesAll(route, next) ? Route::FewerRays : route;
}

}
