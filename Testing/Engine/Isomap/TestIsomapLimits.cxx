// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Limits of memory and stops are heeded inside the parts of a build, too. Tolerances that cannot be
// kept count as none. A range that cannot fit drops nothing, and is tried once.

#include "Grid.h"
#include "Isomap/BandTracer.h"
#include "Isomap/Isomap.h"
#include "Isomap/IsomapBuilder.h"
#include "Isomap/RangeBuild.h"
#include "Kinds/FieldKind.h"
#include "Lattice/RaySource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{

using namespace TemporalCoherence;

TEST(IsomapLimits, TheFinestToleranceDependsOnTheLengthOfRays)
{
  Field field;
  field.Dimensions = glm::ivec3(60000, 60000, 2);
  EXPECT_EQ(Isomap::SmallestTolerance(field, IndexTransform()), Isomap::FinestTolerance);
  // Voxels 1000 times as long in one direction.
  IndexTransform stretched;
  stretched.WorldFromIndex[0][0] = 1000.0;
  EXPECT_GT(Isomap::SmallestTolerance(field, stretched), 40.0 * Isomap::FinestTolerance);
}

/// Noise in a still view.
struct NoiseView
{
  NoiseView()
    : Noise(glm::ivec3(20, 21, 22))
  {
    this->Noise.FillRandomly(20.0, 220.0, 3);
    this->Key.Samples = this->Noise.Field;
    this->Key.View = LookAt(this->Noise.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 93, 71 });
    this->Key.EditIsosurfaces().Isovalues = { 100.0 };
    this->Pyramid.Build(this->Key.Samples);
  }

  /// Build a range into an empty map.
  Isomap::Outcome Build(Isomap& map, std::size_t memory, double patience,
    const ReportProgress& report, bool* isDropped = nullptr)
  {
    map.Begin(this->Key, {});
    return this->Add(map, { 80.0, 180.0 }, memory, patience, report, isDropped);
  }

  Isomap::Outcome Add(Isomap& map, const ValueBand& band, std::size_t memory, double patience,
    const ReportProgress& report, bool* isDropped = nullptr)
  {
    std::int64_t cells = 0;
    bool dropped = false;
    const Isomap::Outcome outcome = BuildRange(
      { { this->Key, this->Pyramid, MakeBandTracer }, band, memory, ++this->Frame, patience }, map,
      report, dropped, cells);
    EXPECT_EQ(cells > 0, outcome == Isomap::Outcome::Built);
    if (isDropped)
    {
      *isDropped = dropped;
    }
    return outcome;
  }

  Grid<float> Noise;
  FrameKey Key;
  ValueRangePyramid Pyramid;
  std::uint64_t Frame = 0;
};

constexpr std::size_t Plenty = std::size_t(1) << 30;
constexpr double Endless = std::numeric_limits<double>::infinity();

/// The builder asks whether to go on within a part of the picture, too, and what it builds does not
/// depend on how often it asks.
TEST(IsomapLimits, QuestionsAreAskedInsideAPart)
{
  NoiseView view;
  Isomap plain, asking;
  ASSERT_EQ(view.Build(plain, Plenty, Endless, {}), Isomap::Outcome::Built);
  int reports = 0;
  double last = 0.0;
  const auto goOn = [&](double progress)
  {
    ++reports;
    EXPECT_GE(progress, last);
    last = progress;
    return true;
  };
  ASSERT_EQ(view.Build(asking, Plenty, 0.0, goOn), Isomap::Outcome::Built);
  // One after each group, and one after each of the 16 parts.
  EXPECT_GE(reports, 16);
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(asking.NumberOfKnots(), plain.NumberOfKnots());
  EXPECT_EQ(asking.MemoryInBytes(), plain.MemoryInBytes());

  Isomap stopped;
  const auto stop = [](double progress) { return progress < 0.03; };
  EXPECT_EQ(view.Build(stopped, Plenty, 0.0, stop), Isomap::Outcome::Stopped);
  EXPECT_EQ(stopped.NumberOfBands(), 0u);
}

