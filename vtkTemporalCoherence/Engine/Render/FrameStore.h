// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameStore_h
#define TemporalCoherence_FrameStore_h

#include "Render/FrameOptions.h"

#include <memory>

namespace TemporalCoherence
{

/// The last frame, the frame being made, and the cached images that later frames may start from. A
/// finished frame changes places with the last one. So an unfinished frame leaves no trace, and in
/// steady state no plane is allocated.
class FrameStore
{
public:
  /// The last frame, and the key it was made for. The frame is empty before the first one.
  const CachedImage& Last() const { return *this->Front; }

  /// The last frame, for new colours in place.
  CachedImage& LastToRecolor() { return *this->Front; }

  /// The frame being made.
  CachedImage& Next() { return *this->Back; }

  /// The cached image from which to make the frame of a key; null if none can serve.
  std::shared_ptr<CachedImage> FindNearest(const FrameKey& key, const FrameOptions& options) const;

  /// Begin the frame of a key, and make room for it.
  /// \throws std::bad_alloc
  void Begin(const FrameKey& key, const FrameExtras& extras);

  /// Make the new frame the last one.
  void Finish(const ImageCache::Options& options);

  /// Reassign the last frame and cached images to a field whose samples are equal but lie
  /// elsewhere.
  void MoveTo(const Field& field);

private:
  std::shared_ptr<CachedImage> Front = std::make_shared<CachedImage>();
  std::shared_ptr<CachedImage> Back; ///< memory for the frame being made; or null
  ImageCache Images;                 ///< Front among them
};

}

#endif
