// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/ImageCache.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{

bool CanServe(const FrameKey& cached, const FrameKey& next)
{
  // Pictures of another size are not used: too much can hide between their pixels.
  const FrameChange change = CompareFrames(cached, next);
  return !change.Data && !change.Surfaces && !change.Blending && cached.View.Size == next.View.Size;
}

std::shared_ptr<CachedImage> ImageCache::Find(
  const FrameKey& next, const Options& options, const Suits& suits) const
{
  const bool isKeyDue = options.Policy == ImageCachePolicy::KeyImage &&
    this->FramesSinceKey + 1 >= options.KeyImageInterval;
  if (isKeyDue)
  {
    return nullptr;
  }
  std::shared_ptr<CachedImage> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::shared_ptr<CachedImage>& image : this->Images)
  {
    if (!CanServe(image->Key, next) || !suits(*image))
    {
      continue;
    }
    const double distance = DistanceOfViews(image->Key, next);
    if (!nearest || distance <= least)
    {
      nearest = image;
      least = distance;
    }
  }
  return nearest;
}

std::shared_ptr<CachedImage> ImageCache::Keep(
  const std::shared_ptr<CachedImage>& image, const Options& options)
{
  if (options.Policy == ImageCachePolicy::KeyImage && !image->IsExact)
  {
    ++this->FramesSinceKey;
    return nullptr;
  }
  this->Images.reserve(this->Images.size() + 1); // first, as only this can fail
  const auto isDropped = [&](const std::shared_ptr<CachedImage>& old)
  {
    const FrameChange change = CompareFrames(old->Key, image->Key);
    return change.Data || !(change.View || change.Surfaces);
  };
  std::shared_ptr<CachedImage> dropped;
  const auto drop = [&](std::vector<std::shared_ptr<CachedImage>>::iterator old)
  {
    dropped = *old;
    return this->Images.erase(old);
  };
  for (auto old = this->Images.begin(); old != this->Images.end();)
  {
    old = isDropped(*old) ? drop(old) : old + 1;
  }
  while (static_cast<int>(this->Images.size()) >= options.NumberOfImages)
  {
    drop(this->Images.begin());
  }
  this->Images.push_back(image);
  this->FramesSinceKey = 0;
  return dropped;
}

void ImageCache::MoveTo(const Field& now, const Field& before)
{
  for (const std::shared_ptr<CachedImage>& image : this->Images)
  {
    if (image->Key.Samples == before)
    {
      image->Key.Samples = now;
    }
  }
}

bool ImageCache::Holds(const std::shared_ptr<CachedImage>& image) const
{
  return std::find(this->Images.begin(), this->Images.end(), image) != this->Images.end();
}

double DistanceOfViews(const FrameKey& a, const FrameKey& b)
{
  constexpr double Across = 2.0; // of the picture, in normalised device coordinates
  const glm::dmat4 toA = a.View.ClipFromWorld * a.Transform.WorldFromIndex;
  const glm::dmat4 toB = b.View.ClipFromWorld * b.Transform.WorldFromIndex;
  const glm::dvec3 half = 0.5 * glm::dvec3(a.Samples.Dimensions - 1);
  double sum = 0.0;
  int points = 0;
  for (int i = 0; i < 27; ++i)
  {
    const glm::dvec4 point(half * glm::dvec3(i % 3, i / 3 % 3, i / 9), 1.0);
    const glm::dvec4 inA = toA * point;
    const glm::dvec4 inB = toB * point;
    if (inA.w > 0.0 && inB.w > 0.0)
    {
      sum += std::min(glm::distance(glm::dvec2(inA) / inA.w, glm::dvec2(inB) / inB.w), Across);
    }
    else if (inA.w > 0.0 || inB.w > 0.0)
    {
      sum += Across;
    }
    else
    {
      continue;
    }
    ++points;
  }
  return points > 0 ? sum / points : 0.0;
}

}
