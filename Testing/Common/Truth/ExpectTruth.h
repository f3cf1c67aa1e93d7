// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ExpectTruth_h
#define Testing_ExpectTruth_h

#include <string>

class BruteForceTracer;
class Scene;

/// Compare what is seen first in a scene's picture with brute force, whose surfaces are those of
/// the scene: all pixels but one, and all but one of the places to 1e-3 voxel.
/// \return pixels where both see a surface
int ExpectTruth(
  const std::string& name, Scene& scene, const BruteForceTracer& truth, int width, int height);

#endif
