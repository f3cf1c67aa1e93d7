// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CachedDepths_h
#define TemporalCoherence_CachedDepths_h

#include "Frame.h"
#include "View.h"

#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// *Disparity*: how near a point is to a view's camera, in a form that is affine in pixel
/// coordinates along the picture of a line, so that a walk over pixels needs no division: for a
/// perspective 1 / depth, for a parallel view -depth. Depth is the world distance along the optical
/// axis.
inline double DisparityOf(double depth, bool isParallel)
{
  return isParallel ? -depth : 1.0 / depth;
}

inline double DepthOf(double disparity, bool isParallel)
{
  return isParallel ? -disparity : 1.0 / disparity;
}

/// Disparity of what is farther than everything.
inline double DisparityOfMiss(bool isParallel)
{
  return isParallel ? -std::numeric_limits<double>::infinity() : 0.0;
}

/// How much of a picture is believed.
struct GuardOptions
{
  double Margin = 0.0; ///< surfaces are taken to be so much nearer; world units
  double FarthestDepth = std::numeric_limits<double>::infinity(); ///< nothing is known behind
  bool OnlyEntered = false; ///< nothing is known where the surface was not met from outside

  bool operator==(const GuardOptions& other) const
  {
    return this->Margin == other.Margin && this->FarthestDepth == other.FarthestDepth &&
      this->OnlyEntered == other.OnlyEntered;
  }
};

/// The depths of a finished picture as queries walk over them: one disparity a pixel, in the order
/// of the frame's planes.
struct CachedDepths
{
  std::vector<float> Surface; ///< of the surface seen in the pixel
  std::vector<float> Guard;   ///< space with a higher disparity is free of surfaces
  bool HasSurface = false;
  bool HasGuard = false;
  GuardOptions Guarded; ///< what Guard was made with

  /// Forget both; their memory is kept.
  void Clear() { this->HasSurface = this->HasGuard = false; }
};

/// Fill depths.Surface.
/// \throws std::bad_alloc
void MakeSurfaceDepths(const Frame& frame, const View& view, CachedDepths& depths);

/// Fill depths.Guard. At edges it is the nearest surface of the pixel and its eight neighbours,
/// moved nearer by the margin. Where the nine are one smooth surface, it is the nearest point that
/// this surface has within the pixel, moved nearer by an eighth of the margin.
/// \pre depths.HasSurface
/// \throws std::bad_alloc
void MakeGuardDepths(
  const Frame& frame, const View& view, const GuardOptions& options, CachedDepths& depths);

}

#endif
