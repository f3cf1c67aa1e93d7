// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VisibleComponents_h
#define TemporalCoherence_VisibleComponents_h

#include "Scene/Blending.h"

#include <optional>
#include <vector>

namespace TemporalCoherence
{

/// For each component, the ranges of values that can be seen, ascending. Where all components are
/// outside of theirs, nothing is. None if any value may be seen.
std::optional<std::vector<std::vector<ValueBand>>> VisibleComponents(const Blending& volume);

}

#endif
