// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/SurfaceLight.h"

#include "Scene/Tiles.h"
#include "Shade/Light/HardShadows.h"
#include "Shade/Light/LightDirections.h"
#include "Shade/Light/LightEstimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Before a patch has this many rays, their mean tells nothing about how certain it is.
constexpr std::uint32_t FewestRays = 256;

}

SurfaceLight::SurfaceLight(const FrameKey& key, const FieldNormals& normals,
  const glm::dvec2& finiteRange, std::shared_ptr<const SurfaceTracer> tracer,
  const LightCache& kept, KeptShadows* shadows, std::uint32_t raysOfFrame, std::uint32_t raysInAll,
  bool sharesPixels)
  : Key(key)
  , Kept(kept)
  , Shadows(shadows)
  , RaysOfFrame(raysOfFrame)
  , RaysInAll(raysInAll)
  , SharesPixels(sharesPixels)
  , Normals(NormalSourceOf(key, normals, finiteRange))
  , Tracer(key, this->Normals, std::move(tracer))
  , WidthPerDepth(0.0)
  , Width(0.0)
  , NormalFromWorld(glm::transpose(glm::dmat3(key.Transform.WorldFromIndex)))
  , OfTiles(static_cast<std::size_t>(NumberOfTiles(key.View.Size)))
{
  const View& view = key.View;
  // Edge of a patch, per half a pixel. Hardly two pixels share a patch of half a pixel, so the
  // light of a still view has no blur.
  const double patch = sharesPixels ? 4.0 : 1.0;
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
  if (key.Appearance.Occlusion.IsOn())
  {
    this->Sources.push_back({ 0, nullptr });
  }
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  for (std::size_t i = 0; i < std::min(key.Appearance.Lights.size(), most); ++i)
  {
    const Light& light = key.Appearance.Lights[i];
    if (light.CastsSoftShadows())
    {
      this->Sources.push_back({ static_cast<std::uint16_t>(i + 1), &light });
    }
  }
}

/// The hits that send rays and look into the cache. A sender serves the hits around it, too.
struct SurfaceLight::Senders
{
  std::size_t Count = 0;
  RayBatch::Array<std::uint8_t> Hit; ///< position in the list
  RayBatch::Array<std::uint8_t> Of;  ///< for each hit that is no miss: position of its sender
};

/// True if two hits lie so close together that one light serves both.
/// \param width of a patch
bool SurfaceLight::CanShare(
  const HitList& hits, std::size_t one, std::size_t other, double width) const
{
  constexpr float alike = 0.9f;
  const auto& a = hits.Normal[one];
  const auto& b = hits.Normal[other];
  const glm::dvec3 step = hits.Rays.PointAt(other) - hits.Rays.PointAt(one);
  return hits.Surface[one] == hits.Surface[other] && hits.Kind[one] == hits.Kind[other] &&
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > alike &&
    std::abs(glm::dot(step, glm::dvec3(a[0], a[1], a[2]))) < width;
}

/// Choose the senders. While pixels share, each square of four neighbours has one sender, at
/// another place in each frame. Else each hit is a sender.
///
/// \param isTile the list holds at most one hit of each pixel of a tile
void SurfaceLight::ChooseSenders(const HitList& hits, bool isTile, Senders& senders) const
{
  constexpr std::uint8_t none = 255;
  std::array<std::uint8_t, RayBatch::Capacity / 4> ofSquare;
  ofSquare.fill(none);
  const auto append = [&](std::size_t hit)
  {
    senders.Hit[senders.Count] = static_cast<std::uint8_t>(hit);
    return static_cast<std::uint8_t>(senders.Count++);
  };
  const bool shares = this->SharesPixels && isTile;
  const auto turn = static_cast<int>(this->Kept.NumberOfFrames() & 3u);
  RayBatch::Array<std::uint8_t> squares;
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    if ((hits.Misses >> i & 1u) != 0)
    {
      continue;
    }
    if (!shares)
    {
      senders.Of[i] = append(i);
      continue;
    }
    const int x = hits.Pixel[i] % this->Key.View.Size.x, y = hits.Pixel[i] / this->Key.View.Size.x;
    squares[i] =
      static_cast<std::uint8_t>((x % TileSize) / 2 + TileSize / 2 * ((y % TileSize) / 2));
    if ((x & 1) + 2 * ((x ^ y) & 1) == turn)
    {
      ofSquare[squares[i]] = append(i);
    }
  }
  for (std::size_t i = 0; shares && i < hits.Rays.Count; ++i)
  {
    if ((hits.Misses >> i & 1u) != 0)
    {
      continue;
    }
    std::uint8_t& sender = ofSquare[squares[i]];
    sender = sender == none ? append(i) : sender;
    const std::size_t hit = senders.Hit[sender];
    senders.Of[i] = hit == i || this->CanShare(hits, hit, i, this->WidthAt(hits.Rays.T[hit]))
      ? sender
      : append(i);
  }
}

