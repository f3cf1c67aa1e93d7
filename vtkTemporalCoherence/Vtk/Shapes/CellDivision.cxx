// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CellDivision.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

using Place = glm::ivec3; // on the lattice of a shape

/// Points on the lattice of a shape, and cells between them.
class Lattice
{
public:
  Lattice(CurvedShape shape, int parts)
    : Shape(shape)
    , Parts(parts)
    , Numbers(static_cast<std::size_t>((parts + 1) * (parts + 1) * (parts + 1)), -1)
  {
  }

  void AddCell(MeshCellType type, const std::vector<Place>& places)
  {
    DivisionCell cell{ type, static_cast<int>(places.size()), {} };
    std::transform(places.begin(), places.end(), cell.Points.begin(),
      [this](const Place& place) { return this->NumberOf(place); });
    this->Made.Cells.push_back(cell);
  }

  /// The corners in any order: the cell is turned inside out if it has to be.
  void AddTetrahedron(const Place& a, const Place& b, const Place& c, const Place& d)
  {
    const glm::dvec3 from = this->At(a);
    const bool isLeft =
      glm::dot(glm::cross(this->At(b) - from, this->At(c) - from), this->At(d) - from) > 0.0;
    this->AddCell(MeshCellType::Tetrahedron,
      isLeft ? std::vector<Place>{ a, b, c, d } : std::vector<Place>{ a, c, b, d });
  }

  CellDivision Made;

private:
  int NumberOf(const Place& place)
  {
    const int row = this->Parts + 1;
    int& number =
      this->Numbers[static_cast<std::size_t>(place.x + row * (place.y + row * place.z))];
    if (number < 0)
    {
      number = static_cast<int>(this->Made.Points.size());
      DivisionPoint point;
      point.At = this->At(place);
      this->Name(place, point);
      this->Made.Points.push_back(point);
    }
    return number;
  }

  /// Pyramids have their apex over the middle of their base.
  glm::dvec3 At(const Place& place) const
  {
    const glm::dvec3 at = glm::dvec3(place) / static_cast<double>(this->Parts);
    return this->Shape == CurvedShape::Pyramid
      ? glm::dvec3(at.x + 0.5 * at.z, at.y + 0.5 * at.z, at.z)
      : at;
  }

  /// Weights of the corners of the straight cell.
  std::vector<std::int64_t> WeightsAt(const Place& place) const
  {
    const std::int64_t n = this->Parts, i = place.x, j = place.y, k = place.z, m = n - k;
    switch (this->Shape)
    {
      case CurvedShape::Tetrahedron:
        return { n - i - j - k, i, j, k };
      case CurvedShape::Wedge:
        return { (n - i - j) * m, i * m, j * m, (n - i - j) * k, i * k, j * k };
      case CurvedShape::Pyramid:
        return { (m - i) * (m - j), i * (m - j), i * j, (m - i) * j, m == 0 ? 1 : k * m };
      case CurvedShape::Hexahedron:
        break;
    }
    return { (n - i) * (n - j) * m, i * (n - j) * m, i * j * m, (n - i) * j * m,
      (n - i) * (n - j) * k, i * (n - j) * k, i * j * k, (n - i) * j * k };
  }

  void Name(const Place& place, DivisionPoint& point) const
  {
    const std::vector<std::int64_t> weights = this->WeightsAt(place);
    const std::size_t corners = static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](std::int64_t w) { return w != 0; }));
    if (corners > 4 || (corners == 4 && this->Shape == CurvedShape::Tetrahedron))
    {
      return;
    }
    std::int64_t divisor = 0;
    for (const std::int64_t weight : weights)
    {
      divisor = std::gcd(divisor, weight);
    }
    for (std::size_t c = 0; c < weights.size(); ++c)
    {
      if (weights[c] != 0)
      {
        const auto at = static_cast<std::size_t>(point.NumberOfCorners++);
        point.Corners[at] = static_cast<int>(c);
        point.Weights[at] = weights[c] / divisor;
      }
    }
  }

  CurvedShape Shape;
  int Parts;
  std::vector<int> Numbers;
};

