// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MadeCells_h
#define TemporalCoherence_MadeCells_h

#include "Mesh/Mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Where a point lies, and its value.
using PointValue = std::array<double, 4>; // x, y, z, value

/// Linear cells, points and values that the bridge makes of cells that the engine does not know.
struct MadeCells
{
  std::vector<PointValue> Points;
  std::vector<std::uint8_t> Types; ///< empty: all are hexahedra
  std::vector<std::int32_t> Offsets{ 0 }, Connectivity;
  std::vector<std::int64_t> Originals; ///< empty: each cell is its own

  std::int32_t AddPoint(const PointValue& point)
  {
    this->Points.push_back(point);
    return static_cast<std::int32_t>(this->Points.size() - 1);
  }

  template <typename Ids>
  void AddCell(MeshCellType type, const Ids& ids, std::int64_t original)
  {
    this->Types.push_back(static_cast<std::uint8_t>(type));
    this->Connectivity.insert(this->Connectivity.end(), std::begin(ids), std::end(ids));
    this->Offsets.push_back(static_cast<std::int32_t>(this->Connectivity.size()));
    this->Originals.push_back(original);
  }
};

/// The most numbers in a connectivity.
constexpr std::int64_t MostMadeIds = std::numeric_limits<std::int32_t>::max();

/// The cells as a part of a mesh, which owns them.
inline MeshPart PartOf(const std::shared_ptr<const MadeCells>& cells)
{
  MeshPart part;
  part.NumberOfPoints = static_cast<std::int64_t>(cells->Points.size());
  part.NumberOfCells = static_cast<std::int64_t>(cells->Offsets.size()) - 1;
  const double* first = cells->Points.empty() ? nullptr : cells->Points.front().data();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    part.Coordinates[axis] = { first ? first + axis : nullptr, ScalarType::Float64, 4 };
  }
  part.Values = { first ? first + 3 : nullptr, ScalarType::Float64, 4 };
  part.Types = cells->Types.empty() ? nullptr : cells->Types.data();
  part.Offsets = { cells->Offsets.data(), ScalarType::Int32, 1 };
  part.Connectivity = { cells->Connectivity.data(), ScalarType::Int32, 1 };
  part.ConnectivitySize = static_cast<std::int64_t>(cells->Connectivity.size());
  if (!cells->Originals.empty())
  {
    part.Originals = { cells->Originals.data(), ScalarType::Int64, 1 };
  }
  part.Owner = cells;
  return part;
}

}

#endif
