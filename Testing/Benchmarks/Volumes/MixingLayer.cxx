// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MixingLayer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

using TemporalCoherence::ScalarType;

namespace
{

constexpr std::size_t SamplesOfPart = 256; // whose tables stay in the cache of a core
constexpr std::size_t MostFactors = 64;

const std::vector<int> LargeFrequencies = { 0, 1, 2, 3, 4, 5, 6, 8 };
const std::vector<Octave> LargeOctaves = { { 2.5, 4.5, 24, 0.3 }, { 4.5, 8.0, 40, 0.28 } };

const std::vector<int> SmallFrequencies = { 0, 4, 8, 12, 17, 22, 28, 36, 46, 58, 72, 90 };
const std::vector<Octave> SmallOctaves = { { 8.0, 14.0, 60, 0.26 }, { 14.0, 28.0, 80, 0.18 },
  { 28.0, 52.0, 90, 0.11 }, { 52.0, 95.0, 120, 0.055 } };

/// How the layer changes with height.
struct Heights
{
  float Rise;   ///< distance from the middle of the layer; -1 and 1 at its ends
  float Window; ///< share of waves: 1 in the middle, 0 beyond the ends
};

Heights HeightsAt(int z, int slices)
{
  const double height = (z + 0.5) / slices;
  const double rise = (height - 0.5) / 0.2;
  const double inside = std::max(0.0, 1.0 - rise * rise);
  return { static_cast<float>(rise), static_cast<float>(std::sqrt(inside)) };
}

/// Combine waves to values between 0 and 255.
void MakeValues(
  const Heights& heights, const float* large, const float* small, std::size_t count, float* values)
{
  constexpr float sharpness = 1.0f / 0.05f; // the interface is about five samples wide at 2048
  const float rise = heights.Rise, window = heights.Window;
  for (std::size_t i = 0; i < count; ++i)
  {
    // The square makes bubbles round and spikes thin; small waves are stronger in some places.
    const float bulk = large[i];
    const float detail = small[i] * (0.9f + 0.6f * bulk);
    const float level = 0.7f * rise + window * (bulk + 0.35f * bulk * bulk - 0.08f + detail);
    float t = level * sharpness;
    t = std::min(3.0f, std::max(-3.0f, t));
    const float square = t * t;
    const float step = t * (27.0f + square) / (27.0f + 9.0f * square); // nearly tanh(t)
    const float value = 127.5f + 116.0f * step + 6.0f * bulk;
    values[i] = std::min(255.0f, std::max(0.0f, value));
  }
}

/// Change values to samples of a type.
template <typename T>
void Convert(const float* values, std::size_t count, T* samples)
{
  constexpr float scale = sizeof(T) == 1 ? 1.0f : 257.0f;
  for (std::size_t i = 0; i < count; ++i)
  {
    samples[i] = static_cast<T>(static_cast<int>(values[i] * scale + 0.5f));
  }
}

}

MixingLayer::MixingLayer(const glm::ivec3& dimensions)
  : Size(dimensions)
  , Large(dimensions, LargeFrequencies, LargeOctaves, 1)
  , Small(dimensions, SmallFrequencies, SmallOctaves, 2)
{
}

void MixingLayer::Row(int y, int z, float* values) const
{
  const Heights heights = HeightsAt(z, this->Size.z);
  std::array<float, MostFactors> large, small;
  this->Large.Factors(y, z, large.data());
  this->Small.Factors(y, z, small.data());
  std::array<float, SamplesOfPart> bulk, detail;
  detail.fill(0.0f);
  const auto all = static_cast<std::size_t>(this->Size.x);
  for (std::size_t first = 0; first < all; first += SamplesOfPart)
  {
    const std::size_t count = std::min(SamplesOfPart, all - first);
    this->Large.Sum(large.data(), first, count, bulk.data());
    if (heights.Window > 0.0f)
    {
      this->Small.Sum(small.data(), first, count, detail.data());
    }
    MakeValues(heights, bulk.data(), detail.data(), count, values + first);
  }
}

void MixingLayer::Slices(int first, int count, ScalarType type, void* samples) const
{
  this->Rows({ 0, first }, { this->Size.y, count }, type, samples);
}

void MixingLayer::Rows(
  const glm::ivec2& first, const glm::ivec2& count, ScalarType type, void* samples) const
{
  const auto row = static_cast<std::size_t>(this->Size.x);
  std::vector<float> values(row);
  std::size_t at = 0;
  for (int z = first.y; z < first.y + count.y; ++z)
  {
    for (int y = first.x; y < first.x + count.x; ++y, at += row)
    {
      if (type == ScalarType::Float32)
      {
        this->Row(y, z, static_cast<float*>(samples) + at);
        continue;
      }
      this->Row(y, z, values.data());
      if (type == ScalarType::UInt16)
      {
        Convert(values.data(), row, static_cast<std::uint16_t*>(samples) + at);
      }
      else
      {
        Convert(values.data(), row, static_cast<std::uint8_t*>(samples) + at);
      }
    }
  }
}

bool IsTypeOfMixingLayer(ScalarType type)
{
  return type == ScalarType::UInt8 || type == ScalarType::UInt16 || type == ScalarType::Float32;
}

glm::ivec3 SizeOfLevel(const glm::ivec3& dimensions, int level)
{
  glm::ivec3 size = dimensions;
  for (int i = 0; i < level; ++i)
  {
    size = (size + 1) / 2;
  }
  return size;
}

int NumberOfLevels(const glm::ivec3& dimensions)
{
  constexpr int longest = 128;
  int levels = 1;
  for (glm::ivec3 size = dimensions; glm::any(glm::greaterThan(size, glm::ivec3(longest)));
       size = SizeOfLevel(size, 1))
  {
    ++levels;
  }
  return levels;
}
