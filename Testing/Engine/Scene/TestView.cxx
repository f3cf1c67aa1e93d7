// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays of any camera, sheared or transformed, pass through the centres of their pixels. Degenerate
// matrices are refused.

#include "Grid.h"
#include "Scene/View.h"

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
  ASSERT_TRUE(
    MakeView(Camera, glm::perspective(0.5, 4.0 / 3.0, 1.0, 100.0), { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);
  EXPECT_NEAR(glm::length(view.RayThrough(3, 5).Origin - glm::dvec3(10.0, -20.0, 5.0)), 0.0, 1e-9);
}

TEST(View, ParallelRaysBeginOnThePlaneThroughTheCamera)
{
  View view;
  ASSERT_TRUE(
    MakeView(Camera, glm::ortho(-4.0, 4.0, -3.0, 3.0, 1.0, 100.0), { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);
  const glm::dvec3 toOrigin = view.RayThrough(3, 5).Origin - glm::dvec3(10.0, -20.0, 5.0);
  EXPECT_NEAR(glm::dot(toOrigin, view.Forward), 0.0, 1e-9);
}

TEST(View, OffAxisAndShearedProjections)
{
  View view;
  ASSERT_TRUE(
    MakeView(Camera, glm::frustum(-0.2, 0.5, -0.1, 0.4, 1.0, 100.0), { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);

  glm::dmat4 shear(1.0);
  shear[2][0] = 0.3;
  shear[2][1] = -0.2;
  ASSERT_TRUE(MakeView(
    Camera, glm::ortho(-4.0, 4.0, -3.0, 3.0, 1.0, 100.0) * shear, { 1.0, 100.0 }, Size, view));
  ExpectRaysToProject(view);
}

/// The view transform that a user may add to a camera need not be rigid.
TEST(View, TransformsOfTheUser)
{
  const glm::dvec2 range(1.0, 100.0);
  const glm::dmat4 parallel = glm::ortho(-4.0, 4.0, -3.0, 3.0, range.x, range.y);
  const glm::dmat4 perspective = glm::perspective(0.5, 4.0 / 3.0, range.x, range.y);
  glm::dmat4 transform(2.0); // scaled, sheared and mirrored
  transform[0][0] = -3.0;
  transform[1][2] = 0.4;
  transform[2][0] = -0.7;
  transform[3] = { 0.5, -0.3, 0.2, 1.0 };
  for (const glm::dmat4& projection : { parallel, perspective })
  {
    View view;
    ASSERT_TRUE(MakeView(transform * Camera, projection, range, Size, view));
    EXPECT_EQ(view.Parallel, projection == parallel);
    ExpectRaysToProject(view);
    // Clipping planes lie where the projection puts them.
    const Ray ray = view.RayThrough(9, 40);
    const double perDepth = 1.0 / glm::dot(ray.Direction, view.Forward);
    const auto depthAt = [&](double t)
    {
      const glm::dvec4 clip = view.ClipFromWorld * glm::dvec4(ray.Origin + t * ray.Direction, 1.0);
      return clip.z / clip.w;
    };
    EXPECT_NEAR(depthAt(view.Near * perDepth), -1.0, 1e-9);
    EXPECT_NEAR(depthAt(view.Far * perDepth), 1.0, 1e-9);
  }

  // What a camera calls parallel.
  transform[2][3] = -0.05;
  View view;
  ASSERT_TRUE(MakeView(transform * Camera, parallel, range, Size, view));
  EXPECT_FALSE(view.Parallel);
  ExpectRaysToProject(view);
}

TEST(View, DegenerateMatricesAreRefused)
{
  View view;
  const glm::dmat4 projection = glm::perspective(0.5, 1.0, 1.0, 100.0);
  EXPECT_FALSE(MakeView(glm::dmat4(0.0), projection, { 1.0, 100.0 }, Size, view));
  EXPECT_FALSE(MakeView(Camera, glm::dmat4(0.0), { 1.0, 100.0 }, Size, view));
  EXPECT_FALSE(MakeView(Camera, projection, { 1.0, 1.0 }, Size, view));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(MakeView(glm::dmat4(nan), projection, { 1.0, 100.0 }, Size, view));
}

}
