// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Which layers of a pixel are kept depends on how many there are, and on nothing else: all of them
// up to the limit; of more, every second, fourth, eighth. Each has the colour of all in front of
// the next one that is kept.

#include "Shade/RecoloredLayers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{

using namespace TemporalCoherence;

constexpr int Width = 13;
const PixelRect Part{ { 8, 0 }, { 5, 8 } }; // a tile at the edge of a picture

std::int32_t PixelAt(std::size_t place)
{
  const auto at = static_cast<int>(place);
  return (Part.First.y + at / Part.Size.x) * Width + Part.First.x + at % Part.Size.x;
}

/// Layer number n of a pixel, with the number in its depth and colour.
LayerHit LayerAt(std::size_t place, std::size_t number)
{
  LayerHit hit{ static_cast<double>(number), PixelAt(place), static_cast<SurfaceIndex>(number % 3),
    HitKind::Entry };
  hit.Color.Values = { static_cast<std::uint16_t>(number) };
  return hit;
}

std::size_t NumberIn(const LayerHit& hit)
{
  return hit.Color.Values[0];
}

/// Keep layers of pixels, round by round.
std::vector<LayerHit> Keep(
  const std::vector<std::size_t>& counts, std::size_t limit, std::uint64_t& merged)
{
  std::vector<LayerHit> layers(3); // of another picture
  LimitedLayers kept(limit, layers);
  const std::size_t rounds = *std::max_element(counts.begin(), counts.end());
  for (std::size_t round = 0; round < rounds; ++round)
  {
    for (std::size_t place = 0; place < counts.size(); ++place)
    {
      if (round < counts[place])
      {
        kept.Keep(place, LayerAt(place, round));
      }
    }
    EXPECT_LE(layers.size(), limit * counts.size());
  }
  kept.Finish();
  merged = kept.Merged();
  std::size_t total = 0;
  for (const std::size_t count : counts)
  {
    total += count;
  }
  EXPECT_EQ(kept.Total(), static_cast<std::int64_t>(total));
  return layers;
}

/// What is to be kept of a pixel: the numbers of layers.
std::vector<std::size_t> ExpectedOf(std::size_t count, std::size_t limit)
{
  std::size_t step = 1;
  while (count > limit * step)
  {
    step *= 2;
  }
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < count; number += step)
  {
    numbers.push_back(number);
  }
  return numbers;
}

void ExpectKept(const std::vector<std::size_t>& counts, std::size_t limit,
  const std::vector<LayerHit>& layers, std::uint64_t merged)
{
  for (std::size_t place = 0; place < counts.size(); ++place)
  {
    std::vector<LayerHit> ofPixel;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(ofPixel),
      [&](const LayerHit& hit) { return hit.Pixel == PixelAt(place); });
    const std::vector<std::size_t> expected = ExpectedOf(counts[place], limit);
    ASSERT_EQ(ofPixel.size(), expected.size()) << counts[place] << " layers, limit " << limit;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      const std::size_t end = i + 1 < expected.size() ? expected[i + 1] : counts[place];
      ASSERT_EQ(ofPixel[i].Depth, static_cast<double>(expected[i])) << "of the first";
      ASSERT_EQ(ofPixel[i].Isovalue, static_cast<SurfaceIndex>(expected[i] % 3));
      ASSERT_EQ(NumberIn(ofPixel[i]), end - 1) << "colour of all";
    }
    ASSERT_EQ(merged >> place & 1u, counts[place] > limit ? 1u : 0u);
  }
}

/// Round by round, and by pixel within a round: a pixel comes again only after all others that have
/// as many.
void ExpectRounds(const std::vector<LayerHit>& layers)
{
  std::vector<std::size_t> rounds(static_cast<std::size_t>(Width) * 8);
  std::size_t before = 0;
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const std::size_t round = rounds[static_cast<std::size_t>(layers[i].Pixel)]++;
    if (i > 0)
    {
      const bool isOrdered =
        before == round ? layers[i - 1].Pixel < layers[i].Pixel : before + 1 == round;
      ASSERT_TRUE(isOrdered) << i;
    }
    before = round;
  }
}

TEST(LimitedLayersTest, KeepsAllUpToTheLimitAndThenEverySecond)
{
  for (const std::size_t limit : { 1u, 2u, 4u, 8u, 16u, 32u })
  {
    for (std::size_t count = 0; count < 140; ++count)
    {
      const std::vector<std::size_t> counts{ count };
      std::uint64_t merged = 0;
      const std::vector<LayerHit> layers = Keep(counts, limit, merged);
      ExpectKept(counts, limit, layers, merged);
    }
  }
}

