// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCrossing_h
#define TemporalCoherence_KernelsCrossing_h

#include "Lattice/SegmentBatch.h"

namespace TemporalCoherence
{

/// Find the first crossing of zero along each segment, exactly (CellRoot.h).
///
/// Uses the widest vectors of the machine. The results are bit-identical to those of
/// FindCrossingsOneByOne.
/// \param isSolid a segment that begins inside (>= 0) crosses where it begins
void FindCrossings(SegmentBatch<float>& segments, bool isSolid);
void FindCrossings(SegmentBatch<double>& segments, bool isSolid);

/// Find crossings in rectilinear cells, from Cell to Last of the segments. The results are
/// bit-identical to those of RectilinearSegment.
/// \pre arrays are set up to the end of the last vector
void FindCrossingsInBoxes(SegmentBatch<double>& segments, bool isSolid);

/// Find the first crossings one by one, as FindCrossings does with few segments.
void FindCrossingsOneByOne(SegmentBatch<float>& segments, bool isSolid);
void FindCrossingsOneByOne(SegmentBatch<double>& segments, bool isSolid);

/// Find the first crossings with nearest interpolation: the faces half way between samples.
void FindNearestCrossings(SegmentBatch<float>& segments);
void FindNearestCrossings(SegmentBatch<double>& segments);

}

#endif
