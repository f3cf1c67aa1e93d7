// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The short ways of shading, for whole tiles and for one light on one colour, give the same bits as
// the long ones.

#include "EachTarget.h"
#include "Shade/KernelsShading.h"
#include "Shade/RandomDirection.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::ShadingKernels;

class KernelsShortcuts : public EachTarget
{
};

/// Rays without a hit get the distance of the first one that has one.
TEST_F(KernelsShortcuts, DistancesOfHits)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const std::uint64_t expected : { std::uint64_t(0), std::uint64_t(1) << 63,
         std::uint64_t(0x123456789ABCDEF0), ~std::uint64_t(0) })
  {
    Array<double> distances;
    double first = infinity;
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      const bool isHit = expected >> i & 1u;
      distances[i] = isHit ? 100.0 + static_cast<double>(i) : infinity;
      first = std::min(first, distances[i]);
    }
    this->ForEachTarget(
      [&](const char* target)
      {
        Array<double> finite;
        ASSERT_EQ(TakeFinite(distances, finite), expected) << target;
        for (std::size_t i = 0; i < distances.size() && expected != 0; ++i)
        {
          EXPECT_EQ(finite[i], expected >> i & 1u ? distances[i] : first) << target;
        }
      });
  }
}

/// One light on one colour, in one pass.
TEST_F(KernelsShortcuts, ColorsOfASimpleLight)
{
  std::mt19937 engine(8);
  SimpleLight light;
  light.Color = { 0.9f, 0.5f, 0.2f };
  light.Toward = { 0.6f, 0.0f, 0.8f };
  light.Diffuse = { 0.7f, 0.8f, 0.9f };
  HitRays rays;
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
      rays.Own[a][i] = ray[static_cast<int>(a)];
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
