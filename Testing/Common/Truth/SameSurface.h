// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_SameSurface_h
#define Testing_SameSurface_h

#include "Checks/Expect.h"
#include "Scenes/Scene.h"

#include <algorithm>
#include <cmath>
#include <string>

/// Draw two scenes with the same surface, made of fields of different kinds: all but a few pixels
/// at silhouettes hit or miss it alike, and at equal depths.
/// \param tolerance of depths, as a share of the largest one
inline void ExpectSameSurface(
  const std::string& name, Scene& scene, Scene& truth, double tolerance = 1e-6)
{
  constexpr int Size = 90;
  if (!scene.Render(Size, Size) || !truth.Render(Size, Size))
  {
    Expect(false, name + ": not rendered");
    return;
  }
  int hits = 0, edges = 0;
  double farthest = 0.0, longest = 0.0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const double here = static_cast<double>(scene.DepthAt(pixel % Size, pixel / Size));
    const double there = static_cast<double>(truth.DepthAt(pixel % Size, pixel / Size));
    hits += std::isfinite(there);
    edges += std::isfinite(here) != std::isfinite(there);
    if (std::isfinite(here) && std::isfinite(there))
    {
      // A ray that touches a fold may pass it in one scene only.
      const bool isFold = std::abs(here - there) > 1e-2 * there;
      edges += isFold;
      farthest = std::max(farthest, isFold ? 0.0 : std::abs(here - there));
      longest = std::max(longest, there);
    }
  }
  Expect(hits > Size * Size / 50, name + ": only " + std::to_string(hits) + " hits");
  Expect(edges <= Size * Size / 1000,
    name + ": " + std::to_string(edges) + " pixels hit one surface only");
  Expect(
    farthest <= tolerance * longest, name + ": " + std::to_string(farthest / longest) + " apart");
}

#endif
