// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Disparity_h
#define TemporalCoherence_Disparity_h

namespace TemporalCoherence
{

/// *Disparity* tells how near a point is to the camera: 1 / depth in a perspective, -depth in a
/// parallel view. Along the image of a line it is affine in pixel coordinates, so that a walk over
/// pixels needs no division. Depth is the world distance along the optical axis.
inline double DisparityOf(double depth, bool isParallel)
{
  return isParallel ? -depth : 1.0 / depth;
}

inline double DepthOf(double disparity, bool isParallel)
{
  return isParallel ? -disparity : 1.0 / disparity;
}

/// The disparity of a miss: farther than everything, but finite.
inline double DisparityOfMiss(bool isParallel)
{
  return isParallel ? -1e30 : 0.0;
}

}

#endif
