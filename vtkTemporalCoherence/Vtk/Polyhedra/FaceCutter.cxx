// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/FaceCutter.h"

#include <vtkPoints.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

using Places = std::vector<glm::dvec3>;

/// The normal of a face, with twice the area as length.
glm::dvec3 NormalOf(const Places& places)
{
  glm::dvec3 normal(0.0);
  for (std::size_t p = 1; p + 1 < places.size(); ++p)
  {
    normal += glm::cross(places[p] - places[0], places[p + 1] - places[0]);
  }
  return normal;
}

/// True if no corner points inwards by more than a slack. A bilinear face would fold there.
bool IsConvex(const Places& places, double slack)
{
  const glm::dvec3 normal = NormalOf(places);
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const glm::dvec3& before = places[(p + places.size() - 1) % places.size()];
    const glm::dvec3& after = places[(p + 1) % places.size()];
    const glm::dvec3 corner = glm::cross(after - places[p], before - places[p]);
    if (glm::dot(corner, normal) < -slack * glm::dot(normal, normal))
    {
      return false;
    }
  }
  return true;
}

/// True if the mean of the points lies on the inner side of each edge, by at least `share` times
/// the largest distance of a point from the edge, divided by the number of points. Convex faces
/// reach a share of 1.
bool SeesItsEdges(const Places& places, double share)
{
  const glm::dvec3 normal = NormalOf(places);
  const double size = static_cast<double>(places.size());
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const glm::dvec3 inwards = glm::cross(normal, places[(p + 1) % places.size()] - places[p]);
    double ofMean = 0.0, largest = 0.0;
    for (const glm::dvec3& place : places)
    {
      const double distance = glm::dot(inwards, place - places[p]);
      ofMean += distance / size;
      largest = std::max(largest, distance);
    }
    if (ofMean < share / size * largest)
    {
      return false;
    }
  }
  return true;
}

/// Places in a face in canonical order: from the point with the lowest number, towards its
/// neighbour with the lower number.
std::vector<std::size_t> CommonOrder(const std::vector<vtkIdType>& face)
{
  const std::size_t size = face.size();
  std::vector<std::size_t> order(size), best;
  const auto isLess = [&](std::size_t a, std::size_t b) { return face[a] < face[b]; };
  for (std::size_t first = 0; first < size; ++first)
  {
    for (const std::size_t step : { std::size_t(1), size - 1 })
    {
      for (std::size_t p = 0; p < size; ++p)
      {
        order[p] = (first + step * p) % size;
      }
      if (best.empty() ||
        std::lexicographical_compare(order.begin(), order.end(), best.begin(), best.end(), isLess))
      {
        best = order;
      }
    }
  }
  return best;
}

}

std::vector<FaceCutter::Triangle> FaceCutter::Cut(
  const std::vector<vtkIdType>& face, const Places& places)
{
  // Rounding depends on the order of the points. So doubtful cases are decided in canonical order,
  // which is equal for all cells.
  const bool isQuadrilateral = face.size() == 4;
  if (face.size() < 4 || (isQuadrilateral ? IsConvex(places, 0.0) : SeesItsEdges(places, 0.5)))
  {
    return {};
  }
  const std::vector<std::size_t> order = CommonOrder(face);
  Places ordered;
  std::transform(order.begin(), order.end(), std::back_inserter(ordered),
    [&](std::size_t place) { return places[place]; });
  constexpr double rounding = 1e-9;
  if (isQuadrilateral ? IsConvex(ordered, rounding) : SeesItsEdges(ordered, 0.25))
  {
    return {};
  }
  std::vector<Triangle> triangles = this->CutEars(ordered);
  for (Triangle& triangle : triangles)
  {
    for (std::size_t& corner : triangle)
    {
      corner = order[corner];
    }
    std::sort(triangle.begin(), triangle.end());
  }
  return triangles;
}

std::vector<FaceCutter::Triangle> FaceCutter::CutEars(const Places& places)
{
  const auto size = static_cast<vtkIdType>(places.size());
  this->Polygon->Points->SetDataTypeToDouble();
  this->Polygon->Points->SetNumberOfPoints(size);
  this->Polygon->PointIds->SetNumberOfIds(size);
  for (vtkIdType p = 0; p < size; ++p)
  {
    this->Polygon->Points->SetPoint(p, &places[static_cast<std::size_t>(p)].x);
    this->Polygon->PointIds->SetId(p, p);
  }
  if (!this->Polygon->EarCutTriangulation(this->Ears) ||
    this->Ears->GetNumberOfIds() != 3 * (size - 2))
  {
    return {};
  }
  // The triangles together have the edges of the face. So they cover the face unless a triangle is
  // inverted.
  const glm::dvec3 normal = NormalOf(places);
  std::vector<Triangle> triangles;
  for (vtkIdType t = 0; t < 3 * (size - 2); t += 3)
  {
    Triangle triangle;
    for (vtkIdType corner = 0; corner < 3; ++corner)
    {
      triangle[static_cast<std::size_t>(corner)] =
        static_cast<std::size_t>(this->Ears->GetId(t + corner));
    }
    std::sort(triangle.begin(), triangle.end());
    const glm::dvec3 ofTriangle =
      NormalOf({ places[triangle[0]], places[triangle[1]], places[triangle[2]] });
    if (!(glm::dot(ofTriangle, normal) > 0.0))
    {
      return {};
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

}
