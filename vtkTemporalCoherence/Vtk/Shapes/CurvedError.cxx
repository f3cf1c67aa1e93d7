// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedError.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace TemporalCoherence
{
namespace
{

/// A place where the difference between a cell and its linear parts is measured: half way between
/// two points of a linear cell, where the linear cell has the mean of both points.
struct DivisionCheck
{
  DivisionPlace At;
  std::array<int, 2> Points;
};

/// The bound of the difference in a linear cell: the sum over groups of checks of the largest
/// difference in the group, times the group's factor.
struct DivisionBound
{
  struct Group
  {
    double Factor;
    std::vector<int> Checks;
  };
  std::vector<Group> Groups;
};

struct DivisionChecks
{
  std::vector<DivisionCheck> Checks;
  std::vector<DivisionBound> Bounds; ///< of each linear cell
};

using Pairs = std::vector<std::array<std::size_t, 2>>;

/// Pairs of points of a cell, and the factor for the worst pair.
struct PairGroup
{
  double Factor;
  Pairs Of;
};

DivisionPlace HalfWay(const DivisionPlace& a, const DivisionPlace& b)
{
  const auto sum = [](int first, int second) { return static_cast<std::uint16_t>(first + second); };
  return { sum(a.I, b.I), sum(a.J, b.J), sum(a.K, b.K), sum(a.Of, b.Of) };
}

const std::vector<PairGroup>& GroupsOf(MeshCellType type)
{
  static const std::vector<PairGroup> tetrahedron = { { 1.5,
    { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } } };
  static const std::vector<PairGroup> pyramid = { { 1.6,
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 2 }, { 1, 3 }, { 0, 4 }, { 1, 4 }, { 2, 4 },
      { 3, 4 } } } };
  static const std::vector<PairGroup> wedge = {
    { 4.0 / 3.0, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 } } },
    { 1.0, { { 0, 3 }, { 1, 4 }, { 2, 5 } } }
  };
  static const std::vector<PairGroup> hexahedron = {
    { 1.0, { { 0, 1 }, { 3, 2 }, { 4, 5 }, { 7, 6 } } },
    { 1.0, { { 0, 3 }, { 1, 2 }, { 4, 7 }, { 5, 6 } } },
    { 1.0, { { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } },
  };
  return type == MeshCellType::Tetrahedron ? tetrahedron
    : type == MeshCellType::Pyramid        ? pyramid
    : type == MeshCellType::Wedge          ? wedge
                                           : hexahedron;
}

/// Where to measure how far linear cells are from functions of the second order. For these the
/// bounds hold everywhere in a cell.
///
/// If weights w of points x add up to 1, the weighted mean of such a function f differs from its
/// value at the mean place by half the sum of w_i w_j f''(x_i - x_j) over all pairs, and half way
/// between two points by f''(x_i - x_j) / 8. So the largest difference is that of the worst pair,
/// times 2 (1 - 1 / k) for k points. A product of linear functions along some axes has a sum of
/// such terms, one for each axis.
DivisionChecks ChecksOf(const CellDivision& division)
{
  DivisionChecks checks;
  std::map<std::array<int, 2>, int> known;
  for (const DivisionCell& cell : division.Cells)
  {
    DivisionBound bound;
    for (const PairGroup& group : GroupsOf(cell.Type))
    {
      bound.Groups.push_back({ group.Factor, {} });
      for (const auto& [first, second] : group.Of)
      {
        std::array<int, 2> points{ cell.Points[first], cell.Points[second] };
        std::sort(points.begin(), points.end());
        const auto found = known.emplace(points, static_cast<int>(checks.Checks.size()));
        if (found.second)
        {
          const auto at = [&](int point)
          { return division.Points[static_cast<std::size_t>(point)]; };
          checks.Checks.push_back({ HalfWay(at(points[0]), at(points[1])), points });
        }
        bound.Groups.back().Checks.push_back(found.first->second);
      }
    }
    checks.Bounds.push_back(bound);
  }
  return checks;
}

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

/// Where the errors of one kind of cells are measured.
struct ErrorPlaces
{
  CellDivision Division;
  DivisionChecks Checks;

  ErrorPlaces(CurvedShape shape, int parts, bool areCones)
    : Division(areCones ? DivideIntoCones(shape, parts) : Divide(shape, CellParts(parts)))
    , Checks(ChecksOf(this->Division))
  {
  }
};

CellError ErrorOf(CurvedCellReader& cell, const ErrorPlaces& places)
{
  CellError error;
  error.Given = cell.Given;
  if (cell.Given == CurvedCellReader::Samples::None)
  {
    return error;
  }
  std::array<Range, 4> ranges;
  for (const PointValue& point : cell.Points)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      ranges[c].Add(point[c]);
    }
  }
  std::vector<PointValue> divided;
  for (const DivisionPlace& place : places.Division.Points)
  {
    divided.push_back(cell.At(place));
  }
  std::vector<glm::dvec2> off; // of points and of values
  for (const DivisionCheck& check : places.Checks.Checks)
  {
    const PointValue truth = cell.At(check.At);
    const PointValue& a = divided[static_cast<std::size_t>(check.Points[0])];
    const PointValue& b = divided[static_cast<std::size_t>(check.Points[1])];
    PointValue difference;
    for (std::size_t c = 0; c < 4; ++c)
    {
      difference[c] = truth[c] - (0.5 * a[c] + 0.5 * b[c]);
    }
    off.emplace_back(
      std::hypot(difference[0], difference[1], difference[2]), std::abs(difference[3]));
  }
  const glm::dvec2 worst = WorstOf(places.Checks.Bounds, off);
  const double size = std::hypot(ranges[0].Length(), ranges[1].Length(), ranges[2].Length());
  error.OfPoints = size > 0.0 ? worst.x / size : 0.0;
  error.OfValues = worst.y;
  error.LowestValue = ranges[3].Low;
  error.HighestValue = ranges[3].High;
  return error;
}

}

bool MeasureErrors(const CurvedSource& source, const std::vector<std::size_t>& numbers,
  const std::vector<int>& partsOfKinds, bool areCones, const ReportProgress& progress,
  std::vector<CellError>& errors)
{
  std::vector<ErrorPlaces> places;
  for (std::size_t k = 0; k < partsOfKinds.size(); ++k)
  {
    places.emplace_back(source.Curved.Kinds[k].Shape, partsOfKinds[k], areCones);
  }
  errors.assign(numbers.size(), CellError());
  return ForEachWithReader(numbers.size(), progress,
    [&](CurvedCellReader& cell, std::size_t i)
    {
      cell.Read(source, numbers[i]);
      errors[i] = ErrorOf(cell, places[source.Curved.KindOf[numbers[i]]]);
    });
}

}
