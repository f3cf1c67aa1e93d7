// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCellValues_h
#define TemporalCoherence_KernelsCellValues_h

#include "Lattice/CellRoot.h"
#include "Lattice/TileBeam.h"
#include "Scene/Difference.h"

#include <array>

namespace TemporalCoherence
{

/// The rows of a cell's corners, each with its two samples beside each other: [y + 2 z].
template <typename T>
using CellRows = std::array<const T*, 4>;

/// Compute the differences at a cell's corners in vectors, bit-identical to Difference.h.
/// \param unit   factor of the differences in `values`
/// \param values gets the scaled differences, in single precision, for the beam
void FindCellValues(const CellRows<float>& rows, const DifferenceInDouble& difference, double unit,
  Corners<double>& corners, CellValues& values);
void FindCellValues(const CellRows<double>& rows, const DifferenceInDouble& difference, double unit,
  Corners<double>& corners, CellValues& values);

}

#endif
