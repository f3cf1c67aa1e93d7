// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The short ways of shading, for whole tiles, for one light on one colour and for a round of
// layers, give the same bits as the long ones.

#include "EachTarget.h"
#include "Scene/LayerBatch.h"
#include "Shade/KernelsShading.h"
#include "Shade/RandomDirection.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
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

/// One light, in one pass.
TEST_F(KernelsShortcuts, ColorsOfASimpleLight)
{
  std::mt19937 engine(8);
  SimpleLight light;
  light.Ambient = 0.1f;
  light.Toward = { 0.6f, 0.0f, 0.8f };
  light.Diffuse = { 0.7f, 0.8f, 0.9f };
  HitRays rays;
  PhongSums sums;
  sums.Toward = light.Toward;
  sums.Diffuse = light.Diffuse;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
    {
      sums.Color[a][i] = 0.9f - 0.2f * static_cast<float>(a) - 0.005f * static_cast<float>(i);
      sums.Sum[a][i] = light.Ambient * sums.Color[a][i];
    }
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
            FindColors(rays, sums.Normal, sums.Color, light, colors);
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

/// Pixels with a surface change as the "over" operator says, and no others.
TEST_F(KernelsShortcuts, RoundsOfLayers)
{
  const auto clampToOne = [](float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; };
  const auto rounded = [&](float value)
  { return static_cast<std::uint8_t>(clampToOne(value) * 255.0f + 0.5f); };
  const auto fine = [&](float value)
  { return static_cast<std::uint16_t>(clampToOne(value) * 65280.0f + 128.0f); };
  constexpr std::uint64_t rounds[] = { ~std::uint64_t(0), 0x00FF00FF12345678, 1,
    std::uint64_t(1) << 63, 0xFFFF000000000000, ~std::uint64_t(0) };
  this->ForEachTarget(
    [&](const char* target)
    {
      std::mt19937 engine(3);
      std::uniform_real_distribution<float> share(0.0f, 1.0f), color(-0.2f, 1.3f);
      CompositedPixels pixels;
      pixels.Sum = {};
      pixels.Colors.fill({});
      pixels.Passed.fill(1.0f);
      pixels.Passing = ~std::uint64_t(0);
      CompositedPixels expected = pixels;
      for (const std::uint64_t which : rounds)
      {
        LayerRound round;
        round.Which = which;
        Array<std::array<std::uint8_t, 4>> bytes;
        for (std::size_t i = 0; i < round.Alpha.size(); ++i)
        {
          const bool isThere = which >> i & 1u;
          round.Alpha[i] = isThere ? (i % 9 == 0 ? 1.0f : i % 7 == 0 ? 0.0f : share(engine)) : 0.0f;
          float& passed = expected.Passed[i];
          for (std::size_t c = 0; c < 3; ++c)
          {
            round.Color[c][i] = i % 5 == 0 ? std::numeric_limits<float>::infinity() : color(engine);
            expected.Sum[c][i] += passed * round.Alpha[i] * clampToOne(round.Color[c][i]);
          }
          passed = PassedBehind(passed, round.Alpha[i]);
          if (passed == 0.0f)
          {
            expected.Passing &= ~(std::uint64_t(1) << i);
          }
          if (isThere)
          {
            const std::array<float, 4> sum = { expected.Sum[0][i], expected.Sum[1][i],
              expected.Sum[2][i], 1.0f - passed };
            std::transform(sum.begin(), sum.end(), expected.Colors[i].Values.begin(), fine);
            std::transform(sum.begin(), sum.end(), bytes[i].begin(), rounded);
          }
        }
        CompositeRound(round, pixels);
        for (std::size_t i = 0; i < round.Alpha.size(); ++i)
        {
          if (which >> i & 1u)
          {
            EXPECT_EQ(pixels.Colors[i], expected.Colors[i]) << target << ", pixel " << i;
            EXPECT_EQ(pixels.Colors[i].Bytes(), bytes[i]) << target << ", pixel " << i;
          }
        }
        EXPECT_TRUE(AreIdentical(pixels.Passed, expected.Passed, RayBatch::Capacity)) << target;
        EXPECT_EQ(pixels.Passing, expected.Passing) << target;
        for (std::size_t c = 0; c < 3; ++c)
        {
          EXPECT_TRUE(AreIdentical(pixels.Sum[c], expected.Sum[c], RayBatch::Capacity)) << target;
        }
      }
    });
}

}
