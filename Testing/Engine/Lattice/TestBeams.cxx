// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The rays of a tile that go as a beam meet what they meet on walks, bit by bit, on any field, from
// anywhere, on every kind of vectors.
#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "Grid.h"
#include "Lattice/BeamCameras.h"
#include "Lattice/BothWays.h"
#include "Lattice/Waves.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

class Beams : public EachTarget
{
protected:
  template <typename T>
  void Compare(Grid<T>& grid, double isovalue, int pixels = IsMemorySanitized ? 24 : 72)
  {
    this->CompareAll(grid, { isovalue }, pixels);
  }

  template <typename T>
  void CompareAll(Grid<T>& grid, const std::vector<double>& isovalues, int pixels)
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      BothWays<T> ways(grid, isovalues, mode);
      for (const Camera& camera : CamerasFor(grid.Field.Dimensions))
      {
        ways.Compare(ViewFrom(camera, pixels));
        if (this->HasFatalFailure())
        {
          return;
        }
      }
      EXPECT_GT(ways.Hits, ways.Rays / 50);
      this->Rays += ways.Rays;
    }
  }

  std::int64_t Rays = 0;
};

TEST_F(Beams, MeetWhatWalksMeetOnSmoothFields)
{
  Grid<float> waves(glm::ivec3(50, 41, 37));
  waves.Fill(Wave);
  this->Compare(waves, 0.1);
  Grid<std::int16_t> ball(glm::ivec3(41, 41, 41));
  ball.Fill([](int i, int j, int k)
    { return 100.0 * glm::length(glm::dvec3(i - 20.0, j - 20.0, k - 20.0)); });
  this->Compare(ball, 1500.0);
  EXPECT_GT(this->Rays, IsMemorySanitized ? 20000 : 200000);
}

TEST_F(Beams, MeetWhatWalksMeetAtSamplesEqualToTheIsovalue)
{
  Grid<std::uint8_t> steps(glm::ivec3(33, 34, 35));
  steps.Fill([](int i, int j, int k) { return (i / 3 + j / 4 + k / 5) % 5; });
  this->Compare(steps, 2.0);
  Grid<std::uint8_t> noise(glm::ivec3(21, 22, 23));
  noise.FillRandomly(0.0, 4.0, 9);
  this->Compare(noise, 2.0);
  Grid<std::uint16_t> plane(glm::ivec3(20, 20, 20));
  plane.Fill([](int i, int, int) { return 100 * i; });
  this->Compare(plane, 1000.0);
}

TEST_F(Beams, MeetWhatWalksMeetInNoise)
{
  Grid<double> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(-1.0, 1.0, 10);
  this->Compare(noise, 0.7);
  Grid<std::int8_t> bytes(glm::ivec3(30, 20, 25));
  bytes.FillRandomly(-100.0, 100.0, 11);
  this->Compare(bytes, 60.5);
}

TEST_F(Beams, MeetWhatWalksMeetInNumbersOfAnySize)
{
  for (const double unit : { 1e-300, 1e-30, 1e30, 1e300 })
  {
    Grid<double> waves(glm::ivec3(24, 21, 27));
    waves.Fill([unit](int i, int j, int k) { return unit * Wave(i, j, k); });
    this->Compare(waves, 0.1 * unit, 40);
  }
  Grid<float> holes(glm::ivec3(24, 21, 27));
  holes.Fill(
    [](int i, int j, int k)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      return i % 7 == 0 ? std::numeric_limits<double>::quiet_NaN()
        : j % 9 == 0    ? infinity
                        : 1e30 * Wave(i, j, k);
    });
  this->Compare(holes, 1e29, 40);
  Grid<std::int64_t> large(glm::ivec3(24, 21, 27));
  large.Fill([](int i, int j, int k) { return 4e18 * Wave(i, j, k); });
  this->Compare(large, 1e18, 40);
}

