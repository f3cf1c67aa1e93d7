// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BothWays_h
#define Testing_BothWays_h

#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/Tiles.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

/// Traces tiles both ways, by walks and as beams, and compares.
template <typename T>
class BothWays
{
public:
  BothWays(Grid<T>& grid, const std::vector<double>& isovalues, TemporalCoherence::SurfaceMode mode)
    : Dimensions(grid.Field.Dimensions)
    , Traced(grid, isovalues, mode)
  {
    TemporalCoherence::TraceScene& scene = this->Traced.Scene;
    scene.By = TemporalCoherence::Traversal::Walks;
    this->Walks = TemporalCoherence::MakeSurfaceTracer(scene);
    scene.By = TemporalCoherence::Traversal::Beams;
    this->Beams = TemporalCoherence::MakeSurfaceTracer(scene);
  }

  /// All tiles of a view.
  void Compare(const TemporalCoherence::View& view)
  {
    const TemporalCoherence::RaySource source(
      view, TemporalCoherence::IndexTransform(), this->Dimensions);
    for (std::int64_t tile = 0; tile < TemporalCoherence::NumberOfTiles(view.Size); ++tile)
    {
      const TemporalCoherence::PixelRect part = TemporalCoherence::PixelsOfTile(view.Size, tile);
      TemporalCoherence::RayBatch rays;
      source.SetUp(part.First, part.Size, rays);
      this->CompareRays(rays);
    }
  }

  /// The same of rays that begin and end anywhere.
  void CompareCut(const TemporalCoherence::View& view)
  {
    const TemporalCoherence::RaySource source(
      view, TemporalCoherence::IndexTransform(), this->Dimensions);
    std::uniform_real_distribution<double> share(-0.3, 1.0);
    for (std::int64_t tile = 0; tile < TemporalCoherence::NumberOfTiles(view.Size); ++tile)
    {
      const TemporalCoherence::PixelRect part = TemporalCoherence::PixelsOfTile(view.Size, tile);
      TemporalCoherence::RayBatch rays;
      source.SetUp(part.First, part.Size, rays);
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
      {
        const double length = rays.End[i] - rays.Begin[i];
        const auto cut = [&] { return std::max(0.5 * share(this->Random) * length, 0.0); };
        rays.WalkBegin[i] = rays.Begin[i] += cut();
        rays.WalkEnd[i] = rays.End[i] -= cut();
      }
      this->CompareRays(rays);
    }
  }

  std::int64_t Rays = 0, Hits = 0;

protected:
  void CompareRays(const TemporalCoherence::RayBatch& rays)
  {
    TemporalCoherence::HitBatch walked, beamed;
    this->Walks->Trace(rays, walked);
    this->Beams->Trace(rays, beamed);
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      ++this->Rays;
      this->Hits += walked.Kind[i] != TemporalCoherence::HitKind::None;
      ASSERT_EQ(beamed.Depth[i], walked.Depth[i]);
      ASSERT_EQ(beamed.Surface[i], walked.Surface[i]);
      ASSERT_EQ(beamed.Kind[i], walked.Kind[i]);
    }
  }

  glm::ivec3 Dimensions;
  Tracing<T> Traced;
  std::shared_ptr<const TemporalCoherence::SurfaceTracer> Walks, Beams;
  std::mt19937 Random{ 7 };
};

#endif
