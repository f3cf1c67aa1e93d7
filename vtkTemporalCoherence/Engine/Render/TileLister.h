// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileLister_h
#define TemporalCoherence_TileLister_h

#include "Render/LayerLimit.h"
#include "Render/Routes.h"
#include "Scene/Parallel.h"
#include "Scene/Timers.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <new>
#include <vector>

namespace TemporalCoherence
{

/// Works on listed tiles of the frame being made.
class TileLister
{
public:
  /// \throws std::bad_alloc
  explicit TileLister(FrameTask& task)
    : Task(task)
    , Made(task.Store.Next().Picture)
    , Limit(task.Options.Layers, Made)
  {
  }

  /// Call work(tile, part, frame) for tiles from the front of a list, in parallel, as long as
  /// goOn() returns true.
  /// \param report may stop the work; may be null
  /// \param number receives the number of tiles that are made
  /// \return false if the report stopped it
  /// \throws std::bad_alloc
  template <typename GoOn, typename Work>
  bool MakeFront(const std::vector<std::int64_t>& tiles, const ReportProgress& report,
    const GoOn& goOn, const Work& work, std::size_t& number)
  {
    constexpr std::size_t parts = 32, smallestPart = 128;
    const std::size_t inPart = report ? std::max(tiles.size() / parts, smallestPart) : tiles.size();
    for (number = 0; number < tiles.size();)
    {
      if (report && !report(static_cast<double>(number) / static_cast<double>(tiles.size())))
      {
        return false;
      }
      const std::size_t end = std::min(number + inPart, tiles.size());
      std::atomic<std::size_t> next{ number };
      std::atomic<bool> isStopped{ false };
      // Threads take tiles in the order of the list, so those that are made are its front.
      this->InParallel(end - number, 1,
        [&](std::size_t, TraceCounts& counts)
        {
          if (!isStopped && !goOn())
          {
            isStopped = true;
          }
          if (!isStopped)
          {
            counts += this->MakeTile(tiles[next++], work);
          }
        });
      number = next;
      if (number < end)
      {
        break;
      }
    }
    return true;
  }

  /// Call work(tile, part, frame) for all tiles of a list, in parallel.
  /// \throws std::bad_alloc
  template <typename Work>
  void MakeAll(const std::vector<std::int64_t>& tiles, const Work& work)
  {
    this->InParallel(tiles.size(), TileGrain,
      [&](std::size_t i, TraceCounts& counts) { counts += this->MakeTile(tiles[i], work); });
  }

  /// Limit the layers of the frame once all tiles are made.
  void Finish() { this->Limit.Finish(this->Made, this->Task.Statistics); }

private:
  /// Call work(i, counts) for each i below a number.
  /// \param grain how many follow each other in a thread
  template <typename Work>
  void InParallel(std::size_t number, std::int64_t grain, const Work& work)
  {
    double seconds = 0.0;
    TraceCounts sum;
    std::atomic<bool> isOutOfMemory{ false };
    std::mutex guard;
    {
      const Stopwatch watch(seconds);
      ParallelForRanges(static_cast<std::int64_t>(number), grain,
        [&](std::int64_t begin, std::int64_t end)
        {
          TraceCounts counts;
          const std::int64_t before = TileTimer::Now();
          for (std::int64_t i = begin; i < end && !isOutOfMemory; ++i)
          {
            try
            {
              work(static_cast<std::size_t>(i), counts);
            }
            catch (const std::bad_alloc&)
            {
              isOutOfMemory = true; // not every kind of threads passes exceptions on
            }
          }
          counts.GroupTime = TileTimer::Now() - before;
          const std::lock_guard<std::mutex> lock(guard);
          sum += counts;
        });
    }
    if (isOutOfMemory)
    {
      throw std::bad_alloc();
    }
    this->Task.Statistics.Add(sum, seconds);
  }

  template <typename Work>
  TraceCounts MakeTile(std::int64_t tile, const Work& work)
  {
    std::int64_t nanoseconds = 0;
    TraceCounts counts;
    SampleUse::Renew();
    {
      const TileTimer timer(tile, nanoseconds);
      counts = work(tile, PixelsOfTile(this->Made.Size, tile), this->Made);
    }
    counts.TileTime += nanoseconds;
    if (!SampleUse::HasMissed()) // else the tile is made again
    {
      this->Limit.Take(tile, this->Made);
    }
    return counts;
  }

  FrameTask& Task;
  Frame& Made;
  LayerLimit Limit;
};

}

#endif
