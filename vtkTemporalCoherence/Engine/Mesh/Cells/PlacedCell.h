// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PlacedCell_h
#define TemporalCoherence_PlacedCell_h

#include "Mesh/Cells/MeshCell.h"
#include "Mesh/Cells/Trilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// A cell, ready for the search of points: coordinates and values as trilinear functions, with
/// lengths divided by a power of two near the cell's size.
struct alignas(64) PlacedCell
{
  /// Longest last step of Newton's method. The remaining error is about its square.
  static constexpr double ShortStep = 1e-6;
  /// A longer step starts at a place without volume.
  static constexpr double LongStep = 1e6;
  /// Places are kept in [-FarAway, FarAway].
  static constexpr double FarAway = 2.0;
  /// Places up to this coordinate count as points of the face.
  static constexpr double Border = 1.0 + 1e-5;
  /// Edges are flat if their volume is below this share of the product of their lengths.
  static constexpr double LeastVolume = 1e-9;
  /// The steepest gradient for cells of length 1, and the largest coefficient.
  static constexpr double Steepest = 1e100;

  static constexpr std::size_t Size = 32;

  std::array<double, Size> Numbers; ///< coefficients of x, y, z and the value
  glm::dvec3 Origin;
  double PerLength;  ///< a power of two
  double FirstValue; ///< subtracted from all values

  void Place(const MeshCell& cell)
  {
    this->Origin = cell.Points[0];
    this->FirstValue = cell.Values[0];
    const auto count = static_cast<std::size_t>(cell.NumberOfPoints());
    double largest = 0.0;
    for (std::size_t i = 1; i < count; ++i)
    {
      const glm::dvec3 edge = glm::abs(cell.Points[i] - this->Origin);
      largest = std::max({ largest, edge.x, edge.y, edge.z });
    }
    this->PerLength =
      largest > 0.0 && largest < Steepest ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
    for (int a = 0; a < 3; ++a)
    {
      this->Take(cell, static_cast<std::size_t>(a),
        [&](std::size_t i) { return this->PerLength * (cell.Points[i][a] - this->Origin[a]); });
    }
    this->Take(cell, 3, [&](std::size_t i) { return cell.Values[i] - cell.Values[0]; });
  }

private:
  /// A tetrahedron is the corner of a parallelepiped.
  template <typename Corner>
  void Take(const MeshCell& cell, std::size_t function, const Corner& corner)
  {
    Trilinear c{};
    if (cell.Shape == MeshCellShape::Tetrahedron)
    {
      const double x = 0.5 * corner(1), y = 0.5 * corner(2), z = 0.5 * corner(3);
      c = { x + y + z, x, y, 0.0, z, 0.0, 0.0, 0.0 };
    }
    else
    {
      for (std::size_t i = 0; i < 8; ++i)
      {
        c[i] = corner(i);
      }
      c = TrilinearOf(c);
    }
    std::copy(
      c.begin(), c.end(), this->Numbers.begin() + static_cast<std::ptrdiff_t>(8 * function));
  }
};

}
}

#endif
