// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileLoop_h
#define TemporalCoherence_TileLoop_h

#include "Render/FrameStatistics.h"
#include "Scene/FramePlanes.h"
#include "Scene/Parallel.h"
#include "Scene/Stopwatch.h"
#include "Scene/TileTimer.h"
#include "Scene/Tiles.h"

#include <algorithm>
#include <cstdint>
#include <mutex>

namespace TemporalCoherence
{

/// Call work(tile, part) for each tile of a picture, in parallel, and add up its counts.
/// \param counts gets the sum, which is also added to the statistics
/// \param report is called in this thread with the progress from 0 to 1, before each part of the
///               work; threads wait for each other between parts. May be null: there is only one
///               part
/// \return false if the report stopped it
template <typename Report, typename Work>
bool CountTiles(const glm::ivec2& size, const Report& report, FrameStatistics& statistics,
  TraceCounts& counts, const Work& work)
{
  constexpr std::int64_t mostParts = 32;
  constexpr std::int64_t smallestPart = 16 * TileGrain;
  const std::int64_t tiles = NumberOfTiles(size);
  const std::int64_t inPart = report ? std::max(tiles / mostParts, smallestPart) : tiles;
  double seconds = 0.0;
  std::mutex guard;
  TraceCounts sum;
  for (std::int64_t first = 0; first < tiles; first += inPart)
  {
    if (report && !report(static_cast<double>(first) / static_cast<double>(tiles)))
    {
      return false;
    }
    Stopwatch watch(seconds);
    ParallelForRanges(std::min(inPart, tiles - first), TileGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        TraceCounts inRange;
        for (std::int64_t tile = first + begin; tile < first + end; ++tile)
        {
          std::int64_t nanoseconds = 0;
          {
            const TileTimer timer(tile, nanoseconds);
            inRange += work(tile, PixelsOfTile(size, tile));
          }
          inRange.TileTime += nanoseconds;
        }
        const std::lock_guard<std::mutex> lock(guard);
        sum += inRange;
      });
  }
  statistics.Add(sum, seconds);
  counts += sum;
  return true;
}

}

#endif
