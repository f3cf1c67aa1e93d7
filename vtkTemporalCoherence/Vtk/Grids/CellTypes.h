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

/// The types of the cells of a grid, one for each; null if there are none. Since VTK 9.6 they may
/// be in any array, for example in a constant one.
vtkDataArray* TypesOf(vtkUnstructuredGrid* grid);

/// How many cells there are of each type.
using TypeCounts = std::array<std::int64_t, 256>;

/// \pre the part has a list of cells
TypeCounts CountTypes(const MeshPart& part);

/// The dimension of cells of a type; 0 for empty cells; -1 if VTK does not know the type.
int DimensionOfType(int type);

/// True if one of the types is of three dimensions, or not known.
bool HaveVolume(vtkDataArray* types);

/// True for types of MeshCellType.
bool IsLinear(int type);

}

#endif
