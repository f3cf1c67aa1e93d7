// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/FrameStore.h"

#include <algorithm>
#include <utility>

namespace TemporalCoherence
{

std::shared_ptr<CachedImage> FrameStore::FindNearest(
  const FrameKey& key, const FrameOptions& options) const
{
  return this->Images.Find(key, options.Images,
    [](const CachedImage& image)
    { return !image.Picture.Disparities.empty() && ImageQuery::CanAsk(image.Key); });
}

void FrameStore::Begin(const FrameKey& key, const FrameExtras& extras)
{
  if (!this->Back)
  {
    this->Back = std::make_shared<CachedImage>();
  }
  CachedImage& next = *this->Back;
  next.Picture.Resize(key.View.Size, extras);
  const std::size_t tiles =
    key.Isosurfaces().IsTranslucent() ? next.Picture.ClearTiles.size() : std::size_t(0);
  next.Picture.Layers.resize(tiles);
  next.Picture.Behind.resize(tiles);
  if (next.Key.View.Parallel != key.View.Parallel)
  {
    // The disparity of a miss differs between projections.
    std::fill(next.Picture.ClearTiles.begin(), next.Picture.ClearTiles.end(), std::uint8_t(0));
  }
  next.Picture.IsFromCache = false;
  next.Picture.ForgetAntialiased();
  next.Key = key;
  next.IsExact = true;
  next.Doubts.clear();
}

void FrameStore::Finish(const ImageCache::Options& options)
{
  if (!MeetSameLayers(this->Front->Key, this->Back->Key))
  {
    for (LayersBehind& tile : this->Front->Picture.Behind)
    {
      tile = {}; // no later frame needs them
    }
  }
  const std::shared_ptr<CachedImage> dropped = this->Images.Keep(this->Back, options);
  std::swap(this->Front, this->Back);
  if (this->Images.Holds(this->Back))
  {
    // Other views begin with the planes of a cached image, never with its layers.
    std::vector<std::vector<LayerHit>> layers = std::move(this->Back->Picture.Layers);
    this->Back->Picture.Layers = {};
    this->Back->Picture.Behind = {};
    Plane<double> met;
    met.swap(this->Back->Picture.Met);
    this->Back = dropped;
    if (this->Back)
    {
      this->Back->Picture.Layers = std::move(layers);
      this->Back->Picture.Met.swap(met);
    }
  }
}

void FrameStore::MoveTo(const Field& field)
{
  this->Images.MoveTo(field, this->Front->Key.Samples);
  this->Front->Key.Samples = field;
}

}
