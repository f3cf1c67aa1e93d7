// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grid.h"
#include "Isomap/BandTracer.h"
#include "Isomap/Isomap.h"
#include "Trace/RaySource.h"

#include <gtest/gtest.h>

#include <limits>

// What the building of an isomap may take: memory, cells and patience are asked about inside the
// parts of the picture, too, and tolerances that cannot be kept count as none.

namespace
{

using namespace TemporalCoherence;

TEST(IsomapLimits, TheFinestToleranceDependsOnTheLengthOfRays)
{
  Field field;
  field.Dimensions = glm::ivec3(100);
  EXPECT_EQ(Isomap::SmallestTolerance(field, IndexTransform()), Isomap::FinestTolerance);
  field.Dimensions = glm::ivec3(60000, 60000, 2);
  EXPECT_GT(Isomap::SmallestTolerance(field, IndexTransform()), 40.0 * Isomap::FinestTolerance);
}

/// The builder asks whether to go on within a part of the picture, too, and what it builds does not
/// depend on how often it asks.
TEST(IsomapLimits, QuestionsAreAskedInsideAPart)
{
  Grid<float> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  FrameKey key;
  key.Samples = noise.Field;
  key.View = LookAt(noise.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 93, 71 });
  key.Isosurfaces.Isovalues = { 100.0 };
  ValueRangePyramid pyramid;
  pyramid.Build(key.Samples);
  const ValueBand band{ 80.0, 180.0 };
  Isomap::Limits limits{ std::size_t(1) << 30, std::numeric_limits<double>::infinity() };
  Isomap plain, asking;
  plain.Begin(key, {});
  asking.Begin(key, {});
  ASSERT_EQ(plain.Build(band, pyramid, limits, {}), Isomap::Outcome::Built);
  limits.Patience = 0.0;
  int reports = 0;
  double last = 0.0;
  const auto goOn = [&](double progress)
  {
    ++reports;
    EXPECT_GE(progress, last);
    last = progress;
    return true;
  };
  ASSERT_EQ(asking.Build(band, pyramid, limits, goOn), Isomap::Outcome::Built);
  EXPECT_GT(reports, 20);
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(asking.NumberOfKnots(), plain.NumberOfKnots());
  EXPECT_EQ(asking.MemoryInBytes(), plain.MemoryInBytes());

  Isomap stopped;
  stopped.Begin(key, {});
  const auto stop = [](double progress) { return progress < 0.03; };
  EXPECT_EQ(stopped.Build(band, pyramid, limits, stop), Isomap::Outcome::Stopped);
  EXPECT_EQ(stopped.MemoryInBytes(), 0u);

  // Memory and cost end it before the first part is done.
  int asked = 0;
  const auto count = [&asked](double)
  {
    ++asked;
    return true;
  };
  limits.Patience = std::numeric_limits<double>::infinity();
  Isomap::Limits little = limits;
  little.Memory = plain.MemoryInBytes() / 40;
  EXPECT_EQ(stopped.Build(band, pyramid, little, count), Isomap::Outcome::TooLarge);
  little = limits;
  little.Cells = 10.0;
  EXPECT_EQ(stopped.Build(band, pyramid, little, count), Isomap::Outcome::TooCostly);
  EXPECT_EQ(asked, 0);
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
  const std::int64_t cells = BandTracer::Make(scene)->Trace(rays, all);
  scene.MemoryLimit = all.MemoryInBytes() / 10;
  EXPECT_LT(BandTracer::Make(scene)->Trace(rays, some), cells);
  EXPECT_GT(some.MemoryInBytes(), scene.MemoryLimit);
  EXPECT_LT(some.MemoryInBytes(), all.MemoryInBytes());
}

}
