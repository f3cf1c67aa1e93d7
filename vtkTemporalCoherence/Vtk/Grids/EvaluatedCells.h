// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EvaluatedCells_h
#define TemporalCoherence_EvaluatedCells_h

#include "Mesh/Tracing/MeshValues.h"
#include "vtkTemporalCoherenceCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Find values at the points of a part that divides cells of a data set. The first cell that can be
/// evaluated at a point gives its value; NaN without one.
///
/// \param own values at the points of the data set
/// \throws std::bad_alloc
PartValues EvaluateCells(vtkDataSet* data, const PartValues& own, const MeshPart& part);

}

#endif
