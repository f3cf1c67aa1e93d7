// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameStore_h
#define TemporalCoherence_FrameStore_h

#include "Render/FrameOptions.h"

#include <memory>

namespace TemporalCoherence
{

/// The last frame, the one that is being made, and the finished images that later frames may start
/// from. The last frame and the new one change places when that is finished: an unfinished one
/// leaves no trace, and in steady state nothing is allocated.
class FrameStore
{
public:
  /// The last frame, and the key it was made for. The frame is empty before the first one.
  const CachedImage& Last() const { return *this->Front; }

  /// The same, to be given other colours.
  CachedImage& LastToRecolor() { return *this->Front; }

  /// The frame that was begun.
  CachedImage& Next() { return *this->Back; }

  /// The kept image from which the frame of a key is made best; null if there is none.
  std::shared_ptr<CachedImage> FindNearest(const FrameKey& key, const FrameOptions& options) const;

  /// Get room for the frame of a key.
  /// \throws std::bad_alloc
  void Begin(const FrameKey& key);

  /// The frame that was begun is the last one now.
  void Finish(const ImageCache::Options& options);

  /// The samples of the last frame are equal to those of another field, which lie elsewhere.
  void MoveTo(const Field& field);

private:
  std::shared_ptr<CachedImage> Front = std::make_shared<CachedImage>();
  std::shared_ptr<CachedImage> Back; ///< memory for the frame being made; or null
  ImageCache Images;                 ///< Front among them
};

}

#endif
