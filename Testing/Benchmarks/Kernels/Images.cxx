// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays of a tile, and what a cached image tells about them.

#include "ImageCache/KernelsImage.h"
#include "KernelBenchmarks.h"
#include "KernelScene.h"
#include "Trace/KernelsRays.h"

namespace
{

using namespace TemporalCoherence;

using Scene = KernelScene<std::uint8_t>;

/// A picture of a view as rays of index space see it.
ImageProjection ProjectionOf(const View& view)
{
  const glm::dvec4 x = RowOf(view.ClipFromWorld, 0), y = RowOf(view.ClipFromWorld, 1),
                   w = RowOf(view.ClipFromWorld, 3);
  ImageProjection image;
  image.Near = view.Near;
  image.Far = view.Far;
  image.Size = view.Size;
  image.RowU = 0.5 * view.Size.x * (x + w);
  image.RowV = 0.5 * view.Size.y * (y + w);
  image.RowZ = w;
  return image;
}

/// Surfaces as a cached picture shows them around a tile: the tile's, continued at its border.
std::vector<GuardTile> GuardTilesOf(const Scene& scene)
{
  std::vector<GuardTile> tiles;
  for (const Scene::Tile& full : scene.FullTiles)
  {
    GuardTile tile;
    tile.Fine.fill(0.0f);
    for (int y = 0; y < GuardTile::Width; ++y)
    {
      for (int x = 0; x < GuardTile::Width; ++x)
      {
        const auto ray = static_cast<std::size_t>(
          std::clamp(x - 1, 0, TileSize - 1) + TileSize * std::clamp(y - 1, 0, TileSize - 1));
        const auto at = static_cast<std::size_t>(x + GuardTile::Width * y);
        const auto disparityOf = [&](double t)
        { return static_cast<float>(full.Rays.PerDepth[ray] / t); };
        tile.Surface[at] = disparityOf(full.Hits.Depth[ray]);
        tile.FirstEntry[at] = disparityOf(full.Hits.FirstEntry[ray]);
      }
    }
    tiles.push_back(tile);
  }
  return tiles;
}

}

void KernelBenchmarks::RegisterImages()
{
  ForEachTarget("SetUpRays",
    [](benchmark::State& state)
    {
      Scene& scene = SceneOf<std::uint8_t>();
      const RaySource source(scene.Key.View, scene.Key.Transform, scene.Key.Samples.Dimensions);
      RayBatch rays;
      RunOnTiles(state, scene.FullTiles,
        [&](const Scene::Tile& tile) { SetUpRays(source, tile.Part.First, tile.Part.Size, rays); });
    });
  ForEachTarget("ProjectWalks",
    [](benchmark::State& state)
    {
      Scene& scene = SceneOf<std::uint8_t>();
      // A turned camera's: in a ray's own picture it is a point.
      const ImageProjection image =
        ProjectionOf(LookAt(scene.Key.Samples.Dimensions, { 1.0, 2.05, 0.7 }, scene.Key.View.Size));
      PathBatch paths;
      RunOnTiles(state, scene.FullTiles,
        [&](const Scene::Tile& tile) { ProjectWalks(image, tile.Rays, paths); });
    });
  ForEachTarget("MakeGuard",
    [](benchmark::State& state)
    {
      GuardRule rule;
      rule.EdgeMargin = 1.5f;
      rule.SmoothMargin = 0.125f;
      rule.LargestBend = 0.25f;
      rule.LargestGap = 1.0f;
      rule.Spacing = 1e-3f;
      auto tiles = GuardTilesOf(SceneOf<std::uint8_t>());
      RunOnTiles(state, tiles, [&](GuardTile& tile) { MakeGuard(rule, tile); });
    });
}