/// Make room for what is found in a tile.
/// \return false if there is no memory
bool SurfaceLight::PrepareRoom(std::int64_t tile, std::size_t senders, ArrivingLight& arriving)
{
  const Appearance& appearance = this->Key.Appearance;
  try
  {
    if (std::any_of(appearance.Lights.begin(), appearance.Lights.end(),
          [](const Light& light) { return light.CastsShadows; }))
    {
      arriving.OfLights.resize(appearance.Lights.size());
    }
    std::vector<LightCache::Found>& found = this->OfTiles[static_cast<std::size_t>(tile)];
    found.reserve(found.size() + senders * this->Sources.size());
    return true;
  }
  catch (const std::bad_alloc&)
  {
    arriving.OfLights.clear();
    return false;
  }
}

std::int64_t SurfaceLight::Find(
  std::int64_t tile, const HitList& hits, bool isTile, ArrivingLight& arriving)
{
  const std::vector<Light>& lights = this->Key.Appearance.Lights;
  Senders senders;
  if (!this->Sources.empty())
  {
    this->ChooseSenders(hits, isTile, senders);
  }
  const bool hasRoom = this->PrepareRoom(tile, senders.Count, arriving);
  arriving.FromAllSides.fill(1.0f);
  for (RayBatch::Array<float>& ofLight : arriving.OfLights)
  {
    ofLight.fill(1.0f);
  }
  if (!hasRoom)
  {
    // A later frame may find the light.
    this->Wanted += static_cast<std::int64_t>(hits.Rays.Count) * this->RaysInAll;
    return 0;
  }
  std::int64_t cells = 0;
  for (std::size_t i = 0; i < arriving.OfLights.size(); ++i)
  {
    if (lights[i].CastsHardShadows())
    {
      cells += FindHardShadows(this->Tracer, this->Key.Appearance, i, hits,
        isTile ? this->Shadows : nullptr, arriving.OfLights[i]);
    }
  }
  const double strength = this->Key.Appearance.Occlusion.Strength;
  for (const Source& source : this->Sources)
  {
    RayBatch::Array<float>& of =
      source.Of ? arriving.OfLights[source.Number - 1u] : arriving.FromAllSides;
    cells += this->FindKept(tile, hits, isTile, senders, source, of);
    for (std::size_t i = 0; !source.Of && i < hits.Rays.Count; ++i)
    {
      of[i] = static_cast<float>(1.0 - strength * (1.0 - static_cast<double>(of[i])));
    }
    FillLastVector(hits.Rays.Count, of);
  }
  return cells;
}

/// The number of rays that make a patch final: fewer if nearly all or hardly any of them pass, as
/// their mean is certain sooner.
std::uint32_t SurfaceLight::RaysNeeded(std::uint32_t rays, std::uint32_t light) const
{
  if (rays < FewestRays)
  {
    return this->RaysInAll;
  }
  const double share = static_cast<double>(light) / (static_cast<double>(rays) * LightSum::Whole);
  const double spread = 8.0 * share * (1.0 - share);
  return std::min(
    std::max(FewestRays, static_cast<std::uint32_t>(spread * this->RaysInAll)), this->RaysInAll);
}

/// Find the light from a source: what is kept of it, and what new rays find.
/// \param arriving the share that arrives at each hit
std::int64_t SurfaceLight::FindKept(std::int64_t tile, const HitList& hits, bool isTile,
  const Senders& senders, const Source& source, RayBatch::Array<float>& arriving)
{
  std::vector<LightCache::Found>& found = this->OfTiles[static_cast<std::size_t>(tile)];
  const std::size_t first = found.size();
  RayBatch::Array<std::uint64_t> hashes;
  for (std::size_t k = 0; k < senders.Count; ++k)
  {
    found.push_back({ this->PlaceOf(hits, senders.Hit[k]), LightCache::NoBlock, 0, 0 });
    found.back().Place.Source = source.Number;
    hashes[k] = HashOfBlock(found.back().Place);
    this->Kept.PrepareSlot(hashes[k]);
  }
  for (std::size_t k = 0; k < senders.Count; ++k)
  {
    this->Kept.PrepareBlock(hashes[k], found[first + k].Place);
  }
  RayBatch::Array<LightCache::Known> known;
  for (std::size_t k = 0; k < senders.Count; ++k)
  {
    LightCache::Found& patch = found[first + k];
    known[k] = this->Kept.Find(hashes[k], patch.Place);
    patch.Block = known[k].Block;
    const LightSum& own = known[k].Own;
    patch.Rays = own.Rays() < this->RaysNeeded(own.Rays(), own.Light())
      ? std::min(this->RaysOfFrame, this->RaysInAll - own.Rays())
      : 0;
  }
  const std::int64_t cells = this->Trace(hits, senders, source, known, found.data() + first);
  RayBatch::Array<float> shares;
  this->Gather(senders.Count, known, found.data() + first, isTile, shares);
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    arriving[i] = (hits.Misses >> i & 1u) != 0 ? 1.0f : shares[senders.Of[i]];
  }
  return cells;
}

