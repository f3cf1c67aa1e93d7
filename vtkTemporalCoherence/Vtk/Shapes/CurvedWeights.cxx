// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedWeights.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Where VTK's functions of a pyramid have its base: those of VTK_TRIQUADRATIC_PYRAMID have it at
/// the height 0.5 (VTK 9.1).
double BaseOf(vtkCell* cell)
{
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()) + 32);
  const std::array<double, 3> corner{ 0.0, 0.0, 0.0 };
  cell->InterpolateFunctions(corner.data(), weights.data());
  return std::abs(weights[0] - 1.0) < 1e-6 ? 0.0 : 0.5;
}

/// VTK's parameters. Those of a quadratic pyramid are of a cube whose upper face is the apex.
glm::dvec3 ParametersAt(int type, double base, const glm::dvec3& place)
{
  if (type == VTK_QUADRATIC_PYRAMID)
  {
    const double width = 1.0 - place.z;
    return width > 1e-9
      ? glm::dvec3((place.x - 0.5 * place.z) / width, (place.y - 0.5 * place.z) / width, place.z)
      : glm::dvec3(0.5, 0.5, 1.0);
  }
  return type == VTK_TRIQUADRATIC_PYRAMID
    ? glm::dvec3(place.x, place.y, base + (1.0 - base) * place.z)
    : place;
}

}

std::vector<double> WeightsAt(
  vtkCell* cell, CurvedShape shape, const std::vector<glm::dvec3>& places)
{
  const auto points = static_cast<std::size_t>(cell->GetNumberOfPoints());
  const double base = shape == CurvedShape::Pyramid ? BaseOf(cell) : 0.0;
  std::vector<double> all(places.size() * points);
  std::vector<double> weights(points + 32); // some of VTK's functions write more than they have
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const glm::dvec3 at = ParametersAt(cell->GetCellType(), base, places[p]);
    const std::array<double, 3> parameters{ at.x, at.y, at.z };
    cell->InterpolateFunctions(parameters.data(), weights.data());
    std::copy_n(weights.begin(), points, all.begin() + static_cast<std::ptrdiff_t>(p * points));
  }
  return all;
}

PointValue Weigh(const double* weights, const std::vector<PointValue>& points)
{
  constexpr double rounding = 1e-13;
  const PointValue* first = nullptr; // with a weight
  PointValue sum{ 0.0, 0.0, 0.0, 0.0 };
  bool isAlone = true;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (std::abs(weights[p]) <= rounding)
    {
      continue;
    }
    if (!first)
    {
      first = &points[p];
      continue;
    }
    isAlone = false;
    for (std::size_t c = 0; c < sum.size(); ++c)
    {
      sum[c] += weights[p] * (points[p][c] - (*first)[c]);
    }
  }
  if (!first || isAlone)
  {
    return first ? *first : points.front();
  }
  for (std::size_t c = 0; c < sum.size(); ++c)
  {
    sum[c] += (*first)[c];
  }
  return sum;
}

KindWeights::KindWeights(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const std::vector<std::vector<glm::dvec3>>& places)
  : Grid(grid)
  , Curved(curved)
  , Places(places)
{
  vtkNew<vtkGenericCell> cell;
  for (std::size_t k = 0; k < curved.Kinds.size(); ++k)
  {
    const CurvedKind& kind = curved.Kinds[k];
    grid->GetCell(kind.Example, cell); // of all kinds, as the first call is not thread-safe
    this->Weights.push_back(
      kind.IsRational ? std::vector<double>() : WeightsAt(cell, kind.Shape, places[k]));
  }
}

const double* KindWeights::Of(
  std::size_t number, vtkGenericCell* cell, std::vector<double>& own) const
{
  const std::uint32_t k = this->Curved.KindOf[number];
  const CurvedKind& kind = this->Curved.Kinds[k];
  if (!kind.IsRational)
  {
    return this->Weights[k].data();
  }
  this->Grid->GetCell(this->Curved.Cells[number], cell);
  own = WeightsAt(cell, kind.Shape, this->Places[k]);
  return own.data();
}

void CurvedWorkplace::Read(vtkUnstructuredGrid* grid, vtkIdType cell, const PointReader& reader)
{
  grid->GetCells()->GetCellAtId(cell, this->Ids);
  this->Points.resize(static_cast<std::size_t>(this->Ids->GetNumberOfIds()));
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    this->Points[p] = reader.Read(this->Ids->GetId(static_cast<vtkIdType>(p)));
  }
}

std::vector<glm::dvec3> PlacesOf(const CellDivision& division)
{
  std::vector<glm::dvec3> places;
  for (const DivisionPoint& point : division.Points)
  {
    places.push_back(point.At);
  }
  return places;
}

}
