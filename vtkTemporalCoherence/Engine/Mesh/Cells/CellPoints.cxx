// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/CellPoints.h"

#include "Mesh/Cells/HexahedronRoots.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace MeshKernels
{

namespace
{

/// Where a corner has no volume, the gradient is taken this share of the way to the cell's middle.
constexpr double OutOfCorner = 1e-4;

/// Added to the diagonal of normal equations, by their trace.
constexpr double Damping = 1e-12;

/// Trilinear weights of a hexahedron's corners, or their derivatives along an axis.
std::array<double, 8> WeightsOfCorners(const glm::dvec3& at, int along)
{
  std::array<double, 8> weights;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      const bool isHigh = (corner >> a & 1u) != 0;
      weight *= a == along ? (isHigh ? 1.0 : -1.0) : (isHigh ? at[a] : 1.0 - at[a]);
    }
    weights[corner] = weight;
  }
  return weights;
}

constexpr int AlongNone = 3;

/// Derivatives of the point and the value by the coordinates of the cell.
struct Slopes
{
  std::array<glm::dvec3, 3> Point;
  glm::dvec3 Value;
};

Slopes SlopesAt(const MeshCell& cell, const glm::dvec3& at)
{
  Slopes slopes;
  for (int a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<std::size_t>(a);
    if (cell.Shape == MeshCellShape::Tetrahedron)
    {
      slopes.Point[axis] = cell.Points[axis + 1] - cell.Points[0];
      slopes.Value[a] = cell.Values[axis + 1] - cell.Values[0];
      continue;
    }
    // Differences along edges first: large coordinates cancel exactly.
    const std::array<double, 8> weights = WeightsOfCorners(at, a);
    const std::size_t bit = std::size_t(1) << a;
    slopes.Point[axis] = glm::dvec3(0.0);
    slopes.Value[a] = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      if ((corner & bit) == 0)
      {
        const double weight = weights[corner + bit];
        slopes.Point[axis] += weight * (cell.Points[corner + bit] - cell.Points[corner]);
        slopes.Value[a] += weight * (cell.Values[corner + bit] - cell.Values[corner]);
      }
    }
  }
  return slopes;
}

double LargestOf(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// Solve the equations dot(row i, x) = right[i].
/// \return false if rows span no volume
bool Solve(const std::array<glm::dvec3, 3>& rows, const glm::dvec3& right, glm::dvec3& x)
{
  // Lengths are divided out first, as their product may be too large or too small for a number.
  std::array<glm::dvec3, 3> units;
  glm::dvec3 values;
  for (int i = 0; i < 3; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const double largest = LargestOf(rows[at]);
    if (!(largest > 0.0))
    {
      return false;
    }
    units[at] = rows[at] / largest;
    values[i] = right[i] / largest;
  }
  const glm::dvec3 across[3] = { glm::cross(units[1], units[2]), glm::cross(units[2], units[0]),
    glm::cross(units[0], units[1]) };
  const double volume = glm::dot(units[0], across[0]);
  if (!(std::abs(volume) > LeastCornerVolume))
  {
    return false;
  }
  x = (values.x * across[0] + values.y * across[1] + values.z * across[2]) / volume;
  return true;
}

/// The least-squares gradient; the shortest if several fit equally.
glm::dvec3 FlatGradient(const Slopes& slopes)
{
  double largest = 0.0;
  for (const glm::dvec3& row : slopes.Point)
  {
    largest = std::max(largest, LargestOf(row));
  }
  if (!(largest > 0.0))
  {
    return glm::dvec3(0.0);
  }
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 row = slopes.Point[static_cast<std::size_t>(i)] / largest;
    normal += glm::outerProduct(row, row);
    right += row * (slopes.Value[i] / largest);
  }
  const double damping = Damping * (normal[0][0] + normal[1][1] + normal[2][2]);
  for (int i = 0; i < 3; ++i)
  {
    normal[i][i] += damping;
  }
  const glm::dvec3 gradient = glm::inverse(normal) * right;
  return std::isfinite(gradient.x + gradient.y + gradient.z) ? gradient : glm::dvec3(0.0);
}

bool IsInUnit(const MeshCell& cell, const glm::dvec3& at, double tolerance)
{
  const double sum =
    cell.Shape == MeshCellShape::Tetrahedron ? at.x + at.y + at.z : LargestOf(at - 0.5) + 0.5;
  return std::min({ at.x, at.y, at.z }) >= -tolerance && sum <= 1.0 + tolerance;
}

