// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// On ever finer samples of the distance from a point, positions converge with the square of the
// sample distance, and normals at least with the distance.

#include "Grid.h"
#include "Render/FrameRenderer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace TemporalCoherence;

struct Errors
{
  double Position = 0.0; ///< largest distance of a hit from the sphere, in the world
  double Normal = 0.0;   ///< largest angle from the sphere's normal, in radians
};

Errors ErrorsAt(int n)
{
  constexpr double Radius = 0.6;
  const glm::dvec3 centre(0.03, -0.05, 0.02);
  Grid<double> grid{ glm::ivec3(n) };
  const double step = 2.0 / (n - 1);
  grid.Fill([&](int i, int j, int k)
    { return -glm::length(glm::dvec3(i, j, k) * step - glm::dvec3(1.0) - centre); });

  FrameKey key;
  key.Samples = grid.Field;
  key.Transform.WorldFromIndex = glm::translate(glm::dmat4(1.0), glm::dvec3(-1.0)) *
    glm::scale(glm::dmat4(1.0), glm::dvec3(step));
  key.Transform.IndexFromWorld = glm::inverse(key.Transform.WorldFromIndex);
  const glm::dmat4 camera =
    glm::lookAt(glm::dvec3(2.0, -3.0, 1.5), glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0));
  EXPECT_TRUE(
    MakeView(camera, glm::perspective(0.6, 1.0, 1.0, 10.0), { 1.0, 10.0 }, { 128, 128 }, key.View));
  key.EditIsosurfaces().Isovalues = { -Radius };
  key.Appearance.Colors = { glm::dvec3(1.0) };

  FrameRenderer renderer;
  renderer.Render(key, {});
  const Frame& frame = renderer.LastFrame();
  Errors errors;
  int hits = 0;
  for (int y = 0; y < 128; ++y)
  {
    for (int x = 0; x < 128; ++x)
    {
      const auto pixel = static_cast<std::size_t>(128 * y + x);
      if (frame.Isovalues[pixel] == Frame::NoSurface)
      {
        continue;
      }
      const Ray ray = key.View.RayThrough(x, y);
      const glm::dvec3 point = ray.Origin + frame.Depth[pixel] * ray.Direction - centre;
      errors.Position = std::max(errors.Position, std::abs(glm::length(point) - Radius));
      const double cosine = glm::dot(glm::normalize(point), glm::dvec3(frame.Normals[pixel]));
      errors.Normal = std::max(errors.Normal, std::acos(std::min(1.0, std::abs(cosine))));
      ++hits;
    }
  }
  EXPECT_GT(hits, 2000);
  return errors;
}

TEST(Convergence, PositionsAndNormalsOfASphere)
{
  const Errors coarse = ErrorsAt(33), middle = ErrorsAt(65), fine = ErrorsAt(129);
  // Positions converge with the square of the sample distance, normals at least with the distance.
  for (const double ratio : { coarse.Position / middle.Position, middle.Position / fine.Position })
  {
    EXPECT_GT(ratio, 3.4);
    EXPECT_LT(ratio, 4.6);
  }
  EXPECT_GT(coarse.Normal / middle.Normal, 1.8);
  EXPECT_GT(middle.Normal / fine.Normal, 1.8);
  EXPECT_LT(fine.Position, 1e-3);
  EXPECT_LT(fine.Normal, 1e-2);
}

}
