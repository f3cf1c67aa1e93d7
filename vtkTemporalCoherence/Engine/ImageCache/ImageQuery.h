// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageQuery_h
#define TemporalCoherence_ImageQuery_h

#include "ImageCache/ImageCache.h"
#include "ImageCache/KernelsImage.h"
#include "Scene/RayBatch.h"
#include "Trace/RayHint.h"

#include <cstdint>

namespace TemporalCoherence
{

/// What a frame made from the image cache promises.
enum class ReuseAccuracy : std::uint8_t
{
  Bounded, ///< at most 0.01 % of the pixels differ from the cold picture, however many frames
  Exact,   ///< the cold picture
  Paper    ///< as published: silhouettes erode a little with every frame
};

/// Queries a cached image about the rays of another view (the paper, section 3).
///
/// BOUNDED follows a ray through the space that the image shows to be free (FreeSpace.h). Its
/// answers are definite misses and possible hits. PAPER compares the ray with the depths
/// themselves. A ray that passes in front of one pixel's depth and behind that of the next, where
/// the two depths are within a voxel, is a definite hit; any other ray that passes behind a depth
/// is a possible hit.
///
/// A ray is projected into the cached image and followed from pixel to pixel, from WalkBegin to
/// WalkEnd, until it passes behind the pixel's depth, leaves the image, or ends. The depth of the
/// ray is compared where it enters and leaves a pixel, not at the centre. A ray that begins outside
/// the image or in front of its near clipping plane is a possible hit from its beginning.
class ImageQuery
{
public:
  /// True if a picture made for `cached` can be queried. Its perspective must divide by the depth
  /// along the optical axis, as every camera of VTK does. For BOUNDED, its pixels must be fine
  /// enough at the near side of the field.
  static bool CanAsk(const FrameKey& cached, ReuseAccuracy accuracy);

  /// \param image    computes its free space on demand; must outlive the query
  /// \param next     the frame to be made
  /// \param accuracy Bounded or Paper
  /// \pre CanServe(image.Key, next) and CanAsk(image.Key, accuracy)
  /// \throws std::bad_alloc
  ImageQuery(CachedImage& image, const FrameKey& next, ReuseAccuracy accuracy);

  /// Query the walks of a batch. Thread-safe.
  void Ask(const RayBatch& rays, KnownRays& known) const;

  /// Longest edge of a voxel in the world: the paper's "one voxel distance".
  double VoxelSize() const { return this->Voxel; }

  /// True if a ray that stopped in a pixel of the cached image may come from inside a surface: that
  /// pixel or a neighbour shows a hit from inside.
  bool IsSeenFromInside(std::int32_t pixel) const;

  /// True for BOUNDED, whose hits are all possible hits.
  bool IsBounded() const { return this->Accuracy == ReuseAccuracy::Bounded; }

  /// Write a definite hit from the cached image into a pixel of a frame: colour and normal
  /// interpolated between pixels, and the surface.
  void Interpolate(const KnownRays& known, std::size_t ray, std::size_t pixel, Frame& frame) const;

private:
  void FindFreeSpace(const PathBatch& paths, std::size_t ray, KnownRays& known) const;
  void FindHit(const PathBatch& paths, std::size_t ray, KnownRays& known) const;

  const CachedImage& Image;
  ReuseAccuracy Accuracy;
  ImageProjection Projection;
  double Voxel = 0.0;
};

}

#endif
