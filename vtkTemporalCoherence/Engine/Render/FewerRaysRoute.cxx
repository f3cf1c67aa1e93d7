// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bricks/ImpatientWork.h"
#include "Render/ColdTiles.h"
#include "Render/GridKey.h"
#include "Render/RayGrid.h"
#include "Render/RouteSteps.h"
#include "Render/Routes.h"
#include "Render/SampleDistance.h"
#include "Render/TileLister.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// The share of a frame's progress that the grid of rays takes.
constexpr double ShareOfGrid = 0.5;

/// The share of the grid's rays that must be traced in time. If it shows that fewer will be, a
/// coarser grid takes their place.
constexpr double EnoughOfGrid = 0.6;

/// The part of the grid's time after which that may show.
constexpr double FirstLook = 0.25;

/// Pixels between rays through a stand-in, along each axis.
constexpr double StandInDistance = 3.0;

/// The coarser grid is to take this share of the time that the first one had.
constexpr double ShareOfSecondGrid = 0.25;

LeapedSpace BeginWhole(FrameTask& task)
{
  return task.Key.IsBlended() ? BeginBlended(task) : BeginSurfaces(task);
}

TileWork WorkOf(const FrameTask& task, const LeapedSpace& space)
{
  return task.Key.IsBlended() ? BlendedWork(task, space) : SurfaceWork(task, space);
}

/// The tiles of doubt.
/// \param worstFirst else neighbours follow each other, which takes less time
std::vector<std::int64_t> TilesOfDoubt(const std::vector<float>& doubts, bool worstFirst)
{
  std::vector<std::int64_t> tiles;
  for (std::size_t tile = 0; tile < doubts.size(); ++tile)
  {
    if (doubts[tile] > 0.0f)
    {
      tiles.push_back(static_cast<std::int64_t>(tile));
    }
  }
  if (worstFirst)
  {
    std::stable_sort(tiles.begin(), tiles.end(),
      [&](std::int64_t a, std::int64_t b)
      { return doubts[static_cast<std::size_t>(a)] > doubts[static_cast<std::size_t>(b)]; });
  }
  return tiles;
}

/// Lets samples in bricks be read until a time, as long as this lives.
class ReadingTime
{
public:
  ReadingTime(const Field& samples, const Impatience& reading)
    : Bricks(reading.IsAsked() ? samples.Bricks : nullptr)
    , HasTime(reading.HasTime)
  {
    if (this->Bricks)
    {
      this->Bricks->GiveUpAt(reading.Deadline);
    }
  }
  ~ReadingTime()
  {
    if (this->Bricks)
    {
      this->Bricks->GiveUpAt(BrickCache::Patient);
    }
  }
  ReadingTime(const ReadingTime&) = delete;
  ReadingTime& operator=(const ReadingTime&) = delete;

  bool GoesOn() const { return !this->Bricks || this->HasTime(); }

private:
  std::shared_ptr<const BrickCache> Bricks;
  const std::function<bool()>& HasTime;
};

