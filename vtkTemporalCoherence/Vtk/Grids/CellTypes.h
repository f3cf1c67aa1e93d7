// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellTypes_h
#define TemporalCoherence_CellTypes_h

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// How many cells there are of each type.
using TypeCounts = std::array<std::int64_t, 256>;

TypeCounts CountTypes(const std::uint8_t* types, std::int64_t cells);

/// The dimension of cells of a type; 0 for empty cells; -1 if VTK does not know the type.
int DimensionOfType(int type);

/// True if a type is of three dimensions, or not known.
bool HaveVolume(const std::uint8_t* types, std::int64_t cells);

/// True for types of MeshCellType.
bool IsLinear(int type);

}

#endif
