// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ClosedSurface_h
#define TemporalCoherence_ClosedSurface_h

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A part of the surface of a cell: a triangle, or a bilinear quadrilateral.
struct SurfacePart
{
  std::array<std::int32_t, 4> Points; ///< in order around it
  std::size_t Size;                   ///< three or four points

  std::int32_t At(std::size_t corner) const { return this->Points[corner % this->Size]; }
};

/// Normals at a corner and of a whole part, with twice the area as length. They point to the side
/// from which the points run counter-clockwise.
glm::dvec3 NormalAt(
  const std::vector<glm::dvec3>& points, const SurfacePart& part, std::size_t corner);
glm::dvec3 NormalOf(const std::vector<glm::dvec3>& points, const SurfacePart& part);

/// Height of a point behind a part. Negative if a cone from the point over the part would be
/// inverted somewhere; infinite if the part has no area.
/// \param way 1: height behind the part; -1: height in front of it
double HeightBehind(const std::vector<glm::dvec3>& points, const SurfacePart& part,
  const glm::dvec3& from, double way = 1.0);

/// True if the mean of the cell's corners lies behind all parts, or in front of all.
/// \param corners number of the cell's corners, which are the first points
/// \param share   smallest height of the mean over each part, in units of the largest height of a
///                corner, divided by `corners`. Convex cells reach a share of 1.
bool IsSeenFromMean(const std::vector<glm::dvec3>& points, std::size_t corners,
  const std::vector<SurfacePart>& surface, double share);

/// Turn parts so that their points are counter-clockwise as seen from outside.
/// \return false if the surface is not closed
bool TurnOutwards(const std::vector<glm::dvec3>& points, std::vector<SurfacePart>& surface);

}

#endif
