// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Knots.h"

#include <limits>

namespace TemporalCoherence
{

double ErrorIn(const ValueBand& band, const glm::dvec2& finiteRange)
{
  constexpr double rounding = 32.0 * std::numeric_limits<float>::epsilon();
  const double largest =
    std::max(std::abs(finiteRange.x - band.Low), std::abs(finiteRange.y - band.Low));
  return rounding * (largest + (band.High - band.Low));
}

FitAnswer FindInFit(const FittedKnots& table, std::size_t ray, double progress, double error,
  double tolerance, FitPoint& point)
{
  const std::size_t begin = table.Begin(ray), end = table.Begin(ray + 1);
  const float* const values = table.Get<0>();
  const float* const distances = table.Get<1>();
  const auto at = [values](std::size_t knot) { return static_cast<double>(values[knot]); };
  const auto isJump = [&](std::size_t knot)
  { return knot == begin || knot == end || values[knot - 1] == values[knot]; };

  const auto found = std::lower_bound(values + begin, values + end, static_cast<float>(progress));
  const auto knot = static_cast<std::size_t>(found - values);
  if (knot == end)
  {
    return progress - at(end - 1) <= error ? FitAnswer::Unsure : FitAnswer::Missed;
  }
  // A jump is sure only where rounding cannot have moved the progress across it.
  const bool isCloseBehind = isJump(knot + 1) && at(knot) - progress <= error;
  const bool isCloseBefore = knot > begin && isJump(knot - 1) && progress - at(knot - 1) <= error;
  if (isCloseBehind || isCloseBefore)
  {
    return FitAnswer::Unsure;
  }
  if (knot == begin)
  {
    return FitAnswer::Unsure;
  }
  constexpr double rounding = 0.05; // share of the tolerance that may go into it
  const double way =
    static_cast<double>(distances[knot]) - static_cast<double>(distances[knot - 1]);
  const double gained = at(knot) - at(knot - 1);
  if (!(way * error <= rounding * tolerance * gained))
  {
    return FitAnswer::Unsure;
  }
  const double share = std::min(std::max((progress - at(knot - 1)) / gained, 0.0), 1.0);
  point.Distance = static_cast<double>(distances[knot - 1]) + share * way;
  point.Before = knot - 1;
  point.Knot = knot;
  point.Share = static_cast<float>(share);
  return FitAnswer::Reached;
}

}
