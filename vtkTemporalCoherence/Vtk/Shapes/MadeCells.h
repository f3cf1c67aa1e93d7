// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MadeCells_h
#define TemporalCoherence_MadeCells_h

#include "Mesh/Cells/Mesh.h"
#include "Scene/Progress.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
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

  /// Reserve memory for cells, and for the ids in their connectivity.
  void Reserve(std::int64_t cells, std::int64_t ids)
  {
    this->Types.reserve(static_cast<std::size_t>(cells));
    this->Offsets.reserve(static_cast<std::size_t>(cells) + 1);
    this->Connectivity.reserve(static_cast<std::size_t>(ids));
    this->Originals.reserve(static_cast<std::size_t>(cells));
  }

  std::int64_t NumberOfCells() const { return static_cast<std::int64_t>(this->Offsets.size()) - 1; }

  std::size_t MemoryInBytes() const
  {
    return this->Points.capacity() * sizeof(PointValue) + this->Types.capacity() +
      (this->Offsets.capacity() + this->Connectivity.capacity()) * sizeof(std::int32_t) +
      this->Originals.capacity() * sizeof(std::int64_t);
  }
};

using MadePointValues = std::shared_ptr<const std::vector<PointValue>>;

/// The budget for making cells. Makers ask before they take memory, and from time to time during
/// the work.
class MakingBudget
{
public:
  std::size_t Memory = std::numeric_limits<std::size_t>::max(); ///< bytes
  std::size_t PerCell = 0; ///< bytes that each made cell will take later
  /// Limit of the bytes for curved cells, which can be divided less. Other cells get the rest.
  std::size_t ForDivision = std::numeric_limits<std::size_t>::max();
  ReportProgress Report; ///< called by the calling thread only

  /// \return false if this memory exceeds the budget. The maker must stop then.
  bool Allows(std::size_t bytes, std::int64_t cells)
  {
    this->Needed = std::max(this->Needed, bytes + this->PerCell * static_cast<std::size_t>(cells));
    return !this->IsTooSmall();
  }

  bool IsTooSmall() const { return this->Needed > this->Memory; }

  /// The largest memory that makers have asked for, in bytes.
  std::size_t NeededMemory() const { return this->Needed; }

  /// \param share of the work that is done
  /// \return false if making is stopped
  bool GoesOn(double share) const { return !this->Report || this->Report(share); }

private:
  std::size_t Needed = 0;
};

/// Limit of the ids in a connectivity.
constexpr std::int64_t MostMadeIds = std::numeric_limits<std::int32_t>::max();

/// The cells between points as a part of a mesh, which owns both.
inline MeshPart PartOf(const std::shared_ptr<const MadeCells>& cells, const MadePointValues& points)
{
  MeshPart part;
  part.NumberOfPoints = static_cast<std::int64_t>(points->size());
  part.NumberOfCells = cells->NumberOfCells();
  const double* first = points->empty() ? nullptr : points->front().data();
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
  part.Owner =
    std::make_shared<std::pair<std::shared_ptr<const MadeCells>, MadePointValues>>(cells, points);
  return part;
}

/// A part of a mesh, made of cells that bring their own points.
inline MeshPart PartOf(const std::shared_ptr<const MadeCells>& cells)
{
  return PartOf(cells, MadePointValues(cells, &cells->Points));
}

}

#endif
