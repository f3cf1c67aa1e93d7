// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridCells_h
#define TemporalCoherence_GridCells_h

#include "Grids/GridLeaves.h"
#include "Grids/MadeFrom.h"
#include "Mesh/Mesh.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// What a data set has besides cells that a part of a mesh takes as they are.
struct CellCensus
{
  bool HasOthers = false; ///< such as quadratic cells and polyhedra: to be made of linear ones
};

/// The flags of cells that were made, as the data set's own do not serve; null if these do.
using MadeFlags = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Arrays of cells that were copied, as their numbers do not lie in memory as they are read.
using ArrayCopies = std::vector<vtkSmartPointer<vtkDataArray>>;

/// Note everything that tells which cells a data set has and which are hidden.
void NoteCells(const GridLeaf& leaf, MadeFrom& from);

/// Set the cells of a part, and which of them are hidden. Points and types of cells are read in
/// place where they lie in memory, also if all cells have one type or the same number of points.
/// Ghost arrays of cells hide those that are flagged as hidden, refined or duplicate, and ghost
/// arrays of points the cells around a hidden point. Missing cells are hidden, too. Cells that are
/// no tetrahedra, voxels, hexahedra, wedges or pyramids are left out.
///
/// \param missing see MissingCells.h
/// \param made    gets the flags if they had to be made
/// \param copies  gets the arrays that had to be copied; the part reads them
/// \param census  gets what there is
/// \param error   gets what is wrong and what to do about it
/// \return false on error
/// \throws std::bad_alloc
bool SetCells(const GridLeaf& leaf, const std::vector<std::uint8_t>& missing, MeshPart& part,
  MadeFlags& made, ArrayCopies& copies, CellCensus& census, std::string& error);

}

#endif
