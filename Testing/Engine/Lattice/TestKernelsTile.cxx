// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Work on a tile's rays in vectors, on their way into the planes of the frame, has the bits of the
// same work done one by one.

#include "EachTarget.h"
#include "Grid.h"
#include "Lattice/CellWalk.h"
#include "Lattice/KernelsCorners.h"
#include "Lattice/KernelsRays.h"
#include "Lattice/RaySource.h"
#include "Scene/FramePlanes.h"
#include "Shade/KernelsShading.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

namespace
{

using namespace TemporalCoherence;

class KernelsTile : public EachTarget
{
protected:
  /// Differences of random samples from isovalues, some of which are samples.
  template <typename T>
  void CompareDifferences(double low, double high)
  {
    std::mt19937 engine(17);
    std::uniform_real_distribution<double> value(low, high);
    for (const int count : { 1, 5, 16, 33, 64 })
    {
      CornerPairs<T> pairs{};
      for (auto& row : pairs)
      {
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        {
          row[i] = { static_cast<T>(value(engine)), static_cast<T>(value(engine)) };
        }
      }
      for (const double isovalue : { value(engine), static_cast<double>(pairs[1][0][1]) })
      {
        const Difference<T> difference(isovalue, { low, high });
        this->ForEachTarget(
          [&](const char* target)
          {
            CornerColumns<RealOf<T>> corners;
            FindDifferences(pairs, static_cast<std::size_t>(count), difference, corners);
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            {
              for (std::size_t corner = 0; corner < 8; ++corner)
              {
                EXPECT_EQ(corners[corner][i], difference(pairs[corner / 2][i][corner % 2]))
                  << target << ", segment " << i << " of " << count;
              }
            }
          });
      }
    }
  }
};

TEST_F(KernelsTile, DifferencesOfEveryType)
{
  this->CompareDifferences<std::uint8_t>(0.0, 255.0);
  this->CompareDifferences<std::int8_t>(-128.0, 127.0);
  this->CompareDifferences<std::uint16_t>(0.0, 65535.0);
  this->CompareDifferences<std::int16_t>(-32768.0, 32767.0);
  this->CompareDifferences<std::int32_t>(-2e9, 2e9);
  this->CompareDifferences<float>(-1.0, 1.0);
  this->CompareDifferences<double>(-1e200, 1e200);
}

/// Hits of all kinds, at, before and behind the eye, and misses.
TEST_F(KernelsTile, RowsOfPlanes)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::mt19937 engine(18);
  std::uniform_real_distribution<double> around(-10.0, 10.0);
  std::uniform_int_distribution<int> small(0, 4);
  const glm::ivec2 size(24, 16);
  RayBatch rays;
  HitBatch hits;
  RayBatch::Array<Answer> answers;
  rays.Count = RayBatch::Capacity;
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    rays.Pixel[i] = static_cast<std::int32_t>((8 + i / 8) * 24 + 8 + i % 8);
    rays.PerDepth[i] = 1.0 + 0.01 * around(engine);
    const bool isMiss = small(engine) == 0;
    hits.Depth[i] = isMiss ? infinity : small(engine) == 0 ? 0.0 : around(engine);
    hits.Surface[i] = static_cast<SurfaceIndex>(isMiss ? Frame::NoSurface : small(engine));
    hits.Kind[i] = isMiss ? HitKind::None : static_cast<HitKind>(small(engine) % 4);
    answers[i] = static_cast<Answer>(small(engine) % 3);
  }
  for (const bool isParallel : { false, true })
  {
    for (const bool hasExtras : { false, true })
    {
      Frame expected;
      expected.Resize(size, { hasExtras });
      for (std::int64_t tile = 0; tile < NumberOfTiles(size); ++tile)
      {
        expected.ClearTiles[static_cast<std::size_t>(tile)] = 0;
        StoreMisses(tile, PixelsOfTile(size, tile), isParallel, expected);
      }
      Frame frame = expected;
      for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
      {
        StoreHit(rays, hits, i, answers[i], isParallel, expected);
      }
      StoreHits(rays, hits, answers, isParallel, frame);
      const int pixels = size.x * size.y;
      EXPECT_TRUE(AreIdentical(frame.Depth, expected.Depth, pixels));
      if (hasExtras)
      {
        EXPECT_TRUE(AreIdentical(frame.Disparities, expected.Disparities, pixels));
      }
      EXPECT_TRUE(AreIdentical(frame.Isovalues, expected.Isovalues, pixels));
      EXPECT_TRUE(AreIdentical(frame.Kinds, expected.Kinds, pixels));
      EXPECT_TRUE(AreIdentical(frame.Answers, expected.Answers, pixels));
    }
  }
}

