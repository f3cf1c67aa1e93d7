// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewPoster_h
#define TemporalCoherence_ViewPoster_h

#include "Scene/Frame.h"
#include "ViewFile/ViewDescription.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A frame over the background of a look, as a PNG file: what a page shows while it opens.
/// \return nothing if the file cannot be made
std::vector<std::uint8_t> PosterOf(const Frame& frame, const ViewLook& look);

}

#endif
