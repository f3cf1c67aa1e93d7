// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCellGradients_h
#define TemporalCoherence_KernelsCellGradients_h

#include "Mesh/Cells/KernelsKnownTetrahedra.h"
#include "Mesh/Cells/MeshCell.h"
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Points in cells, and the results there: places and gradients.
///
/// A result depends only on the point and its cell, neither on other points nor on the SIMD target.
struct PointsInCells
{
  static constexpr std::size_t Capacity = 64;
  using Vectors = std::array<TileArray<double>, 3>; ///< by axis

  static constexpr std::uint8_t NoCell = Capacity; ///< of points without a cell

  std::size_t Count = 0;
  TileArray<std::uint8_t> Cell; ///< the number of each point's cell
  Vectors Point;                ///< in the coordinates of the mesh
  /// Known values at the points, or NaN: they tell the places in a folded cell apart.
  TileArray<double> Value;
  bool HasValues = false;
  /// Whether to find At. Gradients of tetrahedra do not need it.
  bool HasPlaces = true;

  Vectors At;       ///< result: as PointInCell::At
  Vectors Gradient; ///< result: as GradientAt

  double ValueAt(std::size_t i) const
  {
    return this->HasValues ? this->Value[i] : std::numeric_limits<double>::quiet_NaN();
  }

  void Set(std::size_t i, std::size_t cell, const glm::dvec3& point)
  {
    this->Cell[i] = static_cast<std::uint8_t>(cell);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Point[a][i] = point[static_cast<int>(a)];
    }
  }
};

/// Find places and gradients of points in their cells, as FindPointWith and GradientAt do, up to
/// rounding errors. Calls these functions where a cell is too flat or folded for vectors. A
/// tetrahedron has one gradient.
/// \param cells at most PointsInCells::Capacity, none of shape None
void FindCellGradients(const MeshCell* cells, std::size_t numberOfCells, PointsInCells& points);

/// Find the gradients of tetrahedra, bit-identical to GradientAt.
/// \pre cells.FillUp() was called
/// \param gradients result, in the order of the cells
void FindTetrahedronGradients(const TetrahedronLanes& cells, PointsInCells::Vectors& gradients);

}
}

#endif
