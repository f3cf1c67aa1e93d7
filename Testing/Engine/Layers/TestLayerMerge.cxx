// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Known layers of a tile and those of new isovalues are merged in the order in which rays meet
// surfaces, up to where no light passes or where nothing is known of kept surfaces. None is lost,
// none is there twice, and the result has the order of Frame::Layers.

#include "Layers/LayerMerge.h"
#include "Scene/HitOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <random>
#include <tuple>
#include <vector>

namespace
{

using namespace TemporalCoherence;

using Ray = std::vector<LayerHit>; ///< its layers, from front to back

/// A tile at the upper right corner of a picture. Isovalue 2 goes, 7 and -4 come.
class LayerMergeTest : public ::testing::Test
{
protected:
  static constexpr int Width = 30;
  static constexpr PixelRect Part{ { 24, 8 }, { 6, 5 } };
  static constexpr std::size_t Rays = 30;

  LayerMergeTest()
    : Change({ { 3.0, -1.0, 2.0 } },
        { { 7.0, -1.0, 3.0, -4.0 }, SurfaceMode::Crossing, { 0.9, 0.6, 0.2, 0.5 } })
  {
  }

  static std::int32_t PixelOf(std::size_t place)
  {
    const auto at = static_cast<int>(place);
    return (Part.First.y + at / 6) * Width + Part.First.x + at % 6;
  }

  static bool IsBefore(const LayerHit& a, const LayerHit& b, const std::vector<double>& isovalues)
  {
    const auto surfaceOf = [&](const LayerHit& hit) {
      return MetSurface{ hit.Depth, hit.Kind, isovalues[static_cast<std::size_t>(hit.Isovalue)] };
    };
    return IsInFront(surfaceOf(a), surfaceOf(b));
  }

  /// Layers of some isovalues in their order: few distances, so that many lie at one distance.
  static Ray AnyLayers(std::mt19937& engine, std::size_t place,
    const std::vector<std::int16_t>& surfaces, const std::vector<double>& isovalues)
  {
    std::map<std::tuple<double, HitKind, std::int16_t>, LayerHit> layers;
    for (auto left = engine() % 7; left > 0; --left)
    {
      const LayerHit hit{ static_cast<double>(engine() % 9), PixelOf(place),
        surfaces[engine() % surfaces.size()],
        std::array{ HitKind::Entry, HitKind::Exit, HitKind::Cap }[engine() % 3] };
      layers[{ hit.Depth, hit.Kind, hit.Isovalue }] = hit;
    }
    Ray ray;
    for (const auto& layer : layers)
    {
      ray.push_back(layer.second);
    }
    std::sort(ray.begin(), ray.end(),
      [&](const LayerHit& a, const LayerHit& b) { return IsBefore(a, b, isovalues); });
    return ray;
  }

  /// Layers of rays, round by round.
  static std::vector<LayerHit> InRounds(const std::vector<Ray>& rays)
  {
    std::vector<LayerHit> layers;
    for (std::size_t round = 0; round < 100; ++round)
    {
      for (const Ray& ray : rays)
      {
        if (round < ray.size())
        {
          layers.push_back(ray[round]);
        }
      }
    }
    return layers;
  }

  /// What is to be found: all layers of the next picture up to the limit of what is known, or to
  /// where no light passes.
  Ray Merged(const Ray& known, const Ray& added, bool hasEnded, bool& isComplete) const
  {
    struct Met
    {
      LayerHit Hit;
      double Isovalue;
    };
    std::vector<Met> all;
    for (const LayerHit& hit : known)
    {
      all.push_back({ hit, this->Change.Last[static_cast<std::size_t>(hit.Isovalue)] });
    }
    for (const LayerHit& hit : added)
    {
      all.push_back({ hit, this->Change.Next[static_cast<std::size_t>(hit.Isovalue)] });
    }
    const auto isBefore = [](const Met& a, const Met& b)
    {
      return IsInFront(
        { a.Hit.Depth, a.Hit.Kind, a.Isovalue }, { b.Hit.Depth, b.Hit.Kind, b.Isovalue });
    };
    std::sort(all.begin(), all.end(), isBefore);
    Ray merged;
    float passed = 1.0f;
    std::size_t knownLeft = known.size();
    isComplete = hasEnded;
    for (const Met& met : all)
    {
      if (passed == 0.0f || (knownLeft == 0 && !hasEnded))
      {
        break;
      }
      const auto next = std::find(this->Change.Next.begin(), this->Change.Next.end(), met.Isovalue);
      const bool isKnown =
        std::count(this->Change.Last.begin(), this->Change.Last.end(), met.Isovalue);
      knownLeft -= isKnown;
      if (next != this->Change.Next.end())
      {
        merged.push_back(met.Hit);
        merged.back().Isovalue = static_cast<std::int16_t>(next - this->Change.Next.begin());
        passed = PassedBehind(
          passed, this->Change.LeastAlphas[static_cast<std::size_t>(merged.back().Isovalue)]);
      }
    }
    isComplete &= passed > 0.0f;
    return merged;
  }