void DivideTetrahedron(int n, Lattice& lattice)
{
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j + k < n; ++j)
    {
      for (int i = 0; i + j + k < n; ++i)
      {
        const Place x(i + 1, j, k), y(i, j + 1, k), z(i, j, k + 1);
        const Place yz(i, j + 1, k + 1), xz(i + 1, j, k + 1), xy(i + 1, j + 1, k);
        lattice.AddTetrahedron(Place(i, j, k), x, y, z);
        if (i + j + k <= n - 2) // an octahedron, around the diagonal from x to yz
        {
          lattice.AddTetrahedron(x, yz, y, z);
          lattice.AddTetrahedron(x, yz, z, xz);
          lattice.AddTetrahedron(x, yz, xz, xy);
          lattice.AddTetrahedron(x, yz, xy, y);
        }
        if (i + j + k <= n - 3)
        {
          lattice.AddTetrahedron(xy, xz, yz, Place(i + 1, j + 1, k + 1));
        }
      }
    }
  }
}

void DivideHexahedron(int n, Lattice& lattice)
{
  for (int c = 0; c < n * n * n; ++c)
  {
    const int i = c % n, j = c / n % n, k = c / n / n;
    lattice.AddCell(MeshCellType::Hexahedron,
      { { i, j, k }, { i + 1, j, k }, { i + 1, j + 1, k }, { i, j + 1, k }, { i, j, k + 1 },
        { i + 1, j, k + 1 }, { i + 1, j + 1, k + 1 }, { i, j + 1, k + 1 } });
  }
}

void DivideWedge(int n, Lattice& lattice)
{
  const auto add = [&](int k, const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c)
  {
    lattice.AddCell(MeshCellType::Wedge,
      { Place(a, k), Place(b, k), Place(c, k), Place(a, k + 1), Place(b, k + 1), Place(c, k + 1) });
  };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i + j < n; ++i)
      {
        add(k, { i, j }, { i + 1, j }, { i, j + 1 });
        if (i + j <= n - 2)
        {
          add(k, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 });
        }
      }
    }
  }
}

void DividePyramid(int n, Lattice& lattice)
{
  const auto add = [&](int i, int j, int base, const Place& apex)
  {
    const Place x(i + 1, j, base), y(i, j + 1, base);
    const bool isUpright = apex.z > base;
    lattice.AddCell(MeshCellType::Pyramid,
      { { i, j, base }, isUpright ? x : y, { i + 1, j + 1, base }, isUpright ? y : x, apex });
  };
  for (int k = 0; k < n; ++k)
  {
    const int m = n - k; // pyramids along an edge of this layer
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        const Place apex(i, j, k + 1);
        add(i, j, k, apex);
        if (i + 1 < m && j + 1 < m)
        {
          add(i, j, k + 1, { i + 1, j + 1, k });
        }
        if (i + 1 < m)
        {
          lattice.AddTetrahedron({ i + 1, j, k }, { i + 1, j + 1, k }, apex, { i + 1, j, k + 1 });
        }
        if (j + 1 < m)
        {
          lattice.AddTetrahedron({ i, j + 1, k }, { i + 1, j + 1, k }, apex, { i, j + 1, k + 1 });
        }
      }
    }
  }
}

}

CellDivision Divide(CurvedShape shape, int parts)
{
  Lattice lattice(shape, parts);
  switch (shape)
  {
    case CurvedShape::Tetrahedron:
      DivideTetrahedron(parts, lattice);
      break;
    case CurvedShape::Hexahedron:
      DivideHexahedron(parts, lattice);
      break;
    case CurvedShape::Wedge:
      DivideWedge(parts, lattice);
      break;
    case CurvedShape::Pyramid:
      DividePyramid(parts, lattice);
      break;
  }
  return std::move(lattice.Made);
}

std::int64_t CountDivisionCells(CurvedShape shape, int parts)
{
  const std::int64_t n = parts;
  // Layers of m^2 upright pyramids, (m - 1)^2 others and 2 m (m - 1) tetrahedra, m from 1 to n.
  return shape == CurvedShape::Pyramid ? n * (4 * n * n - 1) / 3 : n * n * n;
}

}
