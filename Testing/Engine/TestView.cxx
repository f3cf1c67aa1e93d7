// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grid.h"
#include "View.h"

#include <gtest/gtest.h>

namespace
{

using namespace TemporalCoherence;

/// The points of a pixel's ray are seen at the centre of the pixel.
void ExpectRaysToProject(const View& view)
{
  for (const glm::ivec2 pixel : { glm::ivec2(0, 0), glm::ivec2(31, 7), glm::ivec2(63, 47) })
  {
    const Ray ray = view.RayThrough(pixel.x, pixel.y);
    EXPECT_NEAR(glm::length(ray.Direction), 1.0, 1e-12);
    EXPECT_GT(glm::dot(ray.Direction, view.Forward), 0.0);
    for (const double t : { view.Near, view.Far })
    {
      const glm::dvec4 clip = view.ClipFromWorld * glm::dvec4(ray.Origin + t * ray.Direction, 1.0);
      EXPECT_NEAR(clip.x / clip.w, view.PixelCentre(pixel.x, pixel.y).x, 1e-9);
      EXPECT_NEAR(clip.y / clip.w, view.PixelCentre(pixel.x, pixel.y).y, 1e-9);
    }
  }
}

const glm::dmat4 Camera =
  glm::lookAt(glm::dvec3(10.0, -20.0, 5.0), glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(0.0, 0.0, 1.0));
const glm::ivec2 Size(64, 48);

TEST(View, PerspectiveRaysBeginAtTheEye)
{
  View view;
  ASSERT_TRUE(MakeView(
    Camera, glm::perspective(0.5, 4.0 / 3.0, 1.0, 100.0), false, { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);
  EXPECT_NEAR(glm::length(view.RayThrough(3, 5).Origin - glm::dvec3(10.0, -20.0, 5.0)), 0.0, 1e-9);
}

TEST(View, ParallelRaysBeginOnThePlaneThroughTheCamera)
{
  View view;
  ASSERT_TRUE(MakeView(
    Camera, glm::ortho(-4.0, 4.0, -3.0, 3.0, 1.0, 100.0), true, { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);
  const glm::dvec3 toOrigin = view.RayThrough(3, 5).Origin - glm::dvec3(10.0, -20.0, 5.0);
  EXPECT_NEAR(glm::dot(toOrigin, view.Forward), 0.0, 1e-9);
}

TEST(View, OffAxisAndShearedProjections)
{
  View view;
  ASSERT_TRUE(MakeView(
    Camera, glm::frustum(-0.2, 0.5, -0.1, 0.4, 1.0, 100.0), false, { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);

  glm::dmat4 shear(1.0);
  shear[2][0] = 0.3;
  shear[2][1] = -0.2;
  ASSERT_TRUE(MakeView(Camera, glm::ortho(-4.0, 4.0, -3.0, 3.0, 1.0, 100.0) * shear, true,
    { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);
}

TEST(View, DegenerateMatricesAreRefused)
{
  View view;
  const glm::dmat4 projection = glm::perspective(0.5, 1.0, 1.0, 100.0);
  EXPECT_FALSE(MakeView(glm::dmat4(0.0), projection, false, { 1.0, 100.0 }, Size, view));
  EXPECT_FALSE(MakeView(Camera, glm::dmat4(0.0), false, { 1.0, 100.0 }, Size, view));
  EXPECT_FALSE(MakeView(Camera, projection, false, { 1.0, 1.0 }, Size, view));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(MakeView(glm::dmat4(nan), projection, false, { 1.0, 100.0 }, Size, view));
}

}