/// Make the frame: trace tiles of doubt, the worst first, as many as there may be. Call
/// fill(tile, part, frame) for all others.
/// \param work    of a cold frame
/// \param doubts  of the tiles; those that are traced become 0
/// \param prepare is called before the others are filled, if there are any of doubt
template <typename Fill, typename Prepare>
bool TraceWorst(FrameTask& task, const ReportProgress& report, const TileWork& work,
  std::vector<float>& doubts, const Fill& fill, const Prepare& prepare)
{
  const FewerRays& fewer = task.Options.Fewer;
  const bool areFewer = fewer.AreAsked();
  std::vector<std::int64_t> worst = TilesOfDoubt(doubts, areFewer);
  if (areFewer && fewer.Tiles < static_cast<std::int64_t>(worst.size()))
  {
    worst.resize(static_cast<std::size_t>(std::max<std::int64_t>(fewer.Tiles, 0)));
  }
  TileLister lister(task);
  std::size_t traced = 0;
  std::vector<std::uint8_t> isTraced(doubts.size(), 0);
  {
    const ReadingTime reading(task.Key.Samples, task.Options.Reading);
    const auto goOn = [&]() { return (!areFewer || fewer.HasTime()) && reading.GoesOn(); };
    const auto trace = [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const ImpatientWork here;
      const TraceCounts counts = work(tile, part, frame);
      isTraced[static_cast<std::size_t>(tile)] = !SampleUse::HasMissed();
      return counts;
    };
    if (!lister.MakeFront(worst, report, goOn, trace, traced))
    {
      return false;
    }
  }
  for (std::size_t tile = 0; tile < doubts.size(); ++tile)
  {
    doubts[tile] = isTraced[tile] ? 0.0f : doubts[tile];
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
  if (std::any_of(doubts.begin(), doubts.end(), [](float doubt) { return doubt > 0.0f; }))
  {
    prepare();
  }
  lister.MakeAll(others, fill);
  task.Statistics.FillTime = task.Statistics.TilesTime - before;
  task.Statistics.TilesTime = before;
  lister.Finish();
  CachedImage& made = task.Store.Next();
  made.IsExact =
    std::all_of(doubts.begin(), doubts.end(), [](float doubt) { return doubt == 0.0f; });
  made.Doubts = made.IsExact ? std::vector<float>() : doubts;
  return true;
}

/// The tiles of a picture in an order whose every beginning is spread over the picture.
std::vector<std::int64_t> SpreadTiles(const glm::ivec2& size)
{
  constexpr double golden = 0.6180339887498949;
  std::vector<std::int64_t> tiles(static_cast<std::size_t>(NumberOfTiles(size)));
  std::iota(tiles.begin(), tiles.end(), std::int64_t(0));
  const auto place = [](std::int64_t tile) { return std::fmod(golden * double(tile), 1.0); };
  std::sort(tiles.begin(), tiles.end(),
    [&](std::int64_t a, std::int64_t b) { return place(a) < place(b); });
  return tiles;
}

/// What there was time for.
struct GridPace
{
  double Traced = 1.0;  ///< share of the grid
  double Elapsed = 0.0; ///< share of the time that the grid had
};

/// Trace the rays of a grid, or give it up.
/// \param whole  space of the picture with all rays
/// \param enough share of the grid; if less will be traced in time, it is given up
/// \return false if the report stopped it
bool TraceGrid(FrameTask& task, const FrameKey& key, const LeapedSpace& whole, double enough,
  FrameStore& grid, GridPace& pace)
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
    // One by one: a grid has too few tiles for groups.
    const std::vector<std::int64_t> tiles = SpreadTiles(key.View.Size);
    const double least = enough * static_cast<double>(tiles.size());
    std::atomic<std::size_t> begun{ 0 };
    TileLister lister(ofGrid);
    std::size_t number = 0;
    const TileWork work = WorkOf(ofGrid, { whole.Active, &bounds });
    const std::function<double()>& clock = task.Options.Fewer.Elapsed;
    const double begin = clock ? clock() : 0.0;
    // Of the time that was left when the grid began.
    const auto elapsed = [&]()
    {
      const double now = clock ? clock() : 0.0;
      return begin < 1.0 ? (now - begin) / (1.0 - begin) : 1.0;
    };
    const auto goOn = [&]()
    {
      const double now = std::min(elapsed(), 1.0);
      return static_cast<double>(begun++) >= least * now || now < FirstLook;
    };
    if (!lister.MakeFront(tiles, ofGrid.Report, goOn, work, number))
    {
      return false;
    }
    pace = { static_cast<double>(number) / static_cast<double>(tiles.size()), elapsed() };
    lister.Finish();
  }
  const std::int64_t rays = static_cast<std::int64_t>(key.View.Size.x) * key.View.Size.y;
  sum.GridRays += static_cast<std::int64_t>(pace.Traced * static_cast<double>(rays));
  sum.TracedRays += statistics.TracedRays;
  sum.FieldSamples += statistics.FieldSamples;
  sum.Layers += statistics.Layers;
  sum.MergedLayers += statistics.MergedLayers;
  sum.TraceTime += statistics.TraceTime;
  sum.ShadeTime += statistics.ShadeTime;
  return true;
}

/// Trace the rays of the grid, or of a coarser one if that takes too long.
bool TraceGridInTime(FrameTask& task, const LeapedSpace& whole, FrameStore& grid)
{
  const FewerRays& fewer = task.Options.Fewer;
  const auto keyAt = [&](double distance)
  { return KeyOfGrid(task.Key, RaysFor(task.Key.View.Size, distance)); };
  const bool mayBeCoarser = fewer.Distance < fewer.MostDistance;
  GridPace pace;
  if (!TraceGrid(task, keyAt(fewer.Distance), whole, mayBeCoarser ? EnoughOfGrid : 0.0, grid, pace))
  {
    return false;
  }
  if (pace.Traced == 1.0)
  {
    return true;
  }
  const double coarser =
    fewer.Distance * std::sqrt(pace.Elapsed / (ShareOfSecondGrid * pace.Traced));
  return TraceGrid(task, keyAt(std::min(coarser, fewer.MostDistance)), whole, 0.0, grid, pace);
}

