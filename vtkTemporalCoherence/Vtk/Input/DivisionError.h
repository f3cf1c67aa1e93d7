// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DivisionError_h
#define TemporalCoherence_DivisionError_h

#include <algorithm>
#include <cstdint>
#include <string>

namespace TemporalCoherence
{

/// What kept curved cells from being divided further. Of several limits the last one is told.
enum class DivisionLimit
{
  Goal,  ///< SubdivisionGoal: nothing
  Parts, ///< the most parts of one cell
  Cells, ///< the most cells that there may be
  Memory ///< MakingBudget
};

/// Bounds of what linear cells made of curved ones differ by, and polyhedra that overlap others.
struct DivisionError
{
  double OfPoints = 0.0; ///< in parts of the diagonal of the curved cell
  double OfValues = 0.0; ///< in parts of the range of values in it, or of 1 % of that in the grid;
                         ///< NaN where it is not known
  DivisionLimit Limit = DivisionLimit::Goal;
  std::int64_t Overlapping = 0; ///< concave polyhedra that were not divided without leaving them
  std::string Overlaps;         ///< names one of them

  /// Take the larger of each.
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
