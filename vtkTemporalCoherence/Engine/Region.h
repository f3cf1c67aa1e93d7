// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Region_h
#define TemporalCoherence_Region_h

#include "Field.h"
#include "RayBatch.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The part of the field in which surfaces are looked for: what clipping planes and cropping leave.
struct Region
{
  static constexpr std::uint32_t AllBoxes = (1u << 27) - 1u;

  /// Clipping planes in the world, normal and offset: dot(normal, p) + offset >= 0 is kept.
  std::vector<glm::dvec4> Clips;

  /// Cropping planes in index space, the lower and the upper one along each axis, divide the field
  /// into 27 boxes.
  std::array<glm::dvec2, 3> Crops{};
  std::uint32_t Boxes = AllBoxes; ///< one bit for each box that is kept, x + 3 y + 9 z

  /// True if all of the field is kept.
  bool IsWhole() const { return this->Clips.empty() && this->Boxes == AllBoxes; }

  /// True if the boxes that are kept are together a box (or nothing), so that a ray has one piece.
  bool IsConvex() const;
};

bool operator==(const Region& a, const Region& b);

/// Cuts rays to a region.
class RegionCutter
{
public:
  /// \param placement of the field that the region is a part of
  RegionCutter(const Region& region, const Placement& placement);

  bool IsWhole() const { return this->Kept.IsWhole(); }

  /// True if a ray may be in the region, leave it and come back.
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

  /// The planes that cut the field, in index space: normals of unit length, and offsets.
  const std::vector<glm::dvec4>& Planes() const { return this->Cuts; }

private:
  bool Keeps(const glm::dvec3& point) const;

  Region Kept;
  bool IsConvex;
  std::vector<glm::dvec4> Clips; ///< in index space
  std::vector<glm::dvec4> Cuts;
};

}

#endif
