// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HexahedronFunctions_h
#define TemporalCoherence_HexahedronFunctions_h

#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Cells/Trilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Indices of the nonlinear coefficients of trilinear functions.
constexpr std::array<std::size_t, 4> BentTerms = { 3, 5, 6, 7 };

/// A hexahedron in coordinates w in which its linear part is the cube [-1, 1]^3:
///   w = Inverse (p - middle) = u + Bends(u), with the difference = linear in w +
///   DifferenceBends(u),
/// where bends are the terms BentTerms.
struct StraightCell
{
  std::array<Row, 3> Inverse; ///< [a]: column of coordinate a; 0 in flat cells
  std::array<std::array<double, 4>, 3> Bends;
  std::array<double, 4> DifferenceBends;
  double Reach; ///< largest row sum of Inverse: bounds how far errors move w
  double Lost;  ///< error of Inverse: its product with the linear part, minus the identity
  double Slope; ///< of the difference: sum of the amounts along the axes

  StraightCell() = default;
  StraightCell(const std::array<Trilinear, 3>& coordinates, const Trilinear& difference)
  {
    // Rows of the matrix whose columns are edges.
    const Row edges[3] = { { coordinates[0][1], coordinates[0][2], coordinates[0][4] },
      { coordinates[1][1], coordinates[1][2], coordinates[1][4] },
      { coordinates[2][1], coordinates[2][2], coordinates[2][4] } };
    this->Inverse = { Cross(edges[1], edges[2]), Cross(edges[2], edges[0]),
      Cross(edges[0], edges[1]) };
    const double determinant = Dot(edges[0], this->Inverse[0]);
    const double scale =
      std::abs(determinant) > std::numeric_limits<double>::min() ? 1.0 / determinant : 0.0;
    for (Row& column : this->Inverse)
    {
      column = { column[0] * scale, column[1] * scale, column[2] * scale };
    }
    this->Reach = this->Lost = this->Slope = 0.0;
    this->DifferenceBends = { difference[3], difference[5], difference[6], difference[7] };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Row row = { this->Inverse[0][i], this->Inverse[1][i], this->Inverse[2][i] };
      double lost = 0.0;
      for (std::size_t j = 0; j < 3; ++j)
      {
        const double one = Dot(row, { edges[0][j], edges[1][j], edges[2][j] });
        lost += std::abs(one - (i == j ? 1.0 : 0.0));
      }
      const double reach = (std::abs(row[0]) + std::abs(row[1])) + std::abs(row[2]);
      this->Reach = std::max(this->Reach, reach);
      this->Lost = std::max(this->Lost, lost);
      this->Slope += std::abs(difference[std::size_t(1) << i]);
      for (std::size_t term = 0; term < 4; ++term)
      {
        const std::size_t k = BentTerms[term];
        const double bend = Dot(row, { coordinates[0][k], coordinates[1][k], coordinates[2][k] });
        this->Bends[i][term] = bend;
        this->DifferenceBends[term] -= difference[std::size_t(1) << i] * bend;
      }
    }
  }
};

/// The trilinear functions of a hexahedron: coordinates and difference.
struct HexahedronFunctions
{
  std::array<Trilinear, 3> Coordinates;
  Trilinear Difference;
  StraightCell Straight;
  double Far;               ///< largest amounts of the coordinates, summed over the axes
  double LargestDifference; ///< at corners, by amount
  bool IsPassed;            ///< some corners are inside, some outside

  HexahedronFunctions() = default;
  HexahedronFunctions(const MeshCell& cell, const CellDifferences& differences)
    : Difference(TrilinearOf(differences))
  {
    const auto [low, high] = std::minmax_element(differences.begin(), differences.end());
    this->LargestDifference = std::max(-*low, *high);
    this->IsPassed = *low < 0.0 && *high >= 0.0;
    this->Far = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      // Differences to the first corner, as large coordinates cancel.
      const double first = cell.Points[0][static_cast<glm::length_t>(a)];
      std::array<double, 8> corners;
      double far = 0.0;
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        const double at = cell.Points[corner][static_cast<glm::length_t>(a)];
        corners[corner] = at - first;
        far = std::max(far, std::abs(at));
      }
      this->Coordinates[a] = TrilinearOf(corners);
      this->Coordinates[a][0] += first;
      this->Far += far;
    }
    this->Straight = StraightCell(this->Coordinates, this->Difference);
  }
};

}
}

#endif
