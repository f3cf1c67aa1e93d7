// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedCells.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Tables of VTK's Lagrange and Bezier cells end here.
constexpr int HighestOrder = 10;

struct CurvedType
{
  int Type;
  CurvedShape Shape;
  int NumberOfPoints; ///< 0: depends on the order
  int Order;
  const char* Name;
};

/// Cells with a point inside of a triangle hold terms of the third order. The functions of a
/// quadratic pyramid are not polynomials in its straight shape.
const std::array<CurvedType, 15> CurvedTypes = { {
  { VTK_QUADRATIC_TETRA, CurvedShape::Tetrahedron, 10, 2, "VTK_QUADRATIC_TETRA" },
  { VTK_QUADRATIC_HEXAHEDRON, CurvedShape::Hexahedron, 20, 2, "VTK_QUADRATIC_HEXAHEDRON" },
  { VTK_QUADRATIC_WEDGE, CurvedShape::Wedge, 15, 2, "VTK_QUADRATIC_WEDGE" },
  { VTK_QUADRATIC_PYRAMID, CurvedShape::Pyramid, 13, 3, "VTK_QUADRATIC_PYRAMID" },
  { VTK_TRIQUADRATIC_HEXAHEDRON, CurvedShape::Hexahedron, 27, 2, "VTK_TRIQUADRATIC_HEXAHEDRON" },
  { VTK_TRIQUADRATIC_PYRAMID, CurvedShape::Pyramid, 19, 3, "VTK_TRIQUADRATIC_PYRAMID" },
  { VTK_QUADRATIC_LINEAR_WEDGE, CurvedShape::Wedge, 12, 2, "VTK_QUADRATIC_LINEAR_WEDGE" },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, CurvedShape::Wedge, 18, 2, "VTK_BIQUADRATIC_QUADRATIC_WEDGE" },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, CurvedShape::Hexahedron, 24, 2,
    "VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON" },
  { VTK_LAGRANGE_TETRAHEDRON, CurvedShape::Tetrahedron, 0, 0, "VTK_LAGRANGE_TETRAHEDRON" },
  { VTK_LAGRANGE_HEXAHEDRON, CurvedShape::Hexahedron, 0, 0, "VTK_LAGRANGE_HEXAHEDRON" },
  { VTK_LAGRANGE_WEDGE, CurvedShape::Wedge, 0, 0, "VTK_LAGRANGE_WEDGE" },
  { VTK_BEZIER_TETRAHEDRON, CurvedShape::Tetrahedron, 0, 0, "VTK_BEZIER_TETRAHEDRON" },
  { VTK_BEZIER_HEXAHEDRON, CurvedShape::Hexahedron, 0, 0, "VTK_BEZIER_HEXAHEDRON" },
  { VTK_BEZIER_WEDGE, CurvedShape::Wedge, 0, 0, "VTK_BEZIER_WEDGE" },
} };

const CurvedType* Find(int type)
{
  const auto found = std::find_if(CurvedTypes.begin(), CurvedTypes.end(),
    [&](const CurvedType& candidate) { return candidate.Type == type; });
  return found == CurvedTypes.end() ? nullptr : &*found;
}

bool IsBezier(int type)
{
  return type == VTK_BEZIER_TETRAHEDRON || type == VTK_BEZIER_HEXAHEDRON ||
    type == VTK_BEZIER_WEDGE;
}

int CountPoints(CurvedShape shape, const std::array<int, 3>& degrees)
{
  const auto [a, b, c] = degrees;
  switch (shape)
  {
    case CurvedShape::Tetrahedron:
      return (a + 1) * (a + 2) * (a + 3) / 6;
    case CurvedShape::Wedge:
      return (a + 1) * (a + 2) / 2 * (c + 1);
    case CurvedShape::Hexahedron:
    case CurvedShape::Pyramid:
      break;
  }
  return (a + 1) * (b + 1) * (c + 1);
}

