// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VisibleComponents_h
#define TemporalCoherence_VisibleComponents_h

#include "Scene/Blending.h"
#include "Scene/Surfaces.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace TemporalCoherence
{

/// Ranges of values of a component that can be seen.
struct SeenBands
{
  std::size_t Component = 0;
  std::vector<ValueBand> Bands;
  bool HasLabels = false;       ///< Bands count for some labels only
  std::vector<double> CountFor; ///< these, ascending
};

/// The visible values of each component, as by VisibleBands. The first entry is that of component 0
/// for all labels. None if all cells may be visible.
std::optional<std::vector<SeenBands>> VisibleComponents(const Blending& volume);

}

#endif
