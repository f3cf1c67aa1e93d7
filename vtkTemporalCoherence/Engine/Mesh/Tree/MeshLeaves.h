// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshLeaves_h
#define TemporalCoherence_MeshLeaves_h

#include "Mesh/Tree/MeshCheck.h"
#include "Mesh/Tree/MeshEdges.h"
#include "Mesh/Tree/MeshOrder.h"
#include "Mesh/Tree/MeshReader.h"
#include "Scene/Progress.h"

#include <vector>

namespace TemporalCoherence
{

/// Bounding boxes and edge lengths of the cells of a tree.
struct MeshLeaves
{
  std::vector<PointBox> Boxes; ///< around each leaf
  PointBox Whole;              ///< around all of them
  EdgeLengths Edges;
  bool HasVolume = false; ///< false if the points of each cell lie in a plane
};

/// Read the points of all cells of an order.
/// \param problem is set if a point is not finite, or if it was stopped
/// \throws std::bad_alloc
MeshLeaves ReadLeaves(const MeshReader& reader, const CellNumbers& order,
  const ReportProgress& progress, MeshProblem& problem);

}

#endif
