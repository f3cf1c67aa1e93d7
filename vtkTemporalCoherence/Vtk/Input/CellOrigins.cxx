// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CellOrigins.h"

#include "Mesh/Cells/Mesh.h"

#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace TemporalCoherence
{

vtkIdType NearestPointOf(const CellOrigin& cell, const glm::dvec3& place)
{
  if (!cell.Data || cell.Cell < 0 || cell.Cell >= cell.Data->GetNumberOfCells())
  {
    return -1;
  }
  vtkNew<vtkIdList> points;
  cell.Data->GetCellPoints(cell.Cell, points);
  vtkIdType nearest = -1;
  double shortest = std::numeric_limits<double>::infinity();
  for (const vtkIdType point : *points)
  {
    glm::dvec3 at;
    cell.Data->GetPoint(point, &at.x);
    const double distance = glm::distance(at, place);
    if (distance < shortest)
    {
      shortest = distance;
      nearest = point;
    }
  }
  return nearest;
}

CellOrigins::CellOrigins(std::shared_ptr<const Mesh> mesh, std::vector<Part> parts)
  : OfCells(std::move(mesh))
  , Parts(std::move(parts))
{
}

CellOrigin CellOrigins::Of(std::int64_t cell) const
{
  const auto next = std::upper_bound(this->Parts.begin(), this->Parts.end(), cell,
    [](std::int64_t number, const Part& part) { return number < part.First; });
  if (cell < 0 || next == this->Parts.begin())
  {
    return {};
  }
  const auto place = static_cast<std::size_t>(next - this->Parts.begin()) - 1;
  const MeshPart& part = this->OfCells->Parts[place];
  const std::int64_t inPart = cell - this->Parts[place].First;
  if (inPart >= part.NumberOfCells)
  {
    return {};
  }
  const std::int64_t origin = part.Originals.First ? part.Originals.IdAt(inPart) : inPart;
  return { this->Parts[place].Data, this->Parts[place].Block, static_cast<vtkIdType>(origin) };
}

vtkIdType CellOrigins::LargestPoint() const
{
  vtkIdType most = -1;
  for (const Part& part : this->Parts)
  {
    most = std::max(most, part.Data ? part.Data->GetNumberOfPoints() - 1 : most);
  }
  return most;
}

vtkIdType CellOrigins::LargestCell() const
{
  vtkIdType most = -1;
  for (const Part& part : this->Parts)
  {
    most = std::max(most, part.Data ? part.Data->GetNumberOfCells() - 1 : most);
  }
  return most;
}

}
