// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RaySamples_h
#define TemporalCoherence_RaySamples_h

#include "Scene/FrameKey.h"
#include "Scene/RayBatch.h"
#include "Scene/TileHits.h"
#include "Volumes/Samples/ComponentSegment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{

/// Samples at a fixed distance, as VTK takes them: the first sample lies a step behind the ray's
/// entry, whatever cropping keeps.
class RaySamples
{
public:
  /// \param key outlives this
  explicit RaySamples(const FrameKey& key)
    : Key(key)
    , Step(key.Blended().SampleDistance)
  {
  }

  /// False if the picture is to converge instead.
  bool AreAsked() const { return this->Step > 0.0; }

  /// World distance between samples.
  double Distance() const { return this->Step; }

  /// The t from which samples are counted.
  double EntryOf(const RayBatch& rays, const WorldDirections& world, std::size_t ray) const
  {
    const glm::dvec3 direction(world[0][ray], world[1][ray], world[2][ray]);
    const View& view = this->Key.View;
    double entry = view.Near / glm::dot(direction, view.Forward);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double last = this->Key.Samples.Dimensions[static_cast<int>(a)] - 1;
      const double toFirst = (0.0 - rays.Origin[a][ray]) * rays.Inverse[a][ray];
      const double toLast = (last - rays.Origin[a][ray]) * rays.Inverse[a][ray];
      entry = std::max(entry, std::min(toFirst, toLast));
    }
    const glm::dvec3 inIndex(rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray]);
    const glm::dvec3 origin(this->Key.Transform.WorldFromIndex * glm::dvec4(inIndex, 1.0));
    for (const glm::dvec4& plane : this->Key.Region.Clips)
    {
      const glm::dvec3 normal(plane);
      const double slope = glm::dot(normal, direction);
      if (slope > 0.0)
      {
        entry = std::max(entry, -(glm::dot(normal, origin) + plane.w) / slope);
      }
    }
    return entry;
  }

  /// Call visit(share) for each sample in a segment.
  template <typename Visit>
  void ForEach(const ComponentSegment& segment, double entry, const Visit& visit) const
  {
    const double before = std::ceil((segment.Enter - entry) / this->Step);
    for (double count = std::max(before, 1.0);; ++count)
    {
      const double t = entry + count * this->Step;
      if (!(t < segment.Leave))
      {
        return;
      }
      visit(std::clamp((t - segment.Enter) / segment.Length(), 0.0, 1.0));
    }
  }

private:
  const FrameKey& Key;
  double Step;
};

}

#endif
