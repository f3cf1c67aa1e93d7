// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReusePlan_h
#define TemporalCoherence_ReusePlan_h

#include "Scene/FrameKey.h"

#include <cstdint>

namespace TemporalCoherence
{

/// How a whole frame is made. Routes that are no more leave gaps in the numbers.
enum class Route : std::uint8_t
{
  Cold,           ///< every ray is traced, without help from an earlier frame
  Redisplay,      ///< nothing changed: the same picture
  Reshade,        ///< only the appearance changed: known hits get new colours
  IsomapLookup,   ///< another isovalue in the same view, looked up in the isomap
  IsomapBuild,    ///< the same, where the isomap lacks tiles: they are built or traced
  ImageCache = 6, ///< another view: a cached image tells where walks may begin
  TimeStep,       ///< other samples in the same view: tiles that they do not affect are copied
  Recomposite,    ///< only opacities changed: known layers are composited again
  KeepValues = 10 ///< a projection's colours changed: what rays have met is known
};

/// The route's name as in the documentation, for example "Cold".
const char* NameOf(Route route);

/// What the user allows to be re-used.
struct ReuseSwitches
{
  bool ImageCache = true;
  bool Isomap = true;
  bool RefineWhenStill = true; ///< a repeated view ends in the cold picture
};

/// What is available for the next frame.
struct HeldForReuse
{
  bool IsExact = true;        ///< the last picture is the cold picture of its key
  bool Image = false;         ///< a cached image can serve, and is wanted
  bool Isomap = false;        ///< an isomap of this view covers the next isovalues
  bool IsIsomapExact = true;  ///< the isomap gives the cold picture
  bool CanBuildIsomap = true; ///< data and memory allow one
  double ShareToTrace = 1.0;  ///< share of the tiles, if only samples changed
  bool Values = false;        ///< what the rays of a projection have met
};

/// Choose the best route from the last frame to the next one. A pure function, so that every
/// decision can be tested without rendering.
Route PlanRoute(const FrameKey& last, const FrameKey& next, const ReuseSwitches& switches,
  const HeldForReuse& held);

}

#endif