/// Newton's method.
/// \return true if it ends in the cell
bool Approach(const MeshCell& cell, const glm::dvec3& point, double tolerance, glm::dvec3& at)
{
  constexpr int mostSteps = 12;
  constexpr double shortStep = 1e-14, farAway = 4.0;
  bool isNear = false;
  for (int step = 0; step < mostSteps; ++step)
  {
    const Slopes slopes = SlopesAt(cell, at);
    const auto& p = slopes.Point;
    std::array<glm::dvec3, 3> rows;
    for (int a = 0; a < 3; ++a)
    {
      rows[static_cast<std::size_t>(a)] = { p[0][a], p[1][a], p[2][a] };
    }
    glm::dvec3 move;
    if (!Solve(rows, PointAt(cell, at) - point, move))
    {
      return false;
    }
    at -= move;
    const double length = LargestOf(move);
    isNear = length <= tolerance;
    if (length <= shortStep || !(LargestOf(at) < farAway))
    {
      break;
    }
  }
  return isNear && IsInUnit(cell, at, tolerance);
}

}

PointInCell FindPoint(const MeshCell& cell, const glm::dvec3& point, double tolerance)
{
  const bool isTetrahedron = cell.Shape == MeshCellShape::Tetrahedron;
  PointInCell found{ glm::dvec3(isTetrahedron ? 0.25 : 0.5), false };
  found.IsIn = Approach(cell, point, tolerance, found.At);
  if (found.IsIn)
  {
    return found;
  }
  if (!isTetrahedron)
  {
    const PlacesInCell places = FindAllPlaces(cell, point);
    if (places.Count > 0)
    {
      found.At = places.At[0];
      found.IsIn = true;
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    found.At[a] = std::isfinite(found.At[a]) ? std::clamp(found.At[a], 0.0, 1.0) : 0.5;
  }
  return found;
}

PlacesInCell FindAllPlaces(const MeshCell& hexahedron, const glm::dvec3& point)
{
  SeenHexahedron seen;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 from = hexahedron.Points[corner] - point;
    seen.X[corner] = from.x;
    seen.Y[corner] = from.y;
    seen.Difference[corner] = from.z;
    seen.T[corner] = 0.0;
  }
  HexahedronRoots roots;
  FindRoots(seen, roots);
  PlacesInCell places;
  for (; places.Count < roots.Count; ++places.Count)
  {
    const std::array<double, 3>& at = roots.Roots[places.Count].At;
    places.At[places.Count] = 0.5 + 0.5 * glm::dvec3(at[0], at[1], at[2]);
  }
  return places;
}

PointInCell FindPointWith(const MeshCell& cell, const glm::dvec3& point, double value)
{
  PointInCell found = FindPoint(cell, point);
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    return found;
  }
  const auto [least, most] = std::minmax_element(cell.Values.begin(), cell.Values.end());
  const auto wrong = [&](const glm::dvec3& at) { return std::abs(ValueAt(cell, at) - value); };
  double best = wrong(found.At);
  if (best > SameValue * (*most - *least))
  {
    const PlacesInCell places = FindAllPlaces(cell, point);
    for (std::size_t i = 0; i < places.Count; ++i)
    {
      if (wrong(places.At[i]) < best)
      {
        best = wrong(places.At[i]);
        found = { places.At[i], true };
      }
    }
  }
  return found;
}

std::array<double, 8> WeightsAt(const MeshCell& cell, const glm::dvec3& at)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    return { 1.0 - at.x - at.y - at.z, at.x, at.y, at.z, 0.0, 0.0, 0.0, 0.0 };
  }
  return WeightsOfCorners(at, AlongNone);
}

glm::dmat3 JacobianAt(const MeshCell& cell, const glm::dvec3& at)
{
  const Slopes slopes = SlopesAt(cell, at);
  return { slopes.Point[0], slopes.Point[1], slopes.Point[2] };
}

double ValueAt(const MeshCell& cell, const glm::dvec3& at)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    const auto& v = cell.Values;
    return (1.0 - at.x - at.y - at.z) * v[0] + at.x * v[1] + at.y * v[2] + at.z * v[3];
  }
  const std::array<double, 8> weights = WeightsOfCorners(at, AlongNone);
  double value = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    value += weights[corner] * cell.Values[corner];
  }
  return value;
}

glm::dvec3 PointAt(const MeshCell& cell, const glm::dvec3& at)
{
  const auto& p = cell.Points;
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    return p[0] + at.x * (p[1] - p[0]) + at.y * (p[2] - p[0]) + at.z * (p[3] - p[0]);
  }
  const std::array<double, 8> weights = WeightsOfCorners(at, AlongNone);
  glm::dvec3 offset(0.0);
  for (std::size_t corner = 1; corner < 8; ++corner)
  {
    offset += weights[corner] * (p[corner] - p[0]);
  }
  return p[0] + offset;
}

glm::dvec3 GradientAt(const MeshCell& cell, const glm::dvec3& at)
{
  glm::dvec3 gradient;
  const Slopes slopes = SlopesAt(cell, at);
  if (Solve(slopes.Point, slopes.Value, gradient))
  {
    return gradient;
  }
  if (cell.Shape == MeshCellShape::Hexahedron)
  {
    // Where points coincide, take the gradient next to them.
    const Slopes inside = SlopesAt(cell, at + OutOfCorner * (glm::dvec3(0.5) - at));
    if (Solve(inside.Point, inside.Value, gradient))
    {
      return gradient;
    }
  }
  return FlatGradient(slopes);
}

}
}
