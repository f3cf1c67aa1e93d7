// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellPoints_h
#define TemporalCoherence_CellPoints_h

#include "Mesh/KernelsCells.h"
#include "Mesh/MeshCell.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Where a point lies in a cell.
struct PointInCell
{
  /// Coordinates of the cell: of a hexahedron in the unit cube, of a tetrahedron the weights of its
  /// points 1, 2 and 3. Finite.
  glm::dvec3 At;
  bool IsIn; ///< it lies in the cell, within the tolerance
};

/// Edges span no volume if it is less than this, by the product of their lengths.
constexpr double LeastCornerVolume = 1e-12;

/// Find a point in a cell. Where a folded cell covers it more than once, one of these is found.
/// Where the point is outside, At is one nearby: the end of a search that does not always find the
/// nearest.
/// \param tolerance by which coordinates may lie outside of the cell
PointInCell FindPoint(const MeshCell& cell, const glm::dvec3& point, double tolerance = 1e-9);

/// How far the value at the place of a point may be from that which the point is known to have, by
/// the range of values in the cell. Otherwise it is the place of another part of a folded cell.
constexpr double SameValue = 1e-3;

/// Find the place of a point in a cell that may be folded, so that the point has several places:
/// the one whose value is closest to the value that the point is known to have.
/// \param value NaN if it is not known
PointInCell FindPointWith(const MeshCell& cell, const glm::dvec3& point, double value);

/// All places of a point in a hexahedron.
struct PlacesInCell
{
  std::size_t Count = 0;
  std::array<glm::dvec3, Crossings::MostInCell> At;
};

PlacesInCell FindAllPlaces(const MeshCell& hexahedron, const glm::dvec3& point);

/// The weights of the points of a cell. A tetrahedron has four.
std::array<double, 8> WeightsAt(const MeshCell& cell, const glm::dvec3& at);

/// How the coordinates of the mesh change with those of a cell, in columns.
glm::dmat3 JacobianAt(const MeshCell& cell, const glm::dvec3& at);

/// The interpolated value.
double ValueAt(const MeshCell& cell, const glm::dvec3& at);

/// The point in the coordinates of the mesh.
glm::dvec3 PointAt(const MeshCell& cell, const glm::dvec3& at);

/// The gradient of the interpolated value with respect to the coordinates of the mesh. In flat
/// parts of cells it is the gradient along them. It is always finite.
glm::dvec3 GradientAt(const MeshCell& cell, const glm::dvec3& at);

}
}

#endif
