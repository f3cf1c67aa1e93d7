// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsRange_h
#define TemporalCoherence_KernelsRange_h

#include "Trace/SegmentBatch.h"

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

/// Find the lowest and the highest value that the field has along each segment, and where the ray
/// enters and leaves the cell.
///
/// In vectors of the widest kind that the machine has, or one by one; the results are the same to
/// the last bit.
void FindRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges);
void FindRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges);

/// The same, one by one: the reference that the others are compared with.
void FindRangesOneByOne(SegmentBatch<float>& segments, RangeBatch<float>& ranges);
void FindRangesOneByOne(SegmentBatch<double>& segments, RangeBatch<double>& ranges);

/// The same for the value of the nearest sample instead of the trilinear interpolant. Of the
/// cubic only the first and the last coefficient mean something: the values at the ends.
void FindNearestRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges);
void FindNearestRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges);

}

#endif
