// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HiddenPassage_h
#define TemporalCoherence_HiddenPassage_h

#include "Acceleration/HiddenCells.h"
#include "Trace/PassageBatch.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// True if the ray of a passage comes from a hidden cell and does not only touch this one.
/// \param enter t where it enters the cell
template <typename Real>
bool ComesFromHidden(
  const PassageBatch<Real>& passages, std::size_t i, double enter, const HiddenCells& hidden)
{
  // Through an edge or a corner it comes from the cell opposite.
  double leave = passages.EndOf()[i];
  glm::ivec3 before;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const bool isAhead = passages.DirectionOf(a)[i] > 0.0;
    const double cell = passages.Cell[a][i];
    const auto pass = [&](double plane)
    { return (plane - passages.OriginOf(a)[i]) * passages.InverseOf(a)[i]; };
    const bool isEntry = pass(isAhead ? cell : cell + 1.0) == enter;
    leave = std::min(leave, pass(isAhead ? cell + 1.0 : cell));
    before[static_cast<int>(a)] = static_cast<int>(cell) + (isEntry ? (isAhead ? -1 : 1) : 0);
  }
  return enter < leave && hidden.IsHidden(before);
}

}

#endif
