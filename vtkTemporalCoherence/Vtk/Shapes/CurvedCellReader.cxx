// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedCellReader.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Some of VTK's functions write more weights than a cell has points.
constexpr std::size_t RoomForMore = 32;

/// The height of a pyramid's base in VTK's functions: 0.5 for VTK_TRIQUADRATIC_PYRAMID (VTK 9.1),
/// otherwise 0.
double BaseOf(vtkCell* cell)
{
  if (cell->GetCellType() != VTK_TRIQUADRATIC_PYRAMID)
  {
    return 0.0;
  }
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()) + RoomForMore);
  const std::array<double, 3> corner{ 0.0, 0.0, 0.0 };
  cell->InterpolateFunctions(corner.data(), weights.data());
  return std::abs(weights[0] - 1.0) < 1e-6 ? 0.0 : 0.5;
}

/// VTK's parameters at a place. For a quadratic pyramid they lie in a cube whose upper face is the
/// apex.
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

/// Evaluate VTK's functions at a place. Cells write to themselves only, with one exception: up to
/// VTK 9.6, all Bezier wedges of a process share one triangle
/// (vtkBezierInterpolation::WedgeShapeFunctions), so a mutex guards them.
void FunctionsAt(vtkCell* cell, double base, const glm::dvec3& place, std::vector<double>& weights)
{
  static std::mutex usesTriangle;
  std::unique_lock<std::mutex> lock(usesTriangle, std::defer_lock);
  if (cell->GetCellType() == VTK_BEZIER_WEDGE)
  {
    lock.lock();
  }
  const glm::dvec3 at = ParametersAt(cell->GetCellType(), base, place);
  const std::array<double, 3> parameters{ at.x, at.y, at.z };
  cell->InterpolateFunctions(parameters.data(), weights.data());
}

/// The places of a cell's points in the straight cell, from VTK's parameters.
std::vector<glm::dvec3> PlacesOfPoints(vtkCell* cell)
{
  const double base = BaseOf(cell);
  const double* const parameters = cell->GetParametricCoords();
  std::vector<glm::dvec3> places;
  for (vtkIdType p = 0; parameters && p < cell->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 at(parameters[3 * p], parameters[3 * p + 1], parameters[3 * p + 2]);
    if (cell->GetCellType() == VTK_QUADRATIC_PYRAMID) // its parameters lie in the cube
    {
      at.x = at.x * (1.0 - at.z) + 0.5 * at.z;
      at.y = at.y * (1.0 - at.z) + 0.5 * at.z;
    }
    else if (cell->GetCellType() == VTK_TRIQUADRATIC_PYRAMID)
    {
      at.z = (at.z - base) / (1.0 - base);
    }
    places.push_back(at);
  }
  return places;
}

std::vector<std::array<double, 8>> LinearWeightsOf(vtkCell* cell, CurvedShape shape)
{
  const std::vector<glm::dvec3> places = PlacesOfPoints(cell);
  const int corners = FrameOf(shape).NumberOfCorners;
  std::array<double, 8> equal{};
  std::fill_n(equal.begin(), corners, 1.0 / corners);
  std::vector<std::array<double, 8>> all(
    static_cast<std::size_t>(cell->GetNumberOfPoints()), equal);
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const std::array<double, 8> weights = LinearWeightsAt(shape, places[p]);
    const bool isInside = std::all_of(weights.begin(), weights.end(),
      [](double weight) { return weight > -1e-6 && weight < 1.0 + 1e-6; });
    all[p] = isInside ? weights : equal;
  }
  return all;
}

/// A grid with one cell of a kind. Functions depend on its type, number of points and degrees only.
vtkSmartPointer<vtkUnstructuredGrid> ExampleOf(const CurvedKind& kind)
{
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdList> ids;
  for (int p = 0; p < kind.NumberOfPoints; ++p)
  {
    ids->InsertNextId(points->InsertNextPoint(0.0, 0.0, 0.0));
  }
  grid->SetPoints(points);
  grid->InsertNextCell(kind.Type, ids);
  if (kind.Degrees[0] > 0)
  {
    vtkNew<vtkDoubleArray> degrees;
    degrees->SetNumberOfComponents(3);
    degrees->InsertNextTuple3(kind.Degrees[0], kind.Degrees[1], kind.Degrees[2]);
    grid->GetCellData()->SetHigherOrderDegrees(degrees);
  }
  return grid;
}

bool IsEqual(const DivisionPlace& a, const DivisionPlace& b)
{
  return a.I == b.I && a.J == b.J && a.K == b.K && a.Of == b.Of;
}

}

std::vector<double> WeightsAt(vtkCell* cell, const std::vector<glm::dvec3>& places)
{
  const auto points = static_cast<std::size_t>(cell->GetNumberOfPoints());
  const double base = BaseOf(cell);
  std::vector<double> all(places.size() * points);
  std::vector<double> weights(points + RoomForMore);
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    FunctionsAt(cell, base, places[p], weights);
    std::copy_n(weights.begin(), points, all.begin() + static_cast<std::ptrdiff_t>(p * points));
  }
  return all;
}

