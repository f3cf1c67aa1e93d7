// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MeanEdge.h"

#include "Mesh/MeshCell.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

double LengthOfEdges(const MeshCell& cell, int& count)
{
  double length = 0.0;
  const int points = cell.NumberOfPoints();
  for (int a = 0; a < points; ++a)
  {
    for (int b = a + 1; b < points; ++b)
    {
      // Of a tetrahedron each pair of points; of a hexahedron those that differ along one axis.
      const int axes = a ^ b;
      if (cell.Shape == MeshCellShape::Tetrahedron || (axes & (axes - 1)) == 0)
      {
        const double edge = glm::distance(
          cell.Points[static_cast<std::size_t>(a)], cell.Points[static_cast<std::size_t>(b)]);
        length += edge;
        count += edge > 0.0;
      }
    }
  }
  return length;
}

}

double MeanEdgeOf(const Mesh& mesh)
{
  constexpr std::int64_t MostOfPart = 4096;
  double length = 0.0;
  int count = 0;
  MeshCell cell;
  for (const MeshPart& part : mesh.Parts)
  {
    const std::int64_t step = std::max<std::int64_t>(part.NumberOfCells / MostOfPart, 1);
    for (std::int64_t i = 0; i < part.NumberOfCells; i += step)
    {
      ReadCell(part, i, cell);
      length += LengthOfEdges(cell, count);
    }
  }
  return count > 0 ? length / count : 0.0;
}

}
