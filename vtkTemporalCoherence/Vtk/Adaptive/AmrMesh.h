// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrMesh_h
#define TemporalCoherence_AmrMesh_h

#include "Adaptive/AmrGrids.h"
#include "Input/ScalarChoice.h"
#include "Mesh/Cells/Mesh.h"
#include "Shapes/MadeCells.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace TemporalCoherence
{

/// True if no more than one level of an adaptive grid has cells: then it is drawn as blocks of one
/// lattice (MergedBlocks).
bool HasOneLevel(AdaptiveGrid* amr);

/// The blocks of all levels: the grids themselves, not copies.
vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(AdaptiveGrid* amr);

/// Make hexahedra between the values of cells of an adaptive grid, which lie at the centres of the
/// cells.
///
/// For each vertex of the cells that are not refined, the cells in the eight octants around it make
/// a hexahedron; a cell that fills several octants is repeated. So hexahedra share faces also
/// between levels, and no value is resampled. Vertices with an octant that lacks a visible cell get
/// no hexahedron.
///
/// \param component negative: the length of vectors
/// \param parts gets one more part
/// \param error receives the mistake and its remedy; empty if the budget is too small, or if it was
///              stopped
/// \return false on error
/// \throws std::bad_alloc
bool AppendAmrMesh(AdaptiveGrid* amr, const ScalarChoice& choice, int component,
  std::vector<MeshPart>& parts, std::string& error, MakingBudget* budget = nullptr);

}

#endif
