// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceLight_h
#define TemporalCoherence_SurfaceLight_h

#include "Shade/Light/LightCache.h"
#include "Shade/Light/OcclusionTracer.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// How many rays find the light of surfaces.
struct LightOptions
{
  std::uint32_t RaysOfFrame = 1;    ///< from one of each four pixels, in turn
  std::uint32_t RaysWhenStill = 32; ///< from each pixel, if the view and all else stay
  std::uint32_t Rays = 1024; ///< in all frames together, at most 4095; then the light is final
  std::size_t MemoryLimit = std::size_t(256) << 20; ///< bytes of kept light
};

/// The light that reaches the surfaces of one frame: traces some rays, and joins what they find
/// with the kept light. Thread-safe, one thread a tile.
class SurfaceLight
{
public:
  /// The arguments must outlive it.
  /// \throws std::bad_alloc
  SurfaceLight(const FrameKey& key, const FieldNormals& normals, const glm::dvec2& finiteRange,
    std::shared_ptr<const SurfaceTracer> tracer, const LightCache& kept, std::uint32_t raysOfFrame,
    std::uint32_t raysInAll, bool sharesPixels);

  /// Find the share of ambient and diffuse light that reaches hits.
  /// \param hits     with their normals
  /// \param isTile   the list holds the first hits of a tile: neighbours help each other
  /// \param arriving result, up to the end of the last vector
  /// \return cells read
  std::int64_t Find(
    std::int64_t tile, const HitList& hits, bool isTile, RayBatch::Array<float>& arriving);

  /// True if no hit needs more rays.
  bool IsFinal() const { return this->Missing.load() == 0; }

  const std::vector<std::vector<LightCache::Found>>& Found() const { return this->OfTiles; }

private:
  class Batch;

  struct Senders;

  bool CanShare(const HitList& hits, std::size_t one, std::size_t other, double width) const;
  void ChooseSenders(const HitList& hits, bool isTile, Senders& senders) const;
  std::int64_t Trace(const HitList& hits, const Senders& senders,
    const RayBatch::Array<LightCache::Known>& known, LightCache::Found* found) const;
  void Gather(std::size_t count, const RayBatch::Array<LightCache::Known>& known,
    const LightCache::Found* found, bool areTogether, RayBatch::Array<float>& arriving);
  double WidthAt(double t) const { return this->Width + this->WidthPerDepth * t; }
  PatchPlace PlaceOf(const HitList& hits, std::size_t hit) const;

  const FrameKey& Key;
  const LightCache& Kept;
  std::uint32_t RaysOfFrame, RaysInAll;
  bool SharesPixels; ///< one of four pixels sends rays; patches are two pixels wide
  NormalSource Source;
  OcclusionTracer Tracer;
  double WidthPerDepth, Width; ///< of patches: for each unit of t, and at t = 0
  glm::mat3 NormalFromWorld;   ///< to the axes of the data
  glm::dvec3 Edges;            ///< of a cell of index space, in the world
  std::vector<std::vector<LightCache::Found>> OfTiles;
  std::atomic<std::int64_t> Missing{ 0 }; ///< hits that need more rays
};

}

#endif
