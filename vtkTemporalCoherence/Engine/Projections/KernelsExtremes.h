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

/// Widen the largest values by those that some rays, one bit each, meet: the same bits as
/// ExtremeWalk finds.
/// \param meeting with nearest interpolation: searches cells; null: interpolation is linear
/// \param grid    where samples lie; null: at integers
/// \return false if these rays cannot go as a beam
bool FindExtremes(const ExtremeBlocks<float>& blocks, const CellMeeting<float>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<float>& found);
bool FindExtremes(const ExtremeBlocks<double>& blocks, const CellMeeting<double>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<double>& found);

}

#endif
