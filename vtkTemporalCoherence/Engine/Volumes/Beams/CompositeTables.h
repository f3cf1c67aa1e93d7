// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CompositeTables_h
#define TemporalCoherence_CompositeTables_h

#include "Volumes/Beams/EmissionArcs.h"
#include "Volumes/Medium/TransferTables.h"

#include <memory>

namespace TemporalCoherence
{

/// The tables of a composite volume. They depend on its look and its cells, not on the view, and
/// take as long as some thousand rays: later frames use them again.
struct CompositeTables
{
  /// \param shortest edge of a cell in the world
  /// \throws std::bad_alloc
  CompositeTables(const ComponentLook& look, double shortest);

  bool AreOf(const ComponentLook& look, double shortest) const
  {
    return this->Look == look && this->ShortestEdge == shortest;
  }

  const ComponentLook Look;
  const double ShortestEdge;
  const TransferTables Tables;
  const EmissionArcs Arcs;
};

/// Tables of an earlier frame; null if there are none.
using KeptTables = std::shared_ptr<const CompositeTables>;

}

#endif
