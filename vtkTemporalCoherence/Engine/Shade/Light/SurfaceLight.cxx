// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/SurfaceLight.h"

#include "Scene/Tiles.h"
#include "Shade/Light/LightDirections.h"
#include "Shade/Light/LightEstimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

namespace TemporalCoherence
{

SurfaceLight::SurfaceLight(const FrameKey& key, const FieldNormals& normals,
  const glm::dvec2& finiteRange, std::shared_ptr<const SurfaceTracer> tracer,
  const LightCache& kept, std::uint32_t raysOfFrame, std::uint32_t raysInAll, bool sharesPixels)
  : Key(key)
  , Kept(kept)
  , RaysOfFrame(raysOfFrame)
  , RaysInAll(raysInAll)
  , SharesPixels(sharesPixels)
  , Source(NormalSourceOf(key, normals, finiteRange))
  , Tracer(key, this->Source, std::move(tracer))
  , WidthPerDepth(0.0)
  , Width(0.0)
  , NormalFromWorld(glm::transpose(glm::dmat3(key.Transform.WorldFromIndex)))
  , OfTiles(static_cast<std::size_t>(NumberOfTiles(key.View.Size)))
{
  const View& view = key.View;
  // Hardly two pixels share a patch of half a pixel, so the light of a still view has no blur.
  const double patch = sharesPixels ? 2.0 : 1.0;
  if (view.Parallel)
  {
    this->Width = patch * glm::length(view.OriginX) / view.Size.x;
  }
  else
  {
    this->WidthPerDepth =
      patch * glm::length(view.DirectionX) / (view.Size.x * glm::length(view.Direction));
  }
  for (int a = 0; a < 3; ++a)
  {
    this->Edges[a] = glm::length(glm::dvec3(key.Transform.WorldFromIndex[a]));
    for (int world = 0; world < 3; ++world)
    {
      this->NormalFromWorld[world][a] /= static_cast<float>(this->Edges[a]);
    }
  }
}

/// Traces the rays of a tile in batches.
class SurfaceLight::Batch
{
public:
  Batch(const OcclusionTracer& tracer, double length, LightCache::Found* found)
    : Tracer(tracer)
    , Length(length)
    , Found(found)
  {
  }

  /// Append a ray of a patch, and trace the batch if it is full.
  void Append(const glm::dvec3& origin, const glm::dvec3& direction, std::size_t patch)
  {
    const std::size_t at = this->Rays.Count++;
    this->Patch[at] = patch;
    for (int a = 0; a < 3; ++a)
    {
      this->Rays.Origin[static_cast<std::size_t>(a)][at] = origin[a];
      this->Rays.Direction[static_cast<std::size_t>(a)][at] = direction[a];
    }
    if (this->Rays.Count == RayBatch::Capacity)
    {
      this->Trace();
    }
  }

  void Trace()
  {
    if (this->Rays.Count == 0)
    {
      return;
    }
    RayBatch::Array<float> passed;
    this->CellsRead += this->Tracer.Trace(this->Rays, this->Length, passed);
    for (std::size_t i = 0; i < this->Rays.Count; ++i)
    {
      this->Found[this->Patch[i]].Light +=
        static_cast<std::uint32_t>(passed[i] * static_cast<float>(LightSum::Whole) + 0.5f);
    }
    this->Rays.Count = 0;
  }

  std::int64_t CellsRead = 0;

private:
  const OcclusionTracer& Tracer;
  double Length;
  LightCache::Found* Found;
  LightRays Rays;
  RayBatch::Array<std::size_t> Patch; ///< position in Found
};

/// Choose how many rays a hit sends in this frame. Of each four pixels that are neighbours, another
/// one sends its rays in each frame. The first frame has two of them.
std::uint32_t SurfaceLight::RaysOf(std::int32_t pixel, std::uint32_t known) const
{
  const int x = pixel % this->Key.View.Size.x, y = pixel / this->Key.View.Size.x;
  const auto place = static_cast<std::uint32_t>((x & 1) ^ (y & 1)) + 2 * (y & 1);
  const std::uint32_t frame = this->Kept.NumberOfFrames();
  const bool isTurn =
    !this->SharesPixels || (frame == 0 ? (place & 1u) == 0 : place == (frame & 3u));
  const std::uint32_t left = this->RaysInAll - std::min(known, this->RaysInAll);
  return isTurn ? std::min(this->RaysOfFrame, left) : 0;
}

std::int64_t SurfaceLight::Find(
  std::int64_t tile, const HitList& hits, bool areAll, RayBatch::Array<float>& arriving)
{
  std::vector<LightCache::Found>& found = this->OfTiles[static_cast<std::size_t>(tile)];
  const std::size_t first = found.size();
  try
  {
    found.reserve(first + hits.Rays.Count);
  }
  catch (const std::bad_alloc&)
  {
    arriving.fill(1.0f); // a later frame may find the light
    this->Missing += static_cast<std::int64_t>(hits.Rays.Count);
    return 0;
  }
  RayBatch::Array<std::uint8_t> places; // of hits that are no misses
  RayBatch::Array<std::uint64_t> hashes;
  std::size_t count = 0;
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    arriving[i] = 1.0f;
    if ((hits.Misses >> i & 1u) == 0)
    {
      found.push_back({ this->PlaceOf(hits, i), LightCache::NoBlock, 0, 0 });
      hashes[count] = HashOfBlock(found.back().Place);
      this->Kept.PrepareSlot(hashes[count]);
      places[count++] = static_cast<std::uint8_t>(i);
    }
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    this->Kept.PrepareBlock(hashes[k], found[first + k].Place);
  }
  RayBatch::Array<LightCache::Known> known;
  for (std::size_t k = 0; k < count; ++k)
  {
    LightCache::Found& patch = found[first + k];
    known[k] = this->Kept.Find(hashes[k], patch.Place);
    patch.Block = known[k].Block;
    patch.Rays = this->RaysOf(hits.Pixel[places[k]], known[k].Own.Rays());
  }
  const std::int64_t cells = this->Trace(hits, places, count, known, found.data() + first);
  this->Gather(places, count, known, found.data() + first, areAll, arriving);
  FillLastVector(hits.Rays.Count, arriving);
  return cells;
}

