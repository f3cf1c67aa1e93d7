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

/// Twice the area along the normal at a corner, or of the whole part. From where its points are
/// counter-clockwise, the normal points at who looks.
glm::dvec3 NormalAt(
  const std::vector<glm::dvec3>& points, const SurfacePart& part, std::size_t corner);
glm::dvec3 NormalOf(const std::vector<glm::dvec3>& points, const SurfacePart& part);

/// How far a point lies behind a part. Negative if it does not lie there for each place in the
/// part, so that a cone from the point over the part would be turned over somewhere; infinite if
/// the part has no area.
/// \param way -1: how far it lies before the part
double HeightBehind(const std::vector<glm::dvec3>& points, const SurfacePart& part,
  const glm::dvec3& from, double way = 1.0);

/// True if the mean of the first points, which are the corners of the cell, lies behind all parts
/// or before all of them. \param share of the largest height of a corner, divided by the number of
/// corners, which the mean
///              has to have. In a convex cell it has at least a share of 1.
bool IsSeenFromMean(const std::vector<glm::dvec3>& points, std::size_t corners,
  const std::vector<SurfacePart>& surface, double share);

/// Turn parts so that their points are counter-clockwise as seen from outside.
/// \return false if they do not close
bool TurnOutwards(const std::vector<glm::dvec3>& points, std::vector<SurfacePart>& surface);

}

#endif
