// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_PolyhedronGrid_h
#define Testing_PolyhedronGrid_h

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <vector>

/// Faces of a cell: their points, counter-clockwise as seen from outside.
using CellFaces = std::vector<std::vector<glm::dvec3>>;

/// How often a closed surface winds around a place: 1 inside, 0 outside. Faces are planar.
inline double WindingAround(const CellFaces& faces, const glm::dvec3& place)
{
  double angle = 0.0;
  for (const auto& face : faces)
  {
    for (std::size_t p = 1; p + 1 < face.size(); ++p)
    {
      const glm::dvec3 a = glm::normalize(face[0] - place), b = glm::normalize(face[p] - place),
                       c = glm::normalize(face[p + 1] - place);
      angle += 2.0 *
        std::atan2(
          glm::dot(a, glm::cross(b, c)), 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    }
  }
  return angle / (4.0 * 3.14159265358979323846);
}

/// The volume that a closed surface holds.
inline double VolumeIn(const CellFaces& faces)
{
  const glm::dvec3& from = faces.front().front();
  double volume = 0.0;
  for (const auto& face : faces)
  {
    for (std::size_t p = 1; p + 1 < face.size(); ++p)
    {
      volume += glm::dot(face[0] - from, glm::cross(face[p] - from, face[p + 1] - from)) / 6.0;
    }
  }
  return volume;
}

/// A prism over a polygon, which is counter-clockwise.
inline CellFaces PrismOver(const std::vector<glm::dvec2>& polygon, double low, double high)
{
  CellFaces faces(2);
  for (std::size_t p = 0; p < polygon.size(); ++p)
  {
    const glm::dvec2 &here = polygon[p], &next = polygon[(p + 1) % polygon.size()];
    faces[0].insert(faces[0].begin(), glm::dvec3(here, low));
    faces[1].emplace_back(here, high);
    faces.push_back({ glm::dvec3(here, low), glm::dvec3(next, low), glm::dvec3(next, high),
      glm::dvec3(here, high) });
  }
  return faces;
}

/// Unit cubes as one cell, which has a face for each of their outer faces.
inline CellFaces FacesOfCubes(const std::set<std::array<int, 3>>& cubes)
{
  CellFaces faces;
  for (const auto& cube : cubes)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const int way : { -1, 1 })
      {
        auto beside = cube;
        beside[axis] += way;
        if (cubes.count(beside) != 0)
        {
          continue;
        }
        std::vector<glm::dvec3> face;
        for (const auto& [u, v] : { std::pair(0, 0), { 1, 0 }, { 1, 1 }, { 0, 1 } })
        {
          glm::dvec3 corner(cube[0], cube[1], cube[2]);
          corner[static_cast<int>(axis)] += way > 0 ? 1.0 : 0.0;
          corner[static_cast<int>(axis + 1) % 3] += u;
          corner[static_cast<int>(axis + 2) % 3] += v;
          face.push_back(corner);
        }
        if (way < 0)
        {
          std::reverse(face.begin(), face.end());
        }
        faces.push_back(face);
      }
    }
  }
  return faces;
}

/// A grid of polyhedra, which share the points that lie at the same place.
class PolyhedronGrid
{
public:
  /// \param seed another one gives points other numbers, faces another first point, and, unless
  ///             it is 0, other directions
  PolyhedronGrid(const std::vector<CellFaces>& cells, unsigned int seed)
    : Random(seed)
  {
    this->Points->SetDataTypeToDouble();
    std::vector<glm::dvec3> places;
    for (const CellFaces& cell : cells)
    {
      for (const auto& face : cell)
      {
        places.insert(places.end(), face.begin(), face.end());
      }
    }
    std::shuffle(places.begin(), places.end(), this->Random);
    for (const glm::dvec3& place : places)
    {
      this->PointAt(place);
    }
    for (const CellFaces& cell : cells)
    {
      this->Add(cell, seed != 0);
    }
    this->Made->SetPoints(this->Points);
  }

  vtkIdType PointAt(const glm::dvec3& at)
  {
    const std::array<long, 3> key{ std::lround(at.x * 1e6), std::lround(at.y * 1e6),
      std::lround(at.z * 1e6) };
    const auto found = this->Known.emplace(key, this->Points->GetNumberOfPoints());
    if (found.second)
    {
      this->Points->InsertNextPoint(&at.x);
    }
    return found.first->second;
  }

  template <typename Function>
  void Give(const Function& function)
  {
    vtkNew<vtkDoubleArray> values;
    for (vtkIdType p = 0; p < this->Made->GetNumberOfPoints(); ++p)
    {
      glm::dvec3 at;
      this->Made->GetPoint(p, &at.x);
      values->InsertNextValue(function(at));
    }
    this->Made->GetPointData()->SetScalars(values);
  }

  vtkSmartPointer<vtkUnstructuredGrid> Made = vtkSmartPointer<vtkUnstructuredGrid>::New();

private:
  void Add(const CellFaces& faces, bool isTurned)
  {
    std::vector<vtkIdType> stream;
    std::set<vtkIdType> corners;
    for (const auto& face : faces)
    {
      std::vector<vtkIdType> ids;
      for (const glm::dvec3& place : face)
      {
        ids.push_back(this->PointAt(place));
      }
      const auto first = static_cast<std::ptrdiff_t>(this->Random() % ids.size());
      std::rotate(ids.begin(), ids.begin() + first, ids.end());
      if (isTurned && this->Random() % 2 == 0)
      {
        std::reverse(ids.begin(), ids.end());
      }
      stream.push_back(static_cast<vtkIdType>(ids.size()));
      stream.insert(stream.end(), ids.begin(), ids.end());
      corners.insert(ids.begin(), ids.end());
    }
    const std::vector<vtkIdType> own(corners.begin(), corners.end());
    this->Made->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(own.size()), own.data(),
      static_cast<vtkIdType>(faces.size()), stream.data());
  }

  std::mt19937 Random;
  vtkNew<vtkPoints> Points;
  std::map<std::array<long, 3>, vtkIdType> Known;
};

#endif
