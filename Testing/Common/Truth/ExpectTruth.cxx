// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/ExpectTruth.h"

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceRegion.h"
#include "Truth/BruteForceTracer.h"

#include <vtkMath.h>

#include <array>
#include <cmath>

int ExpectTruth(
  const std::string& name, Scene& scene, const BruteForceTracer& truth, int width, int height)
{
  const BruteForceRegion kept(scene.Mapper, scene.Volume);
  Expect(scene.Render(width, height), name + ": rendered");
  int wrong = 0, distant = 0, hits = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const BruteForceTracer::Hit hit =
        kept.Trace(truth, BruteForceTracer::LineThrough(scene.Renderer, x, y, width, height));
      std::array<double, 3> position;
      int isovalue = -1;
      scene.Mapper->PickPixel(x, y, position.data(), nullptr, &isovalue);
      wrong += isovalue != hit.Isovalue;
      if (isovalue >= 0 && hit.Isovalue >= 0)
      {
        ++hits;
        const double apart =
          std::sqrt(vtkMath::Distance2BetweenPoints(position.data(), hit.Position.data()));
        distant += apart > 1e-3 * truth.Field.VoxelSize();
      }
    }
  }
  Expect(wrong <= 1 && distant <= 1,
    name + ": " + std::to_string(wrong) + " pixels and " + std::to_string(distant) +
      " depths differ from the truth of " + std::to_string(hits) + " hits");
  return hits;
}
