// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The light of a patch is found again, and counts for the larger patches around it. Patches that
// were not seen for long are dropped, so memory is bounded. Other surfaces forget everything.

#include "Shade/Light/LightCache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using Found = LightCache::Found;

constexpr std::size_t Much = std::size_t(1) << 30;

PatchPlace PlaceOf(const glm::dvec3& point, double width = 1.0)
{
  return PlaceOfPatch(point, { 0.0f, 0.2f, -1.0f }, width, 0, HitKind::Entry);
}

LightCache::Known Find(const LightCache& cache, const PatchPlace& place)
{
  return cache.Find(HashOfBlock(place), place);
}

Found Of(const PatchPlace& place, std::uint32_t rays, std::uint32_t light)
{
  return { place, LightCache::NoBlock, rays, light };
}

/// A point of a patch: block and patch as one position.
glm::ivec3 PositionOf(const PatchPlace& place)
{
  return 4 * place.Block + glm::ivec3(place.Patch & 3, place.Patch >> 2 & 3, place.Patch >> 4);
}

TEST(PatchPlaces, AreCubesOfAboutTheWidthOfAPixel)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-100.0, 100.0), width(0.01, 8.0);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 point(at(random), at(random), at(random));
    const double pixel = width(random);
    const PatchPlace place = PlaceOf(point, pixel);
    const double edge = std::ldexp(1.0, place.Level);
    EXPECT_GE(edge, 0.7 * pixel);
    EXPECT_LE(edge, 1.42 * pixel);
    EXPECT_EQ(PositionOf(place), glm::ivec3(glm::floor(point / edge)));
    const PatchPlace larger = LargerThan(place);
    EXPECT_EQ(PositionOf(larger), glm::ivec3(glm::floor(point / (2.0 * edge))));
    EXPECT_EQ(larger.Level, place.Level + 1);
  }
}

TEST(PatchPlaces, TellSidesAndSurfacesApart)
{
  const glm::dvec3 point(1.5, 2.5, 3.5);
  const PatchPlace front = PlaceOfPatch(point, { 0.1f, 0.9f, 0.1f }, 1.0, 0, HitKind::Entry);
  EXPECT_TRUE(
    AreTogether(front, PlaceOfPatch(point, { 0.3f, 0.8f, -0.1f }, 1.0, 0, HitKind::Entry)));
  EXPECT_FALSE(
    AreTogether(front, PlaceOfPatch(point, { 0.1f, -0.9f, 0.1f }, 1.0, 0, HitKind::Entry)));
  EXPECT_FALSE(
    AreTogether(front, PlaceOfPatch(point, { 0.1f, 0.9f, 0.1f }, 1.0, 0, HitKind::Exit)));
  EXPECT_FALSE(
    AreTogether(front, PlaceOfPatch(point, { 0.1f, 0.9f, 0.1f }, 1.0, 1, HitKind::Entry)));
}

TEST(LightCacheTest, FindsWhatWasAdded)
{
  LightCache cache;
  const PatchPlace one = PlaceOf({ 4.5, 5.5, 6.5 }), beside = PlaceOf({ 5.5, 5.5, 6.5 });
  EXPECT_EQ(Find(cache, one).Block, LightCache::NoBlock);
  cache.Add({ { Of(one, 4, 300) }, { Of(beside, 2, 510), Of(one, 1, 255) } }, Much);
  const LightCache::Known known = Find(cache, one);
  EXPECT_NE(known.Block, LightCache::NoBlock);
  EXPECT_EQ(known.Own.Rays(), 5u);
  EXPECT_EQ(known.Own.Light(), 555u);
  // Both lie in one patch of twice their size.
  EXPECT_EQ(known.Larger[0].Rays(), 7u);
  EXPECT_EQ(known.Larger[0].Light(), 1065u);
  EXPECT_EQ(known.Larger[1].Rays(), 7u);
  EXPECT_EQ(cache.NumberOfFrames(), 1u);
  // A new patch nearby knows what larger ones know, and so does a smaller one.
  EXPECT_EQ(Find(cache, PlaceOf({ 4.5, 4.5, 6.5 })).Own.Rays(), 0u);
  EXPECT_EQ(Find(cache, PlaceOf({ 4.5, 4.5, 6.5 })).Larger[0].Rays(), 7u);
  EXPECT_EQ(Find(cache, PlaceOf({ 4.4, 5.6, 6.6 }, 0.5)).Larger[0].Rays(), 5u);
  EXPECT_EQ(Find(cache, PlaceOf({ 4.4, 5.6, 6.6 }, 2.0)).Own.Rays(), 7u);
}

TEST(LightCacheTest, PatchesWithManyRaysNeedNoLargerOnes)
{
  LightCache cache;
  const PatchPlace place = PlaceOf({ 4.5, 5.5, 6.5 });
  cache.Add({ { Of(place, LightCache::FewRays, 0), Of(place, 5, 5) } }, Much);
  const LightCache::Known known = Find(cache, place);
  EXPECT_EQ(known.Own.Rays(), LightCache::FewRays + 5);
  EXPECT_EQ(known.Larger[0].Rays(), 0u);
  // A new patch nearby knows what counted when they were few.
  EXPECT_EQ(Find(cache, PlaceOf({ 4.5, 4.5, 6.5 })).Larger[0].Rays(), LightCache::FewRays);
}

