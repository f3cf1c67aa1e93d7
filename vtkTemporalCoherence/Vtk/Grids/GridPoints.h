// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridPoints_h
#define TemporalCoherence_GridPoints_h

#include "Grids/GridLeaves.h"
#include "Grids/MadeFrom.h"
#include "Mesh/Cells/Mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Computed points, for images and rectilinear grids, which have none in memory: x, y and z of
/// each. Null if the data set has its points.
using MadePoints = std::shared_ptr<const std::vector<double>>;

/// Note all arrays and numbers that define the places of points.
void NotePoints(const GridLeaf& leaf, MadeFrom& from);

/// Set the points of a part, in place if the data set has them in memory.
/// \param made  receives the points if they are computed
/// \param error receives the mistake and its remedy
/// \return false on error
/// \throws std::bad_alloc
bool SetPoints(const GridLeaf& leaf, MeshPart& part, MadePoints& made, std::string& error);

}

#endif
