// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HiddenSegment_h
#define TemporalCoherence_HiddenSegment_h

#include "Lattice/SegmentBatch.h"
#include "Scene/HiddenCells.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// True if the ray of a segment comes from a hidden cell and does more than touch this one.
/// \param enter t where it enters the cell
template <typename Real>
bool ComesFromHidden(
  const SegmentBatch<Real>& segments, std::size_t i, double enter, const HiddenCells& hidden)
{
  // Through an edge or a corner the ray comes from the opposite cell.
  double leave = segments.EndOf()[i];
  glm::ivec3 before;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const bool isAhead = segments.DirectionOf(a)[i] > 0.0;
    const double cell = segments.Cell[a][i];
    const auto pass = [&](double plane)
    { return (plane - segments.OriginOf(a)[i]) * segments.InverseOf(a)[i]; };
    const bool isEntry = pass(isAhead ? cell : cell + 1.0) == enter;
    leave = std::min(leave, pass(isAhead ? cell + 1.0 : cell));
    before[static_cast<int>(a)] = static_cast<int>(cell) + (isEntry ? (isAhead ? -1 : 1) : 0);
  }
  return enter < leave && hidden.IsHidden(before);
}

}

#endif
