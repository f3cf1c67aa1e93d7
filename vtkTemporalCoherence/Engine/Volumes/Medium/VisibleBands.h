// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VisibleBands_h
#define TemporalCoherence_VisibleBands_h

#include "Scene/Blending.h"

#include <optional>
#include <vector>

namespace TemporalCoherence
{

/// The ranges of values with an opacity, ascending. Each contains its Low, but not its High.
std::vector<ValueBand> OpaqueBands(const TransferFunction& transfer);

/// The ranges of visible values, ascending; other values are transparent. Returns nullopt if every
/// value may be visible, or if there are several components.
std::optional<std::vector<ValueBand>> VisibleBands(const Blending& blending);

/// The range of visible extremes, in a mode of extremes; other extremes are transparent. The range
/// is infinite if several components have looks.
ValueBand VisibleExtremes(const Blending& blending);

}

#endif
