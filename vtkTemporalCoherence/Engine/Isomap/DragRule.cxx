// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/DragRule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// A drag moves the isovalue by at most this share of the range in a frame.
constexpr double LargestStep = 1.0 / 20.0;

/// Isovalues in a band: usually, and where memory is short.
constexpr double MostSteps = 12.0, LeastSteps = 2.0;
constexpr double WidestBand = 1.0 / 16.0; ///< as a share of the range

/// Half the width of a band around an isovalue that does not move, as a share of the range.
constexpr double HalfWidthAtRest = 1.0 / 1024.0;

/// The share of all groups that a frame builds. Fewer are built while the price is unknown or too
/// high.
constexpr double ShareToBuild = 1.0 / 12.0, ShareToTry = 1.0 / 48.0;

/// Bands that read more cells than so many tracings do not pay. Building is tried again after a
/// pause of so many frames.
constexpr double MostPrice = 4.0;
constexpr int Pause = 8;

/// The largest share of the allowed memory for the bands in use; their successors need the rest.
constexpr double MostMemory = 0.75;

/// Update a mean, in which each new value counts half.
void Mix(double& mean, double now)
{
  mean = mean > 0.0 ? 0.5 * (mean + now) : now;
}

}

bool DragRule::IsJump(const Step& step)
{
  return std::abs(step.Isovalue - step.Before) > LargestStep * step.Range;
}

DragRule::DragRule()
  : Steps(MostSteps)
{
}

ValueBand DragRule::BandFor(const Step& step) const
{
  // A width may overflow.
  constexpr double most = std::numeric_limits<double>::max();
  const double isovalue = step.Isovalue, moved = std::abs(isovalue - step.Before);
  if (moved == 0.0)
  {
    const double half = HalfWidthAtRest * step.Range;
    return { std::max(isovalue - half, -most), std::min(isovalue + half, most) };
  }
  // The band ends a hundredth of a step late, so that rounding does not exclude the last isovalue.
  const double width =
    std::max(moved, std::min((this->Steps - 0.99) * moved, WidestBand * step.Range));
  return step.Before > isovalue ? ValueBand{ std::max(isovalue - width, -most), isovalue }
                                : ValueBand{ isovalue, std::min(isovalue + width, most) };
}

std::size_t DragRule::GroupsToBuild(std::size_t groups) const
{
  if (this->FramesToWait > 0)
  {
    return 0;
  }
  const bool isWorthIt = this->Price > 0.0 && this->Price <= MostPrice;
  const double share = isWorthIt ? ShareToBuild : ShareToTry;
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(groups)));
}

void DragRule::Learn(const Outcome& frame)
{
  if (frame.GroupsTraced > 0)
  {
    Mix(this->CellsOfTracing, 1.0 + frame.CellsTraced / static_cast<double>(frame.GroupsTraced));
  }
  this->FramesToWait = std::max(this->FramesToWait - 1, 0);
  if (frame.GroupsBuilt > 0 && this->CellsOfTracing > 0.0)
  {
    const double cells = frame.CellsBuilt / static_cast<double>(frame.GroupsBuilt);
    Mix(this->Price, std::max(cells, 1.0) / this->CellsOfTracing);
    this->FramesToWait = this->Price > MostPrice ? Pause : 0;
    const double fitting = MostMemory / std::max(frame.MemoryShare, 1e-9);
    this->Steps = std::clamp(this->Steps * std::min(fitting, 1.25), LeastSteps, MostSteps);
  }
}

}
