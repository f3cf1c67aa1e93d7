// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Meshes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <random>
#include <utility>

namespace Meshes
{
namespace
{

using TemporalCoherence::MeshCellType;

/// Corners of a cube: x + 2 y + 4 z.
using Tetrahedron = std::array<int, 4>;
using Wedge = std::array<int, 6>;
using Quad = std::array<int, 4>;

constexpr std::array<Tetrahedron, 6> Six = { { { 0, 1, 3, 7 }, { 0, 5, 1, 7 }, { 0, 3, 2, 7 },
  { 0, 2, 6, 7 }, { 0, 4, 5, 7 }, { 0, 6, 4, 7 } } };
/// Of a cube whose indices have an even sum, and of its neighbours.
constexpr std::array<Tetrahedron, 5> FiveEven = { { { 0, 3, 6, 5 }, { 1, 3, 0, 5 }, { 2, 0, 3, 6 },
  { 4, 0, 5, 6 }, { 7, 3, 5, 6 } } };
constexpr std::array<Tetrahedron, 5> FiveOdd = { { { 1, 2, 4, 7 }, { 0, 1, 2, 4 }, { 3, 1, 7, 2 },
  { 5, 1, 4, 7 }, { 6, 2, 7, 4 } } };
constexpr std::array<Wedge, 2> Wedges = { { { 0, 1, 3, 4, 5, 7 }, { 0, 3, 2, 4, 7, 6 } } };
constexpr std::array<Quad, 6> Faces = { { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 2, 6, 4 },
  { 1, 5, 7, 3 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 } } };
constexpr std::array<int, 8> Hexahedron = { 0, 1, 3, 2, 4, 5, 7, 6 };

glm::dvec3 CornerOf(int corner)
{
  return { corner & 1, corner >> 1 & 1, corner >> 2 };
}

/// Writes the cells of a block.
class Builder
{
public:
  Builder(const Block& block, const Function& value)
    : Shape(block)
    , Value(value)
    , Numbers(block.Seed)
  {
    const glm::ivec3 n = block.Cubes;
    for (int k = 0; k <= n.z; ++k)
    {
      for (int j = 0; j <= n.y; ++j)
      {
        for (int i = 0; i <= n.x; ++i)
        {
          this->AddPoint(this->Place({ i, j, k }));
        }
      }
    }
  }

  void Divide(const glm::ivec3& cube, Cells cells)
  {
    switch (cells)
    {
      case Cells::FiveTetrahedra:
        for (const Tetrahedron& corners : (cube.x + cube.y + cube.z) % 2 == 0 ? FiveEven : FiveOdd)
        {
          this->AddTetrahedron(cube, corners);
        }
        break;
      case Cells::SixTetrahedra:
        for (const Tetrahedron& corners : Six)
        {
          this->AddTetrahedron(cube, corners);
        }
        break;
      case Cells::Hexahedra:
        this->Add(cube, MeshCellType::Hexahedron, Hexahedron);
        break;
      case Cells::Wedges:
        for (const Wedge& corners : Wedges)
        {
          this->Add(cube, MeshCellType::Wedge, corners);
        }
        break;
      case Cells::Pyramids:
        this->AddPyramids(cube);
        break;
      case Cells::Mixed:
        this->DivideMixed(cube);
        break;
    }
  }

  DoubleArrays Result;

private:
  /// Small cubes are in the middle, and no cube is much longer along one axis than along others.
  glm::dvec3 Place(const glm::ivec3& index)
  {
    std::uniform_real_distribution<double> jitter(-this->Shape.Jitter, this->Shape.Jitter);
    glm::dvec3 place = glm::dvec3(index);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double move = jitter(this->Numbers);
      place[axis] += index[axis] > 0 && index[axis] < this->Shape.Cubes[axis] ? move : 0.0;
    }
    const glm::dvec3 from = 2.0 * place / glm::dvec3(this->Shape.Cubes) - 1.0;
    const double far = std::max({ std::abs(from.x), std::abs(from.y), std::abs(from.z) });
    const int most = std::max({ this->Shape.Cubes.x, this->Shape.Cubes.y, this->Shape.Cubes.z, 4 });
    const double power = std::log(this->Shape.Grading) / std::log(0.5 * most);
    return 0.5 + 0.5 * from * (far > 0.0 ? std::pow(far, power) : 0.0);
  }

  std::int64_t AddPoint(const glm::dvec3& point)
  {
    this->Result.Points.insert(this->Result.Points.end(), { point.x, point.y, point.z });
    this->Result.Values.push_back(this->Value(point));
    return static_cast<std::int64_t>(this->Result.Values.size()) - 1;
  }

  std::int64_t PointAt(const glm::ivec3& cube, int corner) const
  {
    const glm::i64vec3 points = glm::i64vec3(this->Shape.Cubes) + std::int64_t(1);
    const glm::i64vec3 place = glm::i64vec3(cube) + glm::i64vec3(CornerOf(corner));
    return place.x + points.x * (place.y + points.y * place.z);
  }

