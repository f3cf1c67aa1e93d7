// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The kind of rectilinear grids knows the edges and coordinates of its cells, and tells grids with
// other coordinates apart.

#include "Lattice/Coordinates.h"

#include <gtest/gtest.h>

namespace
{

using namespace TemporalCoherence;

TEST(RectilinearKind, EdgesOfVoxels)
{
  Grid<float> grid(glm::ivec3(3, 4, 2));
  auto coordinates = std::make_shared<GridCoordinates>(*Uniform(grid.Field.Dimensions));
  coordinates->Along[1] = { 0.0, 0.25, 1.0, 3.0 };
  grid.Field.Shape = RectilinearKind(coordinates);
  IndexTransform transform;
  transform.WorldFromIndex = glm::scale(glm::dmat4(1.0), glm::dvec3(3.0, -2.0, 1.0));
  const auto expectSize = [&](const VoxelSize& expected)
  {
    const VoxelSize size = grid.Field.Shape->VoxelSizeIn(transform);
    EXPECT_EQ(size.Shortest, expected.Shortest);
    EXPECT_EQ(size.Longest, expected.Longest);
  };
  expectSize({ 0.5, 4.0 });
  grid.Field.Shape = UniformShape();
  expectSize({ 1.0, 3.0 });
}

TEST(RectilinearKind, CoordinatesOfSamplesAndCells)
{
  GridCoordinates grid;
  const std::vector<double> all{ 0.0, 0.25, 1.0, 3.0, 3.5 };
  grid.Along = { std::vector{ 0.0, 1.0 }, all, std::vector{ 0.0, 1.0 } };
  for (int i = 0; i < 12; ++i)
  {
    EXPECT_EQ(grid.At(1, i), all[static_cast<std::size_t>(std::min(i, 4))]) << i;
  }
  for (double coordinate = -1.0; coordinate <= 5.0; coordinate += 0.125)
  {
    // A plane between cells belongs to the one behind it.
    int cell = 0;
    while (cell < 3 && coordinate >= all[static_cast<std::size_t>(cell + 1)])
    {
      ++cell;
    }
    EXPECT_EQ(grid.CellOf(1, coordinate), cell) << coordinate;
    EXPECT_EQ(grid.CellOf(0, coordinate), 0) << coordinate;
  }
  // Whatever the number of cells.
  for (int cells = 1; cells < 40; ++cells)
  {
    grid.Along[2].push_back(cells + 1.0);
    for (int i = -1; i <= cells + 2; ++i)
    {
      EXPECT_EQ(grid.CellOf(2, i), std::clamp(i, 0, cells)) << i;
      EXPECT_EQ(grid.CellOf(2, i + 0.5), std::clamp(i, 0, cells)) << i;
    }
  }
}

TEST(RectilinearKind, FieldsDifferByTheirCoordinates)
{
  Grid<float> grid(glm::ivec3(3, 4, 2));
  Field a = grid.Field, b = grid.Field;
  a.Shape = RectilinearKind(Stretched(a.Dimensions, 3.0, 1));
  EXPECT_FALSE(a == b);
  b.Shape = RectilinearKind(Stretched(a.Dimensions, 3.0, 1));
  EXPECT_TRUE(a == b) << "compared by value";
  b.Shape = RectilinearKind(Stretched(a.Dimensions, 3.0, 2));
  EXPECT_FALSE(a == b);
}

}
