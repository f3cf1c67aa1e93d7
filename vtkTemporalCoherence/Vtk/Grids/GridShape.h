// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridShape_h
#define TemporalCoherence_GridShape_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The points along each axis of a structured grid; 0 for other data sets.
glm::ivec3 DimensionsOf(vtkDataSet* data);

/// The explicit list of cells of a data set; null if cells are implicit.
vtkCellArray* CellsOf(vtkDataSet* data);

}

#endif
