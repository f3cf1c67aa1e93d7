// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SubdividedCells_h
#define TemporalCoherence_SubdividedCells_h

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
  int Parts = 1;            ///< of each edge of a curved cell
  std::int64_t Curved = 0;  ///< cells with an order of 2 or more
  std::int64_t Others = 0;  ///< polyhedra, prisms and convex sets of points
  double ErrorOfPoints = 0; ///< of the size of a curved cell
  double ErrorOfValues = 0; ///< of the range of values in it
};

/// What was made of a grid that has curved cells and no others to be replaced: for other values,
/// the linear cells stay.
struct KeptDivision
{
  CurvedCells Curved;
  Subdivision Told;
  CurvedPoints Points;
  std::shared_ptr<const MadeCells> Made; ///< without points; null: nothing is kept

  std::size_t MemoryInBytes() const;
};

/// The error that curved cells are divided for: of their size, and of the range of their values.
/// Where values hardly differ, it is of 1 % of the range of all cells.
constexpr double SubdivisionGoal = 1e-3;

/// Edges are divided into no more parts, and cells into no more cells (1.4 GiB).
constexpr int MostParts = 8;
constexpr std::int64_t MostSubdividedCells = std::int64_t(1) << 25;

/// True for types of cells that AppendSubdividedCells draws.
bool IsSubdivided(int type);

/// Make linear cells of the cells that have a volume, but are neither a tetrahedron, voxel,
/// hexahedron, wedge nor pyramid. Cells of all other types are ignored.
///
/// Cells with an order of 2 or more are divided; all edges into the same number of parts, so that
/// neighbours share all points. Polyhedra become pyramids and tetrahedra around their centre,
/// prisms become wedges around their axis, convex sets of points the tetrahedra that VTK makes of
/// them.
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
/// \return false if the values need another number of parts, nothing is kept, or it was stopped
/// \throws std::bad_alloc
bool SetSubdividedValues(vtkUnstructuredGrid* grid, vtkDataArray* pointScalars, int component,
  const ReportProgress& progress, KeptDivision& kept, MeshPart& part, bool& isStopped);

}

#endif
