// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/RayBudget.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// The part of the allowed time that frames are planned for.
constexpr double Planned = 0.88;

/// The part of the remaining time that the grid may take: a closer grid is worth more than tiles.
/// Tiles get the rest.
constexpr double ShareOfGrid = 0.9;

/// A ray of a grid takes this many times as long as one in a whole tile, until it is measured:
/// fewer rays share what they read.
constexpr double ScatteredRay = 2.0;

/// With closer rays, tiles are a better use of the time.
constexpr double Closest = 3.0;

/// Until anything is known.
constexpr double First = 6.0;

/// The part of the planned time that does not depend on rays, until it is measured. A first frame
/// also makes room for its planes.
constexpr double FirstRest = 0.5;

/// The part of the allowed time that is always left for rays.
constexpr double LeastForRays = 0.2;

}

void RayBudget::Learn(const FrameStatistics& frame, bool wasWhole, double allowed, int kind)
{
  if (kind != this->Kind)
  {
    *this = RayBudget();
    this->Kind = kind;
  }
  const auto pixels = static_cast<double>(std::max<std::int64_t>(frame.Rays, 1));
  const bool hadGrid = frame.GridRays > 0;
  this->IsWholeKnown = wasWhole;
  if (wasWhole)
  {
    this->WholePerPixel = frame.TilesTime / pixels;
  }
  const double perRay = hadGrid ? frame.GridTime / static_cast<double>(frame.GridRays)
                                : ScatteredRay * frame.TilesTime / pixels;
  // Times rise at once, and fall slowly: a frame that is late is worse than a coarse one.
  const double half = 0.5 * (this->GridPerRay + perRay);
  this->GridPerRay = this->IsKnown && hadGrid ? std::max(perRay, half) : perRay;
  this->Rest =
    allowed < InteractiveTime ? frame.FrameTime - frame.GridTime - frame.TilesTime : this->Rest;
  this->Fill = hadGrid ? frame.FillTime : this->Fill;
  this->IsKnown = true;
}

RayBudget::Choice RayBudget::Choose(
  std::int64_t pixels, double allowed, double most, int kind) const
{
  if (!(allowed < InteractiveTime))
  {
    return {};
  }
  const double planned = Planned * std::max(allowed, 1e-9);
  const double until = planned - this->Fill;
  if (!this->IsKnown || kind != this->Kind)
  {
    return { std::max(std::min(First, most), 1.0), until };
  }
  const auto number = static_cast<double>(pixels);
  if (this->IsWholeKnown && this->WholePerPixel * number + std::max(this->Rest, 0.0) <= planned)
  {
    return { 1.0, until };
  }
  const double rest = this->Rest < 0.0 ? FirstRest * planned : this->Rest;
  const double left = std::max(planned - rest, LeastForRays * planned);
  const double needed = std::sqrt(this->GridPerRay * number / (ShareOfGrid * left));
  return { std::max(std::min(std::max(needed, Closest), most), 1.0), until };
}

}
