// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshLeaves_h
#define TemporalCoherence_MeshLeaves_h

#include "Scene/Progress.h"
#include "Trees/MeshCheck.h"
#include "Trees/MeshEdges.h"
#include "Trees/MeshOrder.h"
#include "Trees/MeshReader.h"

#include <vector>

namespace TemporalCoherence
{

/// What the points of the cells of a tree tell.
struct MeshLeaves
{
  std::vector<PointBox> Boxes; ///< around each leaf
  PointBox Whole;              ///< around all of them
  EdgeLengths Edges;
};

/// Read the points of all cells of an order.
/// \param problem is set if a point is not finite, or if it was stopped
/// \throws std::bad_alloc
MeshLeaves ReadLeaves(const MeshReader& reader, const CellNumbers& order,
  const ReportProgress& progress, MeshProblem& problem);

}

#endif
