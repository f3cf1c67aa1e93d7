// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCrossing_h
#define TemporalCoherence_KernelsCrossing_h

#include "Trace/SegmentBatch.h"

namespace TemporalCoherence
{

/// Find the first crossing of zero along each segment, exactly (CellRoot.h).
///
/// In vectors of the widest kind that the machine has, or one by one; the results are the same to
/// the last bit.
/// \param isSolid a segment that begins inside (>= 0) crosses where it begins
void FindCrossings(SegmentBatch<float>& segments, bool isSolid);
void FindCrossings(SegmentBatch<double>& segments, bool isSolid);

/// The same, one by one: the reference that the others are compared with.
void FindCrossingsOneByOne(SegmentBatch<float>& segments, bool isSolid);
void FindCrossingsOneByOne(SegmentBatch<double>& segments, bool isSolid);

/// The same for the value of the nearest sample instead of the trilinear interpolant: crossings
/// are faces half way between samples.
void FindNearestCrossings(SegmentBatch<float>& segments);
void FindNearestCrossings(SegmentBatch<double>& segments);

}

#endif