/// Trace the rays of hits: the first rays of all hits, then their second rays, and so on.
std::int64_t SurfaceLight::Trace(const HitList& hits, const RayBatch::Array<std::uint8_t>& places,
  std::size_t count, const RayBatch::Array<LightCache::Known>& known, LightCache::Found* found)
{
  Batch batch(this->Tracer, this->Key.Appearance.Occlusion.Radius, found);
  for (std::uint32_t ray = 0; ray < this->RaysOfFrame; ++ray)
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      if (ray < found[k].Rays)
      {
        const auto& normal = hits.Normal[places[k]];
        batch.Append(hits.Rays.PointAt(places[k]),
          LightDirection(
            glm::dvec3(normal[0], normal[1], normal[2]), found[k].Place, known[k].Own.Rays() + ray),
          k);
      }
    }
  }
  batch.Trace();
  return batch.CellsRead;
}

/// Gather the light of hits from their patches, and from larger ones where these know little.
void SurfaceLight::Gather(const RayBatch::Array<std::uint8_t>& places, std::size_t count,
  const RayBatch::Array<LightCache::Known>& known, const LightCache::Found* found, bool areAll,
  RayBatch::Array<float>& arriving)
{
  TileSums sums;
  std::int64_t missing = 0;
  bool areFew = false;
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::uint32_t rays = known[k].Own.Rays() + found[k].Rays;
    areFew |= rays + known[k].Larger[1].Rays() < Estimate::FewRays;
    missing += rays < this->RaysInAll;
  }
  const bool pools = areAll && areFew;
  for (std::size_t k = 0; pools && k < count; ++k)
  {
    if (found[k].Rays > 0)
    {
      const PatchPlace larger = LargerThan(found[k].Place);
      sums.At(larger).Add(found[k].Rays, found[k].Light);
      sums.At(LargerThan(larger)).Add(found[k].Rays, found[k].Light);
    }
  }
  const double strength = this->Key.Appearance.Occlusion.Strength;
  for (std::size_t k = 0; k < count; ++k)
  {
    Estimate estimate;
    estimate.AddAll(known[k].Own);
    LightSum isNew;
    isNew.Add(found[k].Rays, found[k].Light);
    estimate.AddAll(isNew);
    for (const LightSum& larger : known[k].Larger)
    {
      estimate.AddMissing(larger);
    }
    if (pools && estimate.Rays < Estimate::FewRays)
    {
      const PatchPlace larger = LargerThan(found[k].Place);
      estimate.AddMissing(sums.At(larger));
      estimate.AddMissing(sums.At(LargerThan(larger)));
    }
    arriving[places[k]] = static_cast<float>(1.0 - strength * (1.0 - estimate.Share()));
  }
  this->Missing += missing;
}

/// The patch of a hit.
PatchPlace SurfaceLight::PlaceOf(const HitList& hits, std::size_t hit) const
{
  const glm::dmat4& toIndex = this->Key.Transform.IndexFromWorld;
  const glm::dvec3 point(toIndex * glm::dvec4(hits.Rays.PointAt(hit), 1.0));
  const auto& normal = hits.Normal[hit];
  return PlaceOfPatch(point * this->Edges,
    this->NormalFromWorld * glm::vec3(normal[0], normal[1], normal[2]),
    this->Width + this->WidthPerDepth * hits.Rays.T[hit], hits.Surface[hit], hits.Kind[hit]);
}

}
