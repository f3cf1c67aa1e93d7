// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshKeys_h
#define TemporalCoherence_MeshKeys_h

#include "Mesh/Tree/HilbertCurve.h"
#include "Mesh/Tree/MeshCheck.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// Layout of sort keys: the place of a cell's centre along the curve in the upper bits, and the
/// cell's number below. So keys are unique, and their order is unambiguous.
struct KeyLayout
{
  int NumberBits = 0; ///< of a cell
  int AxisBits = 0;   ///< of the place along each axis

  KeyLayout(std::int64_t allCells, std::int64_t sortedCells)
  {
    const auto bitsFor = [](std::int64_t count)
    {
      int bits = 1;
      for (; count >> bits != 0; ++bits)
      {
      }
      return bits;
    };
    this->NumberBits = bitsFor(allCells);
    // Eight times as many places along each axis as if cells were spread evenly, at least 2^10.
    const int wanted = std::max(10, bitsFor(sortedCells) / 3 + 3);
    this->AxisBits = std::min((64 - this->NumberBits) / 3, wanted);
  }

  int PlaceBits() const { return 3 * this->AxisBits; }
  std::uint32_t NumberOf(std::uint64_t key) const
  {
    return static_cast<std::uint32_t>(key & ((std::uint64_t(1) << this->NumberBits) - 1));
  }
};

/// Places along a Hilbert curve through a cube around a box.
class Curve
{
public:
  Curve(const PointBox& box, const KeyLayout& layout)
    : Low(box.Low)
    , Layout(layout)
  {
    const glm::dvec3 size = box.High - box.Low;
    const double longest = std::max({ size.x, size.y, size.z });
    this->Last = static_cast<double>((std::uint64_t(1) << layout.AxisBits) - 1);
    // The quotient may overflow where points are that close; then all lie at the last place.
    this->PerLength = longest > 0.0 ? (this->Last + 1.0) / longest : 0.0;
    this->PerLength = std::min(this->PerLength, std::numeric_limits<double>::max());
  }

  std::uint64_t KeyOf(const glm::dvec3& centre, std::uint32_t number) const
  {
    const glm::dvec3 place = glm::min((centre - this->Low) * this->PerLength, this->Last);
    const std::uint64_t along = HilbertCurve::NumberOf(static_cast<std::uint32_t>(place.x),
      static_cast<std::uint32_t>(place.y), static_cast<std::uint32_t>(place.z),
      this->Layout.AxisBits);
    return along << this->Layout.NumberBits | number;
  }

private:
  glm::dvec3 Low;
  KeyLayout Layout;
  double Last, PerLength;
};

/// The centre of the box around points.
inline glm::dvec3 CentreOf(const std::array<glm::dvec3, 8>& points, int count)
{
  PointBox box;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    box.Widen(points[i]);
  }
  return 0.5 * (box.Low + box.High);
}

}

#endif
