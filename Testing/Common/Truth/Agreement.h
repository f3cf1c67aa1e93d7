// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Agreement_h
#define Testing_Agreement_h

#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"

#include <string>

/// How a picture compares with the truth.
struct Agreement
{
  long Pixels = 0;
  long Hits = 0;          ///< of both
  long DifferentHits = 0; ///< a hit here, a miss there, or another isovalue
  long DistantHits = 0;   ///< hits of both that are more than 1e-3 voxel apart
  double MaxDistance = 0; ///< voxels

  /// The contract of a cold frame: hit or miss agrees for 99.99 % of the pixels, depths for 99.9 %
  /// of the hits.
  bool Holds() const
  {
    return 1e4 * static_cast<double>(DifferentHits) <= static_cast<double>(Pixels) &&
      1e3 * static_cast<double>(DistantHits) <= static_cast<double>(Hits);
  }

  std::string Describe() const;
};

/// Hold the last picture of a scene against brute force, every `stride`-th pixel of every
/// `stride`-th row.
Agreement CompareWithTruth(const Scene& scene, const BruteForceTracer& truth, int stride = 1);

/// Render a cold frame, tell how it compares, and expect that the contract holds and something is
/// hit.
void ExpectColdTruth(const std::string& what, Scene& scene, const BruteForceTracer& truth,
  int width, int height, int stride = 1);

#endif
