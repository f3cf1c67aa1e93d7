// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ReadCell_h
#define Testing_ReadCell_h

#include "Mesh/Cells/MeshCell.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Read a cell of a part of a mesh, number by number: what MeshReader is compared with.
/// \pre the connectivity is valid
inline void ReadCell(const MeshPart& part, std::int64_t number, MeshCell& cell)
{
  const MeshCellPoints points = PointsOf(part, number);
  cell.Shape = points.Shape;
  for (std::size_t i = 0; i < static_cast<std::size_t>(cell.NumberOfPoints()); ++i)
  {
    const std::int64_t id = points.Ids[i];
    cell.Points[i] = { part.Coordinates[0].At(id), part.Coordinates[1].At(id),
      part.Coordinates[2].At(id) };
    cell.Values[i] = part.Values.At(id);
  }
}

}

#endif
