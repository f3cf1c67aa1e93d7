// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FiniteRange_h
#define TemporalCoherence_FiniteRange_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// The smallest and the largest finite sample of a field that has samples; 0 and 0 if there is
/// none.
glm::dvec2 FindFiniteRange(const Field& field);

}

#endif
