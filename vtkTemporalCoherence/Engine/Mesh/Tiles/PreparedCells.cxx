// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/PreparedCells.h"

#include "Mesh/Tiles/CellCuts.h"
#include "Mesh/Tiles/CellFolds.h"
#include "Scene/LayerBatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// Fit a linear function of the point to a hexahedron's values. Bend is its largest error, infinite
/// in a flat cell. Along a ray in the cell, values exceed the range between the ray's end values by
/// at most twice Bend.
NearlyLinear NearlyLinearOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // The linear function has the mean slopes of the cell. The difference is trilinear, so its
  // largest and smallest values are at corners.
  glm::dmat3 edges(0.0);
  glm::dvec3 slopes(0.0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sign = (corner >> axis & 1u) != 0 ? 0.25 : -0.25;
      edges[axis] += sign * points[corner];
      slopes[axis] += sign * values[corner];
    }
  }
  NearlyLinear found;
  found.Gradient = glm::transpose(glm::inverse(edges)) * slopes;
  double low = infinity, high = -infinity, largest = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double linear = glm::dot(found.Gradient, points[corner] - points[0]);
    low = std::min(low, values[corner] - linear);
    high = std::max(high, values[corner] - linear);
    largest = std::max({ largest, std::abs(values[corner]), std::abs(linear) });
  }
  const double middle = 0.5 * (low + high), offset = glm::dot(found.Gradient, points[0]);
  constexpr double rounding = 1e-12;
  const double bend = 0.5 * (high - low) + rounding * (largest + std::abs(offset));
  if (bend < infinity)
  {
    found.AtZero = middle - offset;
    found.Bend = bend;
  }
  else
  {
    found = NearlyLinear();
  }
  return found;
}

/// Prepares the cells of a leaf.
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
    cells.Numbers.clear();
    cells.Places.clear();
    cells.Tetrahedra.clear();
    cells.Hexahedra.clear();
  }

  /// Keep the cells that count: first tetrahedra, then hexahedra.
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
  /// \param left upper bound of the cells that are still to come
  /// \return false if the cell does not count
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

  /// The range of differences in a band, widened by rounding errors.
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

  /// \pre all cells were taken
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
      cell.Folds = MeshKernels::MayFold(cell.Cell);
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
  glm::dvec2 Slab; ///< range of differences in the band, slightly widened
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
