// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshReader_h
#define TemporalCoherence_MeshReader_h

#include "Mesh/Cells/Mesh.h"
#include "Mesh/Cells/MeshCell.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// Smallest and largest of some values. Min > Max if there are none.
struct CellRange
{
  double Min = std::numeric_limits<double>::infinity();
  double Max = -std::numeric_limits<double>::infinity();

  void Widen(double value)
  {
    this->Min = std::min(this->Min, value);
    this->Max = std::max(this->Max, value);
  }

  void Widen(const CellRange& other)
  {
    this->Min = std::min(this->Min, other.Min);
    this->Max = std::max(this->Max, other.Max);
  }
};

/// Reads cells by their numbers through all parts. Dispatches on the arrays' types once for each
/// cell, not for each number. Reads a cell with a NaN value as a hidden cell, without points. (The
/// tree omits other hidden cells, but must not depend on values, which may change.)
class MeshReader
{
public:
  /// \pre the mesh outlives its reader
  explicit MeshReader(const Mesh& mesh)
    : Parts(mesh.Parts.data())
  {
    std::int64_t first = 0;
    for (const MeshPart& part : mesh.Parts)
    {
      this->FirstCells.push_back(first);
      first += part.NumberOfCells;
    }
    this->FirstCells.push_back(first);
  }

  std::int64_t NumberOfCells() const { return this->FirstCells.back(); }

  /// The number of the part that a cell lies in, and the number of the cell in that part.
  void Locate(std::int64_t cell, std::size_t& part, std::int64_t& inPart) const
  {
    part = 0;
    if (this->FirstCells.size() > 2)
    {
      const auto next = std::upper_bound(this->FirstCells.begin(), this->FirstCells.end(), cell);
      part = static_cast<std::size_t>(next - this->FirstCells.begin()) - 1;
    }
    inPart = cell - this->FirstCells[part];
  }

  const MeshPart& PartAt(std::size_t part) const { return this->Parts[part]; }

  /// Read a cell.
  /// \pre the connectivity is valid
  void Read(std::int64_t number, MeshCell& cell) const
  {
    std::size_t at;
    std::int64_t inPart;
    this->Locate(number, at, inPart);
    const MeshPart& part = this->Parts[at];
    Read(part, FindPoints(part, inPart), cell);
  }

  /// Several cells, read together. This is faster: memory brings the next cells during the wait for
  /// one cell.
  static constexpr std::size_t MostTogether = 64;
  template <typename T>
  using Together = std::array<T, MostTogether>;

  /// Read the first `count` of some cells.
  void ReadAll(
    const Together<std::uint32_t>& numbers, std::size_t count, Together<MeshCell>& cells) const
  {
    Found found;
    this->Find(numbers.data(), count, found);
    found.ForEach(count, PrefetchCoordinates);
    found.ForEach(count, PrefetchValues);
    for (std::size_t i = 0; i < count; ++i)
    {
      Read(*found.Parts[i], found.Points[i], cells[i]);
    }
  }

  /// Call take(i, points, their number) for each of some cells.
  template <typename Take>
  void ReadPointsOfAll(const std::uint32_t* numbers, std::size_t count, const Take& take) const
  {
    Found found;
    this->Find(numbers, count, found);
    found.ForEach(count, PrefetchCoordinates);
    std::array<glm::dvec3, 8> points;
    for (std::size_t i = 0; i < count; ++i)
    {
      ReadCoordinates(*found.Parts[i], found.Points[i], points);
      take(i, points, NumberOfPointsIn(found.Points[i].Shape));
    }
  }

  /// Call take(i, value) for each value of each of some cells.
  template <typename Take>
  void ReadValuesOfAll(const std::uint32_t* numbers, std::size_t count, const Take& take) const
  {
    Found found;
    this->Find(numbers, count, found);
    found.ForEach(count, PrefetchValues);
    for (std::size_t i = 0; i < count; ++i)
    {
      ReadValues(*found.Parts[i], found.Points[i], NumberOfPointsIn(found.Points[i].Shape),
        [&](int, double value) { take(i, value); });
    }
  }

