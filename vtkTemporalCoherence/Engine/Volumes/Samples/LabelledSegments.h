// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelledSegments_h
#define TemporalCoherence_LabelledSegments_h

#include "Scene/Blending.h"
#include "Volumes/Samples/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Divide the segments of a source where the look of labels changes: half way between samples.
/// \param labels outlives the source that is made
/// \throws std::bad_alloc
std::unique_ptr<const SegmentSource> MakeLabelledSegments(
  const LabelMap& labels, std::unique_ptr<const SegmentSource> cells);

}

#endif
