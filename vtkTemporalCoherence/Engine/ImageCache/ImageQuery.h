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

/// Asks a cached image about the rays of another view (the paper, section 3).
///
/// BOUNDED walks over the space that the image shows to be free (FreeSpace.h); its answers are
/// definite misses and possible hits. PAPER walks over the depths themselves: passing behind a
/// pixel's depth after passing in front of its predecessor's, the two within a voxel, is a definite
/// hit; passing behind it otherwise is a possible one.
///
/// A ray is projected into the cached image and followed from pixel to pixel, from WalkBegin to
/// WalkEnd, until it passes behind the pixel's depth, leaves the image, or ends. What is compared
/// is the ray's depth where it enters and where it leaves the pixel, not at its centre. A ray that
/// begins outside the image, or nearer than its near clipping plane, is a possible hit from its
/// beginning on.
class ImageQuery
{
public:
  /// True if asking a picture made for `cached` can tell anything: what its perspective divides by
  /// is the depth along its optical axis, as for every camera of VTK, and (BOUNDED) its pixels are
  /// fine enough at the near side of the field.
  static bool CanAsk(const FrameKey& cached, ReuseAccuracy accuracy);

  /// \param image    makes its depths as they are needed, and must outlive the query
  /// \param next     the frame to be made
  /// \param accuracy Bounded or Paper
  /// \pre CanServe(image.Key, next) and CanAsk(image.Key, accuracy)
  /// \throws std::bad_alloc
  ImageQuery(CachedImage& image, const FrameKey& next, ReuseAccuracy accuracy);

  /// Ask about the walks of a batch. Safe from many threads.
  void Ask(const RayBatch& rays, KnownRays& known) const;

  /// Longest edge of a voxel in the world: the paper's "one voxel distance".
  double VoxelSize() const { return this->Voxel; }

  /// True if the ray that stopped in a pixel of the cached image may have come from inside a
  /// surface: a hit from inside is seen there or beside it.
  bool IsSeenFromInside(std::int32_t pixel) const;

  /// True if the query is the one of BOUNDED: all its hits are possible ones.
  bool IsBounded() const { return this->Accuracy == ReuseAccuracy::Bounded; }

  /// Give a pixel of a frame what the cached image has at a definite hit: its colour and normal
  /// interpolated between pixels, and its surface.
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
