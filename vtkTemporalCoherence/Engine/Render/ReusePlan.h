// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReusePlan_h
#define TemporalCoherence_ReusePlan_h

#include "Scene/FrameKey.h"

#include <cstdint>

namespace TemporalCoherence
{

/// How a whole frame is made. Removed routes leave gaps in the numbers.
enum class Route : std::uint8_t
{
  Cold,            ///< every ray is traced, without help from an earlier frame
  Redisplay,       ///< nothing changed: the same picture
  Reshade,         ///< only the appearance changed: known hits get new colours
  IsomapLookup,    ///< another isovalue in the same view, looked up in the isomap
  IsomapBuild,     ///< the isomap lacks some tiles: they are built or traced
  ImageCache = 6,  ///< another view: a cached image tells where walks may begin
  TimeStep,        ///< other samples in the same view: tiles that they do not affect are copied
  Recomposite,     ///< only opacities changed: known layers are composited again
  KeepValues = 10, ///< only a projection's colours changed: known values get colours
  Antialias,       ///< nothing changed: pixels at edges get more rays, or lose them
  FewerRays,       ///< some rays are traced, and pixels between them are interpolated
  Refine,          ///< nothing changed: tiles between rays are traced
  KeepLabels       ///< other labels are drawn: rays keep what they met unless that changes
};

/// The route's name as in the documentation, for example "Cold".
const char* NameOf(Route route);

/// Kinds of re-use that the user allows.
struct ReuseSwitches
{
  bool Frames = true; ///< all earlier pictures
  bool Isomap = true;
  bool RefineWhenStill = true; ///< a repeated view ends in the cold picture
  bool FewerRays = false;      ///< a frame that would trace all rays traces fewer
};

/// The data available for the next frame.
struct HeldForReuse
{
  bool IsExact = true;        ///< the last picture is the cold picture of its key
  bool Image = false;         ///< a cached image can serve, and may be used
  bool Isomap = false;        ///< an isomap of this view covers the next isovalues
  bool IsIsomapExact = true;  ///< the isomap gives the cold picture
  bool CanBuildIsomap = true; ///< data and memory allow one
  double ShareToTrace = 1.0;  ///< share of the tiles that changed samples affect; 1 if unknown
  bool IsLightFinal = true;   ///< more rays would not change the light of the last picture
  bool IsSmooth = true; ///< the edges of the last picture have as many rays as they shall have
  bool IsBetweenRays = false; ///< some tiles of the last picture lie between rays
  bool Values = false;        ///< the last frame keeps the values that a projection's rays met
};

/// True if two keys give the same picture.
bool GiveSamePicture(const FrameKey& last, const FrameKey& next);

/// Choose the best route from the last frame to the next one. A pure function, so that every
/// decision can be tested without rendering.
Route PlanRoute(const FrameKey& last, const FrameKey& next, const ReuseSwitches& switches,
  const HeldForReuse& held);

}

#endif
