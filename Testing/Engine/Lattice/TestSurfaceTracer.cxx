// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A ray has the same hit, to the last bit, wherever its walk begins and ends, with and without
// leaping, also beside hidden cells. THRESHOLD caps what is cut open.

#include "Checks/Infinity.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/Frame.h"
#include "Scene/HiddenCells.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace TemporalCoherence;

RayBatch RaysOfTile(const View& view, const glm::ivec3& dimensions, const glm::ivec2& tile)
{
  RayBatch rays;
  RaySource(view, IndexTransform(), dimensions).SetUp(8 * tile, glm::ivec2(8), rays);
  return rays;
}

TEST(SurfaceTracer, PlaneIsHitWhereItIs)
{
  Grid<float> grid(glm::ivec3(40, 30, 20));
  grid.Fill([](int i, int j, int k) { return 0.5 * i - 0.25 * j + k; });
  const double isovalue = 14.125;
  const Tracing<float> tracing(grid, { isovalue }, SurfaceMode::Crossing);
  const View view = LookAt(grid.Field.Dimensions, { -1.0, 0.4, -0.3 }, { 64, 64 });
  int hitCount = 0;
  for (int tile = 0; tile < 64; ++tile)
  {
    const RayBatch rays = RaysOfTile(view, grid.Field.Dimensions, { tile % 8, tile / 8 });
    const HitBatch hits = tracing.Trace(rays);
    for (std::size_t i = 0; i < 64; ++i)
    {
      const glm::dvec3 o(rays.Origin[0][i], rays.Origin[1][i], rays.Origin[2][i]);
      const glm::dvec3 d(rays.Direction[0][i], rays.Direction[1][i], rays.Direction[2][i]);
      const glm::dvec3 normal(0.5, -0.25, 1.0);
      const double t = (isovalue - glm::dot(o, normal)) / glm::dot(d, normal);
      const bool isHit = t >= rays.Begin[i] && t <= rays.End[i];
      EXPECT_EQ(hits.Surface[i], isHit ? 0 : Frame::NoSurface);
      EXPECT_NEAR(isHit ? hits.Depth[i] - t : 0.0, 0.0, 1e-9);
      hitCount += isHit;
    }
  }
  EXPECT_GT(hitCount, 200);
}

/// The same hits, to the last bit.
void ExpectSame(const HitBatch& a, const HitBatch& b, std::size_t i)
{
  EXPECT_EQ(a.Depth[i], b.Depth[i]);
  EXPECT_EQ(a.Surface[i], b.Surface[i]);
  EXPECT_EQ(a.Kind[i], b.Kind[i]);
}

template <typename T>
void ExpectIndependenceOfTheWalk(
  Grid<T>& grid, const std::vector<double>& isovalues, SurfaceMode mode)
{
  const Tracing<T> tracing(grid, isovalues, mode);
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const glm::dvec3 direction : { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0),
         glm::dvec3(-1.0, -1.0, 0.0), glm::dvec3(0.3, -0.7, 0.9) })
  {
    for (const bool parallel : { false, true })
    {
      const View view = LookAt(grid.Field.Dimensions, direction, { 64, 64 }, parallel);
      for (int tile = 0; tile < 64; tile += 3)
      {
        RayBatch rays = RaysOfTile(view, grid.Field.Dimensions, { tile % 8, tile / 8 });
        const HitBatch hits = tracing.Trace(rays);

        TraceScene plain = tracing.Scene;
        plain.Active = nullptr;
        HitBatch plainHits;
        MakeSurfaceTracer(plain)->Trace(rays, plainHits);

        // Any walk that contains the hit must find it.
        for (std::size_t i = 0; i < 64; ++i)
        {
          if (hits.Surface[i] != Frame::NoSurface)
          {
            rays.WalkBegin[i] += share(engine) * (hits.Depth[i] - rays.WalkBegin[i]);
            rays.WalkEnd[i] = hits.Depth[i] + share(engine) * (rays.WalkEnd[i] - hits.Depth[i]);
          }
        }
        const HitBatch shortHits = tracing.Trace(rays);
        for (std::size_t i = 0; i < 64; ++i)
        {
          ExpectSame(hits, plainHits, i);
          if (rays.WalkBegin[i] < rays.WalkEnd[i])
          {
            ExpectSame(hits, shortHits, i);
          }
        }
      }
    }
  }
}

