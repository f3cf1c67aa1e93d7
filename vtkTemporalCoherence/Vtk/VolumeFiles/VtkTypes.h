// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VtkTypes_h
#define TemporalCoherence_VtkTypes_h

#include "Scene/ScalarType.h"

#include <optional>

namespace TemporalCoherence
{

/// VTK's number of a type, such as VTK_FLOAT.
int VtkTypeOf(ScalarType type);

/// The type with a number of VTK; none if samples cannot have it.
std::optional<ScalarType> TypeOfVtk(int type);

}

#endif
