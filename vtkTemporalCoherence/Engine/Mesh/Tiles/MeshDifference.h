// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshDifference_h
#define TemporalCoherence_MeshDifference_h

#include "Mesh/Cells/MeshCell.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{

/// Differences of values in a mesh from one isovalue, with the exact sign.
///
/// They are multiplied by a power of two, so that the largest of finite values is near 1: kernels
/// multiply them by coordinates. Infinities are clamped to the largest difference. (So is NaN,
/// but cells with NaN are hidden.)
class MeshDifference
{
public:
  /// \param finiteRange smallest and largest finite value of the mesh
  MeshDifference(double isovalue, const glm::dvec2& finiteRange)
    : Isovalue(isovalue)
  {
    const double largest =
      std::max({ std::abs(isovalue), std::abs(finiteRange.x), std::abs(finiteRange.y) });
    constexpr int most = 1000;
    this->Factor =
      largest > 0.0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest), -most, most)) : 1.0;
    this->Scaled = isovalue * this->Factor;
  }

  double operator()(double value) const
  {
    // Without branches: the side of the next value cannot be predicted.
    constexpr double least = Least, largest = Largest;
    const double difference = value * this->Factor - this->Scaled;
    const double below = difference > -largest ? std::min(difference, -least) : -largest;
    const double above = std::min(std::max(difference, least), largest);
    return !(value >= this->Isovalue) ? below : value == this->Isovalue ? 0.0 : above;
  }

  /// \return false if the isovalue does not pass the cell
  bool Of(const MeshCell& cell, std::array<double, 8>& differences) const
  {
    bool isAnyInside = false, isAnyOutside = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cell.NumberOfPoints()); ++i)
    {
      differences[i] = (*this)(cell.Values[i]);
      isAnyInside |= differences[i] >= 0.0;
      isAnyOutside |= !(differences[i] >= 0.0);
    }
    return isAnyInside && isAnyOutside;
  }

  /// False for the difference of an infinity.
  static bool IsFinite(double difference) { return std::abs(difference) < Largest; }

  /// Slack for rounding errors of finite differences, and of differences up to this one: far more
  /// than needed.
  static double Slack(double difference) { return 0x1p-40 * (1.0 + difference); }

  /// Units of differences per unit of values.
  double Unit() const { return this->Factor; }
  double Level() const { return this->Isovalue; }

  // Limits of differences that are not 0:
  static constexpr double Least = 0x1p-290;
  static constexpr double Largest = 4.0; ///< more than any difference of finite values

private:
  double Isovalue, Factor, Scaled;
};

}

#endif
