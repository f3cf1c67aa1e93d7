// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageCache_h
#define TemporalCoherence_ImageCache_h

#include "Scene/Frame.h"
#include "Scene/FrameKey.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// A finished picture, and the key it was made for.
struct CachedImage
{
  FrameKey Key;
  Frame Picture;
  bool IsExact = true; ///< bit-identical to the cold picture of its key
  /// For each tile, the expected error of its pixels, in steps of a byte, if they were interpolated
  /// between rays; 0 for traced tiles. Empty if all tiles were traced.
  std::vector<float> Doubts;
};

/// True if a picture made for `cached` shows where space is free of the surfaces of `next`.
bool CanServe(const FrameKey& cached, const FrameKey& next);

/// Which pictures are cached for the next views.
enum class ImageCachePolicy : std::uint8_t
{
  Latest,  ///< every frame
  KeyImage ///< a cold frame every KeyImageInterval frames
};

/// The cached pictures that the next view may start from. The nearest one serves.
class ImageCache
{
public:
  struct Options
  {
    ImageCachePolicy Policy = ImageCachePolicy::Latest;
    int KeyImageInterval = 7; ///< frames from one key image to the next; at least 1
    int NumberOfImages = 1;   ///< the most images to keep; at least 1
  };

  using Suits = std::function<bool(const CachedImage&)>;

  /// The cached image with the nearest view among those that can serve `next`. Null if there is
  /// none, or if the next key image is due.
  /// \param suits a further condition on images
  std::shared_ptr<CachedImage> Find(
    const FrameKey& next, const Options& options,
    const Suits& suits = [](const CachedImage&) { return true; }) const;

  /// Add a finished frame if the policy says so. Drops images of other data, images of the same
  /// view and surfaces, and then the oldest beyond NumberOfImages.
  /// \return a dropped image, to re-use its memory; or null
  std::shared_ptr<CachedImage> Keep(
    const std::shared_ptr<CachedImage>& image, const Options& options);

  /// Reassign images of the field `before` to `now`, whose samples are equal but lie elsewhere.
  void MoveTo(const Field& now, const Field& before);

  /// True if an image is in the cache.
  bool Holds(const std::shared_ptr<CachedImage>& image) const;

private:
  std::vector<std::shared_ptr<CachedImage>> Images; ///< oldest first
  int FramesSinceKey = 0;
};

/// Distance between two views of a field: how far points of its box move in the picture on average,
/// in normalised device coordinates. A point behind one of the eyes counts as moved across the
/// whole picture.
double DistanceOfViews(const FrameKey& a, const FrameKey& b);

}

#endif
