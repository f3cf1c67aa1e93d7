// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCellValues_h
#define TemporalCoherence_KernelsCellValues_h

#include "Beams/TileBeam.h"
#include "Scene/Difference.h"
#include "Trace/CellRoot.h"

#include <array>

namespace TemporalCoherence
{

/// The rows of a cell's corners, each with its two samples beside each other: [y + 2 z].
template <typename T>
using CellRows = std::array<const T*, 4>;

/// Take the differences at the corners of a cell, in vectors of the machine: the same bits as
/// Difference.h.
/// \param unit   that differences are multiplied by for the beam
/// \param values the same for the beam
void FindCellValues(const CellRows<float>& rows, const DifferenceInDouble& difference, double unit,
  Corners<double>& corners, CellValues& values);
void FindCellValues(const CellRows<double>& rows, const DifferenceInDouble& difference, double unit,
  Corners<double>& corners, CellValues& values);

}

#endif
