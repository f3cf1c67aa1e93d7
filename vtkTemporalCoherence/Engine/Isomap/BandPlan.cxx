// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/BandPlan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

// All of these were chosen by the mean and the worst frames of drags, `Benchmark --scenarios
// drags`. Documentation/Tried.md, "Building the isomap", tells what else was tried.

/// A change by more than this share of the range is not a step of a drag.
constexpr double LargestStep = 1.0 / 20.0;

/// Steps that a band may reach ahead, its first isovalue among them.
constexpr std::array<double, 9> AllSteps = { 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 18.0, 27.0, 40.0 };
constexpr double FixedSteps = 12.0;
constexpr double WidestFixed = 1.0 / 16.0; ///< of the range

/// How many more steps a drag goes on, on average.
constexpr double StepsToCome = 40.0;

/// Half the width of a band around an isovalue that does not move, as a share of the range.
constexpr double HalfWidthAtRest = 1.0 / 1024.0;

/// A band must save at least this share of the tracing: less does not pay in a drag of 40 steps for
/// its first ten frames, which cost a fifth more.
constexpr double LeastGain = 0.2;

/// Old measurements count half after so much of the picture was built, and after so much was looked
/// up.
constexpr double HalfLifeBuilt = 0.05, HalfLifeLookedUp = 0.1;

/// What building is taken to cost as long as nothing was measured: at width 0 and at a wider one.
constexpr double GuessAtOnce = 1.4, GuessWide = 2.2, WideGuess = 1.0 / 32.0, WeightOfGuess = 0.01;

/// A measurement counts at least as much as one of this share of the picture. So a few groups,
/// which are all that a frame builds where building is expensive, show soon that it is, or no
/// longer is.
constexpr double LeastWeight = 0.02;

/// The bands in use may take this share of the memory: the rest is for those that follow them.
constexpr double MostMemory = 0.75;

/// What costs less than this share of tracing the picture is empty, and shows nothing.
constexpr double LeastShare = 2e-4;

/// Steps that a band of `steps` serves before the drag ends or turns.
double Served(double steps)
{
  return StepsToCome * (1.0 - std::exp(-steps / StepsToCome));
}

double StepOf(const BandPlan::Wish& wish)
{
  return std::abs(wish.Isovalue - wish.Before);
}

ValueBand BandAhead(const BandPlan::Wish& wish, double width)
{
  // A width may have overflowed.
  constexpr double most = std::numeric_limits<double>::max();
  const double c = wish.Isovalue;
  if (wish.Before == c)
  {
    const double half = HalfWidthAtRest * wish.Range;
    return { std::max(c - half, -most), std::min(c + half, most) };
  }
  return wish.Before > c ? ValueBand{ std::max(c - width, -most), c }
                         : ValueBand{ c, std::min(c + width, most) };
}

}

void BandPlan::Sums::Add(double weight, double width, double cost)
{
  this->Weight += weight;
  this->Width += weight * width;
  this->WidthSquared += weight * width * width;
  this->Cost += weight * cost;
  this->CostWidth += weight * cost * width;
}

void BandPlan::Sums::Fade(double by)
{
  for (double* const sum :
    { &this->Weight, &this->Width, &this->WidthSquared, &this->Cost, &this->CostWidth })
  {
    *sum *= by;
  }
}

bool BandPlan::IsJump(const Wish& wish)
{
  return StepOf(wish) > LargestStep * wish.Range;
}

/// Cost of a band by its width as a share of the range: the line that fits best.
double BandPlan::CostOf(double width) const
{
  Sums sums = this->Known;
  // Of what is measured at one width only, the guess tells the slope.
  sums.Add(WeightOfGuess, 0.0, GuessAtOnce);
  sums.Add(WeightOfGuess, WideGuess, GuessWide);
  const double mean = sums.Width / sums.Weight, meanCost = sums.Cost / sums.Weight;
  const double variance = sums.WidthSquared / sums.Weight - mean * mean;
  const double covariance = sums.CostWidth / sums.Weight - mean * meanCost;
  const double slope = variance > 0.0 ? std::max(covariance / variance, 0.0) : 0.0;
  return std::max(meanCost + slope * (width - mean), 0.5 * meanCost);
}

double BandPlan::StepsFor(const Wish& wish) const
{
  const double step = StepOf(wish) / wish.Range;
  const auto costOfStep = [&](double steps)
  { return (this->CostOf((steps - 1.0) * step) - this->LookUp) / Served(steps); };
  const double best = *std::min_element(AllSteps.begin(), AllSteps.end(),
    [&](double a, double b) { return costOfStep(a) < costOfStep(b); });
  const double fitting = this->MemoryByWidth > 0.0 && step > 0.0
    ? 1.0 + MostMemory / (this->MemoryByWidth * step)
    : AllSteps.back();
  return std::max(std::min(best, fitting) * this->MemoryShare, AllSteps.front());
}

ValueBand BandPlan::Choose(const Wish& wish) const
{
  const bool hasRange = wish.Range > 0.0 && std::isfinite(wish.Range);
  // A little more, so that rounding does not leave the last step out.
  return BandAhead(wish, hasRange ? (this->StepsFor(wish) - 0.99) * StepOf(wish) : 0.0);
}

ValueBand BandPlan::ChooseFixed(const Wish& wish)
{
  const double step = StepOf(wish);
  return BandAhead(wish, std::max(step, std::min(FixedSteps * step, WidestFixed * wish.Range)));
}

double BandPlan::BuildCost(const Wish& wish) const
{
  const ValueBand band = this->Choose(wish);
  return wish.Range > 0.0 ? this->CostOf((band.High - band.Low) / wish.Range) : this->CostOf(0.0);
}

bool BandPlan::IsWorthIt(const Wish& wish) const
{
  const bool isMeasured = this->Known.Weight > 0.0;
  if (!isMeasured || wish.Before == wish.Isovalue || !(wish.Range > 0.0))
  {
    return true; // not moving, it stands beside another one that moves
  }
  const double steps = this->StepsFor(wish);
  const double each = (this->BuildCost(wish) - this->LookUp) / Served(steps) + this->LookUp;
  return each < 1.0 - LeastGain;
}

void BandPlan::Learn(const Measured& measured)
{
  if (measured.TracingBuilt > LeastShare * measured.TracingAll)
  {
    const double share = std::clamp(measured.TracingBuilt / measured.TracingAll, LeastWeight, 1.0);
    this->Known.Fade(std::exp2(-share / HalfLifeBuilt));
    this->Known.Add(
      share, measured.Width, std::min(measured.Built / measured.TracingBuilt, 1000.0));
  }
  if (measured.Memory > 0.0 && measured.Width > 0.0)
  {
    const double byWidth = measured.Memory / measured.Width;
    double& known = this->MemoryByWidth;
    known = known > 0.0 ? 0.5 * (known + byWidth) : byWidth;
  }
  if (measured.TracingFound > 0.0)
  {
    const double share = std::min(measured.TracingFound / measured.TracingAll, 1.0);
    const double cost = std::min(measured.LookedUp / measured.TracingFound, 10.0);
    this->LookUp += (1.0 - std::exp2(-share / HalfLifeLookedUp)) * (cost - this->LookUp);
  }
  this->MemoryShare = std::min(this->MemoryShare * (measured.IsMemoryFull ? 0.7 : 1.02), 1.0);
}

}
