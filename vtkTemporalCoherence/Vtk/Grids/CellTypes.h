// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellTypes_h
#define TemporalCoherence_CellTypes_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <array>
#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

struct MeshPart;

/// The type of each cell of a grid; null if the grid has no types. Since VTK 9.6 any kind of array
/// may hold them, for example a constant array.
vtkDataArray* TypesOf(vtkUnstructuredGrid* grid);

/// Number of cells, by type.
using TypeCounts = std::array<std::int64_t, 256>;

/// \pre the part has a list of cells
TypeCounts CountTypes(const MeshPart& part);

/// The dimension of cells of a type; 0 for empty cells; -1 if VTK does not know the type.
int DimensionOfType(int type);

/// True if one of the types has three dimensions or is unknown.
bool HaveVolume(vtkDataArray* types);

/// True for types of MeshCellType.
bool IsLinear(int type);

}

#endif
