// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileTracer_h
#define TemporalCoherence_TileTracer_h

#include "Acceleration/TileBounds.h"
#include "ImageCache/ImageQuery.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Shade/Shader.h"
#include "Trace/RaySource.h"
#include "Trace/SurfaceTracer.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// What tiles are traced with; all of it must outlive the tracer.
struct TileScene
{
  const FrameKey& Key;
  const ActiveCells* Active = nullptr; ///< null: no space leaping
  const TileBounds* Bounds = nullptr;  ///< of Active
  glm::dvec2 FiniteRange{ 0.0 };
  const ImageQuery* Query = nullptr; ///< null: a cold frame
  bool InterpolateColors = false;    ///< definite hits take what the cached image has
  const Frame* Before = nullptr; ///< exact picture of the same view and another isovalue; or null
  bool IsRaised = false;         ///< that isovalue is lower
};

/// Takes the rays of one tile from their set-up to the planes of the frame: the walk narrowed by
/// the tile's bounds and by what a cached image or the last picture knows, the trace, and a second
/// trace where that turned out wrong.
class TileTracer
{
public:
  /// \throws std::bad_alloc
  explicit TileTracer(const TileScene& scene);

  /// Trace the rays through `part`, which is tile number `tile`. Safe from many threads.
  TraceCounts Trace(std::int64_t tile, const PixelRect& part, Frame& frame) const;

  /// Trace some rays of a tile, one bit each, with no help from an image.
  TraceCounts TraceSome(
    std::int64_t tile, const PixelRect& part, std::uint64_t which, Frame& frame) const;

private:
  bool CanSkip(std::int64_t tile) const;
  void Find(const RayBatch& rays, HitBatch& hits) const;
  void TraceCold(const RayBatch& rays, Frame& frame, TraceCounts& counts) const;
  void StoreTraced(const RayBatch& rays, const HitBatch& hits, std::size_t ray, Frame& frame,
    TraceCounts& counts) const;
  void TraceHinted(RayBatch& rays, Frame& frame, TraceCounts& counts) const;
  void TraceKnown(const QueryBatch& known, RayBatch& rays, Frame& frame, TraceCounts& counts) const;
  void NarrowByImage(const QueryBatch& known, RayBatch& rays) const;
  bool IsWrong(const QueryBatch& known, const HitBatch& hits, std::size_t ray) const;
  Answer AnswerAfter(
    const QueryBatch& known, const HitBatch& hits, std::size_t ray, bool isServed) const;
  void TraceAgain(const RayBatch& rays, Frame& frame, TraceCounts& counts) const;

  TileScene Scene;
  RaySource Rays;
  bool HasSurfaces;
  bool IsSolid;
  std::shared_ptr<const SurfaceTracer> Tracer;
};

}

#endif
