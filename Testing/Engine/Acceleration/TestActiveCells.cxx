// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Active cells are those with samples on both sides of an isovalue. Hidden cells and cells beyond
// the field are never active. The levels above tell where active leaves are.

#include "Acceleration/ActiveCells.h"
#include "Grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace TemporalCoherence;

template <typename T>
bool IsActive(Grid<T>& grid, const glm::ivec3& cell, const std::vector<double>& isovalues)
{
  for (const double isovalue : isovalues)
  {
    int inside = 0, numbers = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const T value =
        grid.At(cell.x + (corner & 1), cell.y + (corner >> 1 & 1), cell.z + (corner >> 2));
      inside += static_cast<double>(value) >= isovalue;
      numbers += !std::isnan(static_cast<double>(value));
    }
    if (inside != 0 && inside != 8 && numbers == 8)
    {
      return true;
    }
  }
  return false;
}

template <typename T>
void ExpectBits(Grid<T>& grid, const std::vector<double>& isovalues)
{
  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  ActiveCells active;
  active.Build(grid.Field, pyramid, Surfaces{ isovalues, SurfaceMode::Crossing });
  const TypedField<T> field(grid.Field);
  const glm::ivec3 cells = grid.Field.Dimensions - 1;
  for (int k = 0; k < cells.z; ++k)
  {
    for (int j = 0; j < cells.y; ++j)
    {
      for (int i = 0; i < cells.x; ++i)
      {
        const glm::ivec3 cell(i, j, k);
        const std::int64_t node = active.NodeOf(cell);
        const bool leaf = active.LeavesOf(node) >> ActiveCells::LeafOf(cell) & 1u;
        const bool bit =
          leaf && (active.CellsOf(field, node, cell) >> ActiveCells::BitOf(cell) & 1u);
        ASSERT_EQ(bit, IsActive(grid, cell, isovalues)) << i << ' ' << j << ' ' << k;
      }
    }
  }
}

TEST(ActiveCells, AreThoseWithSamplesOnBothSides)
{
  Grid<std::uint8_t> bytes(glm::ivec3(37, 18, 9));
  bytes.FillRandomly(0.0, 20.0, 1);
  ExpectBits(bytes, { 10.0 });
  ExpectBits(bytes, { 18.5 });
  ExpectBits(bytes, { 2.0, 19.0 });
  ExpectBits(bytes, { -5.0, 300.0 });

  Grid<double> doubles(glm::ivec3(6, 5, 21), 2, 1);
  doubles.FillRandomly(-1.0, 1.0, 2);
  ExpectBits(doubles, { 0.0 });
  ExpectBits(doubles, { 0.99, -0.99 });
}

TEST(ActiveCells, IsovaluesEqualToSamples)
{
  Grid<std::int16_t> grid(glm::ivec3(20, 20, 20));
  grid.Fill([](int i, int j, int) { return i / 5 + j / 7; });
  for (int isovalue = -1; isovalue < 8; ++isovalue)
  {
    ExpectBits(grid, { static_cast<double>(isovalue) });
  }
}

TEST(ActiveCells, NotANumberHidesTheCellsAround)
{
  Grid<float> grid(glm::ivec3(9, 9, 9));
  grid.Fill([](int i, int, int) { return i; });
  grid.At(4, 4, 4) = std::numeric_limits<float>::quiet_NaN();
  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  grid.Field.Hidden = HiddenCells::WithoutNaN(grid.Field, pyramid.LeavesWithNaN());
  ASSERT_TRUE(grid.Field.Hidden);
  for (const double isovalue : { 1.5, 3.5, 4.5, 5.0 })
  {
    ExpectBits(grid, { isovalue });
  }
}

/// A node reaches past the field. Its leaves there have no samples, whatever the band.
TEST(ActiveCells, NoLeafOutsideOfTheFieldIsActive)
{
  Grid<std::int8_t> grid(glm::ivec3(8, 8, 8));
  grid.FillRandomly(-128.0, 127.0, 3);
  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  ActiveCells active;
  active.Build(grid.Field, pyramid, { -1e300, 1e300 }, SurfaceMode::Crossing);
  ASSERT_EQ(active.NodeDimensions(), glm::ivec3(1));
  for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
  {
    const glm::ivec3 place(leaf & 3, leaf >> 2 & 3, leaf >> 4);
    const bool isInside = glm::all(glm::lessThan(place, glm::ivec3(2)));
    EXPECT_EQ(active.LeavesOf(0) >> leaf & 1u, isInside ? 1u : 0u) << leaf;
  }
}