/// The way of a ray of a patch: its target is another point in each ray.
SurfaceLight::Way SurfaceLight::WayTo(const Source& source, const HitList& hits, std::size_t hit,
  const PatchPlace& place, std::uint32_t number) const
{
  if (!source.Of)
  {
    const auto& normal = hits.Normal[hit];
    return { DirectionAround({ normal[0], normal[1], normal[2] }, place, number),
      this->Key.Appearance.Occlusion.Radius };
  }
  const Light& light = *source.Of;
  const glm::dvec3 middle =
    light.Positional ? light.Position - hits.Rays.PointAt(hit) : -light.Direction;
  const double distance = glm::length(middle);
  if (!(distance > 0.0))
  {
    return { glm::dvec3(0.0, 0.0, 1.0), 0.0 };
  }
  const glm::dvec3 way = middle + light.Size * PointOnDisk(middle / distance, place, number);
  const double length = glm::length(way);
  return { way / length, light.Positional ? length : std::numeric_limits<double>::infinity() };
}

/// Trace the rays of hits: the first rays of all hits, then their second rays, and so on. A patch
/// sends no more rays than it needs.
std::int64_t SurfaceLight::Trace(const HitList& hits, const Senders& senders, const Source& source,
  const RayBatch::Array<LightCache::Known>& known, LightCache::Found* found) const
{
  LightRayBatches batches(this->Tracer,
    [&](std::size_t sender, float passed)
    {
      found[sender].Light +=
        static_cast<std::uint32_t>(passed * static_cast<float>(LightSum::Whole) + 0.5f);
    });
  for (std::uint32_t begin = 0; begin < this->RaysOfFrame; begin += FewestRays)
  {
    const std::uint32_t end = std::min(begin + FewestRays, this->RaysOfFrame);
    for (std::uint32_t ray = begin; ray < end; ++ray)
    {
      for (std::size_t k = 0; k < senders.Count; ++k)
      {
        if (ray < found[k].Rays)
        {
          const Way way =
            this->WayTo(source, hits, senders.Hit[k], found[k].Place, known[k].Own.Rays() + ray);
          batches.Append(hits.Rays.PointAt(senders.Hit[k]), way.Direction, way.Length, k);
        }
      }
    }
    batches.Finish();
    for (std::size_t k = 0; k < senders.Count; ++k)
    {
      const std::uint32_t rays = known[k].Own.Rays() + end;
      const bool isDone = rays >= this->RaysNeeded(rays, known[k].Own.Light() + found[k].Light);
      found[k].Rays = isDone ? std::min(found[k].Rays, end) : found[k].Rays;
    }
  }
  return batches.Finish();
}

/// Gather the light of patches, and of larger ones where these know little.
void SurfaceLight::Gather(std::size_t count, const RayBatch::Array<LightCache::Known>& known,
  const LightCache::Found* found, bool areTogether, RayBatch::Array<float>& shares)
{
  TileSums sums;
  std::int64_t sum = 0, wanted = 0;
  bool areFew = false;
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::uint32_t rays = known[k].Own.Rays() + found[k].Rays;
    areFew |= rays + known[k].Larger[1].Rays() < LightCache::FewRays;
    const std::uint32_t needed = this->RaysNeeded(rays, known[k].Own.Light() + found[k].Light);
    wanted += needed;
    // A still frame has smaller patches, and finds their light anew.
    sum += this->SharesPixels ? 0 : std::min(rays, needed);
  }
  const bool pools = areTogether && areFew;
  for (std::size_t k = 0; pools && k < count; ++k)
  {
    if (found[k].Rays > 0)
    {
      const PatchPlace larger = LargerThan(found[k].Place);
      sums.At(larger).Add(found[k].Rays, found[k].Light);
      sums.At(LargerThan(larger)).Add(found[k].Rays, found[k].Light);
    }
  }
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
    if (pools && estimate.Rays < LightCache::FewRays)
    {
      const PatchPlace larger = LargerThan(found[k].Place);
      estimate.AddMissing(sums.At(larger));
      estimate.AddMissing(sums.At(LargerThan(larger)));
    }
    shares[k] = static_cast<float>(estimate.Share());
  }
  this->Wanted += wanted;
  this->Known += sum;
}

/// The patch of a hit.
PatchPlace SurfaceLight::PlaceOf(const HitList& hits, std::size_t hit) const
{
  const glm::dmat4& toIndex = this->Key.Transform.IndexFromWorld;
  const glm::dvec3 point(toIndex * glm::dvec4(hits.Rays.PointAt(hit), 1.0));
  const auto& normal = hits.Normal[hit];
  return PlaceOfPatch(point * this->Edges,
    this->NormalFromWorld * glm::vec3(normal[0], normal[1], normal[2]),
    this->WidthAt(hits.Rays.T[hit]), hits.Surface[hit], hits.Kind[hit]);
}

}
