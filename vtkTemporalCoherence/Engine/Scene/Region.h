// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Region_h
#define TemporalCoherence_Region_h

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The range along each axis of the boxes that cropping keeps; First > Last if it keeps none.
struct BoxRange
{
  glm::ivec3 First{ 3 }, Last{ -1 };
};

/// The part of the field that clipping planes and cropping keep. Surfaces are only drawn in it.
struct Region
{
  static constexpr std::uint32_t AllBoxes = (1u << 27) - 1u;

  /// Clipping planes in the world, normal and offset: dot(normal, p) + offset >= 0 is kept.
  std::vector<glm::dvec4> Clips;

  /// Lower and upper cropping plane along each axis, in index space. They divide the field into 27
  /// boxes.
  std::array<glm::dvec2, 3> Crops{};
  std::uint32_t Boxes = AllBoxes; ///< bit x + 3 y + 9 z is set if that box is kept

  /// True if the whole field is kept.
  bool IsWhole() const { return this->Clips.empty() && this->Boxes == AllBoxes; }

  BoxRange RangeOfBoxes() const;

  /// True if the kept boxes form one box (or nothing), so that a ray has one piece.
  bool IsConvex() const;
};

bool operator==(const Region& a, const Region& b);

}

#endif
