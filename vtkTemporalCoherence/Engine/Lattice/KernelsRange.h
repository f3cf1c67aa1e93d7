// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsRange_h
#define TemporalCoherence_KernelsRange_h

#include "Lattice/SegmentBatch.h"

namespace TemporalCoherence
{

/// The field along segments, as arrays over segments.
template <typename Real>
struct RangeBatch
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  Array<double> Leave;              ///< t where the ray leaves the cell
  std::array<Array<Real>, 4> Cubic; ///< Bernstein coefficients of the field from Enter to Leave
  Array<Real> Lowest, Highest;      ///< of the field from Enter to Leave
};

/// Find the lowest and the highest value of the field along each segment, and where the ray enters
/// and leaves the cell.
///
/// Uses the widest vectors of the machine. The results are bit-identical to those of CellSegment
/// and CellRoot.h.
void FindRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges);
void FindRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges);

/// FindRanges for nearest interpolation. Only the first and the last coefficient of the cubic have
/// a meaning: the values at the ends.
void FindNearestRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges);
void FindNearestRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges);

}

#endif
