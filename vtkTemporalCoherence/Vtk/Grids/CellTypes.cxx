// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/CellTypes.h"

#include "Mesh/Mesh.h"

#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace TemporalCoherence
{

TypeCounts CountTypes(const std::uint8_t* types, std::int64_t cells)
{
  TypeCounts counts{};
  for (std::int64_t cell = 0; cell < cells; ++cell)
  {
    ++counts[types[cell]];
  }
  return counts;
}

int DimensionOfType(int type)
{
  if (type == VTK_EMPTY_CELL)
  {
    return 0;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return cell ? cell->GetCellDimension() : -1;
}

bool HaveVolume(const std::uint8_t* types, std::int64_t cells)
{
  std::array<bool, 256> isFlat{}; // and has been seen
  return std::any_of(types, types + cells,
    [&](std::uint8_t type)
    {
      const int dimension = isFlat[type] ? 0 : DimensionOfType(type);
      isFlat[type] = dimension >= 0 && dimension < 3;
      return !isFlat[type];
    });
}

bool IsLinear(int type)
{
  return type >= static_cast<int>(MeshCellType::Tetrahedron) &&
    type <= static_cast<int>(MeshCellType::Pyramid);
}

}
