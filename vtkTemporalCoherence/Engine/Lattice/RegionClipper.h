// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RegionClipper_h
#define TemporalCoherence_RegionClipper_h

#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Scene/Region.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Clips rays to a region.
class RegionClipper
{
public:
  /// \param transform of the field
  RegionClipper(const Region& region, const IndexTransform& transform);

  bool IsWhole() const { return this->ClipRegion.IsWhole(); }

  /// True if a ray may leave the region and come back.
  bool HasPieces() const { return !this->IsConvex; }

  /// Shorten Begin, End and the walks of rays to the parts between their first and their last point
  /// in the region.
  void Narrow(RayBatch& rays) const;

  /// The parts of a ray in the region, ascending.
  static constexpr std::size_t MostPieces = 4;
  struct Pieces
  {
    std::size_t Count = 0;
    std::array<glm::dvec2, MostPieces> Ends;
  };
  Pieces PiecesOf(const RayBatch& rays, std::size_t ray) const;

  /// The planes that clip the field, in index space: normals of unit length, and offsets.
  const std::vector<glm::dvec4>& Planes() const { return this->AllPlanes; }

private:
  bool Keeps(const glm::dvec3& point) const;

  Region ClipRegion;
  bool IsConvex;
  std::vector<glm::dvec4> Clips; ///< in index space
  std::vector<glm::dvec4> AllPlanes;
};

}

#endif
