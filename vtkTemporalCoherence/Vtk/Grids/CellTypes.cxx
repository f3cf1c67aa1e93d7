// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/CellTypes.h"

#include "Mesh/Cells/Mesh.h"

#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

#include <algorithm>

namespace TemporalCoherence
{

vtkDataArray* TypesOf(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

TypeCounts CountTypes(const MeshPart& part)
{
  TypeCounts counts{};
  for (std::int64_t cell = 0; cell < part.NumberOfCells; ++cell)
  {
    ++counts[part.TypeOf(cell)];
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

bool HaveVolume(vtkDataArray* types)
{
  std::array<bool, 256> isFlat{}; // of types that were looked up
  const auto hasVolume = [&](std::uint8_t type)
  {
    const int dimension = isFlat[type] ? 0 : DimensionOfType(type);
    isFlat[type] = dimension >= 0 && dimension < 3;
    return !isFlat[type];
  };
  const vtkIdType cells = types->GetNumberOfValues();
  if (auto* const inMemory = vtkUnsignedCharArray::SafeDownCast(types))
  {
    return std::any_of(inMemory->GetPointer(0), inMemory->GetPointer(0) + cells, hasVolume);
  }
  vtkIdType cell = 0;
  while (cell < cells && !hasVolume(static_cast<std::uint8_t>(types->GetComponent(cell, 0))))
  {
    ++cell;
  }
  return cell < cells;
}

bool IsLinear(int type)
{
  return type >= static_cast<int>(MeshCellType::Tetrahedron) &&
    type <= static_cast<int>(MeshCellType::Pyramid);
}

}
