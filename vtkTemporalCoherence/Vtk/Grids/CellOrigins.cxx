// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/CellOrigins.h"

#include "Mesh/Mesh.h"

#include <algorithm>
#include <utility>

namespace TemporalCoherence
{

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
  return { this->Parts[place].Data, this->Parts[place].Block, static_cast<vtkIdType>(inPart) };
}

}
