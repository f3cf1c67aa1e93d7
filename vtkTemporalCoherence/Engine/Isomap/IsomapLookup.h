// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsomapLookup_h
#define TemporalCoherence_IsomapLookup_h

#include "Isomap/Isomap.h"
#include "Scene/FramePlanes.h"
#include "Scene/RayBatch.h"
#include "Trace/HitRules.h"
#include "Trace/RaySource.h"
#include "Trace/SurfaceTracer.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Looks the surfaces of a frame up in an isomap: a search among a ray's knots, and then the exact
/// crossing in the cell that they tell, or, in an isomap with a tolerance, a point between them.
class IsomapLookup
{
public:
  /// \param bands       one for each isovalue of the key, which it holds
  /// \param finiteRange smallest and largest finite sample
  /// All of it must outlive this.
  /// \throws std::bad_alloc
  IsomapLookup(const FrameKey& key, const std::vector<const Isomap::Band*>& bands, double tolerance,
    const glm::dvec2& finiteRange);

  /// Look up the rays through `part`, which is tile number `tile`, and write their planes: definite
  /// hits and misses, and caps, which are possible hits. Where knots have normals, those of
  /// definite hits are written, too. Safe from many threads.
  /// \param unresolved gets one bit for each ray that has to be traced instead, as an isovalue is
  /// too
  ///             close to a value that the ray only just reaches; its planes hold nothing of use
  TraceCounts LookUpTile(
    std::int64_t tile, const PixelRect& part, Frame& frame, std::uint64_t& unresolved) const;

private:
  /// An isovalue and its band.
  struct IsovalueKeys
  {
    const Isomap::Band* Band;
    std::array<BandScale::Key, NumberOfDirections> Key; ///< of the isovalue, in each direction
    std::array<double, NumberOfDirections> Progress;    ///< likewise, as it is stored
  };

  /// What is looked up in a tile.
  struct Found
  {
    HitBatch Hits;
    std::uint64_t Wanted = ~std::uint64_t(0); ///< one bit for each ray that is looked up
    std::uint64_t Unresolved = 0;
    RayBatch::Array<glm::vec3> Normals;
  };

  void FindInPieces(std::int64_t tile, const RayBatch& rays, Found& found) const;
  void FindSurfaces(std::int64_t tile, std::size_t piece, const RayBatch& rays, Found& found) const;
  std::uint64_t BeginOn(std::size_t surface, const TileKnots& knots, const RayBatch& rays,
    RayBatch::Array<std::uint8_t>& directions, Found& found) const;
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
