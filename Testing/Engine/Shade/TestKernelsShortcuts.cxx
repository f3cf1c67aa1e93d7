// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The short ways of shading, for rays from one point and for one light on one colour, give the same
// bits as the long ones.

#include "EachTarget.h"
#include "Shade/KernelsShading.h"
#include "Shade/RandomDirection.h"

#include <glm/glm.hpp>

#include <random>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::ShadingKernels;

class KernelsShortcuts : public EachTarget
{
};

/// Rays from one point whose directions are known.
TEST_F(KernelsShortcuts, PointsOfKnownDirections)
{
  std::mt19937 engine(6);
  std::uniform_real_distribution<double> around(-1.0, 1.0);
  RayPoints rays;
  rays.Count = RayBatch::Capacity;
  rays.LinearOrigin = { RandomDirection(engine), glm::dvec3(0.0), glm::dvec3(0.0) };
  for (glm::dvec3& vector : rays.LinearDirection)
  {
    vector = RandomDirection(engine);
  }
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    rays.X[i] = around(engine);
    rays.Y[i] = around(engine);
    rays.T[i] = 100.0 * around(engine);
  }
  this->ForEachTarget(
    [&](const char* target)
    {
      RayPoints expected = rays, found;
      FindRayPoints(expected);
      found.Count = rays.Count;
      FindPointsFrom(rays.LinearOrigin[0], expected.Direction, rays.T, found);
      constexpr int count = RayBatch::Capacity;
      for (std::size_t a = 0; a < 3; ++a)
      {
        EXPECT_TRUE(AreIdentical(found.Direction[a], expected.Direction[a], count)) << target;
        EXPECT_TRUE(AreIdentical(found.FloatDirection[a], expected.FloatDirection[a], count))
          << target;
        EXPECT_TRUE(AreIdentical(found.Point[a], expected.Point[a], count)) << target;
      }
    });
}

/// One light on one colour, in one pass.
TEST_F(KernelsShortcuts, ColorsOfASimpleLight)
{
  std::mt19937 engine(8);
  SimpleLight light;
  light.Color = { 0.9f, 0.5f, 0.2f };
  light.Toward = { 0.6f, 0.0f, 0.8f };
  light.Diffuse = { 0.7f, 0.8f, 0.9f };
  RayPoints rays;
  PhongSums sums;
  sums.Toward = light.Toward;
  sums.Diffuse = light.Diffuse;
  for (std::size_t a = 0; a < 3; ++a)
  {
    light.Ambient[a] = 0.1f * light.Color[a];
    sums.Color[a].fill(light.Color[a]);
    sums.Sum[a].fill(light.Ambient[a]);
  }
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    const glm::dvec3 normal = RandomDirection(engine), ray = RandomDirection(engine);
    for (std::size_t a = 0; a < 3; ++a)
    {
      sums.Normal[i][a] = static_cast<float>(normal[static_cast<int>(a)]);
      rays.FloatDirection[a][i] = static_cast<float>(ray[static_cast<int>(a)]);
    }
  }
  for (const double power : { 1.0, 10.0, 7.5 })
  {
    for (const float specular : { 0.0f, 0.4f })
    {
      for (const int count : { 1, 9, 64 })
      {
        sums.Count = rays.Count = static_cast<std::size_t>(count);
        sums.Power = light.Power = power;
        sums.Specular = light.Specular = { specular, 0.5f * specular, specular };
        this->ForEachTarget(
          [&](const char* target)
          {
            Array<std::array<std::uint8_t, 4>> colors;
            FindColors(rays, sums.Normal, light, colors);
            PhongSums lit = sums;
            AddLight(rays, lit);
            Array<std::array<std::uint8_t, 4>> expected;
            RoundColors(lit, expected);
            EXPECT_TRUE(AreIdentical(colors, expected, count)) << target << ", power " << power;
          });
      }
    }
  }
}

}
