// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotImage_h
#define TemporalCoherence_KnotImage_h

#include "Isomap/Isomap.h"
#include "Isomap/KnotGrid.h"
#include "Isomap/Knots.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A unit vector by octahedral coordinates, in units of 1 / OctahedralSteps.
using OctahedralNormal = std::array<std::int8_t, 2>;
constexpr int OctahedralSteps = 80;

OctahedralNormal ToOctahedral(const glm::dvec3& normal);
glm::dvec3 FromOctahedral(const OctahedralNormal& packed, int steps = OctahedralSteps);

/// The knots of all pixels in one direction, row by row from the bottom.
struct PixelKnots
{
  std::vector<std::uint32_t> Begin; ///< pixel i has knots Begin[i] to Begin[i + 1] - 1
  std::vector<std::uint16_t> Progress;
  std::vector<std::uint32_t> Distance;
  std::vector<OctahedralNormal> Normals;
  /// Half way from the knot before; at knots that begin a piece, that of the knot.
  std::vector<OctahedralNormal> Middles;

  bool IsEmpty(std::size_t pixel) const { return this->Begin[pixel] == this->Begin[pixel + 1]; }
  FittedRay RayOf(std::size_t pixel) const
  {
    return { this->Distance.data(), this->Progress.data(), this->Begin[pixel],
      this->Begin[pixel + 1] };
  }
};

/// A range of an isomap as an image: what files of views hold (Documentation/ViewFile.md).
struct KnotImage
{
  glm::ivec2 Size{ 0 };
  ValueBand Values{ 1.0, 0.0 };
  KnotGrid Grid; ///< ProgressStep in the units of isovalues
  int NormalSteps = OctahedralSteps;
  std::array<PixelKnots, NumberOfDirections> Knots;
  /// Rising progress where each ray begins; 0 below the range. Empty if all rays begin there.
  std::vector<std::uint16_t> Entries;
  /// 1 for each ray that meets samples that are not finite. Empty if there is none.
  std::vector<std::uint8_t> Unknown;

  /// What a pixel shows of an isovalue.
  struct Hit
  {
    bool IsReached = false;
    bool IsSure = true; ///< false: close to a jump, or steep; a mapper would trace the ray
    ValueDirection Direction = ValueDirection::Rising;
    double Distance = 0.0;    ///< from where the ray begins, in the world
    glm::dvec3 Normal{ 0.0 }; ///< towards higher or lower values
  };
  Hit LookUp(std::size_t pixel, double isovalue) const;

  /// Progress of an isovalue in steps.
  double StepsOf(ValueDirection direction, double isovalue) const;
};

/// The image of the bands that an isomap with a tolerance and normals has for a range.
/// \pre map.Pieces() == 1, and all groups have a band of just these isovalues
/// \throws std::bad_alloc
KnotImage ImageOf(const Isomap& map, const ValueBand& range, const glm::dvec2& finiteRange);

}

#endif
