// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/Agreement.h"

#include "Checks/Expect.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <sstream>

std::string Agreement::Describe() const
{
  std::ostringstream text;
  text << this->Pixels << " pixels, " << this->Hits << " hits of both, " << this->DifferentHits
       << " differ, " << this->DistantHits << " beyond 1e-3 voxel, largest " << this->MaxDistance
       << " voxel";
  return text.str();
}

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
  scene.Mapper->ClearCache();
  if (!scene.Render(width, height))
  {
    Expect(false, what + ": not rendered");
    return;
  }
  const Agreement agreement = CompareWithTruth(scene, truth, stride);
  const std::string found = what + ": " + agreement.Describe();
  const bool isHeld = agreement.Holds() && agreement.Hits > 0;
  Expect(isHeld, found);
  if (isHeld)
  {
    std::cout << found << '\n';
  }
}
