// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/ReusePlan.h"

namespace TemporalCoherence
{
namespace
{

/// Where more of the tiles can see samples that changed, the rest is not worth its copy. Not tuned:
/// copies cost little, but so does what they save.
constexpr double MostToTrace = 0.5;

/// True if parts of the last picture are parts of the next one, to the last bit. Colours of answers
/// are not: they would have to be those of a copy.
bool CanCopy(const FrameChange& change, const FrameKey& next, const HeldForReuse& held)
{
  return change.Samples && !change.View && !change.Surfaces && !change.Opacity &&
    !change.Appearance && !next.Appearance.ColorByAnswer && held.IsExact &&
    held.ShareToTrace <= MostToTrace;
}

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
    case Route::ThresholdHint:
      return "ThresholdHint";
    case Route::ImageCache:
      return "ImageCache";
    case Route::TimeStep:
      return "TimeStep";
  }
  return "";
}

Route PlanRoute(const FrameKey& last, const FrameKey& next, const ReuseSwitches& switches,
  const HeldForReuse& held)
{
  const FrameChange change = CompareFrames(last, next);
  const bool isSame = !change.Data && !change.View && !change.Surfaces && !change.Opacity;
  if (isSame && (held.IsExact || !switches.RefineWhenStill))
  {
    return change.Appearance ? Route::Reshade : Route::Redisplay;
  }
  // An isomap serves wherever the last frame was, but does not complete what is not exact itself.
  if (switches.Isomap && held.Isomap && !next.Isosurfaces.Isovalues.empty() &&
    (!isSame || held.IsIsomapExact))
  {
    return Route::IsomapLookup;
  }
  if (change.Data || isSame)
  {
    return switches.ImageCache && CanCopy(change, next, held) ? Route::TimeStep : Route::Cold;
  }
  if (change.View)
  {
    return switches.ImageCache && held.Image ? Route::ImageCache : Route::Cold;
  }
  const std::size_t isovalues = next.Isosurfaces.Isovalues.size();
  if (last.Isosurfaces.Mode != next.Isosurfaces.Mode || isovalues == 0 || change.Opacity)
  {
    return Route::Cold;
  }
  if (switches.Isomap && held.CanBuildIsomap)
  {
    return Route::IsomapBuild;
  }
  // A hint is one isovalue's hit for another.
  const bool isOneForOne = last.Isosurfaces.Isovalues.size() == 1 && isovalues == 1;
  const bool isHint = isOneForOne && (!change.Raised || AreHitsOrdered(next));
  return held.IsExact && isHint ? Route::ThresholdHint : Route::Cold;
}

}
