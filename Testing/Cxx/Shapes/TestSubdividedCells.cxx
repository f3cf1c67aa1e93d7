// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Linear cells made of curved ones, without a picture: all neighbours share all points of their
// faces, they fill the space of the grid, and the error told holds at random places, compared with
// VTK's own interpolation.

#include "Checks/Expect.h"
#include "CurvedGrids.h"
#include "LinearCells.h"
#include "Shapes/CurvedCells.h"
#include "Shapes/CurvedWeights.h"
#include "Shapes/SubdividedCells.h"

#include <vtkCellData.h>
#include <vtkCellTypeSource.h>
#include <vtkIdList.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

namespace
{

using namespace TemporalCoherence;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

struct Divided
{
  std::vector<MeshPart> Parts;
  Subdivision Told;
  std::string Error;
};

Divided DividedOf(vtkUnstructuredGrid* grid)
{
  Divided divided;
  Expect(AppendSubdividedCells(grid, grid->GetPointData()->GetScalars(), 0, nullptr, 0,
           divided.Parts, divided.Error, &divided.Told),
    "cells are divided: " + divided.Error);
  Expect(divided.Parts.size() == 1, "there is one part");
  return divided;
}

/// How many triangles and quadrilaterals on the surface of a grid there are after each edge became
/// so many parts.
std::size_t CountOuterFaces(vtkUnstructuredGrid* grid, int parts)
{
  std::map<std::set<vtkIdType>, int> counts;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      vtkCell* face = cell->GetFace(f);
      const int corners = face->GetNumberOfEdges();
      const vtkIdType* ids = face->GetPointIds()->GetPointer(0);
      ++counts[std::set<vtkIdType>(ids, ids + corners)];
    }
  }
  const auto outer =
    std::count_if(counts.begin(), counts.end(), [](const auto& face) { return face.second == 1; });
  return static_cast<std::size_t>(outer * parts * parts);
}

/// Faces have a cell on both sides, or none lies behind them in the grid either.
void ExpectConforming(const Divided& divided, std::size_t outerFaces, const std::string& what)
{
  std::size_t single = 0;
  for (const auto& [face, count] : CountFaces(divided.Parts.front()))
  {
    Expect(count <= 2, what + ": a face has at most two cells");
    single += count == 1;
  }
  Expect(single == outerFaces,
    what + ": " + std::to_string(single) + " faces with one cell, not " +
      std::to_string(outerFaces));
}

void ExpectVolume(const Divided& divided, double volume, const std::string& what)
{
  const MeshPart& part = divided.Parts.front();
  double sum = 0.0, least = 1e300, most = -1e300;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    MeshCell cell;
    ReadCell(part, c, cell);
    sum += VolumeOf(cell);
    least = std::min(least, VolumeOf(cell));
    most = std::max(most, VolumeOf(cell));
  }
  Expect(std::abs(std::abs(sum) - volume) < 1e-9 * volume,
    what + ": volume " + std::to_string(sum) + ", not " + std::to_string(volume));
  // VTK's source makes wedges inside out.
  Expect(least > 0.0 || most < 0.0, what + ": all cells are turned alike");
}

/// A random place in a linear cell: a weight for each of its points, in VTK's order.
std::vector<double> RandomWeights(const DivisionCell& cell, std::mt19937& engine)
{
  std::uniform_real_distribution<double> random(0.0, 1.0);
  const double r = random(engine), s = random(engine), t = random(engine);
  switch (cell.Type)
  {
    case MeshCellType::Tetrahedron:
    {
      std::array<double, 3> cuts{ r, s, t };
      std::sort(cuts.begin(), cuts.end());
      return { cuts[0], cuts[1] - cuts[0], cuts[2] - cuts[1], 1.0 - cuts[2] };
    }
    case MeshCellType::Wedge:
    {
      const double a = std::min(r, s), b = std::abs(r - s), c = 1.0 - a - b;
      return { a * (1 - t), b * (1 - t), c * (1 - t), a * t, b * t, c * t };
    }
    case MeshCellType::Pyramid:
      return { (1 - r) * (1 - s) * (1 - t), r * (1 - s) * (1 - t), r * s * (1 - t),
        (1 - r) * s * (1 - t), t };
    case MeshCellType::Voxel:
    case MeshCellType::Hexahedron:
      break;
  }
  return { (1 - r) * (1 - s) * (1 - t), r * (1 - s) * (1 - t), r * s * (1 - t),
    (1 - r) * s * (1 - t), (1 - r) * (1 - s) * t, r * (1 - s) * t, r * s * t, (1 - r) * s * t };
}

glm::dvec4 At(const MeshPart& part, std::int64_t id)
{
  return { part.Coordinates[0].At(id), part.Coordinates[1].At(id), part.Coordinates[2].At(id),
    part.Values.At(id) };
}

/// The points of a cell of VTK with their values, and how large and how different they are.
struct TrueCell
{
  vtkNew<vtkGenericCell> Cell;
  std::vector<PointValue> Points;
  double Size = 0.0, Length = 0.0;

