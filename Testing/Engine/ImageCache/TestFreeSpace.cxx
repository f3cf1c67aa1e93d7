// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What a picture shows to be free, on pictures made by hand: a hit on its own keeps its
// neighbours from being free, in whatever tiles these are, and planes are free up to where they
// are.

#include "Grid.h"
#include "ImageCache/FreeSpace.h"
#include "ImageCache/KernelsImage.h"
#include "Scene/Disparity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using namespace TemporalCoherence;

const glm::ivec2 Size(21, 19); ///< tiles of which not all are whole

std::size_t PlaceOf(int x, int y)
{
  return static_cast<std::size_t>(y * Size.x + x);
}

/// A picture with nothing in it.
Frame ClearFrame(bool isParallel)
{
  Frame frame;
  frame.Resize(Size, { true, true });
  const auto miss = static_cast<float>(DisparityOfMiss(isParallel));
  std::fill(frame.Disparities.begin(), frame.Disparities.end(), miss);
  std::fill(frame.FirstEntries.begin(), frame.FirstEntries.end(), miss);
  std::fill(frame.Kinds.begin(), frame.Kinds.end(), HitKind::None);
  std::fill(frame.ClearTiles.begin(), frame.ClearTiles.end(), std::uint8_t(1));
  return frame;
}

/// A surface, and where its ray comes to active cells.
void SetHit(Frame& frame, int x, int y, double depth, double firstEntry, bool isParallel)
{
  frame.Disparities[PlaceOf(x, y)] = static_cast<float>(DisparityOf(depth, isParallel));
  frame.FirstEntries[PlaceOf(x, y)] = static_cast<float>(DisparityOf(firstEntry, isParallel));
  frame.Kinds[PlaceOf(x, y)] = HitKind::Entry;
  frame.ClearTiles[static_cast<std::size_t>(y / TileSize * TilesOf(Size).x + x / TileSize)] = 0;
}

/// Voxels are 1, and pixels too, which is too coarse for surfaces alone to tell anything.
FreeSpace::Options Coarse()
{
  FreeSpace::Options options;
  options.Voxel = options.Bend = options.Spacing = 1.0;
  options.FineDepth = 0.0;
  return options;
}

TEST(FreeSpace, AHitOnItsOwnGuardsItsNeighbours)
{
  for (const bool isParallel : { false, true })
  {
    const View view = LookAt(glm::ivec3(20), { 1.0, 2.0, 0.7 }, Size, isParallel);
    const auto miss = static_cast<float>(DisparityOfMiss(isParallel));
    FreeSpace space;
    for (int hit = 0; hit < Size.x * Size.y; ++hit)
    {
      const glm::ivec2 at(hit % Size.x, hit / Size.x);
      Frame frame = ClearFrame(isParallel);
      SetHit(frame, at.x, at.y, 30.0, 29.0, isParallel);
      space.Clear();
      space.Make(frame, view, Coarse());
      for (int y = 0; y < Size.y; ++y)
      {
        for (int x = 0; x < Size.x; ++x)
        {
          const bool isNear = std::abs(x - at.x) <= 1 && std::abs(y - at.y) <= 1;
          const float expected = isNear ? frame.FirstEntries[PlaceOf(at.x, at.y)] : miss;
          ASSERT_EQ(space.Guard()[PlaceOf(x, y)], expected)
            << x << ", " << y << " for a hit at " << at.x << ", " << at.y;
        }
      }
    }
  }
}

/// The guard, as a depth, of a pixel in the middle of a surface that a parallel view shows.
double GuardedDepth(const std::function<double(int, int)>& depth, double entryBefore,
  const FreeSpace::Options& options = Coarse(), HitKind kind = HitKind::Entry)
{
  Frame frame = ClearFrame(true);
  for (int y = 0; y < Size.y; ++y)
  {
    for (int x = 0; x < Size.x; ++x)
    {
      SetHit(frame, x, y, depth(x, y), depth(x, y) - entryBefore, true);
      frame.Kinds[PlaceOf(x, y)] = kind;
    }
  }
  FreeSpace space;
  space.Make(frame, LookAt(glm::ivec3(20), { 1.0, 2.0, 0.7 }, Size, true), options);
  return -static_cast<double>(space.Guard()[PlaceOf(12, 11)]);
}

