// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/IsomapLookup.h"
#include "Render/RouteSteps.h"

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
constexpr std::int64_t FewRaysInMesh = 64; ///< where a tile looks at all of its leaves

/// Trace the rays that an isomap leaves unresolved, one bit each, tile by tile, and shade these
/// tiles.
/// \param leaps active cells are prepared
/// \param limit counts the layers of these tiles
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
  const std::int64_t few = task.Key.Samples.Shape->Abilities().IsMesh ? FewRaysInMesh : FewRays;
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
    , Lookup(task.Key, map, task.Structures.Pyramid().FiniteRange(),
        MakeSurfaceTracer({ task.Key.Samples, task.Key.Isosurfaces(),
          task.Structures.Pyramid().FiniteRange(), nullptr }))
    , Tracer(SceneOf(task, space, nullptr))
    , Shader(ShadeSceneOf(task, space), map.Form().HasNormals ? HitSet::NotDefinite : HitSet::All,
        HitSet::All)
    , ShaderOfTraced(ShadeSceneOf(task, space), HitSet::All, HitSet::All)
  {
  }

  bool MakeAll(const ReportProgress& report)
  {
    const glm::ivec2& size = this->Task.Key.View.Size;
    return CountGroups(size, report, this->Task.Statistics,
      [&](std::size_t group, TraceCounts& sum)
      {
        TraceCounts ofGroup;
        this->Make(group, ofGroup);
        this->Bands.Done(group, ofGroup.CellsRead);
        sum += ofGroup;
      });
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
    bands.MakeBuilders();
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
  // If every tile has bands, rays only walk behind translucent surfaces.
  const bool isCovered = map.Built().Covers(task.Key.Isosurfaces().Isovalues);
  isBuilding |= !isCovered;
  const bool leaps =
    task.Options.SpaceLeaping && (task.Key.Isosurfaces().IsTranslucent() || !isCovered);
  const LeapedSpace space = Begin(task, leaps, ExtrasOf(task));
  const BandSource source{ task.Key, task.Structures.Pyramid(), MakeBandTracer };
  FrameBands bands({ source, task.Options.Map, task.Store.Last().Key.Isosurfaces().Isovalues },
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
