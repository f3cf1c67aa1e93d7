// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileCompositor_h
#define TemporalCoherence_TileCompositor_h

#include "Acceleration/TileBounds.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/Frame.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Scene/LayerBatch.h"
#include "Shade/KnownLayers.h"
#include "Shade/LayerShader.h"
#include "Shade/LimitedLayers.h"
#include "Shade/Shader.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Colours tiles with translucent surfaces. It starts from the first hits, whatever route found
/// them, finds and shades layer after layer, and composites them from front to back with the "over"
/// operator, until the pixels are opaque.
class TileCompositor
{
public:
  /// The arguments must outlive it.
  /// \param tracer finds the layers behind the first ones
  /// \param bounds of the active cells that the tracer leaps between; null: no space leaping
  /// \param light  that reaches the surfaces; null: all of it does
  /// \throws std::bad_alloc
  TileCompositor(const FrameKey& key, const NormalSource& source,
    std::shared_ptr<const SurfaceTracer> tracer, const TileBounds* bounds, SurfaceLight* light);

  /// Find and colour the layers behind the first hits of `part`, which is tile number `tile`. The
  /// planes then hold the first visible surface. Thread-safe.
  /// \param found its rays and first layers, which are used up; null, or without layers: takes the
  ///              first hits from the planes
  void Composite(std::int64_t tile, const PixelRect& part, TileHits* found, Frame& frame,
    TraceCounts& counts) const;

  /// Composite known layers, and find the layers behind them where light passes. The planes need
  /// not hold anything before.
  /// \throws std::bad_alloc
  void CompositeKnown(std::int64_t tile, const PixelRect& part, const KnownLayers& known,
    Frame& frame, TraceCounts& counts) const;

  /// Colour a tile again from the layers of the frame. Merged layers are traced again. Nothing is
  /// allocated.
  void CompositeAgain(
    std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const;

  /// Find and composite all surfaces along rays that go anywhere through a tile. Layers are not
  /// kept. \param found the rays \param rays  a frame of one whole tile, whose pixels show these
  /// rays
  void CompositeAt(std::int64_t tile, const RayPlaces& at, TileHits& found, Frame& rays,
    TraceCounts& counts) const;

private:
  void SetUpRays(std::int64_t tile, const PixelRect& part, TileHits& found) const;
  void SetUp(std::int64_t tile, const PixelRect& part, const Frame& frame, TileHits& found) const;
  template <typename Keeper>
  void AddAll(std::int64_t tile, TileHits& found, const PixelCentres& centres, LayerCanvas& canvas,
    Keeper& kept, TraceCounts& counts) const;
  template <typename Keeper>
  void AddLayers(std::int64_t tile, const TileHits& found, const PixelCentres& centres,
    LayerCanvas& canvas, Keeper& kept) const;
  void AddKnown(std::int64_t tile, const std::vector<LayerHit>& known, const PixelCentres& centres,
    LayerCanvas& canvas, LimitedLayers& kept, std::vector<LayerHit>& behind) const;
  template <typename Keeper, typename SetLast>
  void AddUnknown(std::uint64_t open, const SetLast& setLast, std::int64_t tile,
    const PixelRect& part, const PixelCentres& centres, LayerCanvas& canvas, Keeper& kept,
    TraceCounts& counts) const;
  void RecolorMerged(std::uint64_t merged, std::int64_t tile, const PixelRect& part,
    const PixelCentres& centres, LayerCanvas& canvas, Frame& frame, TraceCounts& counts) const;
  void Paint(const std::vector<LayerHit>& layers, Frame& frame) const;

  const FrameKey& Key;
  LayerShader Shader;
  const TileBounds* Bounds; ///< null: no space leaping
  RaySource Rays;
  std::shared_ptr<const SurfaceTracer> Tracer;
  std::vector<float> Alphas; ///< AlphasOf the surfaces
};

}

#endif
