// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileLoop_h
#define TemporalCoherence_TileLoop_h

#include "Isomap/TileGroups.h"
#include "Render/FrameStatistics.h"
#include "Scene/FramePlanes.h"
#include "Scene/Parallel.h"
#include "Scene/Tiles.h"
#include "Scene/Timers.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <new>

namespace TemporalCoherence
{

/// Call work(tile, part) for each tile of a group, and add up its counts.
template <typename Work>
void CountGroup(const glm::ivec2& size, std::size_t group, TraceCounts& counts, const Work& work)
{
  const TileRange tiles = TilesOfGroup(size, group);
  for (std::int64_t tile = tiles.First; tile < tiles.End; ++tile)
  {
    std::int64_t nanoseconds = 0;
    SampleUse::Renew();
    {
      const TileTimer timer(tile, nanoseconds);
      counts += work(tile, PixelsOfTile(size, tile));
    }
    counts.TileTime += nanoseconds;
  }
}

/// Call work(group, counts) for each group of tiles of a picture, in parallel.
/// \param statistics receives the sum of all counts
/// \param report is called in this thread with the progress from 0 to 1, before each part of the
///               work; threads wait for each other between parts. May be null: there is only one
///               part
/// \return false if the report stopped it
/// \throws std::bad_alloc if work() does, once no thread works any more
template <typename Report, typename Work>
bool CountGroups(
  const glm::ivec2& size, const Report& report, FrameStatistics& statistics, const Work& work)
{
  constexpr std::int64_t mostParts = 32;
  constexpr std::int64_t smallestPart = 16;
  const auto groups = static_cast<std::int64_t>(NumberOfGroups(size));
  const std::int64_t inPart = report ? std::max(groups / mostParts, smallestPart) : groups;
  double seconds = 0.0;
  std::mutex guard;
  TraceCounts sum;
  std::atomic<bool> isOutOfMemory{ false };
  for (std::int64_t first = 0; first < groups; first += inPart)
  {
    if (report && !report(static_cast<double>(first) / static_cast<double>(groups)))
    {
      return false;
    }
    Stopwatch watch(seconds);
    ParallelForRanges(std::min(inPart, groups - first), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        TraceCounts inRange;
        const std::int64_t before = TileTimer::Now();
        for (std::int64_t group = first + begin; group < first + end && !isOutOfMemory; ++group)
        {
          try
          {
            work(static_cast<std::size_t>(group), inRange);
          }
          catch (const std::bad_alloc&)
          {
            isOutOfMemory = true; // not every kind of threads passes exceptions on
          }
        }
        inRange.GroupTime = TileTimer::Now() - before;
        const std::lock_guard<std::mutex> lock(guard);
        sum += inRange;
      });
    if (isOutOfMemory)
    {
      throw std::bad_alloc();
    }
  }
  statistics.Add(sum, seconds);
  return true;
}

}

#endif