TEST(LightCacheTest, CountsNoMoreRaysThanFit)
{
  LightCache cache;
  const PatchPlace place = PlaceOf({ 0.5, 0.5, 0.5 });
  for (int i = 0; i < 100; ++i)
  {
    cache.Add({ { Of(place, 64, 64 * LightSum::Whole) } }, Much);
  }
  const LightSum sum = Find(cache, place).Own;
  EXPECT_LE(sum.Rays(), LightSum::MostRays);
  EXPECT_GE(sum.Rays(), 4000u);
  EXPECT_EQ(sum.Light(), sum.Rays() * LightSum::Whole);
}

TEST(LightCacheTest, DropsWhatWasNotSeenForLong)
{
  constexpr std::size_t most = std::size_t(1) << 20;
  LightCache cache;
  std::vector<PatchPlace> last;
  for (int frame = 0; frame < 100; ++frame)
  {
    last.clear();
    std::vector<Found> found;
    for (int i = 0; i < 200; ++i)
    {
      last.push_back(PlaceOf({ 64.0 * i, 64.0 * frame, 0.0 }));
      found.push_back(Of(last.back(), 1, 100));
    }
    cache.Add({ found }, most);
    EXPECT_LE(cache.Bytes(), most);
  }
  for (const PatchPlace& place : last)
  {
    EXPECT_EQ(Find(cache, place).Own.Light(), 100u);
  }
  EXPECT_EQ(Find(cache, PlaceOf({ 0.0, 0.0, 0.0 })).Own.Rays(), 0u);
}

TEST(LightCacheTest, FollowsSurfacesAndRadius)
{
  FrameKey key;
  key.EditIsosurfaces().Isovalues = { 1.0 };
  key.Appearance.Occlusion.Radius = 2.0;
  LightCache cache;
  const PatchPlace place = PlaceOf({ 0.5, 0.5, 0.5 });
  const auto isKept = [&]
  {
    cache.Follow(key);
    const bool isThere = Find(cache, place).Own.Rays() > 0;
    cache.Add({ { Of(place, 1, 0) } }, Much);
    return isThere;
  };
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  key.Appearance.Colors = { { 1.0, 0.0, 0.0 } };
  key.Appearance.Occlusion.Strength = 0.5;
  key.View.Size = { 10, 10 };
  EXPECT_TRUE(isKept());
  key.EditIsosurfaces().Isovalues = { 1.5 };
  EXPECT_FALSE(isKept());
  key.Appearance.Occlusion.Radius = 3.0;
  EXPECT_FALSE(isKept());
  ++key.Samples.Stamp;
  EXPECT_FALSE(isKept());
}

TEST(LightCacheTest, AMovedLightDropsItsOwnShadow)
{
  FrameKey key;
  key.EditIsosurfaces().Isovalues = { 1.0 };
  key.Appearance.Occlusion.Radius = 2.0;
  key.Appearance.Lights.resize(3);
  key.Appearance.Lights[0].CastsShadows = key.Appearance.Lights[2].CastsShadows = true;
  key.Appearance.Lights[0].Size = key.Appearance.Lights[2].Size = 0.1;
  LightCache cache;
  std::vector<PatchPlace> places(4, PlaceOf({ 0.5, 0.5, 0.5 }));
  for (std::size_t source = 0; source < places.size(); ++source)
  {
    places[source].Source = static_cast<std::uint16_t>(source);
  }
  const auto kept = [&]
  {
    cache.Follow(key);
    std::vector<bool> found;
    std::vector<Found> again;
    for (const PatchPlace& place : places)
    {
      found.push_back(Find(cache, place).Own.Rays() > 0);
      again.push_back(Of(place, 1, 0));
    }
    cache.Add({ again }, Much);
    return found;
  };
  kept();
  EXPECT_EQ(kept(), std::vector<bool>(4, true));
  key.Appearance.Lights[2].Direction = { 1.0, 0.0, 0.0 };
  EXPECT_EQ(kept(), (std::vector<bool>{ true, true, true, false }));
  key.Appearance.Lights[1].Direction = { 1.0, 0.0, 0.0 }; // casts no shadow
  key.Appearance.Lights[0].Diffuse = { 0.5, 0.5, 0.5 };
  EXPECT_EQ(kept(), std::vector<bool>(4, true));
  key.Appearance.Occlusion.Radius = 3.0;
  EXPECT_EQ(kept(), (std::vector<bool>{ false, true, true, true }));
  key.Appearance.Lights.resize(2);
  EXPECT_EQ(kept(), (std::vector<bool>{ true, true, true, false }));
  key.EditIsosurfaces().Isovalues = { 1.5 };
  EXPECT_EQ(kept(), std::vector<bool>(4, false));
}

}
