// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/ColdTiles.h"
#include "Render/RayGrid.h"
#include "Render/RouteSteps.h"
#include "Render/Routes.h"
#include "Render/SampleDistance.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// The share of a frame's progress that the grid of rays takes.
constexpr double ShareOfGrid = 0.5;

LeapedSpace BeginWhole(FrameTask& task)
{
  return task.Key.IsBlended() ? BeginBlended(task) : BeginSurfaces(task);
}

TileWork WorkOf(const FrameTask& task, const LeapedSpace& space)
{
  return task.Key.IsBlended() ? BlendedWork(task, space) : SurfaceWork(task, space);
}

/// The tiles of doubt, the worst first.
std::vector<std::int64_t> SortByDoubt(const std::vector<float>& doubts)
{
  std::vector<std::int64_t> tiles;
  for (std::size_t tile = 0; tile < doubts.size(); ++tile)
  {
    if (doubts[tile] > 0.0f)
    {
      tiles.push_back(static_cast<std::int64_t>(tile));
    }
  }
  std::stable_sort(tiles.begin(), tiles.end(),
    [&](std::int64_t a, std::int64_t b)
    { return doubts[static_cast<std::size_t>(a)] > doubts[static_cast<std::size_t>(b)]; });
  return tiles;
}

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
  bool Make(const std::vector<std::int64_t>& tiles, const ReportProgress& report, const GoOn& goOn,
    const Work& work, std::size_t& number)
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
      number = this->MakePart(tiles, number, end, goOn, work);
      if (number < end)
      {
        break;
      }
    }
    return true;
  }

  /// Limit the layers of the frame once all tiles are made.
  void Finish() { this->Limit.Finish(this->Made, this->Task.Statistics); }