/// Trace rays through the stand-in.
void TraceStandIn(const FrameTask& task, FrameStore& grid)
{
  const StandIn& standIn = *task.Options.Reading.StandIn;
  FrameKey key = KeyOfGrid(task.Key, RaysFor(task.Key.View.Size, StandInDistance));
  key.Samples = standIn.Samples;
  key.Samples.Between = task.Key.Samples.Between;
  key.Transform.WorldFromIndex =
    glm::scale(glm::translate(key.Transform.WorldFromIndex, standIn.First), standIn.Step);
  key.Transform.IndexFromWorld = glm::inverse(key.Transform.WorldFromIndex);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec2& crop = key.Region.Crops[static_cast<std::size_t>(axis)];
    crop = (crop - standIn.First[axis]) / standIn.Step[axis];
  }
  FrameStructures structures(std::make_shared<FieldStructures>());
  structures.PrepareRanges(key);
  FrameStatistics statistics;
  FrameTask ofStandIn{ key, task.Options, grid, structures, statistics, nullptr, {} };
  const LeapedSpace space = BeginSurfaces(ofStandIn);
  TileLister lister(ofStandIn);
  std::vector<std::int64_t> tiles(static_cast<std::size_t>(NumberOfTiles(key.View.Size)));
  std::iota(tiles.begin(), tiles.end(), std::int64_t(0));
  lister.MakeAll(tiles, SurfaceWork(ofStandIn, space));
  lister.Finish();
  task.Statistics.GridRays += static_cast<std::int64_t>(key.View.Size.x) * key.View.Size.y;
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

/// True if two frames have the same optional planes.
bool HaveSamePlanes(const Frame& a, const Frame& b)
{
  bool areSame = a.Met.size() == b.Met.size() && a.Layers.size() == b.Layers.size();
  Frame::ForEachPlane(
    0.0f, [&](auto plane, const auto&) { areSame &= (a.*plane).size() == (b.*plane).size(); });
  return areSame;
}

}

bool CanHaveFewerRays(const FrameKey& key, const FrameOptions& options)
{
  const glm::ivec2 rays = RaysFor(key.View.Size, options.Fewer.Distance);
  return MayShowAnything(key) && options.Fewer.AreAsked() &&
    options.Accuracy == ReuseAccuracy::Exact && !key.Appearance.HasMutualLight() &&
    !key.Appearance.ColorByAnswer && rays.x > 1 && rays.y > 1;
}

bool TraceFewerRays(FrameTask& task, FrameStore& grid)
{
  const LeapedSpace space = BeginWhole(task);
  if (!TraceGridInTime(task, space, grid))
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
  return TraceWorst(
    task, PartOf(task.Report, ShareOfGrid, 1.0), work, doubts,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const bool isBetween = doubts[static_cast<std::size_t>(tile)] > 0.0f;
      return isBetween ? rays.Fill(tile, part, frame) : work(tile, part, frame);
    },
    []() {});
}

bool CanBeImpatient(const FrameKey& key, const FrameOptions& options)
{
  return MayShowAnything(key) && options.Reading.IsAsked() && key.Samples.Bricks &&
    !key.IsBlended() && !key.Samples.Labels && options.Accuracy == ReuseAccuracy::Exact &&
    !key.Appearance.HasMutualLight() && !key.Appearance.ColorByAnswer &&
    glm::all(glm::greaterThan(RaysFor(key.View.Size, StandInDistance), glm::ivec2(1)));
}

bool TraceInTime(FrameTask& task, FrameStore& grid)
{
  const LeapedSpace space = BeginWhole(task);
  const auto tiles = static_cast<std::size_t>(NumberOfTiles(task.Key.View.Size));
  std::vector<float> doubts(tiles, 1.0f);
  for (std::size_t tile = 0; space.Active && tile < tiles; ++tile)
  {
    doubts[tile] = space.Bounds->At(static_cast<std::int64_t>(tile)).IsEmpty() ? 0.0f : 1.0f;
  }
  const TileWork work = WorkOf(task, space);
  std::unique_ptr<const RayGrid> rays;
  return TraceWorst(
    task, task.Report, work, doubts,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const bool isMissing = doubts[static_cast<std::size_t>(tile)] > 0.0f;
      return isMissing ? rays->Fill(tile, part, frame) : work(tile, part, frame);
    },
    [&]()
    {
      TraceStandIn(task, grid);
      rays = std::make_unique<const RayGrid>(grid.Next().Picture, task.Key);
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
    const bool isWhole = KeepsAllLayers(static_cast<std::int64_t>(tile), last, task.Options.Layers);
    doubts[tile] = isWhole ? doubts[tile] : std::max(doubts[tile], 1.0f);
  }
  const bool isParallel = task.Key.View.Parallel;
  return TraceWorst(
    task, task.Report, WorkOf(task, space), doubts,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    { return KeepTile(tile, part, last, isParallel, frame); },
    []() {});
}

}
