// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Mesh_h
#define TemporalCoherence_Mesh_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Numbers in memory that are read in place, not copied or owned: number i lies i * Step numbers
/// behind the first one.
struct MeshArray
{
  const void* First = nullptr;
  ScalarType Type = ScalarType::Float64;
  std::int64_t Step = 1;

  /// Number i as a double.
  double At(std::int64_t i) const
  {
    return DispatchScalarType(this->Type,
      [&](auto type) {
        return static_cast<double>(static_cast<const decltype(type)*>(this->First)[i * this->Step]);
      });
  }

  /// Number i of an array of 32 or 64 bit integers.
  std::int64_t IdAt(std::int64_t i) const
  {
    return this->Type == ScalarType::Int32
      ? static_cast<const std::int32_t*>(this->First)[i * this->Step]
      : static_cast<const std::int64_t*>(this->First)[i * this->Step];
  }
};

/// The types of cells that have volume and linear edges, by VTK's numbers, so that VTK's arrays of
/// types are read in place. Cells of all other types are left out.
enum class MeshCellType : std::uint8_t
{
  Tetrahedron = 10,
  Voxel = 11,
  Hexahedron = 12,
  Wedge = 13,
  Pyramid = 14
};

/// Cells that share points: the arrays of one data set. The order of the points of a cell is VTK's.
///
/// If Dimensions is 0, cell c has the points Connectivity[OffsetOf(c)] up to
/// Connectivity[OffsetOf(c + 1) - 1]. Otherwise the cells are the hexahedra between the points of a
/// curvilinear grid, and there is no connectivity.
struct MeshPart
{
  std::int64_t NumberOfPoints = 0;
  std::int64_t NumberOfCells = 0;
  std::array<MeshArray, 3> Coordinates; ///< by axis
  MeshArray Values;                     ///< one for each point

  const std::uint8_t* Types = nullptr; ///< MeshCellType of each cell; null: all are hexahedra
  std::int64_t TypeStep = 1;           ///< from cell to cell; 0: all cells have the first type
  MeshArray Offsets, Connectivity;     ///< integers of 32 or 64 bits
  std::int64_t PointsOfEach = 0;       ///< number of ids of every cell; 0: Offsets tell it
  std::int64_t ConnectivitySize = 0;   ///< numbers in Connectivity, so that offsets can be checked
  glm::ivec3 Dimensions{ 0 };          ///< points along each axis

  const std::uint8_t* Flags = nullptr; ///< of each cell; null: no cell is hidden
  std::uint8_t HidingFlags = 0;        ///< a cell with any of these bits is hidden

  MeshArray Originals; ///< number of each cell in the data set; null: its own number

  /// Owns the arrays that were made for this part; null if others own all arrays.
  std::shared_ptr<const void> Owner;

  /// VTK's number for the type of a cell of a list.
  std::uint8_t TypeOf(std::int64_t cell) const
  {
    return this->Types ? this->Types[cell * this->TypeStep]
                       : static_cast<std::uint8_t>(MeshCellType::Hexahedron);
  }

  /// Where the points of a cell of a list begin in Connectivity.
  std::int64_t OffsetOf(std::int64_t cell) const
  {
    return this->PointsOfEach != 0 ? cell * this->PointsOfEach : this->Offsets.IdAt(cell);
  }
};

/// An irregular field: cells of any shape with a value at each point. Cells are numbered through
/// all parts, those of the first part first.
struct Mesh
{
  std::vector<MeshPart> Parts;
  // A stamp changes whenever its data may have changed:
  std::uint64_t CellStamp = 0;  ///< cells, and the ids of their points
  std::uint64_t PointStamp = 0; ///< coordinates of points
  std::uint64_t ValueStamp = 0; ///< values at points

  std::int64_t NumberOfCells() const
  {
    std::int64_t count = 0;
    for (const MeshPart& part : this->Parts)
    {
      count += part.NumberOfCells;
    }
    return count;
  }
};

}

#endif
