// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VisibleBands_h
#define TemporalCoherence_VisibleBands_h

#include "Scene/Blending.h"

#include <optional>
#include <vector>

namespace TemporalCoherence
{

/// The ranges of values that can be seen, ascending; all others are transparent. None if every
/// value may be seen, or if there are several components.
std::optional<std::vector<ValueBand>> VisibleBands(const Blending& blending);

/// The extremes of rays that can be seen, in a mode of extremes; all beyond are transparent. All
/// if there are several components that each have a look.
ValueBand VisibleExtremes(const Blending& blending);

}

#endif
