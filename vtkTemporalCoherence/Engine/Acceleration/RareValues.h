// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RareValues_h
#define TemporalCoherence_RareValues_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// True if samples of a field lie within a range, and at most one beyond it for each 4096 within.
/// Samples at the ends of the field's own range do not count: they are often marks of missing data.
/// Estimated from at most 65536 samples, always the same ones for equal dimensions.
/// \param whole the range of the field's finite samples
bool AreRareBeyond(const Field& field, const glm::dvec2& range, const glm::dvec2& whole);

}

#endif
