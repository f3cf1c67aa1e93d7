// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCrossing_h
#define TemporalCoherence_KernelsCrossing_h

#include "RayBatch.h"

#include <array>

namespace TemporalCoherence
{

/// Rays that pass through cells, as arrays over passages. `Real` is what the field's samples are
/// computed in.
template <typename Real>
struct PassageBatch
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  int Count = 0;
  std::array<Array<double>, 3> Origin, Direction, Inverse; ///< of the ray, in index space
  Array<double> Begin, End;                                ///< of the ray
  std::array<Array<double>, 3> Cell;                       ///< its first corner
  std::array<Array<Real>, 8> Corners; ///< differences from the isovalue, [x + 2 y + 4 z]

  Array<double> Enter;    ///< found: t where the ray enters the cell
  Array<double> Distance; ///< found: t of the first crossing; infinity if there is none
  Array<Real> AtEntry;    ///< found: difference from the isovalue where the ray enters the cell
};

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
