// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/GroupCosts.h"
#include "Isomap/TileGroups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

// What groups of tiles are taken to cost, and the order in which they are chosen.

namespace
{

using namespace TemporalCoherence;

/// Clocks are noisy. What tracing is taken to cost must not grow by that while all is looked up.
TEST(GroupCosts, NoiseDoesNotMakeTracingDearer)
{
  constexpr std::size_t groups = 2000;
  GroupCosts costs;
  costs.Resize(groups);
  std::mt19937 engine(7);
  std::uniform_int_distribution<std::int64_t> cost(100, 900);
  for (std::size_t group = 0; group < groups; ++group)
  {
    costs.SetTraced(group, 1000);
  }
  for (int frame = 0; frame < 20; ++frame)
  {
    const std::int64_t factor = frame < 10 ? 1 : 3; // more surface in every group
    for (std::size_t group = 0; group < groups; ++group)
    {
      costs.SetLookedUp(group, factor * cost(engine));
    }
    const std::vector<double> all = costs.All();
    const double sum = std::accumulate(all.begin(), all.end(), 0.0);
    EXPECT_NEAR(sum / groups, 1000.0 * static_cast<double>(factor), 60.0 * factor) << frame;
  }
}

/// What groups take that are traced after many look-ups tells of those that still are looked up.
TEST(GroupCosts, TracingNeedNotFollowLookUps)
{
  constexpr std::size_t groups = 2000;
  for (const double end : { 0.4, 1.0, 2.0 })
  {
    GroupCosts costs;
    costs.Resize(groups);
    for (std::size_t group = 0; group < groups; ++group)
    {
      costs.SetTraced(group, 1000);
    }
    costs.Learn();
    EXPECT_FALSE(costs.AreOld());
    constexpr int frames = 30;
    for (int frame = 0; frame < frames; ++frame)
    {
      const double along = static_cast<double>(frame) / (frames - 1);
      const double traced = 1000.0 * std::pow(end, along);
      const double lookedUp = 300.0 * std::pow(end, 0.4 * along);
      for (std::size_t group = 0; group < groups; ++group)
      {
        const bool isTraced = static_cast<int>(group % 60) == frame;
        isTraced ? costs.SetTraced(group, std::lround(traced))
                 : costs.SetLookedUp(group, std::lround(lookedUp));
      }
      costs.Learn();
      const std::vector<double> all = costs.All();
      const double sum = std::accumulate(all.begin(), all.end(), 0.0);
      EXPECT_NEAR(sum / (groups * traced), 1.0, 0.12) << "frame " << frame << " to " << end;
    }
    EXPECT_EQ(costs.AreOld(), end != 1.0);
  }
}

/// Every group comes once, whatever the size of the picture, and those of a square follow each
/// other.
TEST(TileGroups, AnOrderIsMadeOfSquaresSpreadOverThePicture)
{
  for (const glm::ivec2& size :
    { glm::ivec2(1024, 1024), glm::ivec2(93, 71), glm::ivec2(8, 8), glm::ivec2(1920, 1079) })
  {
    SCOPED_TRACE(testing::Message() << size.x << " x " << size.y);
    for (const std::int64_t rows : { 1, 8 })
    {
      std::vector<std::size_t> order = OrderOfGroups(size, rows);
      std::vector<std::size_t> sorted = order;
      std::sort(sorted.begin(), sorted.end());
      std::vector<std::size_t> all(NumberOfGroups(size));
      std::iota(all.begin(), all.end(), std::size_t(0));
      EXPECT_EQ(sorted, all);
    }
  }
  // Of 1024 pixels, 16 groups are a row of tiles.
  const std::vector<std::size_t> order = OrderOfGroups({ 1024, 1024 }, 8);
  int quadrants[4] = {};
  for (std::size_t i = 0; i < 512; ++i)
  {
    const std::size_t row = order[i] / 16, column = order[i] % 16;
    EXPECT_EQ(column, order[i - i % 8] % 16);
    EXPECT_EQ(row / 8, order[i - i % 8] / 16 / 8);
    ++quadrants[(row < 64 ? 0 : 2) + (column < 8 ? 0 : 1)];
  }
  for (const int count : quadrants)
  {
    EXPECT_GT(count, 64) << "of 512 groups, a quarter of the picture";
  }
}

}
