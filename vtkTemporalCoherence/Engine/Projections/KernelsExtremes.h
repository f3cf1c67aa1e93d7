// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsExtremes_h
#define TemporalCoherence_KernelsExtremes_h

#include "Beams/TileBeam.h"
#include "Projections/ExtremeBlocks.h"
#include "Scene/GridCoordinates.h"
#include "Scene/RayBatch.h"

#include <cstdint>

namespace TemporalCoherence
{

/// What the rays of a beam have met so far, as arrays over them.
template <typename Real>
struct BeamExtremes
{
  RayBatch::Array<Real> Value;   ///< the largest, or minus infinity
  RayBatch::Array<double> First; ///< the smallest t at which it is taken, or infinity
  std::int64_t CellsRead = 0;
};

/// What beams search.
template <typename Real>
struct BeamSearch
{
  const ExtremeBlocks<Real>& Blocks;
  const CellMeeting<Real>* Meeting; ///< with nearest interpolation: searches cells; else null
  const GridCoordinates* Grid;      ///< where samples lie; null: at integers
  float Least;                      ///< values that are less need not be found
};

/// Widen the largest values by those that some rays, one bit each, meet: the same bits as
/// ExtremeWalk finds.
/// \return false if these rays cannot go as a beam
bool FindExtremes(const BeamSearch<float>& search, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<float>& found);
bool FindExtremes(const BeamSearch<double>& search, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<double>& found);

}

#endif
