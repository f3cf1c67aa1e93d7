// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/CellFolds.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{
namespace
{

/// The four edges of a hexahedron along one axis, by place [first][second] along the other axes.
using Edges = std::array<std::array<glm::dvec3, 2>, 2>;

/// \param step between the corners at both ends of an edge; `first` and `second` are the steps of
///             the other axes
Edges EdgesAlong(const MeshCell& cell, std::size_t step, std::size_t first, std::size_t second)
{
  Edges edges;
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (std::size_t j = 0; j < 2; ++j)
    {
      const std::size_t from = i * first + j * second;
      edges[i][j] = cell.Points[from + step] - cell.Points[from];
    }
  }
  return edges;
}

double LongestOf(const Edges& edges)
{
  return std::max({ glm::length(edges[0][0]), glm::length(edges[0][1]), glm::length(edges[1][0]),
    glm::length(edges[1][1]) });
}

}

/// The determinant of the Jacobian is of degree 2 along each axis. Its 27 Bernstein coefficients
/// are means of the volumes that three edges span, and they bound it.
bool MayFold(const MeshCell& hexahedron)
{
  constexpr double rounding = 1e-12;
  const Edges alongX = EdgesAlong(hexahedron, 1, 2, 4), alongY = EdgesAlong(hexahedron, 2, 1, 4),
              alongZ = EdgesAlong(hexahedron, 4, 1, 2);
  std::array<std::array<std::array<double, 3>, 3>, 3> coefficients{};
  for (std::size_t place = 0; place < 64; ++place)
  {
    const auto bit = [&](std::size_t which) { return place >> which & 1u; };
    const std::size_t x = bit(0) + bit(1), y = bit(2) + bit(3), z = bit(4) + bit(5);
    const auto weight = [](std::size_t index) { return index == 1 ? 0.5 : 1.0; };
    const glm::dvec3& a = alongX[bit(2)][bit(4)];
    const glm::dvec3& b = alongY[bit(0)][bit(5)];
    const glm::dvec3& c = alongZ[bit(1)][bit(3)];
    coefficients[x][y][z] += weight(x) * weight(y) * weight(z) * glm::dot(a, glm::cross(b, c));
  }
  double least = coefficients[0][0][0], most = least;
  for (const auto& plane : coefficients)
  {
    for (const auto& row : plane)
    {
      least = std::min({ least, row[0], row[1], row[2] });
      most = std::max({ most, row[0], row[1], row[2] });
    }
  }
  const double slack = rounding * LongestOf(alongX) * LongestOf(alongY) * LongestOf(alongZ);
  // Coefficients that are not finite count as a fold, too.
  return !(least >= -slack || most <= slack) || !(most - least < 1e300) ||
    !(std::max(most, -least) > slack);
}

}
}
