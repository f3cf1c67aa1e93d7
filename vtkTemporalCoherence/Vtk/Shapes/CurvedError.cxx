// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedError.h"

#include "Shapes/CurvedWeights.h"
#include "Shapes/DivisionChecks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

struct Range
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  void Add(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }

  double Length() const { return std::max(this->High - this->Low, 0.0); }
};

/// Differences of a cell, not yet divided by anything.
struct CellError
{
  double OfPoints = 0.0, OfValues = 0.0;
  double Size = 0.0; ///< the diagonal of the box around its points
  Range Values;
};

/// The largest bound of all linear cells.
glm::dvec2 WorstOf(const std::vector<DivisionBound>& bounds, const std::vector<glm::dvec2>& off)
{
  glm::dvec2 worst(0.0);
  for (const DivisionBound& bound : bounds)
  {
    glm::dvec2 sum(0.0);
    for (const DivisionBound::Group& group : bound.Groups)
    {
      glm::dvec2 largest(0.0);
      for (const int check : group.Checks)
      {
        largest = glm::max(largest, off[static_cast<std::size_t>(check)]);
      }
      sum += group.Factor * largest;
    }
    worst = glm::max(worst, sum);
  }
  return worst;
}

/// Where the error is measured: first the points of divided cells of each kind, then the checks.
struct ErrorPlaces
{
  std::vector<std::vector<glm::dvec3>> Places;
  std::vector<DivisionChecks> Checks;

  ErrorPlaces(const CurvedCells& curved, int parts)
  {
    for (const CurvedKind& kind : curved.Kinds)
    {
      const CellDivision division = Divide(kind.Shape, parts);
      this->Places.push_back(PlacesOf(division));
      this->Checks.push_back(ChecksOf(division));
      for (const DivisionCheck& check : this->Checks.back().Checks)
      {
        this->Places.back().push_back(check.At);
      }
    }
  }

  CellError ErrorOf(
    std::uint32_t kind, const std::vector<PointValue>& points, const double* weights) const
  {
    CellError error;
    std::array<Range, 4> ranges;
    for (const PointValue& point : points)
    {
      for (std::size_t c = 0; c < 4; ++c)
      {
        ranges[c].Add(point[c]);
      }
    }
    error.Size = std::hypot(ranges[0].Length(), ranges[1].Length(), ranges[2].Length());
    error.Values = ranges[3];

    const DivisionChecks& checks = this->Checks[kind];
    const std::size_t count = this->Places[kind].size() - checks.Checks.size();
    std::vector<PointValue> divided(count);
    for (std::size_t p = 0; p < count; ++p)
    {
      divided[p] = Weigh(weights + p * points.size(), points);
    }
    std::vector<glm::dvec2> off(checks.Checks.size()); // of points and of values
    for (std::size_t i = 0; i < off.size(); ++i)
    {
      const PointValue truth = Weigh(weights + (count + i) * points.size(), points);
      const PointValue& a = divided[static_cast<std::size_t>(checks.Checks[i].Points[0])];
      const PointValue& b = divided[static_cast<std::size_t>(checks.Checks[i].Points[1])];
      PointValue difference;
      for (std::size_t c = 0; c < 4; ++c)
      {
        difference[c] = truth[c] - 0.5 * (a[c] + b[c]);
      }
      off[i] = { std::hypot(difference[0], difference[1], difference[2]), std::abs(difference[3]) };
    }
    const glm::dvec2 worst = WorstOf(checks.Bounds, off);
    error.OfPoints = worst.x;
    error.OfValues = worst.y;
    return error;
  }
};

/// Values that hardly differ in a cell are compared with this part of the range of all.
constexpr double SmallestRange = 0.01;

}

int OrderOf(const CurvedCells& curved)
{
  int order = 2;
  for (const CurvedKind& kind : curved.Kinds)
  {
    order = std::max(order, kind.Order);
  }
  return order;
}

bool MeasureError(vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader,
  int parts, const ReportProgress& progress, CurvedError& worst)
{
  const ErrorPlaces places(curved, parts);
  std::vector<CellError> errors(curved.Cells.size());
  if (!ForEachCurvedCell(grid, curved, reader, places.Places, progress,
        [&](std::size_t cell, const std::vector<PointValue>& points, const double* rows)
        { errors[cell] = places.ErrorOf(curved.KindOf[cell], points, rows); }))
  {
    return false;
  }
  Range all;
  for (const CellError& error : errors)
  {
    all.Add(error.Values.Low);
    all.Add(error.Values.High);
  }
  worst = CurvedError();
  for (const CellError& error : errors)
  {
    const double length = std::max(error.Values.Length(), SmallestRange * all.Length());
    worst.OfPoints = std::max(worst.OfPoints, error.Size > 0.0 ? error.OfPoints / error.Size : 0.0);
    worst.OfValues = std::max(worst.OfValues, length > 0.0 ? error.OfValues / length : 0.0);
  }
  return true;
}

}
