// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/Knots.h"

namespace TemporalCoherence
{
namespace
{

/// Largest error of a distance by the error of progress, in steps.
constexpr double LargestDoubt = 0.1 * KnotGrid::StepsOfTolerance;

/// A jump is misplaced by half a step of progress; the rest is for errors of progress.
constexpr double JumpError = 1.0;

/// The first knot with at least this progress.
std::size_t KnotOf(const FittedRay& ray, double progress)
{
  return static_cast<std::size_t>(
    std::lower_bound(ray.Progress + ray.Begin, ray.Progress + ray.End, progress,
      [](std::uint16_t knot, double value) { return knot < value; }) -
    ray.Progress);
}

/// \pre `knot` is not the ray's first knot
double ShareOf(const FittedRay& ray, double progress, std::size_t knot)
{
  const double from = ray.Progress[knot - 1];
  return (progress - from) / (ray.Progress[knot] - from);
}
double DistanceOf(const FittedRay& ray, double progress, std::size_t knot)
{
  const double from = ray.Distance[knot - 1];
  return from + ShareOf(ray, progress, knot) * (ray.Distance[knot] - from);
}

/// True if there is a jump among knots.
bool Jumps(const FittedRay& ray, std::size_t first, std::size_t end)
{
  const auto* const jump = std::adjacent_find(ray.Progress + first, ray.Progress + end);
  return jump != ray.Progress + end;
}

}

FitAnswer FindInFit(const FittedRay& ray, double progress, double error, FitPoint& point)
{
  const std::size_t first = KnotOf(ray, progress - JumpError);
  if (first == ray.End)
  {
    return FitAnswer::Missed;
  }
  const std::size_t knot = KnotOf(ray, progress);
  if (knot == ray.End)
  {
    return FitAnswer::UnsureMiss;
  }
  if (knot == ray.Begin)
  {
    point = { static_cast<double>(ray.Distance[knot]), knot, knot, 1.0f };
    return FitAnswer::UnsureHit;
  }
  point = { DistanceOf(ray, progress, knot), knot - 1, knot,
    static_cast<float>(ShareOf(ray, progress, knot)) };
  const std::size_t last = KnotOf(ray, progress + JumpError);
  if (first == ray.Begin || last == ray.End || Jumps(ray, first, last + 1))
  {
    return FitAnswer::UnsureHit;
  }
  const double lowest = progress - error, highest = progress + error;
  const double doubt =
    DistanceOf(ray, highest, KnotOf(ray, highest)) - DistanceOf(ray, lowest, KnotOf(ray, lowest));
  return doubt <= LargestDoubt ? FitAnswer::Reached : FitAnswer::UnsureHit;
}

}