/// Memory ends it before the first report.
TEST(IsomapLimits, MemoryEndsABuildInsideAPart)
{
  NoiseView view;
  Isomap plain, limited;
  ASSERT_EQ(view.Build(plain, Plenty, Endless, {}), Isomap::Outcome::Built);
  int asked = 0;
  const auto count = [&asked](double)
  {
    ++asked;
    return true;
  };
  EXPECT_EQ(
    view.Build(limited, plain.MemoryInBytes() / 40, Endless, count), Isomap::Outcome::TooLarge);
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(limited.NumberOfBands(), 0u);
}

/// The limit is kept to the byte; the least recently used band goes first, and one that a wider one
/// contains is not kept beside it.
TEST(IsomapLimits, TheOldestBandsMakeRoom)
{
  NoiseView view;
  Isomap map;
  ASSERT_EQ(view.Build(map, Plenty, Endless, {}), Isomap::Outcome::Built);
  const std::size_t one = map.MemoryInBytes();
  bool isDropped = true;
  ASSERT_EQ(
    view.Add(map, { 190.0, 214.0 }, Plenty, Endless, {}, &isDropped), Isomap::Outcome::Built);
  EXPECT_FALSE(isDropped);
  const std::size_t two = map.MemoryInBytes();
  ASSERT_GT(two, one);
  map.MarkUsed({ 100.0 }, 10);
  ASSERT_EQ(view.Add(map, { 30.0, 31.0 }, two, Endless, {}, &isDropped), Isomap::Outcome::Built);
  EXPECT_TRUE(isDropped);
  EXPECT_LE(map.MemoryInBytes(), two);
  EXPECT_TRUE(map.Covers({ 100.0 })) << "used last";
  EXPECT_TRUE(map.Covers({ 30.5 })) << "just built";
  EXPECT_FALSE(map.Covers({ 205.0 })) << "the oldest";

  ASSERT_EQ(view.Add(map, { 30.0, 215.0 }, Plenty, Endless, {}), Isomap::Outcome::Built);
  EXPECT_EQ(map.NumberOfBands(), map.Size()) << "one for each group";
  EXPECT_TRUE(map.Holds({ 30.0, 215.0 }));
}

/// A range that does not fit drops nothing, even if there is no room for any part of it.
TEST(IsomapLimits, WhatCannotFitDropsNothing)
{
  NoiseView view;
  view.Key.View = LookAt(view.Key.Samples.Dimensions, { 1.0, 2.0, 0.7 }, { 256, 200 });
  Isomap map;
  map.Begin(view.Key, {});
  const ValueBand wide{ 30.0, 210.0 };
  ASSERT_EQ(view.Add(map, wide, Plenty, Endless, {}), Isomap::Outcome::Built);
  const std::size_t whole = map.MemoryInBytes();
  map.Begin(view.Key, {});
  ASSERT_EQ(view.Add(map, { 100.0, 101.0 }, Plenty, Endless, {}), Isomap::Outcome::Built);
  const std::size_t kept = map.MemoryInBytes(), bands = map.NumberOfBands();
  ASSERT_LT(kept, whole * 3 / 5);

  for (const double patience : { Endless, 0.0 })
  {
    for (const std::size_t limit : { kept, whole * 3 / 5 })
    {
      SCOPED_TRACE(testing::Message() << limit << " of " << whole << " bytes");
      std::size_t most = 0;
      const auto watch = [&](double progress)
      {
        EXPECT_LT(progress, 0.5) << "what cannot fit is given up soon";
        most = std::max(most, map.MemoryInBytes());
        return true;
      };
      bool isDropped = true;
      EXPECT_EQ(view.Add(map, wide, limit, patience, watch, &isDropped), Isomap::Outcome::TooLarge);
      EXPECT_FALSE(isDropped);
      EXPECT_EQ(map.MemoryInBytes(), kept);
      EXPECT_EQ(map.NumberOfBands(), bands);
      EXPECT_LE(most, limit);
    }
  }
  // What fits takes the place of others, still.
  EXPECT_EQ(view.Add(map, wide, whole, Endless, {}), Isomap::Outcome::Built);
}

