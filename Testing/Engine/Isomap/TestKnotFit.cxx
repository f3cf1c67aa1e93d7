// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A fit of knots is nowhere farther from the function than the tolerance and keeps its jumps. Any
// tolerance takes a bounded number of knots.

#include "Isomap/KnotFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// A continuous function of cubics, one for each unit of distance.
struct Way
{
  explicit Way(unsigned int seed, int cells)
  {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> value(-1.0, 2.0);
    double at = -0.5;
    for (int cell = 0; cell < cells; ++cell)
    {
      const double next = value(engine);
      this->Cells.push_back({ at, value(engine), value(engine), next });
      at = next;
    }
  }

  double At(double distance) const
  {
    const auto cell = std::min(static_cast<std::size_t>(distance), this->Cells.size() - 1);
    return Evaluate(this->Cells[cell], distance - static_cast<double>(cell));
  }

  std::vector<Cubic<double>> Cells;
};

constexpr double FinestStep = 1.0 / 20000.0; // of progress: ways have less than 3

constexpr double Nowhere = 1e9;

/// A knot of a fit, not in steps.
struct Place
{
  double Progress, Distance;
};

/// The part of a way above -0.1.
std::vector<Place> FitOf(const Way& way, double tolerance, double step = FinestStep)
{
  constexpr double lowest = -0.1;
  const double stepOfDistance = tolerance / KnotGrid::StepsOfTolerance;
  std::vector<Place> knots;
  const auto emit = [&](const Knot& knot, const KnotPlaces& /*places*/) {
    knots.push_back({ lowest + step * knot.Progress, stepOfDistance * knot.Distance });
  };
  KnotFit fit;
  for (std::size_t cell = 0; cell < way.Cells.size(); ++cell)
  {
    Cubic<double> steps = way.Cells[cell];
    for (double& coefficient : steps)
    {
      coefficient = (coefficient - lowest) / step;
    }
    const double enter = static_cast<double>(cell) / stepOfDistance;
    fit.Follow(steps, enter, enter + 1.0 / stepOfDistance, 65535.0, emit);
  }
  fit.Finish(emit);
  return knots;
}

/// Distance at which knots tell that a progress is first reached; far away if it is not.
double LookUp(const std::vector<Place>& knots, double progress)
{
  for (std::size_t i = 1; i < knots.size(); ++i)
  {
    if (knots[i].Progress >= progress && knots[i].Progress > knots[i - 1].Progress)
    {
      const double share =
        (progress - knots[i - 1].Progress) / (knots[i].Progress - knots[i - 1].Progress);
      return knots[i - 1].Distance + share * (knots[i].Distance - knots[i - 1].Distance);
    }
  }
  return Nowhere;
}

TEST(KnotFit, IsNowhereFartherThanTheTolerance)
{
  constexpr double step = 1e-3;
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Way way(seed, 12);
    for (const double tolerance : { 0.02, 0.1, 0.5, 2.0 })
    {
      const std::vector<Place> knots = FitOf(way, tolerance);
      double reached = std::max(way.At(0.0), 0.0);
      int checked = 0, all = 0;
      for (double distance = 0.0; distance <= 12.0; distance += step)
      {
        // The first point with a new highest value is where that value is first reached.
        const double value = way.At(distance);
        if (value > reached + FinestStep)
        {
          const double told = LookUp(knots, value);
          // Beside a jump, and at the end, one step of the search or of progress makes the
          // difference.
          const bool isBesideJump = way.At(std::max(distance - step, 0.0)) < reached ||
            std::abs(LookUp(knots, value + FinestStep) - LookUp(knots, value - FinestStep)) >
              tolerance;
          if (!isBesideJump)
          {
            ++checked;
            ASSERT_NEAR(told, distance, tolerance + step) << "seed " << seed << " value " << value;
          }
          ++all;
          reached = value;
        }
      }
      EXPECT_EQ(LookUp(knots, reached + 0.01), Nowhere) << "nothing is higher";
      EXPECT_GE(checked, all / 2);
    }
  }
}

TEST(KnotFit, AJumpIsTwoKnotsOfOneProgress)
{
  // Up to 1, down to 0, up to 2.
  Way way(0, 0);
  way.Cells = { { 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 }, { 1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0 },
    { 0.0, 2.0 / 3.0, 4.0 / 3.0, 2.0 } };
  constexpr double tolerance = 1e-3;
  const std::vector<Place> knots = FitOf(way, tolerance);
  ASSERT_EQ(knots.size(), 4u);
  EXPECT_NEAR(knots[1].Progress, 1.0, FinestStep);
  EXPECT_NEAR(knots[1].Distance, 1.0, tolerance);
  EXPECT_EQ(knots[2].Progress, knots[1].Progress);
  EXPECT_NEAR(knots[2].Distance, 2.5, tolerance);
  EXPECT_NEAR(LookUp(knots, 0.5), 0.5, tolerance);
  EXPECT_NEAR(LookUp(knots, 1.5), 2.75, tolerance);
}

TEST(KnotFit, ALargerToleranceTakesFewerKnots)
{
  std::size_t fine = 0, coarse = 0;
  for (unsigned int seed = 0; seed < 50; ++seed)
  {
    const Way way(seed, 30);
    fine += FitOf(way, 0.01).size();
    coarse += FitOf(way, 1.0).size();
  }
  EXPECT_LT(coarse, fine / 2);
}

/// Tolerances far below what can be told apart: a step of progress has two knots at most.
TEST(KnotFit, AnyToleranceTakesABoundedNumberOfKnots)
{
  constexpr double step = 1e-3;
  const Way way(1, 4);
  for (const double tolerance : { 1e-4, 1e-6, 1e-8 })
  {
    EXPECT_LT(FitOf(way, tolerance, step).size(), 2.0 * 3.0 / step) << tolerance;
  }
}

/// Most knots of neighbouring rays have the same progress, as fits prefer round numbers.
TEST(KnotFit, PrefersRoundProgress)
{
  std::size_t round = 0, all = 0;
  for (unsigned int seed = 0; seed < 50; ++seed)
  {
    for (const Place& knot : FitOf(Way(seed, 30), 0.02))
    {
      const auto steps = static_cast<unsigned int>(std::lround((knot.Progress + 0.1) / FinestStep));
      round += steps % 64 == 0;
      ++all;
    }
  }
  EXPECT_GT(round, all / 4);
}

/// What lies above the largest progress is not fitted.
TEST(KnotFit, EndsAtTheLargestProgress)
{
  Way way(0, 0);
  way.Cells = { { -0.1, 2.0, 4.0, 8.0 }, { 8.0, 2.0, 1.0, 9.0 } };
  const std::vector<Place> knots = FitOf(way, 0.01);
  EXPECT_NEAR(knots.back().Progress, -0.1 + 65535.0 * FinestStep, FinestStep);
  EXPECT_LT(knots.back().Distance, 1.0);
}

TEST(KnotFit, APlateauIsNotCutIntoPieces)
{
  // It rises by what rounding adds.
  Way way(0, 0);
  way.Cells = { { 0.5, 0.5, 0.5, std::nextafter(0.5, 1.0) } };
  EXPECT_LE(FitOf(way, 1e-3).size(), 3u);
}

}
