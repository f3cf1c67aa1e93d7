// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The pyramid holds the ranges of its blocks of cells, for every type and component of samples and
// every kind of vectors. NaN does not count.

#include "Acceleration/ValueRangePyramid.h"
#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "Grid.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using TemporalCoherence::ValueRangePyramid;

/// Every leaf and node of the pyramid against the samples of its cells, one by one.
template <typename T>
void ExpectRanges(Grid<T>& grid, const char* target)
{
  SCOPED_TRACE(target);
  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  const glm::ivec3 n = grid.Field.Dimensions;
  const glm::ivec3 nodes = pyramid.NodeDimensions();
  ASSERT_EQ(nodes, (n - 1 + 15) / 16);
  for (std::int64_t node = 0; node < pyramid.NumberOfNodes(); ++node)
  {
    const auto* leaves = pyramid.LeavesOf<T>(node);
    const glm::ivec3 first =
      16 * glm::ivec3(node % nodes.x, node / nodes.x % nodes.y, node / nodes.x / nodes.y);
    T lowest = std::numeric_limits<T>::max(), highest = std::numeric_limits<T>::lowest();
    for (int leaf = 0; leaf < 64; ++leaf)
    {
      const glm::ivec3 begin = first + 4 * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4);
      if (glm::any(glm::greaterThanEqual(begin, n - 1)))
      {
        EXPECT_GT(leaves[leaf].Min, leaves[leaf].Max) << "a leaf without cells";
        continue;
      }
      T min = std::numeric_limits<T>::max(), max = std::numeric_limits<T>::lowest();
      for (int k = begin.z; k <= std::min(begin.z + 4, n.z - 1); ++k)
      {
        for (int j = begin.y; j <= std::min(begin.y + 4, n.y - 1); ++j)
        {
          for (int i = begin.x; i <= std::min(begin.x + 4, n.x - 1); ++i)
          {
            min = std::min(min, grid.At(i, j, k));
            max = std::max(max, grid.At(i, j, k));
          }
        }
      }
      ASSERT_EQ(leaves[leaf].Min, min);
      ASSERT_EQ(leaves[leaf].Max, max);
      lowest = std::min(lowest, min);
      highest = std::max(highest, max);
    }
    ASSERT_EQ(pyramid.NodeAt<T>(node).Min, lowest);
    ASSERT_EQ(pyramid.NodeAt<T>(node).Max, highest);
  }
}

template <typename T>
class ValueRangePyramidOf : public EachTarget
{
protected:
  void ExpectRangesOnEachTarget(Grid<T>& grid)
  {
    this->ForEachTarget([&](const char* target) { ExpectRanges(grid, target); });
  }
};
using AllTypes = ::testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
  std::int32_t, std::uint32_t, std::int64_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(ValueRangePyramidOf, AllTypes);

TYPED_TEST(ValueRangePyramidOf, HoldsTheRangesOfItsCells)
{
  const double low = std::is_signed_v<TypeParam> ? -100.0 : 0.0;
  for (const glm::ivec3 dimensions :
    { glm::ivec3(2, 2, 2), glm::ivec3(5, 6, 17), glm::ivec3(67, 18, 33), glm::ivec3(4, 99, 6),
      glm::ivec3(2111, 3, 2), glm::ivec3(257, 66, 7) })
  {
    Grid<TypeParam> grid(dimensions);
    grid.FillRandomly(low, 100.0, 3);
    this->ExpectRangesOnEachTarget(grid);
  }
}

TYPED_TEST(ValueRangePyramidOf, SeesOneComponentOfSeveral)
{
  Grid<TypeParam> grid(glm::ivec3(20, 9, 7), 3, 1);
  grid.FillRandomly(0.0, 100.0, 4);
  this->ExpectRangesOnEachTarget(grid);
}

class NotANumber : public EachTarget
{
};

TEST_F(NotANumber, DoesNotCount)
{
  Grid<float> grid(glm::ivec3(99, 9, 9));
  grid.FillRandomly(1.0, 2.0, 5);
  grid.At(1, 2, 3) = std::numeric_limits<float>::quiet_NaN();
  grid.At(7, 7, 7) = std::numeric_limits<float>::infinity();
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      ValueRangePyramid pyramid;
      pyramid.Build(grid.Field);
      const auto* leaves = pyramid.LeavesOf<float>(0);
      EXPECT_GE(leaves[0].Min, 1.0f);
      EXPECT_LE(leaves[0].Max, 2.0f);
      EXPECT_EQ(leaves[1 + 4 + 16].Max, std::numeric_limits<float>::infinity());
      EXPECT_GE(pyramid.FiniteRange().x, 1.0);
      EXPECT_LE(pyramid.FiniteRange().y, 2.0);
      EXPECT_EQ(pyramid.WholeRange().x, pyramid.FiniteRange().x);
      EXPECT_EQ(pyramid.WholeRange().y, std::numeric_limits<double>::infinity());
      ASSERT_EQ(pyramid.LeavesWithNaN().size(), 7u);
      EXPECT_EQ(pyramid.LeavesWithNaN()[0], 1u);
      EXPECT_EQ(pyramid.LeavesWithNaN()[1], 0u);
      EXPECT_FALSE(pyramid.AreSamplesFinite());
    });
}

TEST_F(NotANumber, MayBeAllThereIs)
{
  Grid<double> grid(glm::ivec3(6, 20, 7));
  grid.Fill([](int, int, int) { return std::numeric_limits<double>::quiet_NaN(); });
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      ValueRangePyramid pyramid;
      pyramid.Build(grid.Field);
      EXPECT_GT(pyramid.WholeRange().x, pyramid.WholeRange().y);
      EXPECT_EQ(pyramid.FiniteRange(), glm::dvec2(0.0));
      EXPECT_GT(pyramid.NodeAt<double>(0).Min, pyramid.NodeAt<double>(0).Max);
      EXPECT_EQ(pyramid.LeavesWithNaN()[1] & 3u, 3u);
    });
}

TEST(ValueRangePyramid, IsNotThereWithoutMemory)
{
  if (IsMemorySanitized)
  {
    GTEST_SKIP() << "a build with a sanitizer, which throws no std::bad_alloc";
  }
  // 2^31 samples along two axes: petabytes of leaves, asked for before a sample is read.
  Grid<std::uint8_t> grid(glm::ivec3(2, 2, 2));
  grid.Field.Dimensions = glm::ivec3(2147483000, 2147483000, 2);
  ValueRangePyramid pyramid;
  EXPECT_ANY_THROW(pyramid.Build(grid.Field));
  EXPECT_TRUE(pyramid.IsEmpty());
  EXPECT_EQ(pyramid.NumberOfNodes(), 0);
}

}