  void End(MeshCellType type)
  {
    this->Result.Types.push_back(static_cast<std::uint8_t>(type));
    this->Result.Offsets.push_back(static_cast<std::int64_t>(this->Result.Connectivity.size()));
  }

  template <std::size_t Count>
  void Add(const glm::ivec3& cube, MeshCellType type, const std::array<int, Count>& corners)
  {
    for (const int corner : corners)
    {
      this->Result.Connectivity.push_back(this->PointAt(cube, corner));
    }
    this->End(type);
  }

  /// The order of the points is made such that the volume is positive.
  void AddTetrahedron(const glm::ivec3& cube, Tetrahedron corners)
  {
    const glm::dvec3 first = CornerOf(corners[0]);
    const glm::dmat3 edges(
      CornerOf(corners[1]) - first, CornerOf(corners[2]) - first, CornerOf(corners[3]) - first);
    if (glm::determinant(edges) < 0.0)
    {
      std::swap(corners[1], corners[2]);
    }
    this->Add(cube, MeshCellType::Tetrahedron, corners);
  }

  void AddPyramids(const glm::ivec3& cube)
  {
    glm::dvec3 centre(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const auto first = static_cast<std::size_t>(3 * this->PointAt(cube, corner));
      const double* const point = this->Result.Points.data() + first;
      centre += 0.125 * glm::dvec3(point[0], point[1], point[2]);
    }
    const std::int64_t apex = this->AddPoint(centre);
    for (const Quad& face : Faces)
    {
      for (const int corner : face)
      {
        this->Result.Connectivity.push_back(this->PointAt(cube, corner));
      }
      this->Result.Connectivity.push_back(apex);
      this->End(MeshCellType::Pyramid);
    }
  }

  void DivideMixed(const glm::ivec3& cube)
  {
    const bool isLow = 2 * cube.z < this->Shape.Cubes.z, isLeft = 2 * cube.x < this->Shape.Cubes.x;
    if (isLow && isLeft)
    {
      const bool isEven = (cube.x + cube.y + cube.z) % 2 == 0;
      this->Divide(cube, isEven ? Cells::Hexahedra : Cells::Pyramids);
    }
    else if (!isLeft)
    {
      this->Divide(cube, isLow ? Cells::Wedges : Cells::SixTetrahedra);
    }
  }

  const Block Shape;
  const Function& Value;
  std::mt19937 Numbers;
};

}

double Waves(const glm::dvec3& point)
{
  constexpr double turn = 6.283185307179586;
  return std::sin(3.0 * turn * point.x) * std::cos(3.0 * turn * point.y) +
    std::sin(3.0 * turn * point.z + 2.0 * point.x);
}

DoubleArrays MakeBlock(Cells cells, const Block& block, const Function& value)
{
  Builder builder(block, value);
  for (int k = 0; k < block.Cubes.z; ++k)
  {
    for (int j = 0; j < block.Cubes.y; ++j)
    {
      for (int i = 0; i < block.Cubes.x; ++i)
      {
        builder.Divide({ i, j, k }, cells);
      }
    }
  }
  return std::move(builder.Result);
}

DoubleArrays MakeCurvilinear(const Block& block, const Function& value)
{
  DoubleArrays arrays = Builder(block, value).Result;
  arrays.Dimensions = block.Cubes + 1;
  return arrays;
}

void Transform(DoubleArrays& arrays, const glm::dmat4& matrix)
{
  for (std::size_t i = 0; i < arrays.Points.size(); i += 3)
  {
    const glm::dvec4 point(arrays.Points[i], arrays.Points[i + 1], arrays.Points[i + 2], 1.0);
    const glm::dvec4 moved = matrix * point;
    for (int axis = 0; axis < 3; ++axis)
    {
      arrays.Points[i + static_cast<std::size_t>(axis)] = moved[axis];
    }
  }
}

FloatArrays Narrowed(const DoubleArrays& arrays)
{
  FloatArrays narrow;
  const auto narrowed = [](const auto& from, auto& to)
  {
    using To = typename std::decay_t<decltype(to)>::value_type;
    to.resize(from.size());
    std::transform(
      from.begin(), from.end(), to.begin(), [](auto number) { return static_cast<To>(number); });
  };
  narrowed(arrays.Points, narrow.Points);
  narrowed(arrays.Values, narrow.Values);
  narrowed(arrays.Offsets, narrow.Offsets);
  narrowed(arrays.Connectivity, narrow.Connectivity);
  narrow.Types = arrays.Types;
  narrow.Flags = arrays.Flags;
  narrow.Dimensions = arrays.Dimensions;
  return narrow;
}

std::uint64_t NewStamp()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

}
