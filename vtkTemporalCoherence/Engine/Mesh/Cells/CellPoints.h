// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellPoints_h
#define TemporalCoherence_CellPoints_h

#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Cells/MeshCell.h"

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

/// Three edges are flat if their volume is below this share of the product of their lengths.
constexpr double LeastCornerVolume = 1e-12;

/// Find the place of a point in a cell; in a folded cell that covers the point several times, any
/// of its places. For a point outside, At is the end of Newton's method, clamped to [0, 1]: a
/// nearby place, not always the nearest.
/// \param tolerance by which coordinates may lie outside of the cell
PointInCell FindPoint(const MeshCell& cell, const glm::dvec3& point, double tolerance = 1e-9);

/// Largest error of the interpolated value at a point with known value, as a share of the cell's
/// range of values. A larger error means that the place lies in another fold of the cell.
constexpr double SameValue = 1e-3;

/// Find the place of a point in a cell. In a folded cell, a point may have several places: finds
/// one whose interpolated value equals `value` within SameValue, or else the closest.
/// \param value known value at the point; NaN: unknown
PointInCell FindPointWith(const MeshCell& cell, const glm::dvec3& point, double value);

/// All places of a point in a hexahedron.
struct PlacesInCell
{
  std::size_t Count = 0;
  std::array<glm::dvec3, Crossings::MostInCell> At;
};

PlacesInCell FindAllPlaces(const MeshCell& hexahedron, const glm::dvec3& point);

/// Interpolation weights of the points of a cell. A tetrahedron uses the first four.
std::array<double, 8> WeightsAt(const MeshCell& cell, const glm::dvec3& at);

/// Derivatives of the mesh's coordinates by the cell's coordinates, in columns.
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
