// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/IsomapLookup.h"
#include "Render/RouteSteps.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <bitset>
#include <numeric>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Fewer rays than this are traced without space leaping: that is faster than finding active cells
/// first. Measured by the look-ups of `Benchmark --scenarios routes`.
constexpr std::int64_t FewRays = 256;
constexpr std::int64_t FewRaysInMesh = 64; ///< the same where a tile looks at all of its leaves

/// Trace the rays that an isomap leaves unresolved, one bit each, tile by tile, and shade these
/// tiles.
/// \param leaps the active cells of the frame are prepared
/// \param limit takes these tiles
bool TraceUnresolvedRays(FrameTask& task, const std::vector<std::uint64_t>& unresolved, bool leaps,
  const TileShader& shader, const ReportProgress& report, LayerLimit& limit)
{
  const std::int64_t rays = std::accumulate(unresolved.begin(), unresolved.end(), std::int64_t(0),
    [](std::int64_t sum, std::uint64_t tile)
    { return sum + static_cast<std::int64_t>(std::bitset<64>(tile).count()); });
  if (rays == 0)
  {
    return true;
  }
  const std::int64_t few = task.Key.Samples.Kind->Abilities().IsMesh ? FewRaysInMesh : FewRays;
  if (!leaps && task.Options.SpaceLeaping && rays > few)
  {
    task.Structures.PrepareActiveCells(task.Key);
    leaps = true;
  }
  const TileTracer tracer(SceneOf(task, task.Structures.SpaceToLeap(leaps), nullptr));
  return WorkOnTiles(task, report,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      TraceCounts counts;
      const std::uint64_t which = unresolved[static_cast<std::size_t>(tile)];
      if (which != 0)
      {
        counts = tracer.TraceSome(tile, part, which, frame);
        shader.Shade(tile, part, nullptr, frame, counts);
        limit.Take(tile, frame);
      }
      return counts;
    });
}

/// Makes the tiles of a frame from an isomap.
class IsomapTiles
{
public:
  IsomapTiles(FrameTask& task, const LeapedSpace& space, const Isomap& map, FrameBands& bands,
    std::vector<std::uint64_t>& unresolved, LayerLimit& limit)
    : Task(task)
    , Bands(bands)
    , Unresolved(unresolved)
    , Limit(limit)
    , Lookup(task.Key, map, task.Structures.Pyramid().FiniteRange())
    , Tracer(SceneOf(task, space, nullptr))
    , Shader(task.Key, task.Structures.Pyramid().FiniteRange(), space,
        map.Form().HasNormals ? HitSet::NotDefinite : HitSet::All, HitSet::All)
    , ShaderOfTraced(
        task.Key, task.Structures.Pyramid().FiniteRange(), space, HitSet::All, HitSet::All)
  {
  }

  bool MakeAll(const ReportProgress& report)
  {
    const glm::ivec2& size = this->Task.Key.View.Size;
    return CountGroups(
      size, report, this->Task.Statistics,
      [&](std::size_t group, TraceCounts& ofGroup) { this->Make(group, ofGroup); },
      [&](std::size_t group, std::int64_t cost) { this->Bands.Done(group, cost); });
  }

  const TileShader& ShaderOfLookUps() const { return this->Shader; }

private:
  void Make(std::size_t group, TraceCounts& counts)
  {
    Frame& frame = this->Task.Store.Next().Picture;
    std::vector<IsomapLookup::IsovalueKeys> keys;
    const bool isFound =
      this->Bands.Prepare(group, counts) != GroupWork::Trace && this->Lookup.FindBands(group, keys);
    CountGroup(frame.Size, group, counts,
      [&](std::int64_t tile, const PixelRect& part)
      {
        std::uint64_t& left = this->Unresolved[static_cast<std::size_t>(tile)];
        left = 0;
        TileHits found;
        TraceCounts ofTile = isFound ? this->Lookup.LookUpTile(tile, part, keys, frame, left, found)
                                     : this->Tracer.Trace(tile, part, frame, found);
        if (left == 0)
        {
          (isFound ? this->Shader : this->ShaderOfTraced).Shade(tile, part, &found, frame, ofTile);
          this->Limit.Take(tile, frame);
        }
        return ofTile;
      });
  }

