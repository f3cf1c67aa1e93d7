// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeSearch_h
#define TemporalCoherence_ExtremeSearch_h

#include "Scene/Field.h"
#include "Scene/GridCoordinates.h"
#include "Scene/RayBatch.h"
#include "Volumes/Medium/BlendTracer.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// The extremes of one component along rays so far.
struct RayExtremes
{
  RayBatch::Array<double>& Value; ///< NaN: none
  RayBatch::Array<double>& First; ///< smallest t with this value, or infinity
  std::int64_t& CellsRead;        ///< cells whose eight samples were read
};

/// Finds the largest or the smallest value of one component along rays.
///
/// A cell counts for a ray if the cell is not hidden, all its samples are finite, and the ray
/// passes it, not only touches it, between Begin and End.
class ExtremeSearch
{
public:
  virtual ~ExtremeSearch() = default;
  ExtremeSearch(const ExtremeSearch&) = delete;
  ExtremeSearch& operator=(const ExtremeSearch&) = delete;

  /// Update the extremes by the values of rays from Begin to End. Thread-safe.
  virtual void Search(const RayBatch& rays, const RayExtremes& found) const = 0;

protected:
  ExtremeSearch() = default;
};

/// Input of a search.
struct ExtremeTask
{
  Field Samples;
  const ValueRangePyramid* Ranges; ///< of the samples; null: the search finds them
  const GridCoordinates* Grid;     ///< where samples lie; null: at integers
  bool IsMinimum;
  /// Bound of the visible extremes: smaller maxima, or larger minima, need not be found.
  double LeastSeen;
  bool ByBeams = true; ///< false: rays walk from cell to cell
};

/// Make the search for extremes in an image or a rectilinear grid.
/// \throws std::bad_alloc
std::unique_ptr<const ExtremeSearch> MakeExtremeSearch(const ExtremeTask& task);

/// Makes the search for a task; throws std::bad_alloc.
using ExtremeSearchMaker = std::unique_ptr<const ExtremeSearch> (*)(const ExtremeTask& task);

}

#endif
