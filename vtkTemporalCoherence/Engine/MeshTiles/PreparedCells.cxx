// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTiles/PreparedCells.h"

#include "MeshTiles/CellValues.h"
#include "Scene/LayerBatch.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// A tetrahedron's part between two planes has no more corners.
constexpr std::size_t MostSlabPoints = 8;

/// The corners of the part of a tetrahedron whose values are within bounds.
/// \pre some values of the tetrahedron are
void FindSlab(const glm::dvec3* points, const std::array<double, 4>& values,
  const glm::dvec2& bounds, glm::dvec3* slab)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (values[i] >= bounds[0] && values[i] <= bounds[1])
    {
      slab[count++] = points[i];
    }
  }
  for (int side = 0; side < 2; ++side)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      for (std::size_t j = 0; j < values.size(); ++j)
      {
        if (values[i] < bounds[side] && values[j] > bounds[side])
        {
          const double share = (bounds[side] - values[i]) / (values[j] - values[i]);
          slab[count++] = points[i] + share * (points[j] - points[i]);
        }
      }
    }
  }
  std::fill(slab + count, slab + MostSlabPoints, slab[0]);
}

/// A hexahedron has no more pairs of corners on different sides of a surface.
constexpr std::size_t MostHullPoints = 16;

/// Points around the surface in a hexahedron: where it cuts the lines between corners on different
/// sides. A point of the cell is a mean of corners, with weights that are products; where the mean
/// of the values is 0, the weights can be split among such pairs so that it is 0 in each.
/// \pre some values are negative, some are not
std::array<glm::dvec3, MostHullPoints> HullOf(
  const std::array<glm::dvec3, 8>& points, const MeshKernels::CellDifferences& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  // Corners on which the surface nearly lies count themselves: in pairs, rounding errors of their
  // values would matter.
  const double least = 1e-6 * largest;
  std::array<glm::dvec3, MostHullPoints> hull;
  std::array<std::size_t, 8> inside, outside;
  std::size_t count = 0, numberInside = 0, numberOutside = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (std::abs(values[i]) <= least)
    {
      hull[count++] = points[i];
    }
    else
    {
      (values[i] > 0.0 ? inside[numberInside++] : outside[numberOutside++]) = i;
    }
  }
  for (std::size_t k = 0; k < numberInside; ++k)
  {
    const std::size_t i = inside[k];
    for (std::size_t l = 0; l < numberOutside; ++l)
    {
      const std::size_t j = outside[l];
      hull[count++] = points[i] + values[i] / (values[i] - values[j]) * (points[j] - points[i]);
    }
  }
  std::fill(hull.begin() + static_cast<std::ptrdiff_t>(count), hull.end(), hull[count - 1]);
  return hull;
}