/// Beams begin at the last level: what it leaves out no ray finds.
TEST(ActiveCells, LevelsAboveTellWhereActiveLeavesAre)
{
  Grid<std::uint8_t> grid(glm::ivec3(30, 90, 330));
  grid.Fill([](int i, int j, int k)
    { return glm::length(glm::dvec3(i - 9.0, j - 60.0, k - 200.0)) < 8.0 || k == 300 ? 9 : 0; });
  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  ActiveCells active;
  active.Build(grid.Field, pyramid, Surfaces{ { 5.0 }, SurfaceMode::Crossing });
  const std::vector<ActiveCells::Level>& levels = active.LevelsAbove();
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_EQ(levels.back().Dimensions, glm::ivec3(1));
  glm::ivec3 below = active.NodeDimensions();
  std::size_t activeBlocks = 0, blocks = 0;
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    for (int z = 0; z < below.z; ++z)
    {
      for (int y = 0; y < below.y; ++y)
      {
        for (int x = 0; x < below.x; ++x)
        {
          const glm::ivec3 child(x, y, z);
          const bool isActive = level == 0
            ? active.LeavesOf(active.NodeOf(ActiveCells::NodeSize * child)) != 0
            : levels[level - 1].WordOf(child) != 0;
          const int bit = (x & 3) | (y & 3) << 2 | (z & 3) << 4;
          EXPECT_EQ(levels[level].WordOf(child / 4) >> bit & 1u, isActive ? 1u : 0u);
          activeBlocks += isActive;
          ++blocks;
        }
      }
    }
    below = levels[level].Dimensions;
  }
  EXPECT_GT(activeBlocks, 5u);
  EXPECT_LT(activeBlocks, blocks / 2);
}

TEST(ActiveCells, OfSeveralFields)
{
  const glm::ivec3 size(23, 19, 21);
  Grid<std::int16_t> first(size), second(size);
  first.FillRandomly(0.0, 100.0, 1);
  second.FillRandomly(0.0, 100.0, 2);
  ValueRangePyramid ofFirst, ofSecond;
  ofFirst.Build(first.Field);
  ofSecond.Build(second.Field);
  const std::vector<ValueBand> high{ { 97.0, 1e9 } }, low{ { -1e9, 2.0 } };
  ActiveCells alone, other, both, onlyOther;
  alone.BuildVisible(first.Field, ofFirst, high);
  other.BuildVisible(second.Field, ofSecond, low);
  both.BuildVisible({ { first.Field, &ofFirst, high }, { second.Field, &ofSecond, low } });
  onlyOther.BuildVisible({ { first.Field, &ofFirst, {} }, { second.Field, &ofSecond, low } });
  const TypedField<std::int16_t> samples(first.Field), others(second.Field);
  const auto isActive =
    [](const ActiveCells& cells, const TypedField<std::int16_t>& field, const glm::ivec3& cell)
  {
    const std::int64_t node = cells.NodeOf(cell);
    return (cells.LeavesOf(node) >> ActiveCells::LeafOf(cell) & 1u) != 0 &&
      (cells.CellsOf(field, node, cell) >> ActiveCells::BitOf(cell) & 1u) != 0;
  };
  int active = 0;
  for (int i = 0; i < 22 * 18 * 20; ++i)
  {
    const glm::ivec3 cell(i % 22, i / 22 % 18, i / 22 / 18);
    const bool inOther = isActive(other, others, cell);
    const bool inAny = isActive(alone, samples, cell) || inOther;
    ASSERT_EQ(isActive(both, samples, cell), inAny) << i;
    ASSERT_EQ(isActive(onlyOther, samples, cell), inOther) << i;
    active += inAny;
  }
  EXPECT_GT(active, 100);
  EXPECT_LT(active, 22 * 18 * 20 - 100);
}

}
