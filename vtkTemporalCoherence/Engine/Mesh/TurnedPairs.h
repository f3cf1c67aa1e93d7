// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TurnedPairs_h
#define TemporalCoherence_TurnedPairs_h

#include "Mesh/KernelsCells.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// The points of a cell, and the differences there.
template <std::size_t Number>
struct CornerPoints
{
  static constexpr std::size_t Corners = Number;
  std::array<glm::dvec3, Number> Points;
  std::array<double, Number> Values;
  double Handedness = 1.0; ///< of a tetrahedron: -1 if its points are seen the other way round
};

/// The coordinates that rays along an axis shear: x, y, and the axis itself.
inline std::array<glm::length_t, 3> TurnedAxes(std::size_t axis)
{
  const auto z = static_cast<glm::length_t>(axis);
  return { (z + 1) % 3, (z + 2) % 3, z };
}

/// The points of many cells, as arrays over cells, each turned to the axis of its ray.
template <std::size_t Number>
struct TurnedPairs
{
  std::array<std::array<TileArray<double>, 3>, Number> Points;
  std::array<TileArray<double>, Number> Values;
  TileArray<double> Handedness;

  void Set(std::size_t at, const CornerPoints<Number>& cell, std::size_t axis)
  {
    const std::array<glm::length_t, 3> axes = TurnedAxes(axis);
    for (std::size_t corner = 0; corner < Number; ++corner)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Points[corner][a][at] = cell.Points[corner][axes[a]];
      }
      this->Values[corner][at] = cell.Values[corner];
    }
    this->Handedness[at] = cell.Handedness;
  }

  /// Repeat the last cell up to the end of the last vector, so that no lane is uninitialised.
  void FillUp(std::size_t count)
  {
    for (std::size_t at = count; at > 0 && at < WholeVectors(count); ++at)
    {
      for (std::size_t corner = 0; corner < Number; ++corner)
      {
        for (auto& coordinates : this->Points[corner])
        {
          coordinates[at] = coordinates[at - 1];
        }
        this->Values[corner][at] = this->Values[corner][at - 1];
      }
      this->Handedness[at] = this->Handedness[at - 1];
    }
  }
};

}
}

#endif
