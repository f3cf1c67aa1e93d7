// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// All labels of a field are found, and active are the cells in which a ray can come to a label that
// is drawn.

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Grid.h"
#include "Scene/LabelSets.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Blocks of equal labels, with some noise.
template <typename T>
void FillWithBlocks(Grid<T>& grid, int labels, double step)
{
  std::mt19937 engine(4);
  std::vector<int> ofBlocks(1000);
  for (int& label : ofBlocks)
  {
    label = static_cast<int>(engine() % static_cast<unsigned int>(labels));
  }
  grid.Fill(
    [&](int i, int j, int k)
    {
      const bool isNoise = engine() % 200 == 0;
      const auto block = static_cast<std::size_t>(i / 7 + 10 * (j / 9) + 100 * (k / 8));
      return step *
        (isNoise ? static_cast<int>(engine() % static_cast<unsigned int>(labels))
                 : ofBlocks[block % ofBlocks.size()]);
    });
}

template <typename T>
void ExpectSets(const glm::ivec3& dimensions, int labels, double step)
{
  Grid<T> grid(dimensions);
  FillWithBlocks(grid, labels, step);
  grid.Field.Labels = LabelSets::Make(grid.Field);
  const std::set<std::int64_t> all(grid.Samples.begin(), grid.Samples.end());
  EXPECT_EQ(grid.Field.Labels->Labels(), std::vector<std::int64_t>(all.begin(), all.end()));

  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  Surfaces surfaces;
  surfaces.Mode = SurfaceMode::Threshold;
  std::set<std::int64_t> drawn;
  for (const std::int64_t label : all)
  {
    if (drawn.size() < all.size() / 3 + 1)
    {
      drawn.insert(label);
      surfaces.Isovalues.push_back(static_cast<double>(label));
    }
  }
  ActiveCells active;
  active.Build(grid.Field, pyramid, surfaces);
  int count = 0, superfluous = 0;
  for (int k = 0; k < dimensions.z - 1; ++k)
  {
    for (int j = 0; j < dimensions.y - 1; ++j)
    {
      for (int i = 0; i < dimensions.x - 1; ++i)
      {
        const glm::ivec3 cell(i, j, k);
        std::set<std::int64_t> here;
        bool isDrawn = false;
        for (int corner = 0; corner < 8; ++corner)
        {
          const auto label = static_cast<std::int64_t>(
            grid.At(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)));
          here.insert(label);
          isDrawn |= drawn.count(label) != 0;
        }
        const std::int64_t node = active.NodeOf(cell);
        const bool hasLeaf = active.LeavesOf(node) >> ActiveCells::LeafOf(cell) & 1u;
        const bool isActive = hasLeaf &&
          active.CellsOf(TypedField<T>(grid.Field), node, cell) >> ActiveCells::BitOf(cell) & 1u;
        const bool isAsked = here.size() > 1 && isDrawn;
        EXPECT_TRUE(isActive || !isAsked) << i << " " << j << " " << k;
        count += isAsked;
        superfluous += isActive && !isAsked;
      }
    }
  }
  EXPECT_GT(count, 100);
  EXPECT_LT(superfluous, count); // those between other labels in a leaf with one that is drawn
}

TEST(LabelSets, TellAllLabelsAndActiveCells)
{
  ExpectSets<std::uint8_t>({ 37, 41, 29 }, 6, 1.0);
  ExpectSets<std::int8_t>({ 18, 17, 35 }, 9, -13.0);
  ExpectSets<std::int16_t>({ 33, 34, 35 }, 500, -7.0);
  ExpectSets<std::uint16_t>({ 33, 34, 35 }, 700, 93.0);
  ExpectSets<std::int32_t>({ 33, 34, 35 }, 700, 1e6);
  ExpectSets<std::int64_t>({ 20, 21, 22 }, 40, 4e9);
}

TEST(LabelSets, FollowChangedCells)
{
  const glm::ivec3 dimensions(45, 38, 23);
  Grid<std::uint16_t> grid(dimensions);
  FillWithBlocks(grid, 30, 1.0);
  std::mt19937 engine(6);
  auto sets = LabelSets::Make(grid.Field);
  const auto pick = [&](int below)
  { return static_cast<int>(engine() % static_cast<unsigned int>(below)); };
  for (int stroke = 0; stroke < 20; ++stroke)
  {
    const glm::ivec3 first(pick(dimensions.x), pick(dimensions.y), pick(dimensions.z));
    const glm::ivec3 end =
      glm::min(first + glm::ivec3(1 + pick(20), 1 + pick(9), 1 + pick(9)), dimensions);
    const int label = stroke % 3 == 0 ? 40 + stroke : pick(30); // some labels are new, some vanish
    for (int k = first.z; k < end.z; ++k)
    {
      for (int j = first.y; j < end.y; ++j)
      {
        for (int i = first.x; i < end.x; ++i)
        {
          grid.At(i, j, k) = static_cast<std::uint16_t>(label);
        }
      }
    }
    const glm::ivec3 low = glm::max(first - 1, 0), high = glm::min(end, dimensions - 1);
    sets = sets->Updated(grid.Field, { { low, high - low } });
    const auto made = LabelSets::Make(grid.Field);
    EXPECT_EQ(sets->Labels(), made->Labels());
    const glm::ivec3 along = CellBlocks::NodesFor(dimensions);
    for (std::int64_t node = 0; node < along.x * along.y * along.z; ++node)
    {
      ASSERT_EQ(sets->LabelsOf(node), made->LabelsOf(node));
      EXPECT_EQ(sets->MixedLeaves(node), made->MixedLeaves(node));
      for (const std::int64_t one : made->LabelsOf(node))
      {
        const auto isOne = [&](std::int64_t label) { return label == one; };
        EXPECT_EQ(sets->LeavesWith(sets->BitsOf(node, isOne), node),
          made->LeavesWith(made->BitsOf(node, isOne), node));
      }
    }
  }
}

TEST(LabelSets, OfOneLabelHaveNoActiveLeaf)
{
  Grid<std::uint8_t> grid(glm::ivec3(20, 20, 20));
  grid.Fill([](int, int, int) { return 7; });
  const auto sets = LabelSets::Make(grid.Field);
  EXPECT_EQ(sets->Labels(), std::vector<std::int64_t>{ 7 });
  for (std::int64_t node = 0; node < 8; ++node)
  {
    EXPECT_EQ(sets->MixedLeaves(node), 0u);
  }
}

}
