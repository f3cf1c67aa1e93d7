// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VisibleComponents_h
#define TemporalCoherence_VisibleComponents_h

#include "Scene/Blending.h"

#include <optional>
#include <vector>

namespace TemporalCoherence
{

/// The ranges of visible values of each component, ascending. A place is invisible if all
/// components lie outside of their ranges. Returns nullopt if any value may be visible.
std::optional<std::vector<std::vector<ValueBand>>> VisibleComponents(const Blending& volume);

}

#endif