  void Read(vtkUnstructuredGrid* grid, vtkIdType number)
  {
    grid->GetCell(number, this->Cell);
    this->Points.clear();
    glm::dvec4 low(1e300), high(-1e300);
    for (vtkIdType p = 0; p < this->Cell->GetNumberOfPoints(); ++p)
    {
      const vtkIdType id = this->Cell->GetPointId(static_cast<int>(p));
      glm::dvec4 point;
      grid->GetPoint(id, &point.x);
      point.w = grid->GetPointData()->GetScalars()->GetComponent(id, 0);
      low = glm::min(low, point);
      high = glm::max(high, point);
      this->Points.push_back({ point.x, point.y, point.z, point.w });
    }
    this->Size = glm::length(glm::dvec3(high - low));
    this->Length = high.w - low.w;
  }
};

/// At random places the linear cells are as near to VTK's as was told.
void ExpectError(vtkUnstructuredGrid* grid, const Divided& divided, const std::string& what)
{
  CurvedCellFinder finder(grid);
  std::string error;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Expect(finder.Add(c, error), "a known kind " + error);
  }
  const MeshPart& part = divided.Parts.front();
  std::mt19937 engine(11);
  double ofPoints = 0.0, ofValues = 0.0;
  std::int64_t next = 0;
  TrueCell truth;
  const double* range = grid->GetPointData()->GetScalars()->GetRange();
  const double all = range[1] - range[0];
  for (std::size_t c = 0; c < finder.Found.Cells.size(); ++c)
  {
    const CurvedShape shape = finder.Found.Kinds[finder.Found.KindOf[c]].Shape;
    const CellDivision division = Divide(shape, divided.Told.Parts);
    truth.Read(grid, finder.Found.Cells[c]);
    for (const DivisionCell& cell : division.Cells)
    {
      Expect(part.Originals.IdAt(next) == finder.Found.Cells[c], what + ": number of the cell");
      const std::int64_t offset = part.Offsets.IdAt(next++);
      const std::vector<double> weights = RandomWeights(cell, engine);
      glm::dvec3 at(0.0);
      glm::dvec4 linear(0.0);
      for (std::size_t p = 0; p < weights.size(); ++p)
      {
        at += weights[p] * division.Points[static_cast<std::size_t>(cell.Points[p])].At;
        linear +=
          weights[p] * At(part, part.Connectivity.IdAt(offset + static_cast<std::int64_t>(p)));
      }
      const PointValue exact = Weigh(WeightsAt(truth.Cell, shape, { at }).data(), truth.Points);
      const glm::dvec4 off = linear - glm::dvec4(exact[0], exact[1], exact[2], exact[3]);
      ofPoints = std::max(ofPoints, glm::length(glm::dvec3(off)) / truth.Size);
      ofValues = std::max(ofValues, std::abs(off.w) / std::max(truth.Length, 0.01 * all));
    }
  }
  std::cout << what << ": " << divided.Told.Parts << " parts; told " << divided.Told.ErrorOfPoints
            << " and " << divided.Told.ErrorOfValues << ", found " << ofPoints << " and "
            << ofValues << '\n';
  Expect(ofPoints <= 1.05 * divided.Told.ErrorOfPoints + 1e-12, what + ": error of points");
  Expect(ofValues <= 1.05 * divided.Told.ErrorOfValues + 1e-12, what + ": error of values");
  Expect(ofValues >= 0.1 * divided.Told.ErrorOfValues - 1e-5, what + ": the error told is there");
}

struct Case
{
  std::string Name;
  Grid Input;
  double Size; // of the cube that it fills
};

Grid FromSource(int type)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(2, 2, 2);
  source->SetCellOrder(3);
  source->Update();
  const auto grid = Grid::New();
  grid->DeepCopy(source->GetOutput());
  return grid;
}

std::vector<Case> CurvedCases()
{
  std::vector<Case> cases;
  for (const int type : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
         VTK_QUADRATIC_PYRAMID, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_HEXAHEDRON,
         VTK_LAGRANGE_WEDGE, VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE })
  {
    cases.push_back({ "source of type " + std::to_string(type), FromSource(type), 2.0 });
  }
  for (const int type : { VTK_TRIQUADRATIC_HEXAHEDRON, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON })
  {
    cases.push_back({ "hexahedra of type " + std::to_string(type),
      TileCubes(type, HexahedronPattern(type), 2), 1.0 });
  }
  for (const int type : { VTK_QUADRATIC_LINEAR_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE })
  {
    cases.push_back(
      { "wedges of type " + std::to_string(type), TileCubes(type, WedgePattern(type), 2), 1.0 });
  }
  cases.push_back({ "pyramids", TileCubes(VTK_QUADRATIC_PYRAMID, PyramidPattern(false), 2), 1.0 });
  cases.push_back(
    { "pyramids of 19", TileCubes(VTK_TRIQUADRATIC_PYRAMID, PyramidPattern(true), 2), 1.0 });
  return cases;
}

void TestCurved()
{
  for (const Case& input : CurvedCases())
  {
    for (const double bend : { 0.0, 0.04 })
    {
      const std::string what = input.Name + (bend > 0.0 ? ", bent" : ", straight");
      const Grid grid = Grid::New();
      grid->DeepCopy(input.Input);
      Bend(grid, input.Size, bend, bend);
      const Divided divided = DividedOf(grid);
      ExpectConforming(divided, CountOuterFaces(grid, divided.Told.Parts), what);
      ExpectVolume(divided, std::pow(input.Size, 3), what);
      ExpectError(grid, divided, what);
      Expect(bend > 0.0 || divided.Told.Parts == 1, what + ": straight cells stay whole");
    }
  }
}

}

int TestSubdividedCells(int, char*[])
{
  TestCurved();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
