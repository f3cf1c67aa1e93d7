// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Disparity_h
#define TemporalCoherence_Disparity_h

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

/// Disparity of what is farther than everything, and still a number to compute with.
inline double DisparityOfMiss(bool isParallel)
{
  return isParallel ? -1e30 : 0.0;
}

}

#endif
