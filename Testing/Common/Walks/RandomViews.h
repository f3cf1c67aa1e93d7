// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RandomViews_h
#define Testing_RandomViews_h

#include "Scenes/Scene.h"

#include <random>

/// A camera on a random path around and into a scene's volume: mostly small turns, now and then a
/// jump, another projection or another size of the picture. The same seed gives the same path.
class RandomViews
{
public:
  /// \param size of the smaller pictures, in pixels; others are up to 60 pixels larger
  RandomViews(Scene& scene, unsigned seed, int size);

  /// Move the camera, fit its clipping range, and render.
  bool RenderNext();

  /// Move the camera only.
  void Move();

  /// Change the size of the next pictures.
  void Resize();

  bool Render() { return this->Target.Render(this->Width, this->Height); }

  /// One of 0 ... n - 1.
  int Pick(int n) { return static_cast<int>(this->Engine() % static_cast<unsigned>(n)); }

  /// Between `low` and `high`, in a thousand steps.
  double Between(double low, double high) { return low + 1e-3 * this->Pick(1001) * (high - low); }

private:
  void Jump();
  void GoInside();
  void Pan();
  void ClipByNearPlane();

  Scene& Target;
  std::mt19937 Engine;
  int Smallest, Width, Height;
};

#endif
