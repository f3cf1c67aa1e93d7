// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileTracer_h
#define TemporalCoherence_TileTracer_h

#include "Acceleration/TileBounds.h"
#include "Lattice/RayHint.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Render/LooseRays.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Scene/TileHits.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The inputs of TileTracer, which must outlive it.
struct TileScene
{
  const FrameKey& Key;
  const ActiveCells* Active = nullptr; ///< null: no space leaping
  const TileBounds* Bounds = nullptr;  ///< of Active
  glm::dvec2 FiniteRange{ 0.0 };
  const RayHint* Hint = nullptr;             ///< null: no hint, a cold frame
  const ValueRangePyramid* Ranges = nullptr; ///< of the field; null: they are not known
};

/// Traces the rays of a tile and writes the planes of the frame. The tile's bounds and the hint
/// narrow the walks; rays with a wrong hint are traced again.
class TileTracer
{
public:
  /// \throws std::bad_alloc
  explicit TileTracer(const TileScene& scene);

  /// Trace the rays through `part`, which is tile number `tile`. Thread-safe.
  /// \param found receives the rays and, without a hint, all hits
  TraceCounts Trace(std::int64_t tile, const PixelRect& part, Frame& frame, TileHits& found) const;

  /// Trace some rays of a tile, one bit each, without a hint.
  /// \param before a picture of these rays, which meet nothing before what it shows; may be null
  TraceCounts TraceSome(std::int64_t tile, const PixelRect& part, std::uint64_t which, Frame& frame,
    const Frame* before = nullptr) const;

  /// Trace rays that go anywhere through a tile, whatever the hint.
  /// \param found receives the rays and, unless surfaces are translucent, their hits
  /// \return false if the rays are known to miss. They are not set up then
  bool TraceAt(std::int64_t tile, const LooseRays& loose, TileHits& found) const;

private:
  /// Set up the rays of a tile. Narrow their walks to the parts that can hold surfaces.
  /// \return false if the rays are known to miss. They are not set up then
  bool SetUp(std::int64_t tile, const PixelRect& part, TileHits& found) const;

  bool MayBeCapped(std::int64_t tile) const;
  bool CanSkip(std::int64_t tile) const;
  void Find(const RayBatch& rays, HitBatch& hits) const;
  void FindFirstLayers(TileHits& found) const;
  void TraceRays(const RayHint& hint, const KnownRays& known, TileHits& found, Frame& frame,
    TraceCounts& counts) const;
  void Store(const RayBatch& rays, const HitBatch& hits, Frame& frame, TraceCounts& counts) const;
  void TraceAgain(const RayBatch& rays, Frame& frame, TraceCounts& counts) const;

  TileScene Scene;
  RaySource Rays;
  bool HasSurfaces;
  bool IsSolid;
  std::vector<std::uint8_t> Capped; ///< FindCapTiles; empty: not known
  std::shared_ptr<const SurfaceTracer> Tracer;
  std::vector<float> Alphas; ///< AlphasOf the surfaces; empty if no layers are to be found
};

}

#endif
