// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_KernelScene_h
#define Benchmarks_KernelScene_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/FrameKey.h"
#include "Scene/Tiles.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Waves, whose surface a camera looks at: what kernels are given as they are in a frame. Index
/// space is the world.
template <typename T>
struct KernelScene
{
  static constexpr int Samples = 128; ///< along each axis
  static constexpr int Pixels = 512;  ///< in each direction
  static constexpr double Isovalue = 150.0;

  /// A tile all of whose rays meet the surface.
  struct Tile
  {
    std::int64_t Number;
    TemporalCoherence::PixelRect Part;
    TemporalCoherence::RayBatch Rays;
    TemporalCoherence::HitBatch Hits;
  };

  KernelScene()
    : Waves(glm::ivec3(Samples))
  {
    this->Waves.Fill([](int i, int j, int k)
      { return 120.0 + 100.0 * std::sin(0.1 * i) * std::cos(0.125 * j) * std::sin(0.15 * k); });
    this->Pyramid.Build(this->Waves.Field);
    this->Key.Samples = this->Waves.Field;
    this->Key.EditIsosurfaces().Isovalues = { Isovalue };
    this->Key.View = LookAt(this->Waves.Field.Dimensions, { 1.0, 2.0, 0.7 }, { Pixels, Pixels });
    this->Active.Build(this->Key.Samples, this->Pyramid, this->Key.Isosurfaces());
    this->Scene.Samples = this->Key.Samples;
    this->Scene.Isosurfaces = this->Key.Isosurfaces();
    this->Scene.FiniteRange = this->Pyramid.FiniteRange();
    this->Scene.Active = &this->Active;
    this->FindFullTiles();
  }
  KernelScene(const KernelScene&) = delete;
  void operator=(const KernelScene&) = delete;

  Grid<T> Waves;
  TemporalCoherence::ValueRangePyramid Pyramid;
  TemporalCoherence::FrameKey Key;
  TemporalCoherence::ActiveCells Active;
  TemporalCoherence::TraceScene Scene;
  std::vector<Tile> FullTiles;

private:
  void FindFullTiles()
  {
    using namespace TemporalCoherence;
    const RaySource source(this->Key.View, this->Key.Transform, this->Key.Samples.Dimensions);
    const auto tracer = MakeSurfaceTracer(this->Scene);
    for (std::int64_t number = 0; number < NumberOfTiles(this->Key.View.Size); ++number)
    {
      Tile tile{ number, PixelsOfTile(this->Key.View.Size, number), {}, {} };
      source.SetUp(tile.Part.First, tile.Part.Size, tile.Rays);
      tracer->Trace(tile.Rays, tile.Hits);
      const auto count = static_cast<std::size_t>(tile.Rays.Count);
      const auto begin = tile.Hits.Depth.begin();
      if (count == RayBatch::Capacity &&
        std::all_of(begin, begin + RayBatch::Capacity, [](double t) { return std::isfinite(t); }))
      {
        this->FullTiles.push_back(tile);
      }
    }
  }
};

/// One scene for all benchmarks of a type of samples.
template <typename T>
KernelScene<T>& SceneOf()
{
  static KernelScene<T> scene;
  return scene;
}

#endif
