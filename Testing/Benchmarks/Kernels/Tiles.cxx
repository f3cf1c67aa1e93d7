// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Whole tiles: walk from cell to cell and crossings; look-up in an isomap.

#include "Isomap/IsomapLookup.h"
#include "Isomap/RangeBuild.h"
#include "KernelBenchmarks.h"
#include "KernelScene.h"
#include "Kinds/FieldKind.h"
#include "Lattice/KernelsWalk.h"

#include <limits>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// The active cells of a scene's leaves.
template <typename T>
class SceneLeaves : public LeafSource
{
public:
  explicit SceneLeaves(const KernelScene<T>& scene)
    : Active(scene.Active)
    , Samples(scene.Key.Samples)
  {
  }

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Active.CellsOf(this->Samples, node, cell);
  }

private:
  const ActiveCells& Active;
  const TypedField<T> Samples;
};

/// An isomap of one band around the scene's isovalue.
template <typename T>
Isomap IsomapOf(const KernelScene<T>& scene)
{
  constexpr double halfBand = 2.0;
  constexpr double isovalue = KernelScene<T>::Isovalue;
  Isomap map;
  map.Begin(scene.Key, {});
  const RangeBuild wanted{ { scene.Key, scene.Pyramid, MakeBandTracer },
    { isovalue - halfBand, isovalue + halfBand }, std::numeric_limits<std::size_t>::max(), 1 };
  bool isDropped = false;
  std::int64_t cellsRead = 0;
  BuildRange(wanted, map, {}, isDropped, cellsRead);
  return map;
}

template <typename T>
void RegisterFor(const std::string& type)
{
  using Tile = typename KernelScene<T>::Tile;
  KernelBenchmarks::ForEachTarget("TraceTile/" + type,
    [](benchmark::State& state)
    {
      KernelScene<T>& scene = SceneOf<T>();
      const auto tracer = MakeSurfaceTracer(scene.Scene);
      HitBatch hits;
      KernelBenchmarks::RunOnTiles(
        state, scene.FullTiles, [&](const Tile& tile) { tracer->Trace(tile.Rays, hits); });
    });
  KernelBenchmarks::ForEachTarget("LookUpTile/" + type,
    [](benchmark::State& state)
    {
      KernelScene<T>& scene = SceneOf<T>();
      const Isomap map = IsomapOf(scene);
      if (!map.Covers({ KernelScene<T>::Isovalue }))
      {
        state.SkipWithError("There is no band for the isovalue: mend the benchmark.");
        return;
      }
      TraceScene cells = scene.Scene;
      cells.Active = nullptr;
      const IsomapLookup lookup(scene.Key, map, cells.FiniteRange, MakeSurfaceTracer(cells));
      std::vector<IsomapLookup::IsovalueKeys> keys;
      Frame frame;
      frame.Resize(scene.Key.View.Size);
      KernelBenchmarks::RunOnTiles(state, scene.FullTiles,
        [&](const Tile& tile)
        {
          std::uint64_t unresolved = 0;
          TileHits hits;
          lookup.FindBands(static_cast<std::size_t>(tile.Number / TileGrain), keys);
          benchmark::DoNotOptimize(
            lookup.LookUpTile(tile.Number, tile.Part, keys, frame, unresolved, hits));
        });
    });
}

/// The way to the first active cell, which does not depend on the type of the samples.
void RegisterWalk()
{
  using Scene = KernelScene<std::uint8_t>;
  KernelBenchmarks::ForEachTarget("FindActiveCells",
    [](benchmark::State& state)
    {
      Scene& scene = SceneOf<std::uint8_t>();
      const SceneLeaves<std::uint8_t> leaves(scene);
      const WalkScene walked{ scene.Active, leaves, scene.Key.Samples.Dimensions - 1 };
      KernelBenchmarks::RunOnTiles(state, scene.FullTiles,
        [&](const Scene::Tile& tile)
        {
          RayWalks walks(tile.Rays, ~std::uint64_t(0));
          FindActiveCells(walked, walks);
          benchmark::DoNotOptimize(walks);
        });
    });
}

/// The search among the knots of a ray alone, of which there is one kind.
void RegisterKnots()
{
  for (const int knots : { 4, 64 })
  {
    benchmark::RegisterBenchmark(("FindKnot/of " + std::to_string(knots)).c_str(),
      [knots](benchmark::State& state)
      {
        std::vector<BandScale::Key> keys, wanted;
        for (int i = 0; i < knots; ++i)
        {
          keys.push_back(static_cast<BandScale::Key>(i * 65535 / knots));
        }
        for (int i = 0; i < 64; ++i)
        {
          wanted.push_back(static_cast<BandScale::Key>(i * 7919 % 65536));
        }
        std::vector<int> once(1);
        KernelBenchmarks::RunOnTiles(state, once,
          [&](int)
          {
            for (const BandScale::Key key : wanted)
            {
              benchmark::DoNotOptimize(FirstNotBelow(keys.data(), 0, keys.size(), key));
            }
          });
      });
  }
}

}

void KernelBenchmarks::RegisterTiles()
{
  RegisterFor<std::uint8_t>("bytes");
  RegisterFor<float>("floats");
  RegisterWalk();
  RegisterKnots();
}
