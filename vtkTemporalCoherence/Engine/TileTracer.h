// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileTracer_h
#define TemporalCoherence_TileTracer_h

#include "ImageQuery.h"
#include "ReusePlan.h"
#include "Shader.h"
#include "SurfaceTracer.h"
#include "TileBounds.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// What the rays of some tiles came to.
struct TraceCounts
{
  std::int64_t DefiniteHits = 0;
  std::int64_t DefiniteMisses = 0;
  std::int64_t PossibleHits = 0;
  std::int64_t TracedRays = 0;
  std::int64_t CellsRead = 0;
  std::int64_t QueryTime = 0; ///< nanoseconds spent in asking the image, where it was timed
  std::int64_t TileTime = 0;  ///< nanoseconds, with that included
};

/// What tiles are traced with; all of it must outlive the tracer.
struct TileScene
{
  const FrameKey& Key;
  const ActiveCells* Active = nullptr; ///< null: no space leaping
  const TileBounds* Bounds = nullptr;  ///< of Active
  glm::dvec2 FiniteRange{ 0.0 };
  const ImageQuery* Query = nullptr; ///< null: a cold frame
  bool InterpolateColors = false;    ///< definite hits take what the cached image has
};

/// Takes the rays of one tile from their set-up to the planes of the frame: the walk narrowed by
/// the tile's bounds and by what a cached image knows, the trace, and a second trace where that
/// turned out wrong.
class TileTracer
{
public:
  /// \throws std::bad_alloc
  explicit TileTracer(const TileScene& scene);

  /// Trace the rays through `part`, which is tile number `tile`. Safe from many threads.
  TraceCounts Trace(std::int64_t tile, const PixelRect& part, Frame& frame) const;

private:
  bool CanSkip(std::int64_t tile) const;
  void TraceCold(const RayBatch& rays, Frame& frame, TraceCounts& counts) const;
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
  std::unique_ptr<SurfaceTracer> Tracer;
};

}

#endif
