// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The nearest cached picture with the data and surfaces of the next frame serves it. Key images
// come at their intervals.

#include "Grid.h"
#include "ImageCache/ImageCache.h"

#include <gtest/gtest.h>

namespace
{

using namespace TemporalCoherence;

const glm::ivec3 Dimensions(20, 30, 40);

FrameKey KeyFrom(const glm::dvec3& direction)
{
  FrameKey key;
  key.Samples.Dimensions = Dimensions;
  key.EditIsosurfaces().Isovalues = { 5.0 };
  key.View = LookAt(Dimensions, direction, { 64, 64 });
  return key;
}

std::shared_ptr<CachedImage> ImageFrom(const glm::dvec3& direction, bool isExact = true)
{
  auto image = std::make_shared<CachedImage>();
  image->Key = KeyFrom(direction);
  image->IsExact = isExact;
  return image;
}

TEST(ImageCache, LatestImageServes)
{
  ImageCache cache;
  const FrameKey next = KeyFrom({ 1.0, 0.1, 0.0 });
  EXPECT_EQ(cache.Find(next, {}), nullptr);
  const auto first = ImageFrom({ 1.0, 0.0, 0.0 });
  EXPECT_EQ(cache.Keep(first, {}), nullptr);
  EXPECT_EQ(cache.Find(next, {}), first);
  const auto second = ImageFrom({ 0.0, 1.0, 0.0 }, false);
  EXPECT_EQ(cache.Keep(second, {}), first) << "only one is kept";
  EXPECT_FALSE(cache.Holds(first));
  EXPECT_EQ(cache.Find(next, {}), second);
}

TEST(ImageCache, NearestOfSeveralServes)
{
  ImageCache cache;
  ImageCache::Options options;
  options.NumberOfImages = 3;
  std::shared_ptr<CachedImage> images[4];
  const glm::dvec3 directions[4] = { { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 0.0, 0.0, 1.0 } };
  for (int i = 0; i < 4; ++i)
  {
    images[i] = ImageFrom(directions[i]);
    EXPECT_EQ(cache.Keep(images[i], options), i < 3 ? nullptr : images[0]);
  }
  EXPECT_EQ(cache.Find(KeyFrom({ 1.0, 0.8, 0.0 }), options), images[1]);
  EXPECT_EQ(cache.Find(KeyFrom({ 0.1, 1.0, 0.1 }), options), images[2]);
  EXPECT_EQ(cache.Find(KeyFrom({ 0.1, 0.1, 1.0 }), options), images[3]);
}

TEST(ImageCache, KeyImagesAreColdAndDueAtIntervals)
{
  ImageCache cache;
  ImageCache::Options options;
  options.Policy = ImageCachePolicy::KeyImage;
  options.KeyImageInterval = 4;
  const auto key = ImageFrom({ 1.0, 0.0, 0.0 });
  cache.Keep(key, options);
  for (int frame = 1; frame < 4; ++frame)
  {
    EXPECT_EQ(cache.Find(KeyFrom({ 1.0, 0.1 * frame, 0.0 }), options), key) << frame;
    EXPECT_EQ(cache.Keep(ImageFrom({ 1.0, 0.1 * frame, 0.0 }, false), options), nullptr);
  }
  EXPECT_EQ(cache.Find(KeyFrom({ 1.0, 0.4, 0.0 }), options), nullptr) << "time for a key image";
  const auto next = ImageFrom({ 1.0, 0.4, 0.0 });
  EXPECT_EQ(cache.Keep(next, options), key);
  EXPECT_EQ(cache.Find(KeyFrom({ 1.0, 0.5, 0.0 }), options), next);
}

TEST(ImageCache, WhatShowsOtherDataOrTheSameViewIsDropped)
{
  ImageCache cache;
  ImageCache::Options options;
  options.NumberOfImages = 5;
  const auto first = ImageFrom({ 1.0, 0.0, 0.0 }, false);
  cache.Keep(first, options);
  const auto completed = ImageFrom({ 1.0, 0.0, 0.0 });
  EXPECT_EQ(cache.Keep(completed, options), first);
  const auto other = ImageFrom({ 0.0, 1.0, 0.0 });
  other->Key.Samples.Stamp = 7;
  EXPECT_EQ(cache.Keep(other, options), completed);
  EXPECT_EQ(cache.Find(KeyFrom({ 1.0, 0.0, 0.0 }), options), nullptr);
}

TEST(ImageCache, ImagesThatCannotServeArePassedOver)
{
  ImageCache cache;
  ImageCache::Options options;
  options.NumberOfImages = 2;
  const auto low = ImageFrom({ 1.0, 0.0, 0.0 });
  const auto high = ImageFrom({ 0.9, 0.1, 0.0 });
  high->Key.EditIsosurfaces().Isovalues[0] = 9.0;
  cache.Keep(low, options);
  cache.Keep(high, options);
  FrameKey next = KeyFrom({ 0.9, 0.11, 0.0 });
  EXPECT_EQ(cache.Find(next, options), low) << "the nearer one shows another isovalue";
}

TEST(DistanceOfViews, GrowsWithTheWayBetweenThem)
{
  const FrameKey a = KeyFrom({ 1.0, 0.0, 0.0 });
  EXPECT_EQ(DistanceOfViews(a, a), 0.0);
  double last = 0.0;
  for (const double side : { 0.05, 0.1, 0.5, 1.0, 5.0 })
  {
    const double distance = DistanceOfViews(a, KeyFrom({ 1.0, side, 0.0 }));
    EXPECT_GT(distance, last);
    last = distance;
  }
}

}