TEST(SurfaceTracer, ResultDoesNotDependOnTheWalk)
{
  Grid<std::uint8_t> smooth(glm::ivec3(50, 41, 37));
  smooth.Fill([](int i, int j, int k)
    { return 120.0 + 100.0 * std::sin(0.4 * i) * std::cos(0.3 * j + 0.2 * k); });
  Grid<std::uint8_t> noise(glm::ivec3(33, 34, 35));
  noise.FillRandomly(0.0, 4.0, 9); // few values: many samples equal the isovalue
  Grid<double> doubles(glm::ivec3(20, 21, 22));
  doubles.FillRandomly(-1.0, 1.0, 10);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
    {
      smooth.Field.Between = noise.Field.Between = doubles.Field.Between = between;
      ExpectIndependenceOfTheWalk(smooth, { 120.0 }, mode);
      ExpectIndependenceOfTheWalk(smooth, { 60.0, 180.0 }, mode);
      ExpectIndependenceOfTheWalk(noise, { 2.0 }, mode);
      ExpectIndependenceOfTheWalk(noise, { 2.5 }, mode);
      ExpectIndependenceOfTheWalk(doubles, { 0.7 }, mode);
    }
  }
}

/// Hide cells here and there, and every cell of some blocks.
template <typename T>
void HideSome(Grid<T>& grid)
{
  const glm::ivec3 cells = grid.Field.Dimensions - 1;
  std::mt19937 engine(4);
  std::vector<std::uint8_t> flags;
  for (int i = 0; i < cells.x * cells.y * cells.z; ++i)
  {
    const glm::ivec3 cell(i % cells.x, i / cells.x % cells.y, i / cells.x / cells.y);
    const glm::ivec3 block = cell / 7;
    flags.push_back((block.x + block.y + block.z) % 3 == 0 || engine() % 9 == 0);
  }
  grid.Field.Hidden = HiddenCells::Make(grid.Field.Dimensions, { flags.data(), 1, nullptr, 0 });
}

TEST(SurfaceTracer, ResultBesideHiddenCellsDoesNotDependOnTheWalk)
{
  Grid<std::uint8_t> smooth(glm::ivec3(50, 41, 37));
  smooth.Fill([](int i, int j, int k)
    { return 120.0 + 100.0 * std::sin(0.4 * i) * std::cos(0.3 * j + 0.2 * k); });
  HideSome(smooth);
  Grid<double> doubles(glm::ivec3(20, 21, 22));
  doubles.FillRandomly(-1.0, 1.0, 10);
  HideSome(doubles);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
    {
      smooth.Field.Between = doubles.Field.Between = between;
      ExpectIndependenceOfTheWalk(smooth, { 120.0 }, mode);
      ExpectIndependenceOfTheWalk(smooth, { 60.0, 180.0 }, mode);
      ExpectIndependenceOfTheWalk(smooth, { 10.0 }, mode);
      ExpectIndependenceOfTheWalk(doubles, { 0.7 }, mode);
    }
  }
}

TEST(SurfaceTracer, ThresholdCapsWhatIsCutOpen)
{
  Grid<std::uint8_t> grid(glm::ivec3(8, 8, 8));
  grid.Fill([](int, int, int) { return 9; });
  const View view = LookAt(grid.Field.Dimensions, { 0.0, 0.0, 1.0 }, { 8, 8 }, true);
  const RayBatch rays = RaysOfTile(view, grid.Field.Dimensions, { 0, 0 });

  const Tracing<std::uint8_t> crossing(grid, { 5.0 }, SurfaceMode::Crossing);
  const Tracing<std::uint8_t> threshold(grid, { 5.0, 7.0, 12.0 }, SurfaceMode::Threshold);
  const HitBatch open = crossing.Trace(rays);
  const HitBatch capped = threshold.Trace(rays);
  int caps = 0;
  for (std::size_t i = 0; i < 64; ++i)
  {
    EXPECT_EQ(open.Surface[i], Frame::NoSurface);
    if (rays.Begin[i] < rays.End[i])
    {
      EXPECT_EQ(capped.Depth[i], rays.Begin[i]);
      EXPECT_EQ(capped.Surface[i], 1) << "the highest isovalue that the field reaches";
      EXPECT_EQ(capped.Kind[i], HitKind::Cap);
      ++caps;
    }
  }
  EXPECT_GT(caps, 10);
}

TEST(SurfaceTracer, NothingWhereNothingIs)
{
  Grid<float> grid(glm::ivec3(9, 9, 9));
  grid.Fill([](int, int, int) { return std::numeric_limits<double>::quiet_NaN(); });
  const View view = LookAt(grid.Field.Dimensions, { 1.0, 2.0, 3.0 }, { 8, 8 });
  const RayBatch rays = RaysOfTile(view, grid.Field.Dimensions, { 0, 0 });
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    const HitBatch hits = Tracing<float>(grid, { -1e30 }, mode).Trace(rays);
    for (std::size_t i = 0; i < 64; ++i)
    {
      EXPECT_EQ(hits.Depth[i], Infinity);
    }
  }
}

}
