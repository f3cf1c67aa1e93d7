// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeSearches_h
#define TemporalCoherence_ExtremeSearches_h

#include "Projections/ExtremeSearch.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the search for extremes in a field of samples at the corners of boxes.
/// \throws std::bad_alloc
std::unique_ptr<const ExtremeSearch> MakeExtremeSearch(const ExtremeTask& task);

}

#endif
