// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlaceCheck_h
#define PlaceCheck_h

#include <vtkVector.h>

#include <array>
#include <string>

class vtkDataObject;
class vtkDataSet;

// Cameras are placed by the box of what is shown: it must be one that numbers can tell of.
// \param corner of the box
// \param edges from there
bool CanBeSeen(const vtkVector3d& corner, const std::array<vtkVector3d, 3>& edges);

// Remove arrays that have not a tuple for each point, or for each cell.
void RemoveUnfitting(vtkDataSet* set);

// A grid, or a composite of grids, whose arrays fit together. Arrays of values that do not are left
// out. Throws UserError.
// \param name for messages, between quotes
void CheckMesh(vtkDataObject* data, const std::string& name);

#endif
