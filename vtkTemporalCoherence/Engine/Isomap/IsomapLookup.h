// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsomapLookup_h
#define TemporalCoherence_IsomapLookup_h

#include "Isomap/Isomap.h"
#include "Lattice/HitRules.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/FramePlanes.h"
#include "Scene/RayBatch.h"
#include "Scene/TileHits.h"

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
  /// \param map         of the view of the key
  /// \param finiteRange smallest and largest finite sample
  /// \param tracer      searches single cells; it leaps no space
  IsomapLookup(const FrameKey& key, const Isomap& map, const glm::dvec2& finiteRange,
    std::shared_ptr<const SurfaceTracer> tracer);

  /// An isovalue in a band.
  struct IsovalueKeys
  {
    const GroupBand* Band;
    std::array<BandScale::Key, NumberOfDirections> Key; ///< of the isovalue, in each direction
    std::array<double, NumberOfDirections> Progress;    ///< progress of the isovalue, as stored
    std::array<double, NumberOfDirections> Steps;       ///< the same in steps of the grid
    double StepError;                                   ///< of these, in steps
    double DistanceStep;
    double EntryError; ///< of progress where a ray begins, as stored
  };

  /// The isovalues of the frame in the bands of a group of tiles.
  /// \param keys gets one for each isovalue
  /// \return false if a band is missing, or memory runs out
  bool FindBands(std::size_t group, std::vector<IsovalueKeys>& keys) const;

  /// Look up the rays through `part`, which is tile number `tile`, and write their planes: definite
  /// hits and misses, and caps, which are possible hits. If knots have normals, the normals of
  /// definite hits are written, too. Thread-safe.
  /// \param keys       of the tile's group
  /// \param unresolved gets one bit for each ray that must be traced instead: its isovalue is too
  ///                   close to a value that the ray barely reaches. Its planes are undefined.
  /// \param tileHits   gets the rays and their hits; unchanged in a tile without any
  TraceCounts LookUpTile(std::int64_t tile, const PixelRect& part,
    const std::vector<IsovalueKeys>& keys, Frame& frame, std::uint64_t& unresolved,
    TileHits& tileHits) const;

private:
  /// The results of a tile.
  struct Found
  {
    Found(const std::vector<IsovalueKeys>& isovalues, HitBatch& hits)
      : Isovalues(isovalues)
      , Hits(hits)
    {
    }

    const std::vector<IsovalueKeys>& Isovalues;
    HitBatch& Hits;
    std::uint64_t Wanted = ~std::uint64_t(0); ///< one bit for each ray that is looked up
    std::uint64_t Unresolved = 0;
    RayBatch::Array<glm::vec3> Normals;
  };

  void PrefetchNext(std::int64_t tile, const std::vector<IsovalueKeys>& keys) const;
  void FindInPieces(std::int64_t tile, const RayBatch& rays, Found& found) const;
  void FindSurfaces(std::int64_t tile, std::size_t piece, const RayBatch& rays, Found& found) const;
  std::uint64_t BeginOn(std::size_t surface, const TileKnots& knots, const RayBatch& rays,
    RayBatch::Array<std::uint8_t>& directions, Found& found) const;
  static void FindKnots(const IsovalueKeys& keys, std::uint64_t which,
    const RayBatch::Array<std::uint8_t>& directions, const TileKnots& knots, RayCells& cells,
    RayBatch::Array<std::size_t>& places);
  std::uint64_t SearchNextKnots(std::uint64_t missing,
    const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
    RayCells& cells, RayBatch::Array<std::size_t>& places, HitBatch& hits) const;
  void FindInCells(std::size_t surface, std::uint64_t which,
    const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
    Found& found) const;
  void FindInFittedKnots(std::size_t surface, std::uint64_t which,
    const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
    Found& found) const;
  TraceCounts StoreFound(std::uint64_t unresolved, TileHits& tileHits, Frame& frame) const;
  void StoreNormals(const RayBatch& rays, const Found& found, Frame& frame) const;

  const TileKnots* KnotsOf(const IsovalueKeys& keys, std::int64_t tile) const;
  bool IsMiss(std::int64_t tile, const std::vector<IsovalueKeys>& keys) const;

  const FrameKey& Key;
  const Isomap& Map;
  glm::dvec2 FiniteRange;
  double Tolerance;
  bool HasNormals;
  std::size_t Pieces;
  RaySource Rays;
  HitRules Rules;
  std::shared_ptr<const SurfaceTracer> Tracer;
};

}

#endif
