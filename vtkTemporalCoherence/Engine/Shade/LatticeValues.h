// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LatticeValues_h
#define TemporalCoherence_LatticeValues_h

#include "Scene/ArrayLooks.h"
#include "Scene/Field.h"
#include "Scene/GridCoordinates.h"

#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// An array on an image or a rectilinear grid.
struct LatticeArray
{
  /// Fields with a sample at each point of the lattice, or in each cell, which are alike. Of
  /// several ones, the values are the lengths of vectors.
  std::vector<Field> Components;
  bool IsOfCells = false;   ///< a cell has one value; else the field interpolates between points
  IndexTransform Transform; ///< of the lattice, whose points lie at integers
  std::shared_ptr<const GridCoordinates> Grid; ///< of points that lie elsewhere; or null
};

/// Make the values of an array. Points beyond the lattice have the values at its boundary.
std::shared_ptr<const ArrayValues> MakeLatticeValues(const LatticeArray& array);

}

#endif
