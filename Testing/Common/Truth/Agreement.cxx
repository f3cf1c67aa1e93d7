// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/Agreement.h"

#include "Checks/Expect.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <sstream>

Agreement CompareWithTruth(const Scene& scene, const BruteForceTracer& truth, int stride)
{
  int dimensions[3];
  scene.Depth->GetDimensions(dimensions);
  // The camera computes its matrices on demand: once here, not in every thread.
  scene.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    static_cast<double>(dimensions[0]) / dimensions[1], -1.0, 1.0);
  Agreement sum;
  for (int y = 0; y < dimensions[1]; y += stride)
  {
    for (int x = 0; x < dimensions[0]; x += stride)
    {
      const BruteForceTracer::Hit hit =
        truth.Trace(scene.Renderer, x, y, dimensions[0], dimensions[1]);
      int isovalue = -1;
      scene.Mapper->PickPixel(x, y, nullptr, nullptr, &isovalue);
      ++sum.Pixels;
      if (isovalue != hit.Isovalue)
      {
        ++sum.DifferentHits;
      }
      else if (isovalue >= 0)
      {
        double position[3];
        scene.Mapper->PickPixel(x, y, position, nullptr, nullptr);
        // The depth image is in single precision; what is picked is not.
        const double rounding = 1e-7 * hit.Distance;
        const double inDepth = std::abs(static_cast<double>(scene.DepthAt(x, y)) - hit.Distance);
        const double inPosition =
          std::sqrt(vtkMath::Distance2BetweenPoints(position, hit.Position.data()));
        const double distance = std::max(inDepth - rounding, inPosition) / truth.Field.VoxelSize();
        ++sum.Hits;
        sum.DistantHits += distance > 1e-3;
        sum.MaxDistance = std::max(sum.MaxDistance, distance);
      }
    }
  }
  return sum;
}

void ExpectColdTruth(const std::string& what, Scene& scene, const BruteForceTracer& truth,
  int width, int height, int stride)
{
  scene.Mapper->ReleaseReuse();
  if (!scene.Render(width, height))
  {
    Expect(false, what + ": not rendered");
    return;
  }
  const Agreement agreement = CompareWithTruth(scene, truth, stride);
  std::ostringstream found;
  found << what << ": " << agreement.Pixels << " pixels, " << agreement.Hits << " hits of both, "
        << agreement.DifferentHits << " differ, " << agreement.DistantHits
        << " beyond 1e-3 voxel, largest " << agreement.MaxDistance << " voxel";
  const bool isHeld = agreement.Holds() && agreement.Hits > 0;
  Expect(isHeld, found.str());
  if (isHeld)
  {
    std::cout << found.str() << '\n';
  }
}
