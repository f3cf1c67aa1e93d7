// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileCompositor_h
#define TemporalCoherence_TileCompositor_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/TileBounds.h"
#include "Scene/Frame.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Shade/Shader.h"
#include "Trace/RaySource.h"
#include "Trace/SurfaceTracer.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// The structures for space leaping.
struct LeapedSpace
{
  const ActiveCells* Active = nullptr; ///< of a frame's isovalues; null: no leaping
  const TileBounds* Bounds = nullptr;  ///< of Active
};

/// Colours tiles with translucent surfaces. It starts from the first hits, whatever route found
/// them, finds and shades layer after layer, and composites them from front to back with the "over"
/// operator, until the pixels are opaque.
class TileCompositor
{
public:
  /// The arguments must outlive it.
  /// \throws std::bad_alloc
  TileCompositor(const FrameKey& key, const NormalSource& source, const LeapedSpace& space);

  /// Find and colour the layers behind the first hits of `part`, which is tile number `tile`. The
  /// planes then hold the first visible surface. Thread-safe.
  void Composite(std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const;

  /// Colour a tile again from the layers of the frame.
  void CompositeAgain(std::int64_t tile, const PixelRect& part, Frame& frame) const;

private:
  class Canvas;
  void SetUp(std::int64_t tile, const PixelRect& part, const Frame& frame, RayBatch& rays,
    HitBatch& hits) const;
  void FindNext(const RayBatch& rays, HitBatch& hits) const;
  void AddLayer(HitList& layer, LayerHit* hits, Canvas& canvas) const;

  const FrameKey& Key;
  const NormalSource& Source;
  const TileBounds* Bounds; ///< null: no space leaping
  RaySource Rays;
  std::shared_ptr<const SurfaceTracer> Tracer;
};

}

#endif
