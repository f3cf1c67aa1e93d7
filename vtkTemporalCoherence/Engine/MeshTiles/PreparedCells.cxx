// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTiles/PreparedCells.h"

#include "MeshTiles/CellValues.h"
#include "Scene/LayerBatch.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

/// The box around points in index space.
FloatBox BoxAround(const glm::dvec3* points, std::size_t count)
{
  FloatBox box;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::vec3 point(points[i]);
    box.Low = glm::min(box.Low, point);
    box.High = glm::max(box.High, point);
  }
  return box;
}

/// The corners of the polygon in which a tetrahedron is cut where its values are 0.
/// \pre some values are negative, some are not
void FindPolygon(const glm::dvec3* points, const std::array<double, 4>& values, glm::dvec3* polygon)
{
  std::array<std::size_t, 4> inside, outside;
  std::size_t numberInside = 0, numberOutside = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    (values[i] >= 0.0 ? inside[numberInside++] : outside[numberOutside++]) = i;
  }
  const auto cut = [&](std::size_t i, std::size_t j)
  { return points[i] + values[i] / (values[i] - values[j]) * (points[j] - points[i]); };
  if (numberInside == 2)
  {
    polygon[0] = cut(inside[0], outside[0]);
    polygon[1] = cut(inside[0], outside[1]);
    polygon[2] = cut(inside[1], outside[1]);
    polygon[3] = cut(inside[1], outside[0]);
    return;
  }
  const bool isOneInside = numberInside == 1;
  const std::size_t lone = isOneInside ? inside[0] : outside[0];
  const std::array<std::size_t, 4>& others = isOneInside ? outside : inside;
  for (std::size_t i = 0; i < 3; ++i)
  {
    polygon[i] = cut(lone, others[i]);
  }
  polygon[3] = polygon[2];
}

/// Reads the cells of a leaf.
class CellPreparer
{
public:
  CellPreparer(const MeshTree& tree, std::int64_t leaf, const MeshDifference& difference,
    CellPurpose purpose, PreparedCells& cells)
    : Tree(tree)
    , Middle(tree.LeafBox(leaf).Middle())
    , Difference(difference)
    , Purpose(purpose)
    , Cells(cells)
  {
    cells.Purpose = purpose;
    cells.Numbers.clear();
    cells.Places.clear();
    cells.Tetrahedra.clear();
    cells.Hexahedra.clear();
  }

  /// Keep the tetrahedra of some cells that count, and then the hexahedra.
  void Take(const MeshReader::Together<std::uint8_t>& places,
    const MeshReader::Together<CellNumber>& numbers, const MeshReader::Together<MeshCell>& cells,
    std::size_t count)
  {
    this->Cells.Numbers.reserve(count);
    this->Cells.Places.reserve(count);
    for (const MeshCellShape shape : { MeshCellShape::Tetrahedron, MeshCellShape::Hexahedron })
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        if (cells[i].Shape == shape && this->Take(cells[i], count - i))
        {
          this->Cells.Numbers.push_back(numbers[i]);
          this->Cells.Places.push_back(places[i]);
        }
      }
    }
    this->Outline();
  }

