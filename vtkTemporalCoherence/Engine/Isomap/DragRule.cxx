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

/// A band with n isovalues is n - 0.99 steps wide: the hundredth keeps the last one inside if it is
/// rounded.
constexpr double AlmostOne = 0.99;

/// Half the width of a band around an isovalue that does not move, as a share of the range.
constexpr double HalfWidthAtRest = 1.0 / 1024.0;

/// The share of all groups that a frame builds. Fewer are built while the price is unknown or too
/// high.
constexpr double ShareToBuild = 1.0 / 12.0, ShareToTry = 1.0 / 48.0;

/// The share of a tracing that each later look-up in a band is taken to save. It saves half, but
/// not all bands are used to their end.
constexpr double GainOfLookUp = 0.25;

/// Building is tried again after a pause of so many frames.
constexpr int Pause = 8;

/// The largest share of the allowed memory for the bands in use; their successors need the rest.
constexpr double MostMemory = 0.75;

/// Update a mean, in which each new value counts half.
void Mix(double& mean, double now)
{
  mean = mean > 0.0 ? 0.5 * (mean + now) : now;
}

/// A band pays if building it reads at most the cells of so many tracings.
double MostPrice(double steps)
{
  return 1.0 + GainOfLookUp * (steps - 1.0);
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
  const double width = std::max(1.0, this->StepsIn(step) - AlmostOne) * moved;
  return step.Before > isovalue ? ValueBand{ std::max(isovalue - width, -most), isovalue }
                                : ValueBand{ isovalue, std::min(isovalue + width, most) };
}

double DragRule::StepsIn(const Step& step) const
{
  const double moved = std::abs(step.Isovalue - step.Before);
  return moved > 0.0 ? std::clamp(WidestBand * step.Range / moved + AlmostOne, 1.0, this->Steps)
                     : this->Steps;
}

std::size_t DragRule::GroupsToBuild(std::size_t groups, double steps) const
{
  if (this->FramesToWait > 0)
  {
    return 0;
  }
  const bool isWorthIt = this->Price > 0.0 && this->Price <= MostPrice(steps);
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
    this->FramesToWait = this->Price > MostPrice(frame.Steps) ? Pause : 0;
    const double fitting = MostMemory / std::max(frame.MemoryShare, 1e-9);
    this->Steps = std::clamp(this->Steps * fitting, LeastSteps, MostSteps);
  }
}

}