TEST_F(Beams, MeetWhatWalksMeetOnPartsOfRays)
{
  Grid<std::uint8_t> smooth(glm::ivec3(50, 41, 37));
  smooth.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    BothWays<std::uint8_t> ways(smooth, { 120.0 }, mode);
    for (const Camera& camera : CamerasFor(smooth.Field.Dimensions))
    {
      // Where a walk begins in a plane between cells, it may begin on either side.
      const glm::dvec3 off(0.0137, 0.0071, 0.0093);
      ways.CompareCut(ViewFrom(
        { camera.Eye + 7.0 * off, camera.Towards + off, camera.Pixel, camera.Parallel }, 48));
      ASSERT_FALSE(this->HasFatalFailure());
    }
    EXPECT_GT(ways.Hits, ways.Rays / 20);
  }
}

TEST_F(Beams, MeetTheFirstOfSeveralIsovalues)
{
  Grid<std::uint8_t> smooth(glm::ivec3(50, 41, 37));
  smooth.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  this->CompareAll(smooth, { 120.0, 60.0, 180.0 }, 48);
  // Some that no sample meets, and some that lie close together.
  this->CompareAll(smooth, { 1e300, 120.0, 120.5, 121.0, -1e300 }, 48);
  Grid<std::uint16_t> steps(glm::ivec3(33, 34, 35));
  steps.Fill([](int i, int j, int k) { return 1000 * ((i / 3 + j / 4 + k / 5) % 5); });
  this->CompareAll(steps, { 2000.0, 1000.0, 2999.0 }, 48);
  Grid<std::int32_t> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(-1e9, 1e9, 10);
  this->CompareAll(noise, { 7e8, -5e8, 9e8 }, 48);
}

TEST_F(Beams, MeetTheFirstOfSeveralIsovaluesInFloatsOfAnySize)
{
  Grid<float> floats(glm::ivec3(20, 21, 22));
  floats.FillRandomly(-1.0, 1.0, 10);
  this->CompareAll(floats, { 0.7, -0.5 }, 48);
  Grid<double> doubles(glm::ivec3(24, 21, 27));
  doubles.Fill([](int i, int j, int k) { return 1e200 * Wave(i, j, k); });
  this->CompareAll(doubles, { 1e199, -3e199, 1e308, 0.0 }, 40);
  // Differences of what is not finite are others for each isovalue.
  Grid<float> holes(glm::ivec3(24, 21, 27));
  holes.Fill(WaveWithHoles);
  this->CompareAll(holes, { 1e29, -4e29, 1e30, 0.0 }, 40);
}

TEST_F(Beams, MeetWhatWalksMeetBesideHiddenCells)
{
  Grid<std::uint8_t> smooth(glm::ivec3(30, 31, 27));
  smooth.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  const glm::ivec3 cells = smooth.Field.Dimensions - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
  std::mt19937 random(5);
  std::size_t at = 0;
  for (int k = 0; k < cells.z; ++k)
  {
    for (int j = 0; j < cells.y; ++j)
    {
      for (int i = 0; i < cells.x; ++i)
      {
        // Half of the field, a slab, and single cells.
        flags[at++] = i + j + k > 45 || k / 3 == 4 || random() % 16 == 0;
      }
    }
  }
  smooth.Field.Hidden = HiddenCells::Make(smooth.Field.Dimensions, { flags.data(), 1 });
  ASSERT_TRUE(smooth.Field.Hidden);
  this->Compare(smooth, 120.0, 48);
  this->CompareAll(smooth, { 120.0, 60.0, 180.0 }, 48);
}

TEST_F(Beams, MeetTheSameOnEveryKindOfVectors)
{
  Grid<std::uint8_t> smooth(glm::ivec3(50, 41, 37));
  smooth.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  Grid<double> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(-1.0, 1.0, 10);
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      this->Compare(smooth, 120.0, 24);
      this->Compare(noise, 0.7, 24);
    });
}

TEST_F(Beams, SearchedPastManyCellsForgetNone)
{
  // More cells than a beam remembers, and more that are open.
  constexpr int pixels = IsMemorySanitized ? 8 : 24;
  Grid<std::uint8_t> checks(glm::ivec3(64, 64, 64));
  checks.Fill([](int i, int j, int k) { return (i + j + k) % 2; });
  this->Compare(checks, 0.999, pixels);
  Grid<float> flat(glm::ivec3(64, 64, 64));
  flat.Fill([](int i, int j, int k) { return (i + j + k) % 2 ? 1e-7 : -1.0; });
  this->Compare(flat, 0.0, pixels);
}

}