/// Ranges that take turns and do not fit are tried once each, until the limit is raised.
TEST(IsomapLimits, RangesThatTakeTurnsAreTriedOnce)
{
  NoiseView view;
  IsomapBuilder builder;
  Isomap::Options options;
  options.MemoryLimit = Isomap::FixedMemory(view.Key) + 80000;
  // Each attempt is a frame of the drag.
  const auto attempts = [&](const ValueBand& range)
  {
    const std::uint64_t before = builder.Drag().Frame;
    options.Range = range;
    EXPECT_EQ(builder.Prepare({ view.Key, view.Pyramid, MakeBandTracer }, options, {}),
      Isomap::Outcome::Built);
    return builder.Drag().Frame - before;
  };
  const ValueBand small{ 99.9, 100.1 };
  for (int turn = 0; turn < 3; ++turn)
  {
    const std::uint64_t expected = turn == 0 ? 1 : 0;
    for (const ValueBand& range : { ValueBand{ 30.0, 200.0 }, { 40.0, 210.0 }, { 50.0, 190.0 } })
    {
      EXPECT_EQ(attempts(range), expected) << range.Low << " in turn " << turn;
      EXPECT_TRUE(builder.IsTooLarge());
    }
  }
  EXPECT_EQ(builder.Built().NumberOfBands(), 0u);
  EXPECT_EQ(attempts(small), 1u);
  EXPECT_FALSE(builder.IsTooLarge());
  ASSERT_TRUE(builder.Built().Holds(small));

  view.Key.EditIsosurfaces().Isovalues = { 120.0 };
  EXPECT_EQ(attempts({ 30.0, 200.0 }), 0u);
  EXPECT_TRUE(builder.Built().Holds(small)) << "nothing was dropped for it";
  options.MemoryLimit = Plenty;
  EXPECT_EQ(attempts({ 30.0, 200.0 }), 1u);
  EXPECT_FALSE(builder.IsTooLarge());
  EXPECT_TRUE(builder.Built().Holds({ 30.0, 200.0 }));
}

/// What is built and what makes room for it never hold more than the limit together.
TEST(IsomapLimits, OldBandsGoWhileANewOneGrows)
{
  NoiseView view;
  Isomap map;
  ASSERT_EQ(view.Build(map, Plenty, Endless, {}), Isomap::Outcome::Built);
  ASSERT_EQ(view.Add(map, { 20.0, 79.0 }, Plenty, Endless, {}), Isomap::Outcome::Built);
  const std::size_t limit = map.MemoryInBytes();
  Isomap alone;
  alone.Begin(view.Key, {});
  ASSERT_EQ(view.Add(alone, { 30.0, 170.0 }, Plenty, Endless, {}), Isomap::Outcome::Built);
  const auto whole = static_cast<double>(alone.MemoryInBytes() - Isomap::FixedMemory(view.Key));
  int reports = 0;
  const auto watch = [&](double progress)
  {
    ++reports;
    // Groups differ in size: a few percent of what is built may be ahead of the progress.
    const double built = std::max(progress - 0.2, 0.0) * whole;
    EXPECT_LE(static_cast<double>(map.MemoryInBytes()) + built, static_cast<double>(limit));
    return true;
  };
  bool isDropped = false;
  ASSERT_EQ(view.Add(map, { 30.0, 170.0 }, limit, 0.0, watch, &isDropped), Isomap::Outcome::Built);
  EXPECT_GE(reports, 14);
  EXPECT_TRUE(isDropped);
  EXPECT_LE(map.MemoryInBytes(), limit);
}

/// Not even one tile takes more than the whole band may.
TEST(IsomapLimits, ATileEndsAtTheLimitOfMemory)
{
  Grid<float> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  ValueRangePyramid pyramid;
  pyramid.Build(noise.Field);
  const ValueBand band{ 20.0, 220.0 };
  ActiveCells active;
  active.Build(noise.Field, pyramid, band);
  BandScene scene{ noise.Field, pyramid.FiniteRange(), &pyramid, &active, band };
  scene.Form.Tolerance = 1e-3;
  RayBatch rays;
  const View view = LookAt(noise.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 8, 8 });
  RaySource(view, IndexTransform(), noise.Field.Dimensions).SetUp({ 0, 0 }, { 8, 8 }, rays);
  TileKnots all, some;
  const std::int64_t cells = MakeBandTracer(scene)->Trace(rays, all);
  scene.MemoryLimit = all.MemoryInBytes() / 10;
  EXPECT_LT(MakeBandTracer(scene)->Trace(rays, some), cells);
  EXPECT_GT(some.MemoryInBytes(), scene.MemoryLimit);
  EXPECT_LT(some.MemoryInBytes(), all.MemoryInBytes());
}

}