PointValue Weigh(const double* weights, const std::vector<PointValue>& points)
{
  constexpr double rounding = 1e-13;
  const PointValue* first = nullptr; // the first point with a weight
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

CurvedSource::CurvedSource(
  vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader)
  : Grid(grid)
  , Curved(curved)
  , Reader(reader)
{
  for (const CurvedKind& kind : curved.Kinds)
  {
    this->Examples.push_back(ExampleOf(kind));
  }
  for (std::size_t k = 0; k < curved.Kinds.size(); ++k)
  {
    vtkNew<vtkGenericCell> cell;
    this->SetCell(k, cell);
    this->WeightsOfKinds.push_back(LinearWeightsOf(cell, curved.Kinds[k].Shape));
  }
}

void CurvedSource::SetCell(std::size_t kind, vtkGenericCell* cell) const
{
  const std::lock_guard<std::mutex> lock(this->UsesExamples);
  this->Examples[kind]->GetCell(0, cell);
}

void CurvedSource::ReadIds(std::size_t number, vtkIdList* ids) const
{
  this->Grid->GetCells()->GetCellAtId(this->Curved.Cells[number], ids);
}

KindFunctions::KindFunctions(const CurvedSource& source, std::size_t kind)
  : Shape(source.Curved.Kinds[kind].Shape)
  , NumberOfPoints(static_cast<std::size_t>(source.Curved.Kinds[kind].NumberOfPoints))
  , Scratch(this->NumberOfPoints + RoomForMore)
{
  source.SetCell(kind, this->Cell);
  this->Base = BaseOf(this->Cell);
  if (source.Curved.Kinds[kind].Powers[0] > 0)
  {
    this->Bernstein =
      BernsteinFunctions(this->Shape, PlacesOfPoints(this->Cell), source.Curved.Kinds[kind].Powers);
  }
  constexpr std::size_t mostBytes = 1 << 22;
  std::size_t rows = 1 << 13;
  while (rows > 1 && rows * this->NumberOfPoints * sizeof(double) > mostBytes)
  {
    rows /= 2;
  }
  this->Places.resize(rows, { 0, 0, 0, 0 });
  this->Rows.resize(rows * this->NumberOfPoints);
}

const double* KindFunctions::At(const DivisionPlace& place)
{
  const std::uint64_t bits = (static_cast<std::uint64_t>(place.I) << 48) ^
    (static_cast<std::uint64_t>(place.J) << 32) ^ (static_cast<std::uint64_t>(place.K) << 16) ^
    place.Of;
  const std::size_t slot =
    static_cast<std::size_t>((bits * 0x9e3779b97f4a7c15u) >> 40) & (this->Places.size() - 1);
  double* const row = this->Rows.data() + slot * this->NumberOfPoints;
  if (!IsEqual(this->Places[slot], place))
  {
    const glm::dvec3 at = CoordinatesOf(this->Shape, place);
    if (this->Bernstein.AreKnown())
    {
      this->Bernstein.At(at, row);
    }
    else
    {
      FunctionsAt(this->Cell, this->Base, at, this->Scratch);
      std::copy_n(this->Scratch.begin(), this->NumberOfPoints, row);
    }
    this->Places[slot] = place;
  }
  return row;
}

void CurvedCellReader::Read(const CurvedSource& source, std::size_t number)
{
  const std::size_t k = source.Curved.KindOf[number];
  this->Functions.resize(source.Curved.Kinds.size());
  if (!this->Functions[k])
  {
    this->Functions[k] = std::make_unique<KindFunctions>(source, k);
  }
  this->Of = this->Functions[k].get();
  source.ReadIds(number, this->Ids);
  this->Points.resize(static_cast<std::size_t>(this->Ids->GetNumberOfIds()));
  vtkDataArray* const rational =
    source.Curved.Kinds[k].IsRational ? source.Grid->GetPointData()->GetRationalWeights() : nullptr;
  this->Rational.clear();
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    const vtkIdType id = this->Ids->GetId(static_cast<vtkIdType>(p));
    this->Points[p] = source.Reader.Read(id);
    if (rational)
    {
      this->Rational.push_back(rational->GetComponent(id, 0));
    }
  }
  this->Complete(source, k);
}

/// Give points between corners without a finite value the interpolated value of the corners.
void CurvedCellReader::Complete(const CurvedSource& source, std::size_t kind)
{
  const auto corners =
    static_cast<std::size_t>(FrameOf(source.Curved.Kinds[kind].Shape).NumberOfCorners);
  this->Given = Samples::All;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    const double value = this->Points[p][3];
    if (p < corners && std::isnan(value))
    {
      this->Given = Samples::None;
      return;
    }
    low = std::min(low, value);
    high = std::max(high, value);
    this->Given = p >= corners && !std::isfinite(value) ? Samples::Corners : this->Given;
  }
  if (this->Given == Samples::Corners)
  {
    const std::vector<PointValue> ofCorners(
      this->Points.begin(), this->Points.begin() + static_cast<std::ptrdiff_t>(corners));
    for (std::size_t p = corners; p < this->Points.size(); ++p)
    {
      if (!std::isfinite(this->Points[p][3]))
      {
        this->Points[p][3] = Weigh(source.LinearWeights(kind)[p].data(), ofCorners)[3];
      }
    }
  }
  else if (!std::isfinite(high - low))
  {
    this->Given = Samples::Unbounded;
  }
}

PointValue CurvedCellReader::At(const DivisionPlace& place)
{
  const double* row = this->Of->At(place);
  if (!this->Rational.empty())
  {
    this->Row.resize(this->Rational.size());
    double sum = 0.0;
    for (std::size_t p = 0; p < this->Row.size(); ++p)
    {
      this->Row[p] = row[p] * this->Rational[p];
      sum += this->Row[p];
    }
    for (double& weight : this->Row)
    {
      weight /= sum;
    }
    row = this->Row.data();
  }
  return Weigh(row, this->Points);
}

}
