// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/LayerMerge.h"

#include "Scene/HitOrder.h"
#include "Scene/LayerBatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

void MergeLayers(const PixelRect& part, int width, const std::vector<double>& isovalues,
  std::vector<LayerHit>& layers)
{
  // Lay the layers of each pixel side by side.
  RayBatch::Array<std::uint32_t> first{}, count{};
  for (const LayerHit& hit : layers)
  {
    ++count[PlaceInTile(part, width, hit.Pixel)];
  }
  std::uint32_t end = 0;
  for (std::size_t place = 0; place < count.size(); ++place)
  {
    first[place] = end;
    end += count[place];
  }
  std::vector<LayerHit> ofPixels(layers.size());
  count = {};
  for (const LayerHit& hit : layers)
  {
    const std::size_t place = PlaceInTile(part, width, hit.Pixel);
    ofPixels[first[place] + count[place]++] = hit;
  }

  // Order those of each pixel. Of two that are equal, none is in front of the other.
  const auto isInFront = [&](const LayerHit& a, const LayerHit& b)
  {
    const auto surfaceOf = [&](const LayerHit& hit) {
      return MetSurface{ hit.Depth, hit.Kind, isovalues[static_cast<std::size_t>(hit.Isovalue)] };
    };
    return IsInFront(surfaceOf(a), surfaceOf(b));
  };
  std::uint64_t left = 0;
  for (std::size_t place = 0; place < count.size(); ++place)
  {
    LayerHit* const begin = ofPixels.data() + first[place];
    std::sort(begin, begin + count[place], isInFront);
    LayerHit* const behind = std::unique(begin, begin + count[place],
      [&](const LayerHit& a, const LayerHit& b) { return !isInFront(a, b); });
    count[place] = static_cast<std::uint32_t>(behind - begin);
    left |= static_cast<std::uint64_t>(count[place] > 0) << place;
  }

  // Take the first layers of all pixels, then the second ones.
  layers.clear();
  for (std::uint32_t round = 0; left != 0; ++round)
  {
    ForEachRay(left,
      [&](std::size_t place)
      {
        layers.push_back(ofPixels[first[place] + round]);
        left &= ~(static_cast<std::uint64_t>(round + 1 == count[place]) << place);
      });
  }
}

}
