// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridValues_h
#define TemporalCoherence_GridValues_h

#include "Grids/GridLeaves.h"
#include "Grids/MadeFrom.h"
#include "Mesh/Cells/Mesh.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <string>

namespace TemporalCoherence
{

/// The array whose component has a value for each point of a data set.
struct PointValues
{
  vtkSmartPointer<vtkDataArray> Array;
  int Component = 0;
};

/// Note all arrays and numbers that define the values at points.
void NoteValues(const GridLeaf& leaf, const DrawnComponent& component, MadeFrom& from);

/// Set the values of a part. A component of a point array is read in place. Lengths of vectors are
/// computed. Values of cells are averaged as by vtkCellDataToPointData: a point gets the mean of
/// the surrounding cells with volume and a value, except hidden and refined cells. Duplicates
/// count, so that parts of distributed data have equal values at the points that they share.
///
/// \pre   the part has its cells, and the array of the leaf is in place
/// \param error receives the mistake and its remedy
/// \return false on error
/// \throws std::bad_alloc
bool SetValues(const GridLeaf& leaf, const DrawnComponent& component, MeshPart& part,
  PointValues& values, std::string& error);

}

#endif
