// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SubdividedCells_h
#define TemporalCoherence_SubdividedCells_h

#include "Input/DivisionError.h"
#include "Mesh/Cells/Mesh.h"
#include "Shapes/CurvedDivision.h"
#include "Shapes/GivenCells.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Counts and errors of linear cells that replace other cells.
struct Subdivision
{
  int Parts = 1;           ///< largest number of parts of an edge of a curved cell
  std::int64_t Curved = 0; ///< cells with an order of 2 or more
  std::int64_t Others = 0; ///< polyhedra, prisms and convex sets of points
  DivisionError Error;
};

/// The division of a grid in which only curved cells are replaced. New values keep its linear
/// cells.
struct KeptDivision
{
  CurvedCells Curved;
  Subdivision Told;
  PartsOfCells Parts;
  CurvedPoints Points;
  std::shared_ptr<const MadeCells> Made; ///< without points; null: nothing is kept

  std::size_t MemoryInBytes() const;
};

/// Limits of the linear cells of a grid: 2^12 for each curved cell, but at least 2^20 and at most
/// 2^25 (2.4 GiB) in all. Undivided cells may exceed them. Without limits, a few cells with noisy
/// values would take all memory.
constexpr std::int64_t MostCellsOfEach = std::int64_t(1) << 12;
constexpr std::int64_t MostCellsOfFew = std::int64_t(1) << 20;
constexpr std::int64_t MostSubdividedCells = std::int64_t(1) << 25;

/// True for types of cells that AppendSubdividedCells draws.
bool IsSubdivided(int type);

/// Count the cells of order 2 or more. The grid may be null.
std::int64_t CountCurvedCells(vtkUnstructuredGrid* grid);

/// Make linear cells of the cells that have a volume, but are neither a tetrahedron, voxel,
/// hexahedron, wedge nor pyramid. Cells of all other types are ignored.
///
/// Cells of order 2 or more are divided as SubdivisionGoal demands, or less if the budget is too
/// small. Neighbours share all points of their faces and edges. A point between corners without a
/// finite value gets the interpolated value of the corners; a cell with a NaN corner is left out.
/// Polyhedra become pyramids and tetrahedra around their centre, or around several points if they
/// are concave, prisms become wedges around their axis, convex sets of points the tetrahedra that
/// VTK makes of them.
///
/// \param pointScalars a tuple for each point
/// \param component negative: the length of vectors
/// \param flags of each cell, or null. Cells with a hiding flag are left out.
/// \param parts gets one more part if there are such cells
/// \param error receives the mistake and its remedy; empty if the budget is too small, or if it was
///              stopped
/// \param kept  receives the input of SetSubdividedValues; may be null
/// \return false on error
/// \throws std::bad_alloc
bool AppendSubdividedCells(const GivenCells& given, vtkDataArray* pointScalars, int component,
  const std::uint8_t* flags, std::uint8_t hidingFlags, std::vector<MeshPart>& parts,
  std::string& error, Subdivision* told = nullptr, MakingBudget* budget = nullptr,
  KeptDivision* kept = nullptr);

/// Give the linear cells other values, in parallel.
/// \pre cells, flags and points of the grid have not changed since `kept` was made
/// \param part gets the same cells with other points
/// \param isStopped true if progress stopped it
/// \return false if the values need other numbers of parts, nothing is kept, or it was stopped
/// \throws std::bad_alloc
bool SetSubdividedValues(vtkUnstructuredGrid* grid, vtkDataArray* pointScalars, int component,
  const MakingBudget& budget, KeptDivision& kept, MeshPart& part, bool& isStopped);

}

#endif
