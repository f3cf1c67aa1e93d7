// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hits of a tile become colours.

#include "KernelBenchmarks.h"
#include "KernelScene.h"
#include "Kinds/FieldKind.h"
#include "Shade/KernelsGradients.h"
#include "Shade/KernelsShading.h"
#include "Shade/SurfaceNormal.h"

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::ShadingKernels;

using Vectors = std::array<Array<double>, 3>;

/// A full tile at every stage of its shading.
struct ShadedTile
{
  Array<double> X, Y;
  HitRays Rays;
  Vectors Gradients;
  PhongSums Sums;
};

template <typename T>
GradientQuery QueryOf(const KernelScene<T>& scene)
{
  return { scene.Key.Samples, glm::dmat4(1.0), scene.Scene.FiniteRange,
    &scene.Key.Isosurfaces().Isovalues };
}

RayBatch::Array<SurfaceIndex> FirstSurface()
{
  RayBatch::Array<SurfaceIndex> surfaces;
  surfaces.fill(0);
  return surfaces;
}

template <typename T>
std::vector<ShadedTile> ShadedTilesOf(const KernelScene<T>& scene)
{
  const View& view = scene.Key.View;
  std::vector<ShadedTile> tiles(scene.FullTiles.size());
  for (std::size_t number = 0; number < tiles.size(); ++number)
  {
    const auto& full = scene.FullTiles[number];
    ShadedTile& tile = tiles[number];
    tile.Rays.Count = tile.Sums.Count = RayBatch::Capacity;
    tile.Rays.T = full.Hits.Depth;
    for (int i = 0; i < RayBatch::Capacity; ++i)
    {
      const auto ray = static_cast<std::size_t>(i);
      const glm::ivec2 pixel = full.Part.First + glm::ivec2(i % TileSize, i / TileSize);
      const glm::dvec2 at = view.PixelCentre(pixel.x, pixel.y);
      tile.X[ray] = at.x;
      tile.Y[ray] = at.y;
    }
    FindRays(view, tile.X, tile.Y, tile.Rays);
    KindOf(scene.Scene.Samples)
      .FindGradients(QueryOf(scene), { tile.Rays, FirstSurface(), tile.Gradients });
    FindFacingNormals(tile.Rays, glm::dmat3(1.0), tile.Gradients, tile.Sums.Normal);
    tile.Sums.Toward = { 0.6f, 0.0f, 0.8f };
    tile.Sums.Diffuse = { 0.7f, 0.7f, 0.7f };
    tile.Sums.Specular = { 0.2f, 0.2f, 0.2f };
    tile.Sums.Power = 10.0;
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      tile.Sums.Color[channel].fill(0.8f);
      tile.Sums.Sum[channel].fill(0.1f);
    }
  }
  return tiles;
}

/// Register a kernel that works on tiles as they are in shading.
template <typename T, typename Kernel>
void Register(const std::string& name, const Kernel& kernel)
{
  KernelBenchmarks::ForEachTarget(name,
    [kernel](benchmark::State& state)
    {
      auto tiles = ShadedTilesOf(SceneOf<T>());
      KernelBenchmarks::RunOnTiles(state, tiles, kernel);
    });
}

template <typename T>
void RegisterGradients(const std::string& type)
{
  Register<T>("FindCells/" + type,
    [](ShadedTile& tile)
    {
      const GradientKernels::CellSpace space{ glm::dmat4(1.0),
        SceneOf<T>().Key.Samples.Dimensions };
      GradientKernels::CellPoints<RealOf<T>> found;
      found.Count = RayBatch::Capacity;
      FindCells(space, tile.Rays, found);
      benchmark::DoNotOptimize(found);
    });
  Register<T>("IndexGradients/" + type,
    [surfaces = FirstSurface()](ShadedTile& tile)
    {
      KindOf(SceneOf<T>().Scene.Samples)
        .FindGradients(QueryOf(SceneOf<T>()), { tile.Rays, surfaces, tile.Gradients });
    });
}

}

void KernelBenchmarks::RegisterShading()
{
  RegisterGradients<std::uint8_t>("bytes");
  RegisterGradients<float>("floats");
  Register<std::uint8_t>("FindRays",
    [](ShadedTile& tile)
    { FindRays(SceneOf<std::uint8_t>().Key.View, tile.X, tile.Y, tile.Rays); });
  Register<std::uint8_t>("FindFacingNormals",
    [](ShadedTile& tile)
    { FindFacingNormals(tile.Rays, glm::dmat3(1.0), tile.Gradients, tile.Sums.Normal); });
  Register<std::uint8_t>("AddLight", [](ShadedTile& tile) { AddLight(tile.Rays, tile.Sums); });
  Register<std::uint8_t>("RoundColors",
    [](ShadedTile& tile)
    {
      Array<std::array<std::uint8_t, 4>> colors;
      RoundColors(tile.Sums, colors);
      benchmark::DoNotOptimize(colors);
    });
}