  /// Read the coordinates of a cell's points.
  /// \return their number, 0 for a cell without volume and for a hidden one
  int ReadPoints(std::int64_t number, std::array<glm::dvec3, 8>& result) const
  {
    std::size_t at;
    std::int64_t inPart;
    this->Locate(number, at, inPart);
    return ReadPoints(this->Parts[at], inPart, result);
  }
  static int ReadPoints(
    const MeshPart& part, std::int64_t inPart, std::array<glm::dvec3, 8>& result)
  {
    const MeshCellPoints points = FindPoints(part, inPart);
    const int count = NumberOfPointsIn(points.Shape);
    ReadCoordinates(part, points, result);
    return count;
  }

  /// Call `take(i, value)` for each point of a cell.
  template <typename Take>
  void ReadValues(std::int64_t number, const Take& take) const
  {
    std::size_t at;
    std::int64_t inPart;
    this->Locate(number, at, inPart);
    const MeshPart& part = this->Parts[at];
    const MeshCellPoints points = FindPoints(part, inPart);
    ReadValues(part, points, NumberOfPointsIn(points.Shape), take);
  }

  /// The range of the values of a cell. Empty if a value is NaN.
  CellRange ReadRange(std::int64_t number) const
  {
    CellRange range;
    bool areNumbers = true;
    this->ReadValues(number,
      [&](int, double value)
      {
        range.Widen(value);
        areNumbers &= !std::isnan(value);
      });
    return areNumbers ? range : CellRange();
  }

  /// The number of a point of a cell, in its part.
  std::int64_t PointAt(std::int64_t number, std::size_t point) const
  {
    std::size_t at;
    std::int64_t inPart;
    this->Locate(number, at, inPart);
    return FindPoints(this->Parts[at], inPart).Ids[point];
  }

  /// Find the points of a cell, as PointsOf does.
  static MeshCellPoints FindPoints(const MeshPart& part, std::int64_t cell)
  {
    const ScalarType type = part.Connectivity.Type;
    const bool areOffsetsOther = part.PointsOfEach == 0 && part.Offsets.Type != type;
    if (part.Dimensions.x > 0 || areOffsetsOther)
    {
      return PointsOf(part, cell);
    }
    if (IsHidden(part, cell))
    {
      return {};
    }
    return type == ScalarType::Int32 ? FindPoints<std::int32_t>(part, cell)
                                     : FindPoints<std::int64_t>(part, cell);
  }

  /// Read the coordinates of points.
  static void ReadCoordinates(
    const MeshPart& part, const MeshCellPoints& points, std::array<glm::dvec3, 8>& result)
  {
    const int count = NumberOfPointsIn(points.Shape);
    const auto& [x, y, z] = part.Coordinates;
    if (x.Type == ScalarType::Float32 && y.Type == x.Type && z.Type == x.Type)
    {
      ReadCoordinates<float>(part, points, count, result);
    }
    else if (x.Type == ScalarType::Float64 && y.Type == x.Type && z.Type == x.Type)
    {
      ReadCoordinates<double>(part, points, count, result);
    }
    else
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      {
        const std::int64_t id = points.Ids[i];
        result[i] = { x.At(id), y.At(id), z.At(id) };
      }
    }
  }