/// The order of a cell with this number of points; 0 if no order has that number.
int FindOrder(CurvedShape shape, int points, std::array<int, 3> degrees)
{
  // VTK's cells of order 2 with points in the middle of each face and of the cell.
  if ((shape == CurvedShape::Tetrahedron && points == 15) ||
    (shape == CurvedShape::Wedge && points == 21))
  {
    return 3;
  }
  if (degrees[0] > 0)
  {
    const int most = *std::max_element(degrees.begin(), degrees.end());
    const int least = *std::min_element(degrees.begin(), degrees.end());
    return least >= 1 && most <= HighestOrder && CountPoints(shape, degrees) == points ? most : 0;
  }
  for (int order = 1; order <= HighestOrder; ++order)
  {
    if (CountPoints(shape, { order, order, order }) == points)
    {
      return order;
    }
  }
  return 0;
}

}

bool IsCurved(int type)
{
  return Find(type) != nullptr;
}

CurvedCellFinder::CurvedCellFinder(const GivenCells& given)
  : Given(given)
  , Grid(given.Grid)
{
}

std::array<int, 3> CurvedCellFinder::DegreesOf(vtkIdType cell) const
{
  vtkDataArray* degrees = this->Grid->GetCellData()->GetHigherOrderDegrees();
  if (!degrees || degrees->GetNumberOfComponents() != 3 || degrees->GetNumberOfTuples() <= cell)
  {
    return { 0, 0, 0 };
  }
  std::array<int, 3> found;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double degree = degrees->GetComponent(cell, static_cast<int>(axis));
    found[axis] = degree > 0.0 && degree < 100.0 ? static_cast<int>(degree) : 0;
  }
  return found;
}

bool CurvedCellFinder::FindKind(vtkIdType cell, int points, const std::array<int, 3>& degrees,
  CurvedKind& kind, std::string& error) const
{
  const int number = this->Grid->GetCellType(cell);
  const CurvedType& type = *Find(number);
  const int order = type.NumberOfPoints > 0 ? type.Order : FindOrder(type.Shape, points, degrees);
  if (order == 0 || (type.NumberOfPoints > 0 && type.NumberOfPoints != points))
  {
    error = this->Given.NameOf(cell) + " is a " + type.Name + " with " + std::to_string(points) +
      " points, but needs " +
      (type.NumberOfPoints > 0
          ? std::to_string(type.NumberOfPoints)
          : "as many as an order of up to " + std::to_string(HighestOrder) + " has") +
      "; correct the cell or leave it out with vtkExtractCells.";
    return false;
  }
  vtkDataArray* const weights =
    IsBezier(number) ? this->Grid->GetPointData()->GetRationalWeights() : nullptr;
  const vtkIdType tuples = this->Grid->GetNumberOfPoints();
  if (weights && (weights->GetNumberOfComponents() != 1 || weights->GetNumberOfTuples() < tuples))
  {
    error = this->Given.Name + " has rational weights of " +
      std::to_string(weights->GetNumberOfTuples()) + " tuples of " +
      std::to_string(weights->GetNumberOfComponents()) + " component(s), but " +
      std::to_string(tuples) + " points; give SetRationalWeights one value for each.";
    return false;
  }
  std::array<int, 3> powers = degrees[0] > 0 ? degrees : std::array<int, 3>{ order, order, order };
  const bool isBernstein = IsBezier(number) && CountPoints(type.Shape, powers) == points;
  powers = isBernstein ? powers : std::array<int, 3>{ 0, 0, 0 };
  kind = { number, type.Shape, points, order, weights != nullptr, degrees, powers };
  return true;
}

bool CurvedCellFinder::Add(vtkIdType cell, std::string& error)
{
  const int points = static_cast<int>(this->Grid->GetCells()->GetCellSize(cell));
  const int type = this->Grid->GetCellType(cell);
  std::array<int, 3> degrees{ 0, 0, 0 };
  if (Find(type)->NumberOfPoints == 0)
  {
    degrees = this->DegreesOf(cell);
  }
  const std::array<int, 5> key{ type, points, degrees[0], degrees[1], degrees[2] };
  auto known = this->Known.find(key);
  if (known == this->Known.end())
  {
    CurvedKind kind;
    if (!this->FindKind(cell, points, degrees, kind, error))
    {
      return false;
    }
    known = this->Known.emplace(key, static_cast<std::uint32_t>(this->Found.Kinds.size())).first;
    this->Found.Kinds.push_back(kind);
  }
  this->Found.Cells.push_back(cell);
  this->Found.KindOf.push_back(known->second);
  return true;
}

}
