// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageCache_h
#define TemporalCoherence_ImageCache_h

#include "ImageCache/FreeSpace.h"
#include "Scene/Frame.h"
#include "Scene/FrameKey.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// A finished picture, what it shows, and the space that it shows to be free.
struct CachedImage
{
  FrameKey Key;
  Frame Picture;
  bool IsExact = true;   ///< it is the cold picture of its key, to the last bit
  bool IsEroded = false; ///< made with PAPER, or with a tolerance: first entries are not proven
  FreeSpace Free;        ///< made when first asked for
};

/// True if the picture made for `cached` tells where space is free of the surfaces of `next`.
bool CanServe(const FrameKey& cached, const FrameKey& next);

/// Which pictures are kept for the next views.
enum class ImageCachePolicy : std::uint8_t
{
  Latest,  ///< every frame
  KeyImage ///< a cold frame, which is made every so many frames
};

/// The pictures that the next view may start from: one or more, the nearest of which serves.
class ImageCache
{
public:
  struct Options
  {
    ImageCachePolicy Policy = ImageCachePolicy::Latest;
    int KeyImageInterval = 7; ///< frames from one key image to the next; at least 1
    int NumberOfImages = 1;   ///< at most so many are kept; at least 1
  };

  using Suits = std::function<bool(const CachedImage&)>;

  /// The kept image that can serve `next` and has the view nearest to it. Null if there is none,
  /// or if it is time for the next key image.
  /// \param suits what else an image has to fulfil
  std::shared_ptr<CachedImage> Find(
    const FrameKey& next, const Options& options,
    const Suits& suits = [](const CachedImage&) { return true; }) const;

  /// Take note of a finished frame and keep it if the policy says so. What shows other data, or the
  /// same view and surfaces, is dropped, and what is too much, oldest first.
  /// \return an image that is not kept any more, for its memory; or null
  std::shared_ptr<CachedImage> Keep(
    const std::shared_ptr<CachedImage>& image, const Options& options);

  /// Samples are equal to those of the field `before`, but lie elsewhere now.
  void MoveTo(const Field& now, const Field& before);

  /// True if the image is among those kept.
  bool Holds(const std::shared_ptr<CachedImage>& image) const;

private:
  std::vector<std::shared_ptr<CachedImage>> Images; ///< oldest first
  int FramesSinceKey = 0;
};

/// How far two views of a field are from one another: the mean way that points of its box move in
/// the picture, in normalised device coordinates. Points in front of only one of the eyes count as
/// moved across the whole picture.
double DistanceOfViews(const FrameKey& a, const FrameKey& b);

}

#endif
