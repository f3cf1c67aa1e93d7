// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Normals of composite volumes are those of the first thing seen. Extremes and several components
// have none.

#include "BlendCase.h"
#include "BlendComponents.h"
#include "BlendFrames.h"
#include "Lattice/Coordinates.h"

#include <glm/gtc/matrix_transform.hpp>

namespace
{

using namespace TemporalCoherence;

/// A ball that is opaque: values fall evenly from its centre.
struct Ball
{
  Ball()
    : Volume({ 40, 40, 40 })
  {
    this->Volume.Fill([](int i, int j, int k)
      { return 250.0 - 10.0 * glm::distance(glm::dvec3(i, j, k), glm::dvec3(19.5)); });
    this->Key = MakeBlendKey(this->Volume, BlendMode::Composite, BlendLooks::Step);
  }

  BlendVolume<float> Volume;
  FrameKey Key;
};

/// Normals of what a frame shows are those of the ball, and face the viewer.
void ExpectBall(const FrameKey& key, const glm::dvec3& centre)
{
  const Frame frame = BlendedFrame(key);
  int seen = 0;
  for (int pixel = 0; pixel < key.View.Size.x * key.View.Size.y; ++pixel)
  {
    const auto i = static_cast<std::size_t>(pixel);
    const glm::dvec3 normal(frame.Normals[i]);
    if (frame.Isovalues[i] == Frame::NoSurface)
    {
      ASSERT_EQ(normal, glm::dvec3(0.0));
      continue;
    }
    ++seen;
    const Ray ray = key.View.RayThrough(pixel % key.View.Size.x, pixel / key.View.Size.x);
    const glm::dvec3 outward = glm::normalize(ray.Origin + frame.Depth[i] * ray.Direction - centre);
    ASSERT_NEAR(glm::length(normal), 1.0, 1e-5);
    ASSERT_GT(glm::dot(normal, outward), 0.98);
    ASSERT_LE(glm::dot(normal, ray.Direction), 0.0);
  }
  EXPECT_GT(seen, 500);
}

TEST(BlendNormals, AreThoseOfTheFirstThingSeen)
{
  Ball ball;
  ExpectBall(ball.Key, glm::dvec3(19.5));
  ball.Key.Blended().Looks[0].Material.Shade = true;
  ExpectBall(ball.Key, glm::dvec3(19.5));
  ball.Key.View = LookAt({ 40, 40, 40 }, { -1.0, 0.4, 0.3 }, { 80, 80 }, true);
  ExpectBall(ball.Key, glm::dvec3(19.5));
}

TEST(BlendNormals, OfGrids)
{
  Ball ball;
  const auto grid = Stretched({ 40, 40, 40 }, 1.5, 4);
  FillByPlace(ball.Volume, *grid,
    [](const glm::dvec3& at) { return 250.0 - 10.0 * glm::distance(at, glm::dvec3(19.5)); });
  ball.Key.Samples.Shape = RectilinearKind(grid);
  ExpectBall(ball.Key, glm::dvec3(19.5));
}

TEST(BlendNormals, OfColorsAndAnOpacity)
{
  Ball ball;
  const Grid<float> color({ 40, 40, 40 });
  ball.Key.Blended().Others = { ball.Key.Samples };
  ball.Key.Blended().Use = ComponentUse::ColorOpacity;
  ball.Key.Blended().ScalarRanges.assign(2, ball.Volume.Range);
  ExpectBall(ball.Key, glm::dvec3(19.5));
  ball.Key.Blended().Others.assign(3, color.Field);
  std::swap(ball.Key.Samples.Samples, ball.Key.Blended().Others[2].Samples);
  ball.Key.Blended().Use = ComponentUse::RgbOpacity;
  ball.Key.Blended().ScalarRanges.assign(4, ball.Volume.Range);
  ExpectBall(ball.Key, glm::dvec3(19.5));
}

/// An extreme has no gradient, and several components have several.
TEST(BlendNormals, AreNoneOfExtremesAndOfSeveralComponents)
{
  Ball ball;
  const auto expectNone = [&]
  {
    const Frame frame = BlendedFrame(ball.Key);
    for (const glm::vec3& normal : frame.Normals)
    {
      ASSERT_EQ(normal, glm::vec3(0.0f));
    }
  };
  for (const BlendMode mode : { BlendMode::Maximum, BlendMode::Minimum, BlendMode::Additive })
  {
    ball.Key.Blended().Mode = mode;
    expectNone();
  }
  ball.Key.Blended().Mode = BlendMode::Composite;
  ball.Key.Blended().Others = { ball.Key.Samples };
  ball.Key.Blended().Looks.push_back(ball.Key.Blended().Looks[0]);
  ball.Key.Blended().ScalarRanges.assign(2, ball.Volume.Range);
  expectNone();
}

}