private:
  /// \return the position behind the last tile that is made
  template <typename GoOn, typename Work>
  std::size_t MakePart(const std::vector<std::int64_t>& tiles, std::size_t first, std::size_t end,
    const GoOn& goOn, const Work& work)
  {
    double seconds = 0.0;
    TraceCounts sum;
    std::atomic<std::size_t> next{ first };
    std::atomic<bool> isStopped{ false }, isOutOfMemory{ false };
    std::mutex guard;
    {
      const Stopwatch watch(seconds);
      // Threads take tiles in the order of the list, so those that are made are its front.
      ParallelForRanges(static_cast<std::int64_t>(end - first), TileGrain,
        [&](std::int64_t begin, std::int64_t last)
        {
          TraceCounts counts;
          const std::int64_t before = TileTimer::Now();
          for (; begin < last && !isStopped && !isOutOfMemory; ++begin)
          {
            if (!goOn())
            {
              isStopped = true;
              break;
            }
            try
            {
              counts += this->MakeTile(tiles[next++], work);
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
    return next;
  }

  template <typename Work>
  TraceCounts MakeTile(std::int64_t tile, const Work& work)
  {
    std::int64_t nanoseconds = 0;
    TraceCounts counts;
    {
      const TileTimer timer(tile, nanoseconds);
      counts = work(tile, PixelsOfTile(this->Made.Size, tile), this->Made);
    }
    counts.TileTime += nanoseconds;
    this->Limit.Take(tile, this->Made);
    return counts;
  }

  FrameTask& Task;
  Frame& Made;
  LayerLimit Limit;
};

/// Make the frame: trace tiles of doubt, the worst first, as many as there may be. Call
/// fill(tile, part, frame) for all others.
/// \param work   of a cold frame
/// \param doubts of the tiles; those that are traced become 0
template <typename Fill>
bool TraceWorst(FrameTask& task, const ReportProgress& report, const TileWork& work,
  std::vector<float>& doubts, const Fill& fill)
{
  const FewerRays& fewer = task.Options.Fewer;
  const bool areFewer = fewer.AreAsked();
  std::vector<std::int64_t> worst = SortByDoubt(doubts);
  if (areFewer && fewer.Tiles < static_cast<std::int64_t>(worst.size()))
  {
    worst.resize(static_cast<std::size_t>(std::max<std::int64_t>(fewer.Tiles, 0)));
  }
  TileLister lister(task);
  std::size_t traced = 0;
  const auto goOn = [&]() { return !areFewer || !fewer.HasTime || fewer.HasTime(); };
  if (!lister.Make(worst, report, goOn, work, traced))
  {
    return false;
  }
  std::vector<std::uint8_t> isTraced(doubts.size(), 0);
  for (std::size_t i = 0; i < traced; ++i)
  {
    const auto tile = static_cast<std::size_t>(worst[i]);
    isTraced[tile] = 1;
    doubts[tile] = 0.0f;
  }
  std::vector<std::int64_t> others;
  for (std::size_t tile = 0; tile < doubts.size(); ++tile)
  {
    if (!isTraced[tile])
    {
      others.push_back(static_cast<std::int64_t>(tile));
    }
  }
  const double before = task.Statistics.TilesTime;
  lister.Make(others, {}, []() { return true; }, fill, traced);
  task.Statistics.FillTime = task.Statistics.TilesTime - before;
  task.Statistics.TilesTime = before;
  lister.Finish();
  CachedImage& made = task.Store.Next();
  made.IsExact = std::all_of(doubts.begin(), doubts.end(), [](float doubt) { return doubt == 0.0f; });
  made.Doubts = made.IsExact ? std::vector<float>() : doubts;
  return true;
}

/// Trace the rays of the grid.
/// \param whole space of the picture with all rays
bool TraceGrid(FrameTask& task, const FrameKey& key, const LeapedSpace& whole, FrameStore& grid)
{
  FrameStatistics& sum = task.Statistics;
  FrameStatistics statistics;
  FrameExtras extras;
  extras.Cells = task.Key.Samples.Shape->Abilities().IsMesh;
  grid.Begin(key, extras);
  TileBounds bounds;
  if (whole.Active)
  {
    bounds.Unite(*whole.Bounds, task.Key.View.Size, key.View.Size);
  }
  FrameTask ofGrid{ key, task.Options, grid, task.Structures, statistics, nullptr,
    PartOf(task.Report, 0.0, ShareOfGrid) };
  {
    const Stopwatch watch(sum.GridTime);
    if (!MakeTiles(ofGrid, WorkOf(ofGrid, { whole.Active, &bounds })))
    {
      return false;
    }
  }
  sum.GridRays = static_cast<std::int64_t>(key.View.Size.x) * key.View.Size.y;
  sum.TracedRays += statistics.TracedRays;
  sum.FieldSamples += statistics.FieldSamples;
  sum.Layers += statistics.Layers;
  sum.MergedLayers += statistics.MergedLayers;
  sum.TraceTime += statistics.TraceTime;
  sum.ShadeTime += statistics.ShadeTime;
  return true;
}

/// Copy a tile from a picture of the same key as it is, answers and kept values included.
/// \pre both pictures have the same planes
TraceCounts KeepTile(
  std::int64_t tile, const PixelRect& part, const Frame& from, bool isParallel, Frame& frame)
{
  const TraceCounts counts = CopyTile(tile, part, from, isParallel, frame);
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * frame.Size.x + part.First.x;
    std::copy_n(from.Answers.begin() + row, part.Size.x, frame.Answers.begin() + row);
  }
  const auto met = static_cast<std::ptrdiff_t>(frame.Met.size() / frame.ClearTiles.size());
  std::copy_n(from.Met.begin() + met * tile, met, frame.Met.begin() + met * tile);
  return counts;
}

/// True if one frame has a plane exactly if the other has.
bool HaveSamePlanes(const Frame& a, const Frame& b)
{
  bool areSame = a.Met.size() == b.Met.size() && a.Layers.size() == b.Layers.size();
  Frame::ForEachPlane(0.0f,
    [&](auto plane, const auto&) { areSame &= (a.*plane).size() == (b.*plane).size(); });
  return areSame;
}

}

bool CanHaveFewerRays(const FrameKey& key, const FrameOptions& options)
{
  const glm::ivec2 rays = RaysFor(key.View.Size, options.Fewer.Distance);
  return options.Fewer.AreAsked() && options.Accuracy == ReuseAccuracy::Exact &&
    !key.Appearance.Occlusion.IsOn() && !key.Appearance.ColorByAnswer && rays.x > 1 && rays.y > 1;
}

bool TraceFewerRays(FrameTask& task, FrameStore& grid)
{
  const LeapedSpace space = BeginWhole(task);
  const FrameKey key = KeyOfGrid(task.Key, RaysFor(task.Key.View.Size, task.Options.Fewer.Distance));
  if (!TraceGrid(task, key, space, grid))
  {
    return false;
  }
  const RayGrid rays(grid.Next().Picture, task.Key);
  std::vector<float> doubts = rays.FindDoubts();
  for (std::size_t tile = 0; space.Active && tile < doubts.size(); ++tile)
  {
    const bool showsNothing = space.Bounds->At(static_cast<std::int64_t>(tile)).IsEmpty();
    doubts[tile] = showsNothing ? 0.0f : doubts[tile];
  }
  const TileWork work = WorkOf(task, space);
  return TraceWorst(task, PartOf(task.Report, ShareOfGrid, 1.0), work, doubts,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const bool isBetween = doubts[static_cast<std::size_t>(tile)] > 0.0f;
      return isBetween ? rays.Fill(tile, part, frame) : work(tile, part, frame);
    });
}

bool TraceBetweenRays(FrameTask& task)
{
  const LeapedSpace space = BeginWhole(task);
  const Frame& last = task.Store.Last().Picture;
  if (!HaveSamePlanes(last, task.Store.Next().Picture))
  {
    return task.Key.IsBlended() ? BlendCold(task) : TraceCold(task);
  }
  std::vector<float> doubts = task.Store.Last().Doubts;
  for (std::size_t tile = 0; tile < doubts.size(); ++tile)
  {
    // Layers that the last frame had to merge may fit now.
    const bool isWhole =
      KeepsAllLayers(static_cast<std::int64_t>(tile), last, task.Options.Layers);
    doubts[tile] = isWhole ? doubts[tile] : std::max(doubts[tile], 1.0f);
  }
  const bool isParallel = task.Key.View.Parallel;
  return TraceWorst(task, task.Report, WorkOf(task, space), doubts,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    { return KeepTile(tile, part, last, isParallel, frame); });
}

}