/// Vectors end where the tile does.
TEST(FreeSpace, NothingIsWrittenBehindATile)
{
  struct
  {
    GuardTile Tile;
    std::array<float, 32> Behind;
  } all;
  all.Tile.Surface.fill(0.1f);
  all.Tile.FirstEntry.fill(0.2f);
  all.Tile.Fine.fill(1.0f);
  all.Tile.Guard.fill(-1.0f);
  all.Behind.fill(-2.0f);
  GuardRule rule;
  rule.Spacing = 1.0f;
  MakeGuard(rule, all.Tile);
  EXPECT_EQ(std::count(all.Tile.Guard.begin(), all.Tile.Guard.end(), -1.0f), 0);
  EXPECT_EQ(std::count(all.Behind.begin(), all.Behind.end(), -2.0f), 32);
}

TEST(FreeSpace, APlaneIsFreeAlmostUpToIt)
{
  const auto flat = [](int, int) { return 30.0; };
  // An eighth of a voxel before it, if its active cells begin within two.
  EXPECT_NEAR(GuardedDepth(flat, 1.0), 30.0 - 0.125, 1e-5);
  EXPECT_NEAR(GuardedDepth(flat, 1.9), 30.0 - 0.125, 1e-5);
  EXPECT_NEAR(GuardedDepth(flat, 2.1), 30.0 - 2.1, 1e-5);
  // First entries that are nearer than that tell more.
  EXPECT_NEAR(GuardedDepth(flat, 0.0625), 30.0 - 0.0625, 1e-5);
  // Sloped, it comes nearer within the pixel, by half of the way to its neighbours; and a first
  // entry is farther before it along the ray.
  const auto sloped = [](int x, int y) { return 30.0 + 0.5 * x - 0.25 * y; };
  const double there = sloped(12, 11);
  EXPECT_NEAR(GuardedDepth(sloped, 1.0), there - 0.375 - 0.125, 1e-5);
  EXPECT_NEAR(GuardedDepth(sloped, 3.4), there - 0.375 - 0.125, 1e-5);
  EXPECT_NEAR(GuardedDepth(sloped, 3.6), there - 0.75 - 3.6, 1e-5);
}

TEST(FreeSpace, WhatIsBentIsNoPlane)
{
  // A crease, seen by the neighbours in each direction.
  const glm::ivec2 directions[] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, -1 } };
  for (const glm::ivec2& along : directions)
  {
    for (const double bend : { 0.24, 0.26 })
    {
      const auto bent = [&](int x, int y)
      {
        const bool isThere = x - 12 == along.x && y - 11 == along.y;
        return 30.0 + (isThere ? bend : 0.0);
      };
      const double expected = bend < 0.25 ? 30.0 - 0.125 : 30.0 - 1.0;
      EXPECT_NEAR(GuardedDepth(bent, 1.0), expected, 1e-5) << along.x << ' ' << along.y;
    }
  }
}

TEST(FreeSpace, WherePixelsAreFineSurfacesAloneTell)
{
  FreeSpace::Options fine = Coarse();
  fine.FineDepth = std::numeric_limits<double>::infinity();
  const auto step = [](int x, int) { return x < 13 ? 30.0 : 40.0; };
  // One and a half voxels before an edge, wherever active cells begin.
  EXPECT_NEAR(GuardedDepth(step, 5.0, fine), 30.0 - 1.5, 1e-5);
  // Seen from inside, they do not.
  EXPECT_NEAR(GuardedDepth(step, 5.0, fine, HitKind::Exit), 30.0 - 5.0, 1e-5);
  EXPECT_NEAR(GuardedDepth(step, 5.0, fine, HitKind::Within), 30.0 - 5.0, 1e-5);
  // Nothing is known behind the farthest depth.
  FreeSpace::Options options = Coarse();
  options.FarthestDepth = 20.0;
  EXPECT_NEAR(GuardedDepth(step, 1.0, options), 20.0, 1e-5);
}

}
