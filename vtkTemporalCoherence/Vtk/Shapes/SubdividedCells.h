// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SubdividedCells_h
#define TemporalCoherence_SubdividedCells_h

#include "Input/DivisionError.h"
#include "Mesh/Mesh.h"
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

/// What linear cells made of others differ by.
struct Subdivision
{
  int Parts = 1;            ///< of each edge of a curved cell, at most
  std::int64_t Curved = 0;  ///< cells with an order of 2 or more
  std::int64_t Others = 0;  ///< polyhedra, prisms and convex sets of points
  double ErrorOfPoints = 0; ///< of the size of a curved cell
  double ErrorOfValues = 0; ///< of the range of values in it; NaN: not known
  DivisionLimit Limit = DivisionLimit::Goal;
  std::int64_t Overlapping = 0; ///< of Others: not divided without leaving them
  std::string Overlaps;         ///< the first of these
};

/// What was made of a grid that has curved cells and no others to be replaced: for other values,
/// the linear cells stay.
struct KeptDivision
{
  CurvedCells Curved;
  Subdivision Told;
  PartsOfCells Parts;
  CurvedPoints Points;
  std::shared_ptr<const MadeCells> Made; ///< without points; null: nothing is kept

  std::size_t MemoryInBytes() const;
};

/// The curved cells of a grid are divided into no more cells than 2^12 each, but into up to 2^20
/// where there are few, and never into more than 2^25 (2.4 GiB), unless there are more of them.
/// Few cells whose values are noise would take all memory there is, too.
constexpr std::int64_t MostCellsOfEach = std::int64_t(1) << 12;
constexpr std::int64_t MostCellsOfFew = std::int64_t(1) << 20;
constexpr std::int64_t MostSubdividedCells = std::int64_t(1) << 25;

/// True for types of cells that AppendSubdividedCells draws.
bool IsSubdivided(int type);

/// The cells of a grid, which may be null, with an order of 2 or more.
std::int64_t CountCurvedCells(vtkUnstructuredGrid* grid);

/// Make linear cells of the cells that have a volume, but are neither a tetrahedron, voxel,
/// hexahedron, wedge nor pyramid. Cells of all other types are ignored.
///
/// Cells with an order of 2 or more are divided into as many parts as SubdivisionGoal needs, or
/// less if these are too many for the budget. Neighbours share all points of their faces and edges.
/// A point between corners without a finite value gets that between the corners; a cell with a
/// corner whose value is not a number is left out. Polyhedra become pyramids and tetrahedra around
/// their centre, or around several points if they are concave, prisms become wedges around their
/// axis, convex sets of points the tetrahedra that VTK makes of them.
///
/// \param pointScalars a tuple for each point
/// \param component negative: the length of vectors
/// \param flags of each cell, or null. Cells with a hiding flag are left out.
/// \param parts gets one more part if there are such cells
/// \param error gets what is wrong and what to do about it; empty if the budget does not do, or if
///              it was stopped
/// \param kept  gets what SetSubdividedValues needs; may be null
/// \return false on error
/// \throws std::bad_alloc
bool AppendSubdividedCells(const GivenCells& given, vtkDataArray* pointScalars, int component,
  const std::uint8_t* flags, std::uint8_t hidingFlags, std::vector<MeshPart>& parts,
  std::string& error, Subdivision* told = nullptr, MakingBudget* budget = nullptr,
  KeptDivision* kept = nullptr);

/// Give the linear cells other values, in parallel.
/// \pre   cells, flags and points of the grid are those of which `kept` was made
/// \param part gets the same cells with other points
/// \param isStopped true if progress stopped it
/// \return false if the values need other numbers of parts, nothing is kept, or it was stopped
/// \throws std::bad_alloc
bool SetSubdividedValues(vtkUnstructuredGrid* grid, vtkDataArray* pointScalars, int component,
  const MakingBudget& budget, KeptDivision& kept, MeshPart& part, bool& isStopped);

}

#endif
