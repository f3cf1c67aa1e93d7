// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GhostArray_h
#define TemporalCoherence_GhostArray_h

#include <vtkDataSetAttributes.h>
#include <vtkUnsignedCharArray.h>

namespace TemporalCoherence
{

/// The ghost array of points or cells; null if there is none.
inline vtkUnsignedCharArray* GhostsOf(vtkDataSetAttributes* attributes)
{
  // The data set may answer with an array that has been replaced.
  return vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

/// True if a ghost array has one value for each of this many points or cells.
inline bool HasOneForEach(vtkUnsignedCharArray* ghosts, vtkIdType count)
{
  return ghosts->GetNumberOfTuples() >= count && ghosts->GetNumberOfComponents() == 1;
}

}

#endif
