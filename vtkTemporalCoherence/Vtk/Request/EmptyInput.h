// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EmptyInput_h
#define TemporalCoherence_EmptyInput_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// True if data without a cell of positive volume are no mistake, but give an empty picture: thin
/// images and rectilinear grids, and pieces of distributed data.
bool MayBeEmpty(vtkDataObject* data);

/// The error message for data without cells of positive volume, with the remedy.
std::string WhyThereIsNoVolume(vtkDataObject* data);

}

#endif
