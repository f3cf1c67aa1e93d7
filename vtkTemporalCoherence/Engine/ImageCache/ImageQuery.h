// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageQuery_h
#define TemporalCoherence_ImageQuery_h

#include "ImageCache/ImageCache.h"
#include "ImageCache/KernelsImage.h"
#include "Lattice/RayHint.h"
#include "Scene/RayBatch.h"

#include <cstdint>

namespace TemporalCoherence
{

/// The promise of a frame that is made after the view has changed.
enum class ReuseAccuracy : std::uint8_t
{
  Exact, ///< the cold picture
  Paper  ///< as published: silhouettes erode a little with every frame
};

/// Queries a cached image about the rays of another view (the paper, section 3).
///
/// A ray that passes in front of one pixel's depth and behind that of the next, where the two
/// depths are within a voxel, is a definite hit. Any other ray that passes behind a depth is a
/// possible hit. All others are definite misses.
///
/// A ray is projected into the cached image and followed from pixel to pixel, from WalkBegin to
/// WalkEnd, until it passes behind the pixel's depth, leaves the image, or ends. The depth of the
/// ray is compared where it enters and leaves a pixel, not at the centre. A ray that begins outside
/// the image or in front of its near clipping plane is a possible hit from its beginning.
class ImageQuery
{
public:
  /// True if a picture made for `cached` can be queried. Its perspective must divide by the depth
  /// along the optical axis, as every camera of VTK does.
  static bool CanAsk(const FrameKey& cached);

  /// \param image must outlive the query
  /// \param next  the frame to be made
  /// \pre CanServe(image.Key, next) and CanAsk(image.Key)
  ImageQuery(const CachedImage& image, const FrameKey& next);

  /// Query the walks of a batch. Thread-safe.
  void Ask(const RayBatch& rays, KnownRays& known) const;

  /// Longest edge of a voxel in the world: the paper's "one voxel distance".
  double VoxelSize() const { return this->Voxel; }

  /// True if a ray that stopped in a pixel of the cached image may come from inside a surface: that
  /// pixel or a neighbour shows a hit from inside.
  bool IsSeenFromInside(std::int32_t pixel) const;

  /// Write a definite hit from the cached image into a pixel of a frame: colour and normal
  /// interpolated between pixels, and the surface.
  void Interpolate(const KnownRays& known, std::size_t ray, std::size_t pixel, Frame& frame) const;

private:
  void FindHit(const PathBatch& paths, std::size_t ray, KnownRays& known) const;

  const CachedImage& Image;
  ImageProjection Projection;
  double Voxel = 0.0;
};

}

#endif
