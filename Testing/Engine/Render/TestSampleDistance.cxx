// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The distance between rays fits a frame into its time, does not change to and fro, and leaves no
// more rays than a frame may have.

#include "Render/SampleDistance.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using namespace TemporalCoherence;

constexpr double Rate = 1e-6; ///< seconds a ray
constexpr double Short = 0.1, Long = 1e4;
const glm::ivec2 Window(1000, 1000);
const glm::dvec2 Limits(1.0, 10.0);

double SecondsFor(const glm::ivec2& rays, double rate = Rate)
{
  return rate * rays.x * rays.y;
}

TEST(SampleDistance, FullUntilSomethingIsKnown)
{
  const SampleDistanceChooser chooser;
  EXPECT_EQ(chooser.Choose(Window, Short, 1.0, Limits), 1.0);
  EXPECT_EQ(chooser.Choose(Window, 0.0, 1.0, Limits), 1.0);
}

TEST(SampleDistance, FitsTheTime)
{
  SampleDistanceChooser chooser;
  chooser.Learn(Window, SecondsFor(Window), Long);
  EXPECT_EQ(chooser.Choose(Window, 1.0, 1.0, Limits), 1.0);
  EXPECT_EQ(chooser.Choose(Window, 0.25, 1.0, Limits), 2.0);
  EXPECT_EQ(chooser.Choose(Window, Short, 1.0, Limits), 4.0); // sqrt(10) is more than 3
  EXPECT_EQ(chooser.Choose(Window, 1e-6, 1.0, Limits), 10.0);
  EXPECT_EQ(chooser.Choose(Window, 0.0, 1.0, Limits), 10.0);
  EXPECT_EQ(chooser.Choose(Window, Long, 10.0, Limits), 1.0);
  EXPECT_EQ(chooser.Choose(Window, Long, 10.0, { 2.5, 10.0 }), 2.5);
  EXPECT_EQ(chooser.Choose(Window, Short, 1.0, { 3.0, 2.0 }), 3.0); // the limits are mixed up
}

TEST(SampleDistance, LearnsFromFramesThatCouldUseTheOneBefore)
{
  SampleDistanceChooser chooser;
  const glm::ivec2 coarse = RaysFor(Window, 4.0);
  chooser.Learn(Window, SecondsFor(Window), Long);
  chooser.Learn(coarse, SecondsFor(coarse, 100.0 * Rate), Short);
  EXPECT_EQ(chooser.Choose(Window, Short, 4.0, Limits), 4.0); // another size: not counted
  chooser.Learn(coarse, SecondsFor(coarse, 4.0 * Rate), Short);
  EXPECT_EQ(chooser.Choose(Window, Short, 4.0, Limits), 7.0);
  chooser.Learn(coarse, SecondsFor(coarse, 1e-3 * Rate), Long);
  EXPECT_EQ(chooser.Choose(Window, Short, 4.0, Limits), 7.0); // a still frame: not counted
  chooser.Learn(coarse, SecondsFor(coarse, 1e-3 * Rate), Short);
  EXPECT_EQ(chooser.Choose(Window, Short, 4.0, Limits), 1.0);
}

TEST(SampleDistance, DoesNotChangeToAndFro)
{
  // Just fast enough for a finer frame is not enough.
  SampleDistanceChooser chooser;
  chooser.Learn(Window, SecondsFor(Window), Short);
  EXPECT_EQ(chooser.Choose(Window, 0.26, 3.0, Limits), 3.0);
  EXPECT_EQ(chooser.Choose(Window, 0.5, 3.0, Limits), 2.0);
  // Frames whose time varies by a tenth about any mean settle.
  for (double mean = 0.5; mean < 90.0; mean *= 1.07)
  {
    SampleDistanceChooser settling;
    double distance = 1.0;
    std::vector<double> distances;
    for (int frame = 0; frame < 40; ++frame)
    {
      const glm::ivec2 rays = RaysFor(Window, distance);
      const double rate = Rate * mean * (frame % 2 == 0 ? 1.1 : 0.9);
      settling.Learn(rays, SecondsFor(rays, rate), Short);
      distance = settling.Choose(Window, Short, distance, Limits);
      distances.push_back(distance);
    }
    for (std::size_t frame = 10; frame < distances.size(); ++frame)
    {
      EXPECT_EQ(distances[frame], distances.back()) << "mean " << mean;
    }
  }
}

TEST(SampleDistance, RaysCoverThePixels)
{
  EXPECT_EQ(RaysFor({ 100, 99 }, 1.0), glm::ivec2(100, 99));
  EXPECT_EQ(RaysFor({ 100, 99 }, 3.0), glm::ivec2(34, 33));
  EXPECT_EQ(RaysFor({ 5, 1 }, 10.0), glm::ivec2(1, 1));
  EXPECT_EQ(RaysFor({ 0, 7 }, 10.0), glm::ivec2(0, 1));
  EXPECT_EQ(RaysFor({ 5, 7 }, 0.1), glm::ivec2(50, 70));
  EXPECT_EQ(RaysFor({ 70, 3 }, static_cast<double>(0.7f)), glm::ivec2(100, 4));
  EXPECT_EQ(RaysFor({ 1, 1000 }, 0.99), glm::ivec2(1, 1010));
}

TEST(SampleDistance, IsAWholePartOfAPixelBelowOne)
{
  const glm::dvec2 fine(0.1, 10.0);
  SampleDistanceChooser chooser;
  EXPECT_EQ(chooser.Choose(Window, Long, 1.0, fine), 1.0); // nothing is known
  EXPECT_EQ(chooser.Choose(Window, Long, 1.0, { 3.0, 5.0 }), 3.0);
  chooser.Learn(Window, SecondsFor(Window), Short);
  EXPECT_EQ(chooser.Choose(Window, Long, 1.0, fine), 0.1);
  EXPECT_EQ(chooser.Choose(Window, Long, 1.0, { 0.3, 10.0 }), 0.3);
  EXPECT_EQ(chooser.Choose(Window, 20.0, 1.0, fine), 1.0 / 3.0); // 1.25 / sqrt(20), rounded up
  EXPECT_EQ(chooser.Choose(Window, 2.0, 1.0, fine), 1.0);
  EXPECT_EQ(chooser.Choose(Window, 2.0, 0.5, fine), 1.0);
  EXPECT_EQ(chooser.Choose(Window, 4.5, 0.5, fine), 0.5);
  const auto third = static_cast<double>(1.0f / 3.0f); // as a mapper keeps it
  EXPECT_EQ(chooser.Choose(Window, 11.1, third, fine), 1.0 / 3.0);
}

TEST(SampleDistance, FinestLeavesNoMoreRaysThanAFrameMayHave)
{
  EXPECT_EQ(FinestDistance({ 20000, 20000 }), 1.0);
  for (const glm::ivec2& pixels :
    { glm::ivec2(1920, 1080), glm::ivec2(3840, 2160), glm::ivec2(5000, 17), glm::ivec2(1, 1) })
  {
    const double finest = FinestDistance(pixels);
    const glm::ivec2 rays = RaysFor(pixels, finest);
    EXPECT_NEAR(static_cast<double>(rays.x) * rays.y, MostRays, 0.03 * MostRays);
  }
  EXPECT_LT(FinestDistance({ 3840, 2160 }), 0.5);
}

}
