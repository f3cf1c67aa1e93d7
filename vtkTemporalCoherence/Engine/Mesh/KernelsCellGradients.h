// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCellGradients_h
#define TemporalCoherence_KernelsCellGradients_h

#include "Mesh/KernelsKnownTetrahedra.h"
#include "Mesh/MeshCell.h"
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Points in some cells, and what is to be found there.
///
/// It depends on the point and its cell alone: not on the other points, not on the kind of vectors.
struct PointsInCells
{
  static constexpr std::size_t Capacity = 64;
  using Vectors = std::array<TileArray<double>, 3>; ///< by axis

  static constexpr std::uint8_t NoCell = Capacity; ///< of points that do not count

  std::size_t Count = 0;
  TileArray<std::uint8_t> Cell; ///< the number of each point's cell
  Vectors Point;                ///< in the coordinates of the mesh
  /// Values that the points are known to have, or NaN: in a folded cell, they tell its places
  /// apart.
  TileArray<double> Value;
  bool HasValues = false;
  /// At is wanted. Gradients of tetrahedra do not need it.
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

/// Find where points lie in their cells, and the gradients there: as FindPoint and GradientAt do
/// up to rounding errors, and these are asked where cells are too flat or folded for vectors.
/// Tetrahedra have one gradient each.
/// \param cells at most PointsInCells::Capacity, none of shape None
void FindCellGradients(const MeshCell* cells, std::size_t numberOfCells, PointsInCells& points);

/// Find the gradients of tetrahedra, with the bits of GradientAt.
/// \pre cells are filled up
/// \param gradients result: those of the cells, in their order
void FindTetrahedronGradients(const TetrahedronLanes& cells, PointsInCells::Vectors& gradients);

}
}

#endif
