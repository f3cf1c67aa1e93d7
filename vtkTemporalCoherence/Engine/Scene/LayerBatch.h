// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerBatch_h
#define TemporalCoherence_LayerBatch_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"

#include <hwy/base.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// A transmittance that counts as 0: half a step of a colour.
constexpr float NoLight = 1.0f / 512.0f;

/// Transmittance of a ray behind one more surface of opacity `alpha`.
inline float PassedBehind(float transmittance, float alpha)
{
  const float passed = transmittance * (1.0f - alpha);
  return passed <= NoLight ? 0.0f : passed;
}

/// The next surfaces along the rays of a batch. Each pass finds and composites a few surfaces of
/// each ray, so that memory is bounded.
struct LayerBatch
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  static constexpr std::size_t MostLayers = 16; ///< of one ray in one pass
  static constexpr std::size_t Capacity = MostLayers * RayBatch::Capacity;
  template <typename T>
  using List = std::array<T, Capacity>;

  // The surfaces of this pass, in order of discovery: along each ray from front to back.
  std::size_t Total = 0;
  List<double> Distance;
  List<SurfaceIndex> Surface;
  List<HitKind> Kind;
  List<CellNumber> Cell; ///< of a mesh
  List<std::uint8_t> Ray;

  std::size_t Limit = MostLayers; ///< largest number of surfaces of a ray in this pass
  /// Opacities of the isovalues. Null: only shading knows them.
  const float* Alphas = nullptr;

  Array<std::uint8_t> Count; ///< surfaces of each ray, and their places in the lists:
  std::array<Array<std::uint16_t>, MostLayers> Place;

  /// The last surface of each ray so far, in any pass. The search goes on behind it.
  Array<double> LastDistance;
  Array<SurfaceIndex> LastSurface;
  Array<HitKind> LastKind;

  /// The transmittance of each ray's surfaces. Without Alphas, surfaces of this pass do not count
  /// yet.
  Array<float> Transmittance;
  std::uint64_t Open = 0; ///< one bit for each ray that may meet more surfaces in this pass
  std::int64_t CellsRead = 0;

  /// Begin with rays that have met no surface.
  /// \param alphas AlphasOf the surfaces. If empty, the first pass finds one surface, as it may be
  ///               opaque
  void Begin(std::size_t rays, const std::vector<float>& alphas)
  {
    this->Alphas = alphas.empty() ? nullptr : alphas.data();
    this->Limit = alphas.empty() ? 1 : MostLayers;
    std::fill_n(this->Count.begin(), rays, std::uint8_t(0));
    std::fill_n(this->LastDistance.begin(), rays, -std::numeric_limits<double>::infinity());
    std::fill_n(this->LastSurface.begin(), rays, Frame::NoSurface);
    std::fill_n(this->LastKind.begin(), rays, HitKind::None);
    std::fill_n(this->Transmittance.begin(), rays, 1.0f);
    this->Open = rays == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << rays) - 1;
    this->Total = 0;
    this->CellsRead = 0;
  }

  /// Begin with rays whose first surfaces are known and translucent.
  /// \param open one bit for each ray that goes on behind its last surface
  void BeginBehind(std::size_t rays, const std::vector<float>& alphas, std::uint64_t open,
    const Array<float>& transmittance)
  {
    this->Begin(rays, alphas);
    this->Transmittance = transmittance;
    this->Open = open;
  }

  /// Set the last surface of a ray.
  void SetLast(std::size_t ray, const LayerHit& hit)
  {
    this->LastDistance[ray] = hit.Depth;
    this->LastSurface[ray] = hit.Isovalue;
    this->LastKind[ray] = hit.Kind;
  }

  bool IsOpen(std::size_t ray) const { return this->Open >> ray & 1u; }
  void Close(std::size_t ray) { this->Open &= ~(std::uint64_t(1) << ray); }

  /// Append the next surface of a ray. Close the ray if it is full or opaque now.
  void Append(
    std::size_t ray, double distance, HitKind kind, SurfaceIndex surface, CellNumber cell = NoCell)
  {
    const std::size_t at = this->Total++;
    this->Distance[at] = distance;
    this->Surface[at] = surface;
    this->Kind[at] = kind;
    this->Cell[at] = cell;
    this->Ray[at] = static_cast<std::uint8_t>(ray);
    this->Place[this->Count[ray]++][ray] = static_cast<std::uint16_t>(at);
    this->LastDistance[ray] = distance;
    this->LastSurface[ray] = surface;
    this->LastKind[ray] = kind;
    if (this->Alphas)
    {
      this->Transmittance[ray] =
        PassedBehind(this->Transmittance[ray], this->Alphas[static_cast<std::size_t>(surface)]);
    }
    if (this->IsDone(ray))
    {
      this->Close(ray);
    }
  }

  /// True if a surface lies behind the last one of a ray by more than rounding errors. Closer
  /// surfaces may change their order with the path of a walk.
  bool IsClearlyBehind(std::size_t ray, double distance) const
  {
    constexpr double share = 0x1p-49;
    return distance - this->LastDistance[ray] > share * std::abs(distance);
  }

  /// True if a ray is full or opaque.
  bool IsDone(std::size_t ray) const
  {
    return this->Count[ray] >= this->Limit || this->Transmittance[ray] == 0.0f;
  }

  /// Begin the next pass, with the rays that were full in this pass and are not opaque. The limit
  /// of surfaces doubles.
  /// \param transmittance of each ray, from shading
  /// \return false if no ray goes on
  bool BeginNext(std::size_t rays, const Array<float>& transmittance)
  {
    this->Open = 0;
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      const bool goesOn = this->Count[ray] >= this->Limit && transmittance[ray] > 0.0f;
      this->Open |= static_cast<std::uint64_t>(goesOn) << ray;
      this->Count[ray] = 0;
      this->Transmittance[ray] = transmittance[ray];
    }
    this->Limit = std::min(2 * this->Limit, MostLayers);
    this->Total = 0;
    this->CellsRead = 0;
    return this->Open != 0;
  }
};

/// Call visit(ray) for each ray whose bit is set.
template <typename Visit>
void ForEachRay(std::uint64_t which, const Visit& visit)
{
  for (; which != 0; which &= which - 1)
  {
    visit(hwy::Num0BitsBelowLS1Bit_Nonzero64(which));
  }
}

}

#endif
