// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/Knots.h"

namespace TemporalCoherence
{
namespace
{

/// Share of the tolerance for the error of stored progress.
constexpr double LargestDoubt = 0.1;

/// The fitted function of one ray.
struct FittedRay
{
  /// The first knot with at least this progress.
  std::size_t KnotOf(double progress) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->Progress + this->Begin, this->Progress + this->End, progress,
        [](float knot, double value) { return static_cast<double>(knot) < value; }) -
      this->Progress);
  }

  /// \pre `knot` is not the ray's first knot
  double ShareOf(double progress, std::size_t knot) const
  {
    const auto from = static_cast<double>(this->Progress[knot - 1]);
    return (progress - from) / (static_cast<double>(this->Progress[knot]) - from);
  }
  double DistanceOf(double progress, std::size_t knot) const
  {
    const auto from = static_cast<double>(this->Distance[knot - 1]);
    return from +
      this->ShareOf(progress, knot) * (static_cast<double>(this->Distance[knot]) - from);
  }

  const float *Progress, *Distance;
  std::size_t Begin, End;
};

}

FitAnswer FindInFit(
  const FittedKnots& table, std::size_t ray, double progress, double tolerance, FitPoint& point)
{
  const FittedRay fit{ table.Get<0>(), table.Get<1>(), table.Begin(ray), table.Begin(ray + 1) };
  const double lowest = progress - BandScale::StoredError;
  const double highest = progress + BandScale::StoredError;
  const std::size_t first = fit.KnotOf(lowest), last = fit.KnotOf(highest);
  if (first == fit.End)
  {
    return FitAnswer::Missed;
  }
  // Jumps, plateaus and the end of the ray within the error show at the ends of the error interval.
  if (first == fit.Begin || last == fit.End ||
    !(fit.DistanceOf(highest, last) - fit.DistanceOf(lowest, first) <= LargestDoubt * tolerance))
  {
    return FitAnswer::Unsure;
  }
  point.Knot = fit.KnotOf(progress);
  point.Before = point.Knot - 1;
  point.Share = static_cast<float>(fit.ShareOf(progress, point.Knot));
  point.Distance = fit.DistanceOf(progress, point.Knot);
  return FitAnswer::Reached;
}

}