  const SurfaceChange Change;
};

TEST_F(LayerMergeTest, TellsWhatIsKeptAndWhatIsNew)
{
  EXPECT_EQ(this->Change.Kept, (std::vector<std::int16_t>{ 2, 1, Frame::NoSurface }));
  EXPECT_EQ(this->Change.New, (std::vector<std::int16_t>{ 0, 3 }));
  EXPECT_EQ(this->Change.LeastAlphas, (std::vector{ 0.9f, 0.6f, 0.2f, 0.5f }));
}

TEST_F(LayerMergeTest, OpacitiesThatOnlyShadingTellsAreAtLeast)
{
  Surfaces surfaces{ { 1.0, 2.0 }, SurfaceMode::Crossing, { 0.5, 1.0 } };
  surfaces.ByGradient.Nodes = { { 1.0, 0.9 }, { 2.0, 0.3 }, { 3.0, 0.7 } };
  const std::vector<float> least = SurfaceChange({}, surfaces).LeastAlphas;
  for (double gradient = 0.0; gradient < 4.0; gradient += 1.0 / 128.0)
  {
    const double share = surfaces.ByGradient.At(gradient);
    EXPECT_LE(least[0], static_cast<float>(0.5 * share));
    EXPECT_LE(least[1], static_cast<float>(share));
  }
  EXPECT_NEAR(least[0], 0.15f, 1e-5f);
  EXPECT_NEAR(least[1], 0.3f, 1e-5f);
}

TEST_F(LayerMergeTest, IsTheOrderOfRaysAndOfRounds)
{
  std::size_t dark = 0, limited = 0;
  for (unsigned int seed = 0; seed < 300; ++seed)
  {
    std::mt19937 engine(seed);
    std::vector<Ray> known, added, merged;
    std::uint64_t ends = 0, complete = 0;
    for (std::size_t place = 0; place < Rays; ++place)
    {
      known.push_back(AnyLayers(engine, place, { 0, 1, 2 }, this->Change.Last));
      added.push_back(AnyLayers(engine, place, { 0, 3 }, this->Change.Next));
      const bool hasEnded = engine() % 2;
      bool isComplete = false;
      merged.push_back(this->Merged(known[place], added[place], hasEnded, isComplete));
      ends |= static_cast<std::uint64_t>(hasEnded) << place;
      complete |= static_cast<std::uint64_t>(isComplete) << place;
      limited += !hasEnded;
      dark += hasEnded && !isComplete;
    }
    LayerMerge merge(Part, Width, this->Change);
    merge.Keep(KnownLayers(InRounds(known), ends));
    for (std::size_t place = 0; place < Rays; ++place)
    {
      for (const LayerHit& hit : added[place])
      {
        EXPECT_TRUE(hit.Depth < merge.EndOf(place) || merged[place].empty() ||
          hit.Depth > merged[place].back().Depth)
          << seed;
        merge.Add(place, hit);
      }
    }
    const KnownLayers found = merge.Finish();
    const std::vector<LayerHit> expected = InRounds(merged);
    ASSERT_EQ(found.Composited().size(), expected.size()) << seed;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      const LayerHit& hit = found.Composited()[i];
      ASSERT_EQ(std::tuple(hit.Pixel, hit.Depth, hit.Kind, hit.Isovalue),
        std::tuple(expected[i].Pixel, expected[i].Depth, expected[i].Kind, expected[i].Isovalue))
        << seed << ' ' << i;
    }
    const std::uint64_t pixels = (std::uint64_t(1) << Rays) - 1;
    ASSERT_EQ(found.Ends() & pixels, complete) << seed;
  }
  EXPECT_GT(dark, 100u);
  EXPECT_GT(limited, 100u);
}

/// What is in front of the limit of a ray is not cut off, and what is behind it is.
TEST_F(LayerMergeTest, RaysEndBehindWhatIsKnown)
{
  LayerMerge merge(Part, Width, this->Change);
  const LayerHit last{ 5.0, PixelOf(7), 2, HitKind::Entry };
  merge.Keep(KnownLayers({ last }, ~(std::uint64_t(1) << 7 | std::uint64_t(1) << 8)));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_GT(merge.EndOf(7), 5.0);
  EXPECT_LT(merge.EndOf(7), 5.0 + 1e-12);
  EXPECT_LT(merge.EndOf(8), -1e300) << "nothing is known";
  EXPECT_EQ(merge.EndOf(9), infinity) << "all is known";
  merge.Add(7, { 5.0, PixelOf(7), 3, HitKind::Entry }); // -4 is in front of 2 where a field rises
  merge.Add(7, { 5.0, PixelOf(7), 0, HitKind::Entry }); // 7 is not
  const KnownLayers found = merge.Finish();
  ASSERT_EQ(found.Composited().size(), 1u);
  EXPECT_EQ(found.Composited()[0].Isovalue, 3);
}

TEST(PlaceFinderTest, FindsThePlaceOfAnyPixelInAnyOrder)
{
  const PixelRect part{ { 16, 24 }, { 5, 7 } };
  constexpr int width = 21;
  std::mt19937 engine(1);
  const PlaceFinder places(part, width);
  for (int i = 0; i < 500; ++i)
  {
    const auto place = engine() % 35;
    const auto at = static_cast<int>(place);
    const int pixel = (part.First.y + at / 5) * width + part.First.x + at % 5;
    ASSERT_EQ(places.Find(pixel), place);
  }
}

}
