// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/SameCells.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

bool HasSameNumbers(const MeshArray& a, const MeshArray& b, std::int64_t count)
{
  std::int64_t i = 0;
  while (i < count && a.At(i) == b.At(i))
  {
    ++i;
  }
  return i >= count;
}

}

bool HaveSameCells(const MeshPart& a, const MeshPart& b)
{
  return a.NumberOfCells == b.NumberOfCells && a.NumberOfPoints == b.NumberOfPoints &&
    a.ConnectivitySize == b.ConnectivitySize &&
    std::equal(a.Types, a.Types + a.NumberOfCells, b.Types) && // made ones: one for each cell
    HasSameNumbers(a.Offsets, b.Offsets, a.NumberOfCells + 1) &&
    HasSameNumbers(a.Connectivity, b.Connectivity, a.ConnectivitySize) &&
    HasSameNumbers(a.Originals, b.Originals, a.NumberOfCells) &&
    HasSameNumbers(a.Coordinates[0], b.Coordinates[0], a.NumberOfPoints) &&
    HasSameNumbers(a.Coordinates[1], b.Coordinates[1], a.NumberOfPoints) &&
    HasSameNumbers(a.Coordinates[2], b.Coordinates[2], a.NumberOfPoints);
}

}
