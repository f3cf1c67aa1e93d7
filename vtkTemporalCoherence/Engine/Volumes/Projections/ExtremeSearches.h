// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeSearches_h
#define TemporalCoherence_ExtremeSearches_h

#include "Volumes/Projections/ExtremeSearch.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the search for extremes in an image or a rectilinear grid.
/// \throws std::bad_alloc
std::unique_ptr<const ExtremeSearch> MakeExtremeSearch(const ExtremeTask& task);

}

#endif
