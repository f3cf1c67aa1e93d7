// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridPoints_h
#define TemporalCoherence_GridPoints_h

#include "Grids/GridLeaves.h"
#include "Grids/MadeFrom.h"
#include "Mesh/Mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Points that were made, as images and rectilinear grids have none in memory: x, y and z of each;
/// null if the data set has its points.
using MadePoints = std::shared_ptr<const std::vector<double>>;

/// Note everything that tells where points lie.
void NotePoints(const GridLeaf& leaf, MadeFrom& from);

/// Set the points of a part, in place if the data set has them in memory.
/// \param made  gets the points if they had to be made
/// \param error gets what is wrong and what to do about it
/// \return false on error
/// \throws std::bad_alloc
bool SetPoints(const GridLeaf& leaf, MeshPart& part, MadePoints& made, std::string& error);

}

#endif
