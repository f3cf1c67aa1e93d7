// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridCoordinates_h
#define TemporalCoherence_GridCoordinates_h

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Where the samples of a rectilinear field lie in index space.
///
/// The field fills the same box as an image of the same dimensions, so that code which handles only
/// boxes and planes serves both. Inside the box, samples lie at these coordinates instead of at
/// integers. The unit along an axis is the mean distance between samples.
struct GridCoordinates
{
  /// Strictly ascending. The first is 0, the last is the number of cells.
  std::array<std::vector<double>, 3> Along;

  const std::vector<double>& Of(int axis) const
  {
    return this->Along[static_cast<std::size_t>(axis)];
  }

  /// Coordinate of sample `i`, clamped to the last sample.
  double At(int axis, int i) const
  {
    const std::vector<double>& all = this->Of(axis);
    return all[std::min(static_cast<std::size_t>(i), all.size() - 1)];
  }

  /// The cell that holds a coordinate, or the nearest one.
  int CellOf(int axis, double coordinate) const
  {
    const std::vector<double>& all = this->Of(axis);
    // std::upper_bound among the inner planes, but without unpredictable branches.
    const double* before = all.data();
    std::size_t left = all.size() - 2;
    while (left > 0)
    {
      const std::size_t step = (left + 1) / 2;
      before += coordinate < before[step] ? 0 : step;
      left -= step;
    }
    return static_cast<int>(before - all.data());
  }

  /// Lengths of the shortest and of the longest edge of a cell along an axis.
  glm::dvec2 Edges(int axis) const
  {
    const std::vector<double>& all = this->Of(axis);
    glm::dvec2 edges(std::numeric_limits<double>::infinity(), 0.0);
    for (std::size_t i = 1; i < all.size(); ++i)
    {
      edges = { std::min(edges.x, all[i] - all[i - 1]), std::max(edges.y, all[i] - all[i - 1]) };
    }
    return edges;
  }
};

}

#endif