private:
  /// \param left cells at most
  /// \return false if it does not count
  bool Take(const MeshCell& cell, std::size_t left)
  {
    MeshKernels::CellDifferences differences{};
    const bool isCrossed = this->Difference.Of(cell, differences);
    const bool isInside = !isCrossed && differences[0] >= 0.0;
    if (!isCrossed && this->Purpose != CellPurpose::Bands &&
      !(isInside && this->Purpose == CellPurpose::Solids))
    {
      return false;
    }
    if (cell.Shape == MeshCellShape::Tetrahedron)
    {
      if (this->Cells.Tetrahedra.empty())
      {
        this->Cells.Tetrahedra.reserve(left);
      }
      this->Cells.Tetrahedra.emplace_back(cell, differences);
      return true;
    }
    this->Cells.Hexahedra.push_back({ cell, differences, {}, {}, {} });
    if (this->Purpose == CellPurpose::Crossings)
    {
      this->Cells.Hexahedra.back().Functions = MeshKernels::HexahedronFunctions(cell, differences);
    }
    return true;
  }

  void Outline()
  {
    const std::size_t tetrahedra = this->Cells.Tetrahedra.size(), count = this->Cells.Count();
    const bool isBand = this->Purpose == CellPurpose::Bands;
    this->Cells.Slabs.Resize(isBand ? tetrahedra : 0);
    this->Cells.Outlines.Resize(isBand && tetrahedra == count ? 0 : count);
    for (std::size_t i = 0; i < tetrahedra; ++i)
    {
      isBand ? this->OutlineSlab(i, this->Cells.Tetrahedra[i])
             : this->Outline(i, this->Cells.Tetrahedra[i]);
    }
    for (std::size_t i = tetrahedra; i < count; ++i)
    {
      this->Outline(i, this->Cells.Hexahedra[i - tetrahedra]);
    }
  }

  void OutlineSlab(std::size_t at, const MeshKernels::TetrahedronPoints& cell)
  {
    SlabOutlines::Points points;
    for (std::size_t i = 0; i < 4; ++i)
    {
      points[i] = this->Tree.ToIndex(cell.Points[i]) - this->Middle;
    }
    this->Cells.Slabs.Set(at, points, cell.Values);
  }

  void Outline(std::size_t at, const MeshKernels::TetrahedronPoints& cell)
  {
    CellOutlines::Points points;
    for (std::size_t i = 0; i < 4; ++i)
    {
      points[i] = points[i + 4] = this->Tree.ToIndex(cell.Points[i]) - this->Middle;
    }
    const bool isCut = this->Purpose == CellPurpose::Crossings;
    if (isCut)
    {
      FindPolygon(points.data(), cell.Values, &points[4]);
    }
    this->Cells.Outlines.Set(at, points, isCut);
  }

  void Outline(std::size_t at, PreparedHexahedron& cell)
  {
    CellOutlines::Points points;
    std::transform(cell.Cell.Points.begin(), cell.Cell.Points.end(), points.begin(),
      [&](const glm::dvec3& point) { return this->Tree.ToIndex(point); });
    cell.Box = BoxAround(points.data(), points.size());
    if (this->Purpose != CellPurpose::Solids)
    {
      cell.Values = NearlyLinearOf(points, cell.Differences);
    }
    for (glm::dvec3& point : points)
    {
      point -= this->Middle;
    }
    this->Cells.Outlines.Set(at, points, false);
  }

  const MeshTree& Tree;
  glm::dvec3 Middle;
  const MeshDifference& Difference;
  CellPurpose Purpose;
  PreparedCells& Cells;
};

}

void PrepareCells(const MeshTree& tree, std::int64_t leaf, std::uint64_t which,
  const MeshDifference& difference, CellPurpose purpose, PreparedCells& cells)
{
  MeshReader::Together<std::uint8_t> places;
  MeshReader::Together<CellNumber> numbers;
  std::size_t count = 0;
  ForEachRay(which,
    [&](std::size_t bit)
    {
      places[count] = static_cast<std::uint8_t>(bit);
      numbers[count++] =
        tree.CellAt(MeshLattice::SizeOfBlock * leaf + static_cast<std::int64_t>(bit));
    });
  MeshReader::Together<MeshCell> read;
  tree.Reader().ReadAll(numbers, count, read);
  CellPreparer(tree, leaf, difference, purpose, cells).Take(places, numbers, read, count);
}

SolidCell PreparedCells::SolidAt(std::size_t cell) const
{
  if (!this->IsTetrahedron(cell))
  {
    const PreparedHexahedron& hexahedron = this->HexahedronAt(cell);
    return { hexahedron.Cell, hexahedron.Differences };
  }
  const MeshKernels::TetrahedronPoints& points = this->Tetrahedra[cell];
  SolidCell solid;
  solid.Cell.Shape = MeshCellShape::Tetrahedron;
  std::copy(points.Points.begin(), points.Points.end(), solid.Cell.Points.begin());
  std::copy(points.Values.begin(), points.Values.end(), solid.Differences.begin());
  return solid;
}

FloatBox PreparedCells::BoxOf(std::size_t cell, const MeshTree& tree) const
{
  if (!this->IsTetrahedron(cell))
  {
    return this->HexahedronAt(cell).Box;
  }
  std::array<glm::dvec3, 4> points = this->Tetrahedra[cell].Points;
  for (glm::dvec3& point : points)
  {
    point = tree.ToIndex(point);
  }
  return BoxAround(points.data(), points.size());
}

std::size_t PreparedCells::SizeInBytes() const
{
  return sizeof(PreparedCells) + this->Outlines.SizeInBytes() + this->Slabs.SizeInBytes() +
    this->Numbers.capacity() * sizeof(CellNumber) + this->Places.capacity() +
    this->Tetrahedra.capacity() * sizeof(MeshKernels::TetrahedronPoints) +
    this->Hexahedra.capacity() * sizeof(PreparedHexahedron);
}

}
