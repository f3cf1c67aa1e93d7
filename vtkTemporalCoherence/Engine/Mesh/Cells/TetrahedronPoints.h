// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TetrahedronPoints_h
#define TemporalCoherence_TetrahedronPoints_h

#include "Mesh/Cells/CornerPoints.h"

namespace TemporalCoherence
{
namespace MeshKernels
{

/// The vertices of a tetrahedron, ascending by x, then y, z and value. So two tetrahedra that share
/// a face have its vertices in the same order, and compute the same bits there.
struct TetrahedronPoints : CornerPoints<4>
{
  TetrahedronPoints() = default;
  TetrahedronPoints(const MeshCell& cell, const CellDifferences& differences)
  {
    std::array<std::size_t, 4> rank{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = i + 1; j < 4; ++j)
      {
        const std::size_t isAbove = IsLess(cell, differences, j, i);
        rank[i] += isAbove;
        rank[j] += 1 - isAbove;
      }
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Points[rank[i]] = cell.Points[i];
      this->Values[rank[i]] = differences[i];
    }
    const glm::dvec3 &first = this->Points[0], &last = this->Points[3];
    const glm::dvec3 across = glm::cross(this->Points[1] - first, this->Points[2] - first);
    this->Handedness = glm::dot(across, last - first) < 0.0 ? -1.0 : 1.0;
  }

private:
  static bool IsLess(
    const MeshCell& cell, const CellDifferences& differences, std::size_t i, std::size_t j)
  {
    // Without branches, which would be mispredicted: points of a regular mesh share coordinates.
    const glm::dvec3 &a = cell.Points[i], &b = cell.Points[j];
    const bool byValue = differences[i] < differences[j];
    const bool byZ = (a.z < b.z) | ((a.z == b.z) & byValue);
    const bool byY = (a.y < b.y) | ((a.y == b.y) & byZ);
    return (a.x < b.x) | ((a.x == b.x) & byY);
  }
};

}
}

#endif
