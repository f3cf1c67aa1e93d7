// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Groups of tiles are chosen to be built in squares of neighbours that are spread over the picture.

#include "Isomap/TileGroups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Every group comes once, whatever the size of the picture, and those of a square follow each
/// other.
TEST(TileGroups, AnOrderIsMadeOfSquaresSpreadOverThePicture)
{
  for (const glm::ivec2& size :
    { glm::ivec2(1024, 1024), glm::ivec2(93, 71), glm::ivec2(8, 8), glm::ivec2(1920, 1079) })
  {
    SCOPED_TRACE(testing::Message() << size.x << " x " << size.y);
    std::vector<std::size_t> sorted = OrderOfGroups(size);
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::size_t> all(NumberOfGroups(size));
    std::iota(all.begin(), all.end(), std::size_t(0));
    EXPECT_EQ(sorted, all);
  }
  // Of 1024 pixels, 16 groups are a row of tiles.
  const std::vector<std::size_t> order = OrderOfGroups({ 1024, 1024 });
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
