// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_StraightCell_h
#define TemporalCoherence_StraightCell_h

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The shape of a curved cell with straightened edges.
enum class CurvedShape : std::uint8_t
{
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid
};

/// The corners of faces and edges, in VTK's order of the corners of a linear cell.
struct ShapeFrame
{
  int NumberOfCorners;
  std::vector<std::vector<int>> Faces; ///< corners in order around each face
  std::vector<std::array<int, 2>> Edges;
};

const ShapeFrame& FrameOf(CurvedShape shape);

/// A place in the straight cell, in whole parts of its edges.
struct DivisionPlace
{
  std::uint16_t I, J, K, Of;
};

inline glm::ivec3 NumbersOf(const DivisionPlace& place)
{
  return { place.I, place.J, place.K };
}

/// A place in the straight cell with edges of length 1. Pyramids have their apex over the middle of
/// their base.
glm::dvec3 CoordinatesOn(CurvedShape shape, const glm::ivec3& place, int of);
inline glm::dvec3 CoordinatesOf(CurvedShape shape, const DivisionPlace& place)
{
  return CoordinatesOn(shape, NumbersOf(place), place.Of);
}

/// Weights of the corners of the straight cell: whole numbers, which may have a common divisor.
struct CornerWeights
{
  int Count;
  std::array<std::int64_t, 8> Of;
};

CornerWeights WeightsOn(CurvedShape shape, const glm::ivec3& place, int of);
inline CornerWeights WeightsOf(CurvedShape shape, const DivisionPlace& place)
{
  return WeightsOn(shape, NumbersOf(place), place.Of);
}

/// One bit for each corner, set if its weight is not 0.
unsigned int SupportOn(CurvedShape shape, const glm::ivec3& place, int of);

/// Weights of the corners at any place in the straight cell with edges of length 1. Their sum is 1.
std::array<double, 8> LinearWeightsAt(CurvedShape shape, const glm::dvec3& at);

}

#endif
