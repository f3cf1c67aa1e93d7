// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DivisionError_h
#define TemporalCoherence_DivisionError_h

#include <algorithm>
#include <cstdint>
#include <string>

namespace TemporalCoherence
{

/// The reason why curved cells were not divided further. Of several reasons, the last in this list
/// counts.
enum class DivisionLimit
{
  Goal,  ///< none: SubdivisionGoal was reached
  Parts, ///< the limit of parts in one cell
  Cells, ///< the limit of all cells
  Memory ///< MakingBudget
};

/// Bounds of the errors of divided curved cells, and polyhedra that overlap others.
struct DivisionError
{
  double OfPoints = 0.0; ///< share of the diagonal of the curved cell
  double OfValues = 0.0; ///< share of the range of values in the cell, or of 1 % of the range in
                         ///< the grid; NaN if unknown
  DivisionLimit Limit = DivisionLimit::Goal;
  std::int64_t Overlapping = 0; ///< concave polyhedra that are drawn beyond their faces
  std::string Overlaps;         ///< names one of them

  /// Take the maximum of each error and limit; add up the overlaps.
  void Add(const DivisionError& other)
  {
    const auto largest = [](double a, double b) { return a >= b || a != a ? a : b; };
    this->OfPoints = largest(this->OfPoints, other.OfPoints);
    this->OfValues = largest(this->OfValues, other.OfValues);
    this->Limit = std::max(this->Limit, other.Limit);
    this->Overlapping += other.Overlapping;
    this->Overlaps = this->Overlaps.empty() ? other.Overlaps : this->Overlaps;
  }
};

}

#endif
