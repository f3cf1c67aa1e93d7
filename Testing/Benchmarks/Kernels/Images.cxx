// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays of a tile, and where a cached image shows them.

#include "ImageCache/KernelsImage.h"
#include "KernelBenchmarks.h"
#include "KernelScene.h"
#include "Lattice/KernelsRays.h"

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
}
