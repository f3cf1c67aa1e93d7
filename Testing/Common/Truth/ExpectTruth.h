// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ExpectTruth_h
#define Testing_ExpectTruth_h

#include <string>

class BruteForceTracer;
class Scene;

/// Compare the first surfaces of a scene's picture with brute force. At most one pixel may differ,
/// and at most one position by more than 1e-3 voxels.
/// \return pixels where both have a surface
int ExpectTruth(
  const std::string& name, Scene& scene, const BruteForceTracer& truth, int width, int height);

#endif
