// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsomapLookup_h
#define TemporalCoherence_IsomapLookup_h

#include "Isomap/Isomap.h"
#include "Scene/FramePlanes.h"
#include "Scene/RayBatch.h"
#include "Scene/TileHits.h"
#include "Trace/HitRules.h"
#include "Trace/RaySource.h"
#include "Trace/SurfaceTracer.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Looks up the surfaces of a frame in an isomap. A search among a ray's knots gives the cell in
/// which the exact crossing is computed or, in an isomap with a tolerance, a point between two
/// knots.
class IsomapLookup
{
public:
  /// The arguments must outlive this.
  /// \param bands       for each isovalue of the key the band that holds it
  /// \param finiteRange smallest and largest finite sample
  /// \throws std::bad_alloc
  IsomapLookup(const FrameKey& key, const std::vector<const Isomap::Band*>& bands, double tolerance,
    const glm::dvec2& finiteRange);

  /// Look up the rays through `part`, which is tile number `tile`, and write their planes: definite
  /// hits and misses, and caps, which are possible hits. If knots have normals, those of definite
  /// hits are written, too. Thread-safe.
  /// \param unresolved gets one bit for each ray that must be traced instead: its isovalue is too
  ///                   close to a value that the ray barely reaches. Its planes are undefined.
  /// \param tileHits   gets the rays and their hits; unchanged in a tile without any
  TraceCounts LookUpTile(std::int64_t tile, const PixelRect& part, Frame& frame,
    std::uint64_t& unresolved, TileHits& tileHits) const;

  /// The same, if nobody needs the hits but the planes.
  TraceCounts LookUpTile(
    std::int64_t tile, const PixelRect& part, Frame& frame, std::uint64_t& unresolved) const
  {
    TileHits tileHits;
    return this->LookUpTile(tile, part, frame, unresolved, tileHits);
  }

private:
  /// An isovalue and its band.
  struct IsovalueKeys
  {
    const Isomap::Band* Band;
    std::array<BandScale::Key, NumberOfDirections> Key; ///< of the isovalue, in each direction
    std::array<double, NumberOfDirections> Progress;    ///< the same, as stored
  };

  /// What was found in a tile.
  struct Found
  {
    explicit Found(HitBatch& hits)
      : Hits(hits)
    {
    }

    HitBatch& Hits;
    std::uint64_t Wanted = ~std::uint64_t(0); ///< one bit for each ray that is looked up
    std::uint64_t Unresolved = 0;
    RayBatch::Array<glm::vec3> Normals;
  };

  void FindInPieces(std::int64_t tile, const RayBatch& rays, Found& found) const;
  void FindSurfaces(std::int64_t tile, std::size_t piece, const RayBatch& rays, Found& found) const;
  std::uint64_t BeginOn(std::size_t surface, const TileKnots& knots, const RayBatch& rays,
    RayBatch::Array<std::uint8_t>& directions, Found& found) const;
  void FindKnots(std::uint64_t which, const RayBatch::Array<std::uint8_t>& directions,
    const TileKnots& knots, CellList& cells, RayBatch::Array<std::size_t>& places) const;
  void FindInCells(std::size_t surface, std::uint64_t which,
    const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
    Found& found) const;
  void FindInFittedKnots(std::size_t surface, std::uint64_t which,
    const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
    Found& found) const;
  void StoreNormals(const RayBatch& rays, const Found& found, Frame& frame) const;

  const FrameKey& Key;
  double Tolerance;
  bool HasNormals;
  RaySource Rays;
  std::vector<IsovalueKeys> Isovalues;
  HitRules Rules;
  std::shared_ptr<const SurfaceTracer> Tracer;
};

}

#endif