/// Reads the cells of a leaf.
class CellPreparer
{
public:
  CellPreparer(const MeshTree& tree, std::int64_t leaf, const MeshDifference& difference,
    double width, CellPurpose purpose, PreparedCells& cells)
    : Tree(tree)
    , Middle(tree.LeafBox(leaf).Middle())
    , Difference(difference)
    , Slab(SlabOf(width))
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
    const bool counts = this->Purpose == CellPurpose::Bands
      ? this->IsInSlab(cell, differences)
      : isCrossed || (isInside && this->Purpose == CellPurpose::Solids);
    if (!counts)
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
    if (this->Cells.Hexahedra.empty())
    {
      this->Cells.Hexahedra.reserve(left);
    }
    PreparedHexahedron& hexahedron = this->Cells.Hexahedra.emplace_back();
    hexahedron.Cell = cell;
    hexahedron.Differences = differences;
    if (this->Purpose == CellPurpose::Crossings)
    {
      hexahedron.Functions = MeshKernels::HexahedronFunctions(cell, differences);
    }
    return true;
  }

  /// The differences of a band, and what rounding errors may add.
  static glm::dvec2 SlabOf(double width)
  {
    const double slack = 1e-9 * (1.0 + std::min(width, MeshDifference::Largest));
    return { -slack, width + slack };
  }

  /// True if a cell has values of the band.
  bool IsInSlab(const MeshCell& cell, const MeshKernels::CellDifferences& differences) const
  {
    const auto count = static_cast<std::ptrdiff_t>(cell.NumberOfPoints());
    const auto [least, most] =
      std::minmax_element(differences.begin(), differences.begin() + count);
    return *most >= this->Slab[0] && *least <= this->Slab[1];
  }

  /// \pre cells that count are there
  void Outline()
  {
    const bool areCut = this->Purpose == CellPurpose::Crossings;
    const bool areSlabs = this->Purpose == CellPurpose::Bands;
    const std::size_t tetrahedra = this->Cells.Tetrahedra.size(), count = this->Cells.Count();
    CellOutlines& outlines = this->Cells.Outlines;
    outlines.Polygons.Resize(areCut ? tetrahedra : 0, 8);
    outlines.Slabs.Resize(areSlabs ? tetrahedra : 0, 4 + MostSlabPoints);
    this->FirstHull = outlines.Polygons.Count + outlines.Slabs.Count;
    outlines.Hulls.Resize(count - this->FirstHull, areCut ? MostHullPoints : 8);
    for (std::size_t i = 0; i < tetrahedra; ++i)
    {
      this->Outline(i, this->Cells.Tetrahedra[i]);
    }
    for (std::size_t i = tetrahedra; i < count; ++i)
    {
      this->Outline(i - this->FirstHull, this->Cells.Hexahedra[i - tetrahedra]);
    }
  }

  void Outline(std::size_t at, const MeshKernels::TetrahedronPoints& cell)
  {
    std::array<glm::dvec3, 4 + MostSlabPoints> points;
    for (std::size_t i = 0; i < 4; ++i)
    {
      points[i] = points[i + 4] = this->Tree.ToIndex(cell.Points[i]) - this->Middle;
    }
    CellOutlines& outlines = this->Cells.Outlines;
    switch (this->Purpose)
    {
      case CellPurpose::Crossings:
        FindPolygon(points.data(), cell.Values, &points[4]);
        outlines.Polygons.Set(at, points.data());
        break;
      case CellPurpose::Bands:
        FindSlab(points.data(), cell.Values, this->Slab, &points[4]);
        outlines.Slabs.Set(at, points.data());
        break;
      case CellPurpose::Solids:
        outlines.Hulls.Set(at, points.data());
        break;
    }
  }

  void Outline(std::size_t at, PreparedHexahedron& cell)
  {
    std::array<glm::dvec3, 8> points;
    std::transform(cell.Cell.Points.begin(), cell.Cell.Points.end(), points.begin(),
      [&](const glm::dvec3& point) { return this->Tree.ToIndex(point); });
    cell.Box = BoxAround(points.data(), points.size());
    if (this->Purpose == CellPurpose::Bands)
    {
      cell.Values = NearlyLinearOf(points, cell.Differences);
    }
    for (glm::dvec3& point : points)
    {
      point -= this->Middle;
    }
    if (this->Purpose == CellPurpose::Crossings)
    {
      this->Cells.Outlines.Hulls.Set(at, HullOf(points, cell.Differences).data());
    }
    else
    {
      this->Cells.Outlines.Hulls.Set(at, points.data());
    }
  }

  const MeshTree& Tree;
  glm::dvec3 Middle;
  const MeshDifference& Difference;
  glm::dvec2 Slab; ///< differences within the band, and a little more
  CellPurpose Purpose;
  PreparedCells& Cells;
  std::size_t FirstHull = 0; ///< the first cell with a hull
};

}

void PrepareCells(const MeshTree& tree, std::int64_t leaf, std::uint64_t which,
  const MeshDifference& difference, double width, CellPurpose purpose, PreparedCells& cells)
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
  CellPreparer(tree, leaf, difference, width, purpose, cells).Take(places, numbers, read, count);
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
  return sizeof(PreparedCells) + this->Outlines.SizeInBytes() +
    this->Numbers.capacity() * sizeof(CellNumber) + this->Places.capacity() +
    this->Tetrahedra.capacity() * sizeof(MeshKernels::TetrahedronPoints) +
    this->Hexahedra.capacity() * sizeof(PreparedHexahedron);
}

}
