// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsExtremes_h
#define TemporalCoherence_KernelsExtremes_h

#include "Lattice/TileBeam.h"
#include "Scene/GridCoordinates.h"
#include "Scene/RayBatch.h"
#include "Volumes/Projections/ExtremeBlocks.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Extremes of the rays of a beam so far, as arrays over the rays.
template <typename Real>
struct BeamExtremes
{
  RayBatch::Array<Real> Value;   ///< largest value, or minus infinity
  RayBatch::Array<double> First; ///< smallest t with this value, or infinity
  std::int64_t CellsRead = 0;
};

/// Input of the search of beams.
template <typename Real>
struct BeamSearch
{
  const ExtremeBlocks<Real>& Blocks;
  const CellMeeting<Real>* Meeting; ///< with nearest interpolation: searches cells; else null
  const GridCoordinates* Grid;      ///< where samples lie; null: at integers
  float Least;                      ///< smaller values need not be found
};

/// Update the largest values of some rays, one bit each. The result has the same bits as
/// ExtremeWalk.
/// \return false if these rays cannot form a beam
bool FindExtremes(const BeamSearch<float>& search, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<float>& found);
bool FindExtremes(const BeamSearch<double>& search, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<double>& found);

}

#endif
