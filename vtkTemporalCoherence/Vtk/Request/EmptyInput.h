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

/// True for data without any cell with volume whose picture is empty, which is no mistake: images
/// and rectilinear grids that are too thin, and a piece of data that other processes have more of.
bool MayBeEmpty(vtkDataObject* data);

/// Tells that data have no cells with volume, and what to do about it.
std::string WhyThereIsNoVolume(vtkDataObject* data);

}

#endif
