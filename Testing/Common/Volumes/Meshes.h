// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Meshes_h
#define Testing_Meshes_h

#include "Mesh/Cells/Mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

/// Irregular fields for tests, without VTK.
namespace Meshes
{

/// How the cubes of a block are divided into cells. Cells share whole faces.
enum class Cells
{
  FiveTetrahedra,
  SixTetrahedra,
  Hexahedra,
  Wedges,   ///< two in a cube
  Pyramids, ///< six in a cube, which meet in its centre
  /// Hexahedra and cubes of pyramids in one quarter, wedges beside them, tetrahedra on the wedges;
  /// nothing in the last quarter.
  Mixed
};

/// A block of cubes in the unit cube.
struct Block
{
  glm::ivec3 Cubes{ 8 };
  double Jitter = 0.2;  ///< how far inner points move along each axis, in cubes; 0.2 folds nothing
  double Grading = 1.0; ///< cubes at the faces of the block are so many times as long as inner ones
  unsigned int Seed = 1;
};

using Function = std::function<double(const glm::dvec3&)>;

/// Three waves along each axis.
double Waves(const glm::dvec3& point);

/// The arrays of a part, which tests may change.
template <typename Real, typename Id>
struct Arrays
{
  std::vector<Real> Points; ///< x, y, z of the first point, and so on
  std::vector<Real> Values;
  std::vector<Id> Offsets{ 0 }, Connectivity;
  std::vector<std::uint8_t> Types, Flags;
  glm::ivec3 Dimensions{ 0 };

  std::int64_t NumberOfCells() const;

  /// The arrays as a part. A cell whose flags are not 0 is hidden.
  TemporalCoherence::MeshPart Part() const;
};

using DoubleArrays = Arrays<double, std::int64_t>;
using FloatArrays = Arrays<float, std::int32_t>;

/// The same in other types.
FloatArrays Narrowed(const DoubleArrays& arrays);

/// A block of cells.
DoubleArrays MakeBlock(Cells cells, const Block& block, const Function& value = Waves);

/// The same points and values as a curvilinear grid.
DoubleArrays MakeCurvilinear(const Block& block, const Function& value = Waves);

/// Move, scale and turn all points.
void Transform(DoubleArrays& arrays, const glm::dmat4& matrix);

/// A mesh of parts, which it keeps. All its stamps are new.
template <typename... Each>
std::shared_ptr<const TemporalCoherence::Mesh> MeshOf(Each... parts);

std::uint64_t NewStamp();

template <typename Real, typename Id>
std::int64_t Arrays<Real, Id>::NumberOfCells() const
{
  if (this->Dimensions.x > 0)
  {
    const glm::i64vec3 cells = glm::i64vec3(this->Dimensions) - std::int64_t(1);
    return cells.x * cells.y * cells.z;
  }
  return static_cast<std::int64_t>(this->Offsets.size()) - 1;
}

template <typename Real, typename Id>
TemporalCoherence::MeshPart Arrays<Real, Id>::Part() const
{
  using TemporalCoherence::ScalarType;
  const ScalarType real = sizeof(Real) == 4 ? ScalarType::Float32 : ScalarType::Float64;
  const ScalarType id = sizeof(Id) == 4 ? ScalarType::Int32 : ScalarType::Int64;
  TemporalCoherence::MeshPart part;
  part.NumberOfPoints = static_cast<std::int64_t>(this->Points.size() / 3);
  part.NumberOfCells = this->NumberOfCells();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    part.Coordinates[axis] = { this->Points.data() + axis, real, 3 };
  }
  part.Values = { this->Values.data(), real, 1 };
  part.Types = this->Types.empty() ? nullptr : this->Types.data();
  part.Offsets = { this->Offsets.data(), id, 1 };
  part.Connectivity = { this->Connectivity.data(), id, 1 };
  part.ConnectivitySize = static_cast<std::int64_t>(this->Connectivity.size());
  part.Dimensions = this->Dimensions;
  part.Flags = this->Flags.empty() ? nullptr : this->Flags.data();
  part.HidingFlags = 0xff;
  return part;
}

template <typename... Each>
std::shared_ptr<const TemporalCoherence::Mesh> MeshOf(Each... parts)
{
  const auto mesh = std::make_shared<TemporalCoherence::Mesh>();
  const auto add = [&](auto arrays)
  {
    const auto owner = std::make_shared<const decltype(arrays)>(std::move(arrays));
    mesh->Parts.push_back(owner->Part());
    mesh->Parts.back().Owner = owner;
  };
  (add(std::move(parts)), ...);
  mesh->CellStamp = NewStamp();
  mesh->PointStamp = NewStamp();
  mesh->ValueStamp = NewStamp();
  return mesh;
}

}

#endif
