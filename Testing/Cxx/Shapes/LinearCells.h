// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_LinearCells_h
#define Testing_LinearCells_h

#include "Volumes/ReadCell.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

/// Where a point of the unit cube lies in a hexahedron, and its value.
inline glm::dvec4 HexahedronAt(const TemporalCoherence::MeshCell& cell, const glm::dvec3& at)
{
  glm::dvec4 sum(0.0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double weight = (corner & 1u ? at.x : 1.0 - at.x) * (corner & 2u ? at.y : 1.0 - at.y) *
      (corner & 4u ? at.z : 1.0 - at.z);
    sum += weight * glm::dvec4(cell.Points[corner], cell.Values[corner]);
  }
  return sum;
}

/// The volume of a cell, negative if it is inside out: exact, as two points along each axis are
/// enough for the determinant of a trilinear map.
inline double VolumeOf(const TemporalCoherence::MeshCell& cell)
{
  using TemporalCoherence::MeshCellShape;
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    const glm::dvec3& from = cell.Points[0];
    return glm::dot(
             glm::cross(cell.Points[1] - from, cell.Points[2] - from), cell.Points[3] - from) /
      6.0;
  }
  double volume = 0.0;
  for (int node = 0; node < 8; ++node)
  {
    const double off = 0.5 / std::sqrt(3.0);
    const glm::dvec3 at(
      0.5 + (node & 1 ? off : -off), 0.5 + (node & 2 ? off : -off), 0.5 + (node & 4 ? off : -off));
    std::array<glm::dvec3, 3> along;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 low = at, high = at;
      low[axis] = 0.0;
      high[axis] = 1.0;
      along[static_cast<std::size_t>(axis)] =
        glm::dvec3(HexahedronAt(cell, high) - HexahedronAt(cell, low));
    }
    volume += glm::dot(glm::cross(along[0], along[1]), along[2]) / 8.0;
  }
  return volume;
}

/// True if a part has points, and the value at each is that of a function there.
template <typename Function>
bool HasValuesOf(const Function& function, const TemporalCoherence::MeshPart& part, double error)
{
  bool areRight = part.NumberOfPoints > 0;
  for (std::int64_t p = 0; p < part.NumberOfPoints; ++p)
  {
    const glm::dvec3 at(
      part.Coordinates[0].At(p), part.Coordinates[1].At(p), part.Coordinates[2].At(p));
    areRight &= std::abs(part.Values.At(p) - function(at)) < error;
  }
  return areRight;
}

/// The corners of a face in order; repeated ones once.
using FacePoints = std::vector<std::int64_t>;

inline std::vector<FacePoints> FacesOf(const TemporalCoherence::MeshCellPoints& cell)
{
  using Corners = std::vector<std::size_t>;
  static const std::vector<Corners> tetrahedron = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 },
    { 1, 2, 3 } };
  static const std::vector<Corners> hexahedron = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  std::vector<FacePoints> faces;
  for (const Corners& corners :
    cell.Shape == TemporalCoherence::MeshCellShape::Tetrahedron ? tetrahedron : hexahedron)
  {
    FacePoints face;
    for (const std::size_t corner : corners)
    {
      if (std::find(face.begin(), face.end(), cell.Ids[corner]) == face.end())
      {
        face.push_back(cell.Ids[corner]);
      }
    }
    if (face.size() >= 3) // others are lines or points
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/// How many cells of a part have each face, by its sorted points.
inline std::map<FacePoints, int> CountFaces(const TemporalCoherence::MeshPart& part)
{
  std::map<FacePoints, int> counts;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    for (FacePoints face : FacesOf(TemporalCoherence::PointsOf(part, c)))
    {
      std::sort(face.begin(), face.end());
      ++counts[face];
    }
  }
  return counts;
}

#endif
