// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The rays of a distance cover all pixels, and are no more than a frame may have.

#include "Render/SampleDistance.h"

#include <gtest/gtest.h>

namespace
{

using namespace TemporalCoherence;

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