TEST(LimitedLayersTest, PixelsDoNotDisturbOneAnother)
{
  std::mt19937 engine(1);
  for (int round = 0; round < 60; ++round)
  {
    std::vector<std::size_t> counts(static_cast<std::size_t>(Part.Size.x * Part.Size.y));
    std::generate(
      counts.begin(), counts.end(), [&] { return engine() % (engine() % 4 == 0 ? 900 : 40); });
    const std::size_t limit = std::size_t(1) << engine() % 6;
    std::uint64_t merged = 0;
    const std::vector<LayerHit> layers = Keep(counts, limit, merged);
    ExpectKept(counts, limit, layers, merged);
    ExpectRounds(layers);
  }
}

/// A lower limit, set afterwards, keeps what it would have kept from the beginning.
TEST(LimitedLayersTest, ALowerLimitAfterwardsIsTheSame)
{
  std::mt19937 engine(2);
  for (int round = 0; round < 60; ++round)
  {
    std::vector<std::size_t> counts(static_cast<std::size_t>(Part.Size.x * Part.Size.y));
    std::generate(counts.begin(), counts.end(), [&] { return engine() % 100; });
    LayersBehind behind;
    behind.Ends = ~std::uint64_t(0);
    for (std::size_t place = 0; place < counts.size(); ++place)
    {
      behind.Hits.push_back(LayerAt(place, 1000));
    }
    std::vector<LayerHit> layers = Keep(counts, 32, behind.Merged);
    const std::size_t before = layers.size();
    std::size_t merged = 0;
    for (std::size_t limit = engine() % 2 ? 16 : 8; limit > 0; limit >>= 1 + engine() % 2)
    {
      merged += LimitLayers(limit, Part, Width, layers, behind);
      ExpectKept(counts, limit, layers, behind.Merged);
      ExpectRounds(layers);
      EXPECT_EQ(before, layers.size() + merged);
      EXPECT_EQ(behind.Ends & behind.Merged, 0u);
      for (const LayerHit& hit : behind.Hits)
      {
        EXPECT_FALSE(behind.Merged >> PlaceFinder(Part, Width).Find(hit.Pixel) & 1u);
      }
    }
  }
}

TEST(LimitedLayersTest, LayersThatNoLightReachesCountToo)
{
  std::vector<LayerHit> layers, behind;
  LimitedLayers kept(8, layers);
  const std::vector<std::size_t> lit{ 0, 3, 8, 9 }, hidden{ 9, 5, 1, 1 };
  for (std::size_t place = 0; place < lit.size(); ++place)
  {
    for (std::size_t number = 0; number < lit[place]; ++number)
    {
      kept.Keep(place, LayerAt(place, number));
    }
    for (std::size_t number = 0; number < hidden[place]; ++number)
    {
      kept.KeepBehind(place, LayerAt(place, lit[place] + number), behind);
    }
  }
  kept.Finish();
  EXPECT_EQ(behind.size(), 8u + 5u);
  EXPECT_EQ(kept.Merged(), 8u);
  EXPECT_EQ(kept.Incomplete(), 1u + 4u + 8u) << "all but the one with 3 and 5";
  EXPECT_EQ(behind[7].Depth, 7.0);
  EXPECT_EQ(behind[8].Depth, 3.0);
}

TEST(LimitedLayersTest, ColoursAreFoundAnew)
{
  const std::vector<std::size_t> counts{ 33, 5, 32, 64, 65, 300 };
  for (const std::size_t limit : { 1u, 2u, 8u, 32u })
  {
    std::uint64_t merged = 0;
    std::vector<LayerHit> layers = Keep(counts, limit, merged);
    const std::vector<LayerHit> before = layers;
    for (LayerHit& hit : layers)
    {
      hit.Color = {};
    }
    RecoloredLayers again(Part, Width, merged, layers);
    std::int64_t taken = 0;
    for (std::size_t place = 0; place < counts.size(); ++place)
    {
      if (merged >> place & 1u)
      {
        EXPECT_EQ(again.FirstOf(place).Depth, 0.0);
        for (std::size_t number = 1; number < counts[place]; ++number, ++taken)
        {
          again.Keep(place, LayerAt(place, number));
        }
      }
    }
    EXPECT_EQ(again.Total(), taken);
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      const std::size_t place = PlaceFinder(Part, Width).Find(layers[i].Pixel);
      const bool isFirst = limit > 1 && layers[i].Depth == 0.0 && counts[place] <= 2;
      if ((merged >> place & 1u) && !isFirst)
      {
        EXPECT_EQ(layers[i].Color.Values, before[i].Color.Values)
          << counts[place] << " layers, limit " << limit;
      }
    }
  }
}

TEST(LimitedLayersTest, MemoryThatIsNotUsedIsGivenBack)
{
  std::vector<LayerHit> layers(1000);
  layers.resize(400);
  GiveBackMemory(layers);
  EXPECT_LT(layers.capacity(), 500u);
  const LayerHit* where = layers.data();
  layers.resize(200);
  GiveBackMemory(layers);
  EXPECT_EQ(layers.data(), where) << "half of it is used: nothing is allocated";
  layers.clear();
  GiveBackMemory(layers);
  EXPECT_EQ(layers.capacity(), 0u);
}

}
