// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeSearch_h
#define TemporalCoherence_ExtremeSearch_h

#include "Blending/BlendTracer.h"
#include "Scene/Field.h"
#include "Scene/GridCoordinates.h"
#include "Scene/RayBatch.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// The extremes of one component that rays have met so far.
struct RayExtremes
{
  RayBatch::Array<double>& Value; ///< NaN: none
  RayBatch::Array<double>& First; ///< the smallest t at which it is taken, or infinity
  std::int64_t& CellsRead;        ///< cells whose eight samples were read
};

/// Finds the largest or the smallest value of one component along rays.
///
/// A cell counts for a ray if it is neither hidden nor has a sample that is not finite, and if the
/// ray does more than touch it between its Begin and its End.
class ExtremeSearch
{
public:
  virtual ~ExtremeSearch() = default;
  ExtremeSearch(const ExtremeSearch&) = delete;
  ExtremeSearch& operator=(const ExtremeSearch&) = delete;

  /// Widen the extremes by what rays meet from Begin to End. Thread-safe.
  virtual void Search(const RayBatch& rays, const RayExtremes& found) const = 0;

protected:
  ExtremeSearch() = default;
};

/// What is searched.
struct ExtremeTask
{
  Field Samples;
  const ValueRangePyramid* Ranges; ///< of the samples; null: they are found
  const GridCoordinates* Grid;     ///< where samples lie; null: at integers
  bool IsMinimum;
  /// Extremes on this side of which nothing can be seen need not be found: smaller maxima, or
  /// larger minima.
  double LeastSeen;
  bool ByBeams = true; ///< false: rays walk from cell to cell
};

/// Makes the search for a task; throws std::bad_alloc.
using ExtremeSearchMaker = std::unique_ptr<const ExtremeSearch> (*)(const ExtremeTask& task);

}

#endif
