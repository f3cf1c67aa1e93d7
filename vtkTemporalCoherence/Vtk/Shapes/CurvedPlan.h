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

/// The error that curved cells are divided for: of their size, and of the range of their values.
/// Where values hardly differ, it is of 1 % of the range of all cells.
constexpr double SubdivisionGoal = 1e-3;

/// Into how many parts the edges of each curved cell are divided; 0: the cell is hidden.
using PartsOfCells = std::vector<std::uint16_t>;

/// Plans the division of curved cells.
///
/// Each cell is divided into as few parts as an error needs. Of several numbers of parts, each is a
/// multiple of the smaller ones, so that cells with different numbers can share faces
/// (CellDivider).
class CurvedPlan
{
public:
  explicit CurvedPlan(const CurvedSource& source);

  /// Measure how much the cells are bent.
  /// \return false if progress stopped it
  /// \throws std::bad_alloc
  bool Measure(const ReportProgress& progress);

  /// Choose parts for an error. Another one may be chosen later.
  /// \return the size of the cells before they are joined
  /// \throws std::bad_alloc
  DivisionSize Choose(double error);

  /// Join cells of different parts, so that they share all points of their faces and edges.
  /// \param size gets that of all cells
  /// \return false if progress stopped it
  /// \throws std::bad_alloc
  bool Join(const ReportProgress& progress, DivisionSize& size);

  /// What was chosen.
  const PartsOfCells& Parts() const { return this->Chosen; }

  /// The parts of a cell with those of its faces and edges. What `points` holds then is of no use.
  CellParts PartsOf(std::size_t number, vtkIdList* points) const;

  /// True if some cell does not stay whole.
  bool IsDivided() const { return this->LargestParts() > 1; }
  int LargestParts() const;

  /// Bounds of the errors that were reached. That of values is NaN if there is none: some cells
  /// have samples between corners that are not finite, or values whose range is not.
  CurvedError Error() const;

private:
  /// The error of a whole cell that would give the error of its parts, if that shrinks with the
  /// square of their number.
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
  std::vector<int> FirstParts; ///< of each kind: those that are measured first
  std::vector<Bend> Bends;     ///< of each cell
  std::vector<Bend> ConeBends; ///< if parts are cones; negative: not measured
  double RangeOfAll = 0.0;
  bool AreValuesBounded = true;
  PartsOfCells Chosen;
  double ChosenFor = SubdivisionGoal; ///< the error
  std::vector<int> Chain; ///< for each number of parts that an error needs: those to take
  BoundaryParts Boundary;
  std::vector<std::uint8_t> AreCones; ///< 1: parts of the cell are
  vtkNew<vtkIdList> Ids;
};

}

#endif
