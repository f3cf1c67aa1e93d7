// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DivisionChecks_h
#define TemporalCoherence_DivisionChecks_h

#include "Shapes/CellDivision.h"

#include <array>
#include <vector>

namespace TemporalCoherence
{

/// A place where the difference between a cell and its linear parts is measured: half way between
/// two points of a linear cell. There that has the mean of both.
struct DivisionCheck
{
  glm::dvec3 At;
  std::array<int, 2> Points;
};

/// What bounds the difference in a linear cell: in each group of checks the largest, times a
/// factor, and the sum of this for all groups.
struct DivisionBound
{
  struct Group
  {
    double Factor;
    std::vector<int> Checks;
  };
  std::vector<Group> Groups;
};

struct DivisionChecks
{
  std::vector<DivisionCheck> Checks;
  std::vector<DivisionBound> Bounds; ///< of each linear cell
};

/// Where to measure how far linear cells are from functions of the second order. For these the
/// bounds hold everywhere in a cell.
///
/// If weights w of points x add up to 1, the weighted mean of such a function f differs from its
/// value at the mean place by half the sum of w_i w_j f''(x_i - x_j) over all pairs, and half way
/// between two points by f''(x_i - x_j) / 8. So the largest difference is that of the worst pair,
/// times 2 (1 - 1 / k) for k points. A product of linear functions along some axes has a sum of
/// such terms, one for each axis. 	hrows std::bad_alloc
DivisionChecks ChecksOf(const CellDivision& division);

}

#endif
