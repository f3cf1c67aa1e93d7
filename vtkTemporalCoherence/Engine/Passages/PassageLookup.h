// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageLookup_h
#define TemporalCoherence_PassageLookup_h

#include "Isomap/IsomapLookup.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Scene/TileHits.h"
#include "Shade/TileCompositor.h"
#include "Trace/RaySource.h"
#include "Trace/SurfaceTracer.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Looks up the layers of translucent surfaces in an isomap of passages. Of each ray those cells
/// are searched, in their order along it, whose passages hold an isovalue of the frame. What is
/// found in them has the bits of a cold frame.
class PassageLookup
{
public:
  /// The arguments must outlive this.
  /// \param bands      finds passages in the isomap
  /// \param finiteRange smallest and largest finite sample
  /// \param space      for rays that are traced behind their last passage
  /// \throws std::bad_alloc
  PassageLookup(const FrameKey& key, const IsomapLookup& bands, const glm::dvec2& finiteRange,
    const LeapedSpace& space);

  /// Look up the rays through `part`, which is tile number `tile`, and write the planes of their
  /// first layers. Thread-safe.
  /// \param keys  of the tile's group
  /// \param found gets the rays and layers; unchanged in a tile without any
  /// \throws std::bad_alloc
  TraceCounts LookUpTile(std::int64_t tile, const PixelRect& part,
    const std::vector<IsomapLookup::IsovalueKeys>& keys, Frame& frame, TileHits& found) const;

private:
  std::uint64_t Search(std::int64_t tile, std::size_t piece,
    const std::vector<IsomapLookup::IsovalueKeys>& keys, const RayBatch& rays,
    LayerBatch& layers) const;
  std::uint64_t SearchPieces(std::int64_t tile, const std::vector<IsomapLookup::IsovalueKeys>& keys,
    const RayBatch& rays, LayerBatch& layers) const;

  const FrameKey& Key;
  const IsomapLookup& Bands;
  const TileBounds* Bounds; ///< null: no space leaping
  RaySource Rays;
  std::shared_ptr<const SurfaceTracer> Tracer;
  std::vector<float> Alphas; ///< AlphasOf the surfaces
};

}

#endif
