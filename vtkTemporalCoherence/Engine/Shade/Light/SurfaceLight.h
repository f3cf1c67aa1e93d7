// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceLight_h
#define TemporalCoherence_SurfaceLight_h

#include "Shade/Light/ArrivingLight.h"
#include "Shade/Light/KeptShadows.h"
#include "Shade/Light/LightCache.h"
#include "Shade/Light/LightTracer.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// How many rays find the light of surfaces.
struct LightOptions
{
  std::uint32_t RaysOfFrame = 1;    ///< from one of each four pixels, in turn
  std::uint32_t RaysWhenStill = 32; ///< from each pixel, if the view and all else stay
  std::uint32_t Rays = 1024; ///< in all frames together, at most 4095; then the light is final
  bool AtOnce = false;       ///< all rays in one frame: its light is final
  std::size_t MemoryLimit = std::size_t(256) << 20; ///< bytes of kept light
};

/// The light that reaches the surfaces of one frame: traces some rays, and joins what they find
/// with the kept light. Thread-safe, one thread a tile.
class SurfaceLight
{
public:
  /// The arguments must outlive it.
  /// \param shadows of the first hits of tiles are kept there; null: none are kept
  /// \throws std::bad_alloc
  SurfaceLight(const FrameKey& key, const FieldNormals& normals, const glm::dvec2& finiteRange,
    std::shared_ptr<const SurfaceTracer> tracer, const LightCache& kept, KeptShadows* shadows,
    std::uint32_t raysOfFrame, std::uint32_t raysInAll, bool sharesPixels);

  /// Find the light that reaches hits.
  /// \param hits     with their normals
  /// \param isTile   the list holds the first hits of a tile: neighbours help each other
  /// \return cells read
  std::int64_t Find(std::int64_t tile, const HitList& hits, bool isTile, ArrivingLight& arriving);

  /// The share of the rays of all hits that is known, from 0 to 1. 1: no hit needs more rays.
  double Progress() const
  {
    const auto wanted = static_cast<double>(this->Wanted.load());
    return wanted > 0.0 ? static_cast<double>(this->Known.load()) / wanted : 1.0;
  }

  /// What the rays found, once all tiles are made.
  LightCache::FoundInTiles TakeFound() { return std::move(this->OfTiles); }

private:
  struct Senders;

  /// Where light comes from whose sum is kept.
  struct Source
  {
    std::uint16_t Number; ///< PatchPlace::Source
    const Light* Of;      ///< null: all sides
  };

  /// The way from a point to where its light comes from.
  struct Way
  {
    glm::dvec3 Direction; ///< of unit length
    double Length;
  };

  std::uint32_t RaysNeeded(std::uint32_t rays, std::uint32_t light) const;
  bool PrepareRoom(std::int64_t tile, std::size_t senders, ArrivingLight& arriving);
  bool CanShare(const HitList& hits, std::size_t one, std::size_t other, double width) const;
  void ChooseSenders(const HitList& hits, bool isTile, Senders& senders) const;
  Way WayTo(const Source& source, const HitList& hits, std::size_t hit, const PatchPlace& place,
    std::uint32_t number) const;
  std::int64_t FindKept(std::int64_t tile, const HitList& hits, bool isTile, const Senders& senders,
    const Source& source, RayBatch::Array<float>& arriving);
  std::int64_t Trace(const HitList& hits, const Senders& senders, const Source& source,
    const RayBatch::Array<LightCache::Known>& known, LightCache::Found* found) const;
  void Gather(std::size_t count, const RayBatch::Array<LightCache::Known>& known,
    const LightCache::Found* found, bool areTogether, RayBatch::Array<float>& shares);
  double WidthAt(double t) const { return this->Width + this->WidthPerDepth * t; }
  PatchPlace PlaceOf(const HitList& hits, std::size_t hit) const;

  const FrameKey& Key;
  const LightCache& Kept;
  KeptShadows* Shadows;
  std::uint32_t RaysOfFrame, RaysInAll;
  bool SharesPixels; ///< one of four pixels sends rays; patches are two pixels wide
  NormalSource Normals;
  LightTracer Tracer;
  std::vector<Source> Sources;
  double WidthPerDepth, Width; ///< of patches: for each unit of t, and at t = 0
  glm::mat3 NormalFromWorld;   ///< to the axes of the data
  glm::dvec3 Edges;            ///< of a cell of index space, in the world
  LightCache::FoundInTiles OfTiles;
  std::atomic<std::int64_t> Wanted{ 0 }, Known{ 0 }; ///< rays of all hits
};

}

#endif
