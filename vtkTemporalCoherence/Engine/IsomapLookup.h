// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsomapLookup_h
#define TemporalCoherence_IsomapLookup_h

#include "FramePlanes.h"
#include "Isomap.h"
#include "RayBatch.h"
#include "SurfaceTracer.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Looks the surfaces of a frame up in an isomap: a search among a ray's knots, and the exact
/// crossing in the cell that they tell.
class IsomapLookup
{
public:
  /// \param bands       one for each isovalue of the key, which it holds
  /// \param finiteRange smallest and largest finite sample
  /// All of it must outlive this.
  /// \throws std::bad_alloc
  IsomapLookup(const FrameKey& key, const std::vector<const Isomap::Band*>& bands,
    const glm::dvec2& finiteRange);

  /// Look up the rays through `part`, which is tile number `tile`, and write their planes. Safe
  /// from many threads.
  /// \param open gets one bit for each ray that has to be traced instead, as an isovalue is too
  ///             close to a value that the ray only just reaches; its planes hold nothing of use
  TraceCounts Look(
    std::int64_t tile, const PixelRect& part, Frame& frame, std::uint64_t& open) const;

private:
  /// An isovalue and its band.
  struct Sought
  {
    const Isomap::Band* Band;
    std::array<BandScale::Key, NumberOfCourses> Key; ///< of the isovalue, on each course
    double Difference; ///< of the isovalue from the band's lowest
    double EntryError; ///< how exactly it is known where in the band rays begin
  };

  std::uint64_t LookFor(std::size_t surface, std::int64_t tile, const RayBatch& rays,
    HitBatch& hits) const;
  void Cap(std::size_t surface, std::size_t ray, const RayBatch& rays, HitBatch& hits) const;

  const FrameKey& Key;
  RaySource Rays;
  std::vector<Sought> Isovalues;
  std::unique_ptr<SurfaceTracer> Tracer;
};

}

#endif