  FrameTask& Task;
  FrameBands& Bands;
  std::vector<std::uint64_t>& Unresolved;
  LayerLimit& Limit;
  IsomapLookup Lookup;
  TileTracer Tracer;
  TileShader Shader, ShaderOfTraced;
};

/// Nanoseconds of all threads: what one thread does alone keeps the others waiting.
double ThreadTime()
{
  return static_cast<double>(TileTimer::Now()) *
    static_cast<double>(std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1));
}

/// Prepare the building of bands.
void MakeBuilders(FrameTask& task, FrameBands& bands)
{
  if (bands.NumberOf(GroupWork::Build) == 0)
  {
    return; // a look-up builds nothing, and takes no time for it
  }
  double seconds = 0.0;
  {
    Stopwatch watch(seconds);
    bands.MakeBuilders(ThreadTime);
  }
  task.Statistics.IsomapBuildTime += seconds;
}

void CountTiles(const FrameBands& bands, const glm::ivec2& size, FrameStatistics& statistics)
{
  for (std::size_t group = 0; group < NumberOfGroups(size); ++group)
  {
    const TileRange tiles = TilesOfGroup(size, group);
    const GroupWork work = bands.WorkOf(group);
    std::int64_t& count = work == GroupWork::LookUp ? statistics.TilesLookedUp
      : work == GroupWork::Build                    ? statistics.TilesBuilt
                                                    : statistics.TilesTraced;
    count += tiles.End - tiles.First;
  }
}

}

bool LookUp(
  FrameTask& task, IsomapBuilder& map, std::vector<std::uint64_t>& unresolved, bool& isBuilding)
{
  // If all is looked up, a walk is only needed for layers behind translucent surfaces.
  const bool isCovered = map.Built().Covers(task.Key.Isosurfaces.Isovalues);
  isBuilding |= !isCovered;
  const bool leaps =
    task.Options.SpaceLeaping && (task.Key.Isosurfaces.IsTranslucent() || !isCovered);
  task.Costs = nullptr; // the bands keep them
  const double begin = ThreadTime();
  // A look-up finds no first entries.
  const LeapedSpace space = Begin(task, leaps, ExtrasWithoutEntries(task));
  FrameBands bands({ task.Key, task.Options.Map, task.Store.Last().Key.Isosurfaces.Isovalues,
                     task.Structures.Pyramid(), ThreadTime() - begin },
    map.ToBuild(), map.Drag());
  MakeBuilders(task, bands);
  unresolved.resize(static_cast<std::size_t>(NumberOfTiles(task.Key.View.Size)));
  CachedImage& made = task.Store.Next();
  LayerLimit limit(task.Options.Layers, made.Picture);
  IsomapTiles tiles(task, space, map.Built(), bands, unresolved, limit);
  const bool isDone = tiles.MakeAll(PartOf(task.Report, 0.0, 0.5)) &&
    TraceUnresolvedRays(
      task, unresolved, leaps, tiles.ShaderOfLookUps(), PartOf(task.Report, 0.5, 1.0), limit);
  if (!isDone)
  {
    return false;
  }
  limit.Finish(made.Picture, task.Statistics);
  bands.Finish();
  if (bands.HasFailed())
  {
    map.GiveUp();
  }
  CountTiles(bands, task.Key.View.Size, task.Statistics);
  const bool isOfMap = bands.NumberOf(GroupWork::Trace) < map.Built().Size();
  made.IsExact = !isOfMap || !(map.Built().Tolerance() > 0.0 || map.Built().Form().HasNormals);
  return true;
}

}
