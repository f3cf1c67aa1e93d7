// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RangeOfMost_h
#define TemporalCoherence_RangeOfMost_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// A range that holds nine tenths of the different values of a field, without the outliers on both
/// sides. Estimated by some thousand samples. Values at the ends of the whole range do not count:
/// they are often marks of missing data. The whole range if there are few values.
glm::dvec2 FindRangeOfMost(const Field& field, const glm::dvec2& whole);

}

#endif
