// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedPlan_h
#define TemporalCoherence_CurvedPlan_h

#include "Scene/Progress.h"
#include "Shapes/BoundaryParts.h"
#include "Shapes/CellDivision.h"
#include "Shapes/CurvedCellReader.h"
#include "Shapes/CurvedError.h"

#include <vtkIdList.h>
#include <vtkNew.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Target error of divided cells, as a share of their size and of the range of their values. A
/// range of less than 1 % of the range of all cells counts as 1 %.
constexpr double SubdivisionGoal = 1e-3;

/// Into how many parts the edges of each curved cell are divided; 0: the cell is hidden.
using PartsOfCells = std::vector<std::uint16_t>;

/// Plans the division of curved cells.
///
/// Each cell is divided into as few parts as an error demands. Each number of parts in use is a
/// multiple of all smaller ones, so that cells with different numbers can share faces
/// (CellDivider).
class CurvedPlan
{
public:
  explicit CurvedPlan(const CurvedSource& source);

  /// Measure how much the cells are bent.
  /// \return false if progress stopped it
  /// \throws std::bad_alloc
  bool Measure(const ReportProgress& progress);

  /// Choose parts for an error. May be called again with another error.
  /// \return the size of the cells before they are joined
  /// \throws std::bad_alloc
  DivisionSize Choose(double error);

  /// Join cells of different parts, so that they share all points of their faces and edges.
  /// \param size receives the size of all cells
  /// \return false if progress stopped it
  /// \throws std::bad_alloc
  bool Join(const ReportProgress& progress, DivisionSize& size);

  /// The chosen numbers of parts.
  const PartsOfCells& Parts() const { return this->Chosen; }

  /// The numbers of parts of a cell, its faces and its edges. `points` is scratch memory.
  CellParts PartsOf(std::size_t number, vtkIdList* points) const;

  /// True if any cell is divided.
  bool IsDivided() const { return this->LargestParts() > 1; }
  int LargestParts() const;

  /// Bounds of the errors. The error of values is NaN without a bound: if samples between corners
  /// or ranges of values are not finite.
  CurvedError Error() const;

private:
  /// Extrapolated error of the undivided cell: the error of its parts, times the square of their
  /// number.
  struct Bend
  {
    float OfPoints = 0.0f, OfValues = 0.0f;
    float Largest() const { return OfPoints > OfValues ? OfPoints : OfValues; }
  };

  bool MeasureFurther(const ReportProgress& progress);
  Bend BendOf(const CellError& error, int parts) const;
  void ChooseChain();
  int PartsFor(std::size_t number, const Bend& bend, double error) const;
  int ChainFor(std::size_t number, const Bend& bend) const;
  DivisionSize Size() const;
  bool AreAlike() const;
  std::vector<std::size_t> FindCones();
  bool MeasureCones(const std::vector<std::size_t>& cones, const ReportProgress& progress);
  void AddToBoundary(std::size_t number);
  /// Call `visit(number, list)` for each cell, in parallel, with a list of points to use.
  template <typename Visit>
  void ForEachCell(const Visit& visit) const;
  CellParts BoundaryOf(std::size_t number, vtkIdList* points) const;

  const CurvedSource& Source;
  std::vector<int> FirstParts; ///< first measured numbers of parts, by kind
  std::vector<Bend> Bends;     ///< of each cell
  std::vector<Bend> ConeBends; ///< of cells whose parts are cones; negative: not measured
  double RangeOfAll = 0.0;
  bool AreValuesBounded = true;
  PartsOfCells Chosen;
  double ChosenFor = SubdivisionGoal; ///< the error
  std::vector<int> Chain; ///< numbers of parts to take, by the number that an error demands
  BoundaryParts Boundary;
  std::vector<std::uint8_t> AreCones; ///< 1 for each cell whose parts are cones
  vtkNew<vtkIdList> Ids;
};

}

#endif
