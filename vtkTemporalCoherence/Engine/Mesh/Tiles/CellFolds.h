// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellFolds_h
#define TemporalCoherence_CellFolds_h

#include "Mesh/Cells/MeshCell.h"

namespace TemporalCoherence
{
namespace MeshKernels
{

/// True if a hexahedron may cover some points more than once, or is flat. Such a cell can hold
/// points that lie outside of its faces. Inverted cells and those with repeated corners do not
/// fold. The answer is a bound: a strongly bent cell may count though it does not fold.
bool MayFold(const MeshCell& hexahedron);

}
}

#endif