/// The ray of a pixel is the same in a whole tile and in one that the picture cuts off, and its
/// direction in the world is the one that shading finds from the pixel.
TEST_F(KernelsTile, RaysOfPartsOfTiles)
{
  const glm::ivec3 dimensions(20, 30, 40);
  for (const bool isParallel : { false, true })
  {
    const View view = LookAt(dimensions, { 1.0, 2.0, 0.7 }, { 50, 60 }, isParallel);
    const RaySource source(view, IndexTransform(), dimensions);
    const glm::ivec2 first(16, 24);
    for (const glm::ivec2& size :
      { glm::ivec2(8, 8), glm::ivec2(8, 3), glm::ivec2(8, 4), glm::ivec2(5, 7), glm::ivec2(1) })
    {
      this->ForEachTarget(
        [&](const char* target)
        {
          RayBatch rays;
          WorldDirections world;
          source.SetUp(first, size, rays, &world);
          ASSERT_EQ(rays.Count, size.x * size.y);
          for (int i = 0; i < rays.Count; ++i)
          {
            const auto at = static_cast<std::size_t>(i);
            const glm::ivec2 pixel = first + glm::ivec2(i % size.x, i / size.x);
            RayBatch alone;
            source.SetUp(pixel, glm::ivec2(1), alone);
            EXPECT_EQ(rays.Pixel[at], alone.Pixel[0]) << target;
            EXPECT_EQ(rays.Begin[at], alone.Begin[0]) << target;
            EXPECT_EQ(rays.End[at], alone.End[0]) << target;
            EXPECT_EQ(rays.PerDepth[at], alone.PerDepth[0]) << target;
            HitRays shaded;
            shaded.Count = 1;
            RayBatch::Array<double> x, y;
            x.fill(view.PixelCentre(pixel.x, pixel.y).x);
            y.fill(view.PixelCentre(pixel.x, pixel.y).y);
            ShadingKernels::FindRays(view, x, y, shaded);
            for (std::size_t a = 0; a < 3; ++a)
            {
              EXPECT_EQ(rays.Origin[a][at], alone.Origin[a][0]) << target;
              EXPECT_EQ(rays.Direction[a][at], alone.Direction[a][0]) << target;
              EXPECT_EQ(rays.Inverse[a][at], alone.Inverse[a][0]) << target;
              EXPECT_EQ(world[a][at], shaded.Own[a][0]) << target;
            }
          }
        });
    }
  }
}

/// Which rays of a tile still want a walk, and the cells in which rays begin, are what each ray
/// tells alone, whatever numbers it has.
TEST_F(KernelsTile, WalksAndFirstCellsOfRays)
{
  const glm::ivec3 cells(5, 9, 2);
  std::mt19937 engine(31);
  std::uniform_real_distribution<double> near(-1.0, 10.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::array<double, 6> odd = { 0.0, -0.0, 1e300, -1e300, infinity,
    std::numeric_limits<double>::quiet_NaN() };
  const auto any = [&] { return engine() % 8 == 0 ? odd[engine() % odd.size()] : near(engine); };
  for (const int count : { 1, 5, 16, 33, 63, 64 })
  {
    RayBatch rays{};
    HitBatch hits{};
    rays.Count = count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        rays.Origin[a][i] = any();
        rays.Direction[a][i] = any();
      }
      rays.Begin[i] = any();
      rays.End[i] = any();
      rays.WalkBegin[i] = any();
      rays.WalkEnd[i] = any();
      hits.Kind[i] = engine() % 2 == 0 ? HitKind::None : HitKind::Cap;
    }
    this->ForEachTarget(
      [&](const char* target)
      {
        const std::uint64_t walks = WalksWithoutHit(rays, hits);
        CellsOfRays first;
        FindFirstCells(rays, cells, first);
        for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
        {
          const bool isRay = i < static_cast<std::size_t>(count);
          const bool isOne = isRay && rays.HasWalk(i) && hits.Kind[i] == HitKind::None;
          EXPECT_EQ(walks >> i & 1u, isOne) << target << ", ray " << i << " of " << count;
          if (isRay)
          {
            const glm::ivec3 cell = BatchRay{ rays, i }.CellAt(rays.Begin[i], cells);
            EXPECT_EQ(glm::ivec3(first[0][i], first[1][i], first[2][i]), cell)
              << target << ", ray " << i << " of " << count;
          }
        }
      });
  }
}

}
