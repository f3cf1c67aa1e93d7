// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/StraightCell.h"

namespace TemporalCoherence
{

const ShapeFrame& FrameOf(CurvedShape shape)
{
  static const ShapeFrame tetrahedron{ 4, { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } } };
  static const ShapeFrame hexahedron{ 8,
    { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
      { 4, 5, 6, 7 } },
    { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 }, { 5, 6 }, { 7, 6 }, { 4, 7 }, { 0, 4 },
      { 1, 5 }, { 2, 6 }, { 3, 7 } } };
  static const ShapeFrame wedge{ 6,
    { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } } };
  static const ShapeFrame pyramid{ 5,
    { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } } };
  return shape == CurvedShape::Tetrahedron ? tetrahedron
    : shape == CurvedShape::Wedge          ? wedge
    : shape == CurvedShape::Pyramid        ? pyramid
                                           : hexahedron;
}

CornerWeights WeightsOn(CurvedShape shape, const glm::ivec3& place, int of)
{
  const std::int64_t n = of, i = place.x, j = place.y, k = place.z, m = n - k;
  switch (shape)
  {
    case CurvedShape::Tetrahedron:
      return { 4, { n - i - j - k, i, j, k } };
    case CurvedShape::Wedge:
      return { 6, { (n - i - j) * m, i * m, j * m, (n - i - j) * k, i * k, j * k } };
    case CurvedShape::Pyramid:
      return { 5, { (m - i) * (m - j), i * (m - j), i * j, (m - i) * j, m == 0 ? 1 : k * m } };
    case CurvedShape::Hexahedron:
      break;
  }
  return { 8,
    { (n - i) * (n - j) * m, i * (n - j) * m, i * j * m, (n - i) * j * m, (n - i) * (n - j) * k,
      i * (n - j) * k, i * j * k, (n - i) * j * k } };
}

glm::dvec3 CoordinatesOn(CurvedShape shape, const glm::ivec3& place, int of)
{
  const glm::dvec3 at = glm::dvec3(place) / static_cast<double>(of);
  return shape == CurvedShape::Pyramid ? glm::dvec3(at.x + 0.5 * at.z, at.y + 0.5 * at.z, at.z)
                                       : at;
}

unsigned int SupportOn(CurvedShape shape, const glm::ivec3& place, int of)
{
  // Bits of the corners on either side of each axis.
  const int i = place.x, j = place.y, k = place.z, m = of - k;
  const auto bits = [](int weight, unsigned int corners) { return weight != 0 ? corners : 0u; };
  switch (shape)
  {
    case CurvedShape::Tetrahedron:
      return bits(m - i - j, 0x1u) | bits(i, 0x2u) | bits(j, 0x4u) | bits(k, 0x8u);
    case CurvedShape::Wedge:
      return (bits(of - i - j, 0x09u) | bits(i, 0x12u) | bits(j, 0x24u)) &
        (bits(m, 0x07u) | bits(k, 0x38u));
    case CurvedShape::Pyramid:
      return ((bits(m - i, 0x9u) | bits(i, 0x6u)) & (bits(m - j, 0x3u) | bits(j, 0xcu))) |
        bits(k, 0x10u);
    case CurvedShape::Hexahedron:
      break;
  }
  return (bits(of - i, 0x99u) | bits(i, 0x66u)) & (bits(of - j, 0x33u) | bits(j, 0xccu)) &
    (bits(m, 0x0fu) | bits(k, 0xf0u));
}

std::array<double, 8> LinearWeightsAt(CurvedShape shape, const glm::dvec3& at)
{
  const double k = at.z, m = 1.0 - k;
  double i = at.x, j = at.y;
  switch (shape)
  {
    case CurvedShape::Tetrahedron:
      return { 1.0 - i - j - k, i, j, k };
    case CurvedShape::Wedge:
      return { (1.0 - i - j) * m, i * m, j * m, (1.0 - i - j) * k, i * k, j * k };
    case CurvedShape::Pyramid:
      if (m <= 0.0)
      {
        return { 0.0, 0.0, 0.0, 0.0, 1.0 };
      }
      i -= 0.5 * k;
      j -= 0.5 * k;
      return { (m - i) * (m - j) / m, i * (m - j) / m, i * j / m, (m - i) * j / m, k };
    case CurvedShape::Hexahedron:
      break;
  }
  return { (1.0 - i) * (1.0 - j) * m, i * (1.0 - j) * m, i * j * m, (1.0 - i) * j * m,
    (1.0 - i) * (1.0 - j) * k, i * (1.0 - j) * k, i * j * k, (1.0 - i) * j * k };
}

}
