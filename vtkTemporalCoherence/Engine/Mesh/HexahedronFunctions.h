// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HexahedronFunctions_h
#define TemporalCoherence_HexahedronFunctions_h

#include "Mesh/KernelsCells.h"
#include "Mesh/Trilinear.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// The trilinear functions of a hexahedron: coordinates and difference.
struct HexahedronFunctions
{
  std::array<Trilinear, 3> Coordinates;
  Trilinear Difference;
  double Far;               ///< how far coordinates are from 0 at most, all axes together
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
  }
};

}
}

#endif
