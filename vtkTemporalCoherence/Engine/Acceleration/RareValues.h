// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RareValues_h
#define TemporalCoherence_RareValues_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// True if hardly any sample of a field lies beyond a range, though some lie within. Samples at the
/// ends of the field's own range do not count: they are often marks of missing data. Estimated by
/// many samples, the same ones for equal dimensions.
/// \param whole the range of the field's finite samples
bool AreRareBeyond(const Field& field, const glm::dvec2& range, const glm::dvec2& whole);

}

#endif
