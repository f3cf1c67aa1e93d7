// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Beams/CompositeTables.h"

namespace TemporalCoherence
{
namespace
{

/// Optical depth of the shortest edge of a cell where the opacity is 1.
constexpr double MostDepth = 65536.0;

/// Error of the optical depth per shortest edge of a cell on an arc, at most.
constexpr double ArcTolerance = 1.0 / 8192.0;

}

CompositeTables::CompositeTables(const ComponentLook& look, double shortest)
  : Look(look)
  , ShortestEdge(shortest)
  , Tables(look, MostDepth / shortest)
  , Arcs(Tables, ArcTolerance / shortest)
{
}

}
