// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CoarseField_h
#define TemporalCoherence_CoarseField_h

#include "Scene/KnownRanges.h"
#include "Scene/StandIn.h"
#include "VolumeFiles/VolumeFile.h"

#include <cstddef>
#include <memory>

namespace TemporalCoherence
{

/// Make a small field that stands in for a level of a volume: a coarser level of few samples if
/// there is one, else the middles of the value ranges of blocks.
/// \return null if the volume is too small for any
/// \throws std::bad_alloc
std::shared_ptr<const StandIn> MakeStandIn(
  const std::shared_ptr<const VolumeFile>& file, std::size_t level, const KnownRanges& ranges);

}

#endif
