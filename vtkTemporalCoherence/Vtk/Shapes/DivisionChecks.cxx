// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/DivisionChecks.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace TemporalCoherence
{
namespace
{

using Pairs = std::vector<std::array<std::size_t, 2>>;

/// Pairs of points of a cell, and the factor of the worst of them.
struct PairGroup
{
  double Factor;
  Pairs Of;
};

const std::vector<PairGroup>& GroupsOf(MeshCellType type)
{
  static const std::vector<PairGroup> tetrahedron = { { 1.5,
    { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } } };
  static const std::vector<PairGroup> pyramid = { { 1.6,
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 2 }, { 1, 3 }, { 0, 4 }, { 1, 4 }, { 2, 4 },
      { 3, 4 } } } };
  static const std::vector<PairGroup> wedge = {
    { 4.0 / 3.0, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 } } },
    { 1.0, { { 0, 3 }, { 1, 4 }, { 2, 5 } } }
  };
  static const std::vector<PairGroup> hexahedron = {
    { 1.0, { { 0, 1 }, { 3, 2 }, { 4, 5 }, { 7, 6 } } },
    { 1.0, { { 0, 3 }, { 1, 2 }, { 4, 7 }, { 5, 6 } } },
    { 1.0, { { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } },
  };
  return type == MeshCellType::Tetrahedron ? tetrahedron
    : type == MeshCellType::Pyramid        ? pyramid
    : type == MeshCellType::Wedge          ? wedge
                                           : hexahedron;
}

}

DivisionChecks ChecksOf(const CellDivision& division)
{
  DivisionChecks checks;
  std::map<std::array<int, 2>, int> known;
  for (const DivisionCell& cell : division.Cells)
  {
    DivisionBound bound;
    for (const PairGroup& group : GroupsOf(cell.Type))
    {
      bound.Groups.push_back({ group.Factor, {} });
      for (const auto& [first, second] : group.Of)
      {
        std::array<int, 2> points{ cell.Points[first], cell.Points[second] };
        std::sort(points.begin(), points.end());
        const auto found = known.emplace(points, static_cast<int>(checks.Checks.size()));
        if (found.second)
        {
          const auto at = [&](int point)
          { return division.Points[static_cast<std::size_t>(point)].At; };
          checks.Checks.push_back({ 0.5 * (at(points[0]) + at(points[1])), points });
        }
        bound.Groups.back().Checks.push_back(found.first->second);
      }
    }
    checks.Bounds.push_back(bound);
  }
  return checks;
}

}
