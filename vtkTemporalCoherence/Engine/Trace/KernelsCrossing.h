// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCrossing_h
#define TemporalCoherence_KernelsCrossing_h

#include "Trace/PassageBatch.h"

namespace TemporalCoherence
{

/// Find the first crossing of zero along each passage, exactly (CellRoot.h).
///
/// In vectors of the widest kind that the machine has, or one by one; the results are the same to
/// the last bit.
/// \param isSolid a passage that begins inside (>= 0) crosses where it begins
void FindCrossings(PassageBatch<float>& passages, bool isSolid);
void FindCrossings(PassageBatch<double>& passages, bool isSolid);

/// The same, one by one: the reference that the others are held against.
void FindCrossingsOneByOne(PassageBatch<float>& passages, bool isSolid);
void FindCrossingsOneByOne(PassageBatch<double>& passages, bool isSolid);

/// The same for the value of the nearest sample instead of the trilinear interpolant: crossings
/// are faces half way between samples.
void FindNearestCrossings(PassageBatch<float>& passages);
void FindNearestCrossings(PassageBatch<double>& passages);

}

#endif
