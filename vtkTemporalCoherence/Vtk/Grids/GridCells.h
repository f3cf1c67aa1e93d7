// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridCells_h
#define TemporalCoherence_GridCells_h

#include "Grids/GridLeaves.h"
#include "Grids/MadeFrom.h"
#include "Mesh/Cells/Mesh.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Cells of a data set that a part of a mesh cannot take as they are.
struct CellCensus
{
  bool HasOthers = false; ///< such as quadratic cells and polyhedra: linear cells replace them
};

/// Combined flags of cells; null if the data set's own flags suffice.
using MadeFlags = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Copies of arrays of cells whose numbers cannot be read in place.
using ArrayCopies = std::vector<vtkSmartPointer<vtkDataArray>>;

/// Note all arrays and numbers that define the cells of a data set, and the hidden ones.
void NoteCells(const GridLeaf& leaf, MadeFrom& from);

/// Find the cells whose own values are NaN. They are hidden like flagged cells.
/// \param missing receives 1 for these cells and 0 for others; empty without such cells, or if
///                values lie at points
/// \throws std::bad_alloc
void FindMissingCells(
  const GridLeaf& leaf, const DrawnComponent& component, std::vector<std::uint8_t>& missing);

/// Set the cells of a part, and flags that hide some. Points and types of cells are read in place
/// where they lie in memory, also if all cells have one type or the same number of points. Ghost
/// arrays of cells hide those that are flagged as hidden, refined or duplicate, and ghost arrays of
/// points the cells around a hidden point. Missing cells are hidden, too. Cells other than
/// tetrahedra, voxels, hexahedra, wedges and pyramids are left out.
///
/// \param missing see FindMissingCells
/// \param made    receives the combined flags, if they are needed
/// \param copies  receives the copied arrays, which the part reads
/// \param census  receives the kinds of left-out cells
/// \param error   receives the mistake and its remedy
/// \return false on error
/// \throws std::bad_alloc
bool SetCells(const GridLeaf& leaf, const std::vector<std::uint8_t>& missing, MeshPart& part,
  MadeFlags& made, ArrayCopies& copies, CellCensus& census, std::string& error);

}

#endif
