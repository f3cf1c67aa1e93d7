// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LooseRays_h
#define TemporalCoherence_LooseRays_h

#include "Lattice/RaySource.h"
#include "Scene/RayBatch.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Rays that go anywhere through a tile. A full batch has a ray in each of its 64 pixels, at equal
/// places of these.
struct LooseRays
{
  /// The most rays that go anywhere. Tracers trace full batches as beams, which pays if rays lie
  /// like pixels.
  static constexpr std::size_t Most = RayBatch::Capacity - 4;

  std::size_t Count = 0;
  std::uint64_t Empty = 0;             ///< one bit for each ray that is not wanted
  RayPlaces At;                        ///< finite, also of rays that are not there
  RayBatch::Array<std::int32_t> Pixel; ///< that each ray goes through

  /// Set up the rays of a view.
  void SetUp(const RaySource& source, RayBatch& rays, WorldDirections* world) const
  {
    source.SetUpAt(this->At, this->Count, rays, world);
    for (std::size_t i = 0; i < this->Count && this->Empty != 0; ++i)
    {
      const bool isEmpty = (this->Empty >> i & 1u) != 0;
      rays.End[i] = isEmpty ? rays.Begin[i] : rays.End[i];
      rays.WalkEnd[i] = isEmpty ? rays.WalkBegin[i] : rays.WalkEnd[i];
    }
  }
};

}

#endif