private:
  static void Read(const MeshPart& part, const MeshCellPoints& points, MeshCell& cell)
  {
    bool areNumbers = true;
    ReadCoordinates(part, points, cell.Points);
    ReadValues(part, points, NumberOfPointsIn(points.Shape),
      [&](int i, double value)
      {
        cell.Values[static_cast<std::size_t>(i)] = value;
        areNumbers &= !std::isnan(value);
      });
    cell.Shape = areNumbers ? points.Shape : MeshCellShape::None;
  }

  /// Parts and points of some cells.
  struct Found
  {
    Together<const MeshPart*> Parts;
    Together<MeshCellPoints> Points;

    template <typename Visit>
    void ForEach(std::size_t count, const Visit& visit) const
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        visit(*this->Parts[i], this->Points[i]);
      }
    }
  };

  void Find(const std::uint32_t* numbers, std::size_t count, Found& found) const
  {
    Together<std::int64_t> inPart;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::size_t part;
      this->Locate(numbers[i], part, inPart[i]);
      found.Parts[i] = &this->Parts[part];
      PrefetchCell(*found.Parts[i], inPart[i]);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      PrefetchConnectivity(*found.Parts[i], inPart[i]);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      found.Points[i] = FindPoints(*found.Parts[i], inPart[i]);
    }
  }

  static void Prefetch(const MeshArray& array, std::int64_t i)
  {
    DispatchScalarType(array.Type,
      [&](auto type)
      { hwy::Prefetch(static_cast<const decltype(type)*>(array.First) + i * array.Step); });
  }

  static void PrefetchCell(const MeshPart& part, std::int64_t inPart)
  {
    if (part.Dimensions.x == 0)
    {
      if (part.PointsOfEach == 0)
      {
        Prefetch(part.Offsets, inPart);
      }
      if (part.Types)
      {
        hwy::Prefetch(part.Types + inPart * part.TypeStep);
      }
    }
  }

  static void PrefetchConnectivity(const MeshPart& part, std::int64_t inPart)
  {
    if (part.Dimensions.x == 0)
    {
      Prefetch(part.Connectivity, part.OffsetOf(inPart));
    }
  }

  static void PrefetchCoordinates(const MeshPart& part, const MeshCellPoints& points)
  {
    Prefetch(part.Coordinates[0], points); // mostly, the others lie beside it
  }

  static void PrefetchValues(const MeshPart& part, const MeshCellPoints& points)
  {
    Prefetch(part.Values, points);
  }

  static void Prefetch(const MeshArray& array, const MeshCellPoints& points)
  {
    const auto count = static_cast<std::size_t>(NumberOfPointsIn(points.Shape));
    DispatchScalarType(array.Type,
      [&](auto type)
      {
        const auto* const first = static_cast<const decltype(type)*>(array.First);
        for (std::size_t i = 0; i < count; ++i)
        {
          hwy::Prefetch(first + points.Ids[i] * array.Step);
        }
      });
  }

  template <typename Id>
  static MeshCellPoints FindPoints(const MeshPart& part, std::int64_t cell)
  {
    const std::int64_t offset = part.PointsOfEach != 0
      ? cell * part.PointsOfEach
      : static_cast<const Id*>(part.Offsets.First)[cell * part.Offsets.Step];
    const std::int64_t step = part.Connectivity.Step;
    const Id* const first = static_cast<const Id*>(part.Connectivity.First) + offset * step;
    return PointsInOrder(
      part, cell, [first, step](std::int64_t i) -> std::int64_t { return first[i * step]; });
  }

  template <typename T>
  static void ReadCoordinates(const MeshPart& part, const MeshCellPoints& points, int count,
    std::array<glm::dvec3, 8>& result)
  {
    const auto& [x, y, z] = part.Coordinates;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
      const std::int64_t id = points.Ids[i];
      result[i] = { static_cast<double>(static_cast<const T*>(x.First)[id * x.Step]),
        static_cast<double>(static_cast<const T*>(y.First)[id * y.Step]),
        static_cast<double>(static_cast<const T*>(z.First)[id * z.Step]) };
    }
  }

  template <typename Take>
  static void ReadValues(
    const MeshPart& part, const MeshCellPoints& points, int count, const Take& take)
  {
    DispatchScalarType(part.Values.Type,
      [&](auto type)
      {
        const auto* const values = static_cast<const decltype(type)*>(part.Values.First);
        for (int i = 0; i < count; ++i)
        {
          const std::int64_t id = points.Ids[static_cast<std::size_t>(i)];
          take(i, static_cast<double>(values[id * part.Values.Step]));
        }
      });
  }

  const MeshPart* Parts;
  std::vector<std::int64_t> FirstCells; ///< of each part, and the number of all cells
};

}

#endif
