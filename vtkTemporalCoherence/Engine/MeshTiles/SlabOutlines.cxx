// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTiles/SlabOutlines.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// The polygon in which a tetrahedron is cut at a value.
struct Polygon
{
  Polygon(const glm::dvec3* vertices, const std::array<double, 4>& values, double at)
  {
    std::array<std::size_t, 4> above, below;
    std::size_t numberAbove = 0, numberBelow = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      (values[i] >= at ? above[numberAbove++] : below[numberBelow++]) = i;
    }
    const auto cut = [&](std::size_t i, std::size_t j)
    {
      const double share = (values[i] - at) / (values[i] - values[j]);
      this->Corners[this->Count++] = vertices[i] + share * (vertices[j] - vertices[i]);
    };
    if (numberAbove == 2)
    {
      cut(above[0], below[0]);
      cut(above[0], below[1]);
      cut(above[1], below[1]);
      cut(above[1], below[0]);
      return;
    }
    for (std::size_t i = 0; i < numberAbove * numberBelow; ++i)
    {
      cut(above[numberAbove == 1 ? 0 : i], below[numberAbove == 1 ? i : 0]);
    }
  }

  std::size_t Count = 0; ///< 3, 4, or 0 if it is not cut
  std::array<glm::dvec3, 4> Corners;
};

}

bool FindSlab(const glm::dvec3* vertices, const std::array<double, 4>& values, double low,
  double high, glm::dvec3* corners)
{
  Polygon first(vertices, values, low), second(vertices, values, high);
  if (second.Count > first.Count)
  {
    std::swap(first, second);
  }
  glm::dvec3* end = std::copy_n(first.Corners.begin(), first.Count, corners);
  std::size_t between = 0;
  for (const double value : values)
  {
    between += value >= low && value <= high;
  }
  // A triangle closes with its first corner, if there is room.
  if (first.Count == 3 && first.Count + second.Count + between < SlabOutlines::SlabCorners)
  {
    *end++ = first.Corners[0];
  }
  end = std::copy_n(second.Corners.begin(), second.Count, end);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (values[i] >= low && values[i] <= high)
    {
      *end++ = vertices[i];
    }
  }
  if (end == corners)
  {
    return false;
  }
  std::fill(end, corners + SlabOutlines::SlabCorners, *(end - 1));
  return true;
}

}
