// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Coordinates_h
#define Testing_Coordinates_h

#include "Grid.h"
#include "Kinds/RectilinearKind.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

/// Integers: the cells of an image.
inline std::shared_ptr<const TemporalCoherence::GridCoordinates> Uniform(
  const glm::ivec3& dimensions)
{
  auto grid = std::make_shared<TemporalCoherence::GridCoordinates>();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < dimensions[axis]; ++i)
    {
      grid->Along[static_cast<std::size_t>(axis)].push_back(i);
    }
  }
  return grid;
}

/// Cells of all sizes from 1 to `ratio` in any order.
inline std::shared_ptr<const TemporalCoherence::GridCoordinates> Stretched(
  const glm::ivec3& dimensions, double ratio, unsigned int seed)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> power(0.0, std::log(ratio));
  auto grid = std::make_shared<TemporalCoherence::GridCoordinates>();
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& along = grid->Along[static_cast<std::size_t>(axis)];
    along = { 0.0 };
    for (int i = 1; i < dimensions[axis]; ++i)
    {
      along.push_back(along.back() + std::exp(power(engine)));
    }
    const double scale = (dimensions[axis] - 1) / along.back();
    for (double& coordinate : along)
    {
      coordinate *= scale;
    }
    along.back() = dimensions[axis] - 1;
  }
  return grid;
}

/// Fill a grid by a formula of the coordinates.
template <typename T, typename Formula>
void FillByPlace(
  Grid<T>& grid, const TemporalCoherence::GridCoordinates& at, const Formula& formula)
{
  grid.Fill([&](int i, int j, int k)
    { return formula(glm::dvec3(at.At(0, i), at.At(1, j), at.At(2, k))); });
}

#endif
