// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Linear cells made of curved ones fill the space of the grid. Neighbours share all points of their
// faces, however finely each is divided. The error that is told holds at random places, by VTK's
// own interpolation.

#include "Checks/Expect.h"
#include "LinearCells.h"
#include "Shapes/BoundaryParts.h"
#include "Shapes/CurvedCellReader.h"
#include "Shapes/CurvedCells.h"
#include "Shapes/SubdividedCells.h"
#include "Volumes/CurvedGrids.h"

#include <vtkCellData.h>
#include <vtkCellTypeSource.h>
#include <vtkIdList.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
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
  KeptDivision Kept;
  std::string Error;
};

Divided DividedOf(vtkUnstructuredGrid* grid, MakingBudget budget = {})
{
  Divided divided;
  Expect(AppendSubdividedCells(grid, grid->GetPointData()->GetScalars(), 0, nullptr, 0,
           divided.Parts, divided.Error, &divided.Told, &budget, &divided.Kept),
    "cells are divided: " + divided.Error);
  return divided;
}

glm::dvec4 At(const MeshPart& part, std::int64_t id)
{
  return { part.Coordinates[0].At(id), part.Coordinates[1].At(id), part.Coordinates[2].At(id),
    part.Values.At(id) };
}

/// True if all points lie on one side of a cube from 0 to a size.
bool IsOuter(const MeshPart& part, const FacePoints& face, double size)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0.0, size })
    {
      const auto isThere = [&](std::int64_t id)
      { return std::abs(At(part, id)[axis] - side) < 1e-9 * size; };
      if (std::all_of(face.begin(), face.end(), isThere))
      {
        return true;
      }
    }
  }
  return false;
}

/// Faces have a cell on both sides, or lie on the surface of the cube that the grid fills.
void ExpectConforming(const Divided& divided, double size, const std::string& what)
{
  const MeshPart& part = divided.Parts.front();
  int open = 0, crowded = 0;
  for (const auto& [face, count] : CountFaces(part))
  {
    crowded += count > 2;
    open += count == 1 && !IsOuter(part, face, size);
  }
  Expect(open == 0 && crowded == 0,
    what + ": " + std::to_string(open) + " faces without a neighbour, " + std::to_string(crowded) +
      " with too many");
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

/// The parts of a cell with those of its faces and edges.
CellParts PartsOf(vtkUnstructuredGrid* grid, const KeptDivision& kept, std::size_t number)
{
  BoundaryParts boundary;
  vtkNew<vtkIdList> ids;
  const auto frame = [&](std::size_t c) -> const ShapeFrame&
  { return FrameOf(kept.Curved.Kinds[kept.Curved.KindOf[c]].Shape); };
  for (std::size_t c = 0; c < kept.Parts.size(); ++c)
  {
    grid->GetCells()->GetCellAtId(kept.Curved.Cells[c], ids);
    boundary.Add(frame(c), ids, kept.Parts[c]);
  }
  grid->GetCells()->GetCellAtId(kept.Curved.Cells[number], ids);
  return boundary.Of(frame(number), ids, kept.Parts[number]);
}

/// At random places the linear cells are as near to VTK's as was told.
void ExpectError(vtkUnstructuredGrid* grid, const Divided& divided, const std::string& what)
{
  const CurvedCells& curved = divided.Kept.Curved;
  const MeshPart& part = divided.Parts.front();
  std::mt19937 engine(11);
  double ofPoints = 0.0, ofValues = 0.0;
  std::int64_t next = 0;
  TrueCell truth;
  const double* range = grid->GetPointData()->GetScalars()->GetRange();
  const double all = range[1] - range[0];
  for (std::size_t c = 0; c < curved.Cells.size(); ++c)
  {
    const CurvedShape shape = curved.Kinds[curved.KindOf[c]].Shape;
    const CellDivision division = Divide(shape, PartsOf(grid, divided.Kept, c));
    truth.Read(grid, curved.Cells[c]);
    for (const DivisionCell& cell : division.Cells)
    {
      Expect(part.Originals.IdAt(next) == curved.Cells[c], what + ": number of the cell");
      const std::int64_t offset = part.Offsets.IdAt(next++);
      const std::vector<double> weights = RandomWeights(cell, engine);
      glm::dvec3 at(0.0);
      glm::dvec4 linear(0.0);
      for (std::size_t p = 0; p < weights.size(); ++p)
      {
        at += weights[p] *
          CoordinatesOf(shape, division.Points[static_cast<std::size_t>(cell.Points[p])]);
        linear +=
          weights[p] * At(part, part.Connectivity.IdAt(offset + static_cast<std::int64_t>(p)));
      }
      const PointValue exact = Weigh(WeightsAt(truth.Cell, { at }).data(), truth.Points);
      const glm::dvec4 off = linear - glm::dvec4(exact[0], exact[1], exact[2], exact[3]);
      ofPoints = std::max(ofPoints, glm::length(glm::dvec3(off)) / truth.Size);
      ofValues = std::max(ofValues, std::abs(off.w) / std::max(truth.Length, 0.01 * all));
    }
  }
  std::cout << what << ": " << part.NumberOfCells << " cells, " << divided.Told.Parts
            << " parts; told " << divided.Told.Error.OfPoints << " and "
            << divided.Told.Error.OfValues << ", found " << ofPoints << " and " << ofValues << '\n';
  Expect(next == part.NumberOfCells, what + ": number of cells");
  Expect(ofPoints <= 1.05 * divided.Told.Error.OfPoints + 1e-12, what + ": error of points");
  Expect(ofValues <= 1.05 * divided.Told.Error.OfValues + 1e-12, what + ": error of values");
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
      Bend(grid, input.Size, bend, 0.25 * bend);
      const Divided divided = DividedOf(grid);
      ExpectConforming(divided, input.Size, what);
      ExpectVolume(divided, std::pow(input.Size, 3), what);
      ExpectError(grid, divided, what);
      const double error = std::max(divided.Told.Error.OfPoints, divided.Told.Error.OfValues);
      // Parts of pyramids are limited.
      const bool isPyramid =
        divided.Kept.Curved.Kinds.front().Shape == CurvedShape::Pyramid && bend > 0.0;
      Expect(isPyramid ? error < 0.01 : error <= SubdivisionGoal, what + ": the goal is met");
      Expect(bend > 0.0 || divided.Told.Parts == 1, what + ": straight cells stay whole");
    }
  }
}

/// One bent cell of many: those around it share its points, all others stay whole.
void TestOneBent()
{
  for (const Case& input : CurvedCases())
  {
    const std::string what = input.Name + ", one bent";
    const Grid grid = Grid::New();
    grid->DeepCopy(input.Input);
    Bend(grid, input.Size, 0.0, 0.0);
    // A point inside of the cube that is no corner of a cell.
    vtkNew<vtkIdList> ids;
    vtkIdType bent = -1;
    for (vtkIdType c = 0; c < grid->GetNumberOfCells() && bent < 0; ++c)
    {
      grid->GetCellPoints(c, ids);
      for (vtkIdType p = 8; p < ids->GetNumberOfIds() && bent < 0; ++p)
      {
        const double* at = grid->GetPoint(ids->GetId(p));
        const bool isInside = std::all_of(
          at, at + 3, [&](double x) { return x > 0.01 * input.Size && x < 0.99 * input.Size; });
        bent = isInside ? ids->GetId(p) : bent;
      }
    }
    double at[3];
    grid->GetPoint(bent, at);
    const glm::dvec3 old(at[0], at[1], at[2]);
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p) // VTK's source repeats points
    {
      grid->GetPoint(p, at);
      if (glm::distance(glm::dvec3(at[0], at[1], at[2]), old) < 1e-9)
      {
        grid->GetPoints()->SetPoint(p, at[0] + 0.02 * input.Size, at[1], at[2]);
      }
    }
    const Divided divided = DividedOf(grid);
    ExpectConforming(divided, input.Size, what);
    ExpectVolume(divided, std::pow(input.Size, 3), what);
    ExpectError(grid, divided, what);
    const auto whole =
      std::count(divided.Kept.Parts.begin(), divided.Kept.Parts.end(), std::uint16_t(1));
    Expect(divided.Told.Parts > 1 && whole > 0, what + ": " + std::to_string(whole) + " whole");
  }
}

/// Less memory makes larger cells with a larger error, not none.
void TestBudget()
{
  const Grid grid = FromSource(VTK_QUADRATIC_TETRA);
  Bend(grid, 2.0, 0.1, 0.1);
  const Divided fine = DividedOf(grid);
  std::int64_t last = fine.Parts.front().NumberOfCells;
  double error = 0.0;
  for (const std::size_t memory : { 1 << 20, 1 << 18, 1 << 16 })
  {
    MakingBudget budget;
    budget.Memory = budget.ForDivision = memory;
    budget.PerCell = 16;
    const Divided coarse = DividedOf(grid, budget);
    const std::string what = "memory of " + std::to_string(memory);
    const std::int64_t cells = coarse.Parts.front().NumberOfCells;
    Expect(cells < last && coarse.Told.Error.Limit == DivisionLimit::Memory, what + ": less cells");
    Expect(std::max(coarse.Told.Error.OfPoints, coarse.Told.Error.OfValues) > error,
      what + ": a larger error");
    Expect(cells * 50 < static_cast<std::int64_t>(memory), what + ": fits");
    ExpectConforming(coarse, 2.0, what);
    ExpectError(grid, coarse, what);
    last = cells;
    error = std::max(coarse.Told.Error.OfPoints, coarse.Told.Error.OfValues);
  }
}

/// Points between corners may have no value: that between the corners is taken, and the error of
/// values is not known. A corner without a value hides its cell.
void TestMissing()
{
  const double none = std::nan("");
  for (const Case& input : CurvedCases())
  {
    const std::string what = input.Name + ", missing values";
    const Grid& grid = input.Input;
    Bend(grid, input.Size, 0.0, 0.0);
    const Divided whole = DividedOf(grid);
    std::set<vtkIdType> corners;
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    {
      grid->GetCellPoints(c, ids);
      const CurvedShape shape = whole.Kept.Curved.Kinds[whole.Kept.Curved.KindOf[c]].Shape;
      corners.insert(ids->begin(), ids->begin() + FrameOf(shape).NumberOfCorners);
    }
    const auto spoil = [&]
    {
      for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
      {
        vtkDataArray* const values = grid->GetPointData()->GetScalars();
        values->SetComponent(p, 0, corners.count(p) == 0 ? none : values->GetComponent(p, 0));
      }
    };
    spoil();
    const Divided divided = DividedOf(grid);
    const MeshPart& part = divided.Parts.front();
    Expect(std::isnan(divided.Told.Error.OfValues), what + ": the error is not known");
    Expect(divided.Told.Error.OfPoints < 1e-5 && part.NumberOfCells == grid->GetNumberOfCells(),
      what + ": whole cells");
    Expect(HasValuesOf(
             [&](const glm::dvec3& at) { return (3.0 * at.x - at.y) / input.Size; }, part, 1e-6),
      what + ": values of the corners");
    Bend(grid, input.Size, 0.05, 0.0);
    spoil();
    const Divided bent = DividedOf(grid);
    const MeshPart& ofBent = bent.Parts.front();
    bool areFinite = true;
    for (std::int64_t p = 0; p < ofBent.NumberOfPoints; ++p)
    {
      areFinite &= std::isfinite(ofBent.Values.At(p));
    }
    Expect(areFinite && bent.Told.Parts > 1, what + ": values where points are bent");
    ExpectConforming(bent, input.Size, what);
    grid->GetCellPoints(0, ids);
    grid->GetPointData()->GetScalars()->SetComponent(ids->GetId(0), 0, none);
    const Divided hidden = DividedOf(grid);
    bool isHidden = hidden.Parts.front().NumberOfCells > 0;
    for (std::int64_t c = 0; c < hidden.Parts.front().NumberOfCells; ++c)
    {
      isHidden &= hidden.Parts.front().Originals.IdAt(c) != 0;
    }
    Expect(isHidden, what + ": a corner without a value hides the cell");
  }
}

/// The functions that are used are those of VTK.
void TestFunctions()
{
  std::mt19937 engine(5);
  std::uniform_int_distribution<int> random(0, 30);
  for (const Case& input : CurvedCases())
  {
    Bend(input.Input, input.Size, 0.0, 0.0);
    const Divided divided = DividedOf(input.Input);
    const CurvedSource source(input.Input, divided.Kept.Curved,
      { input.Input->GetPoints(), input.Input->GetPointData()->GetScalars(), 0 });
    KindFunctions functions(source, 0);
    const CurvedKind& kind = divided.Kept.Curved.Kinds.front();
    vtkNew<vtkGenericCell> cell;
    source.SetCell(0, cell);
    double worst = 0.0;
    for (int i = 0; i < 200; ++i)
    {
      const int x = random(engine), y = std::min(random(engine), 30 - x),
                z = std::min(random(engine), 30 - x - y);
      const DivisionPlace place{ static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
        static_cast<std::uint16_t>(z), 30 };
      const std::vector<double> truth = WeightsAt(cell, { CoordinatesOf(kind.Shape, place) });
      const double* const values = functions.At(place);
      for (std::size_t p = 0; p < truth.size(); ++p)
      {
        worst = std::max(worst, std::abs(truth[p] - values[p]));
      }
    }
    Expect(worst < 1e-12, input.Name + ": functions off by " + std::to_string(worst));
  }
}

/// Cells of many threads with weights of their own: the same points each time.
void TestThreads()
{
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(16);
  for (const int type : { VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE,
         VTK_LAGRANGE_WEDGE, VTK_QUADRATIC_WEDGE })
  {
    const Grid grid = FromSource(type);
    Bend(grid, 2.0, 0.01, 0.0);
    vtkNew<vtkDoubleArray> weights;
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      glm::dvec3 at;
      grid->GetPoint(p, &at.x);
      weights->InsertNextValue(1.0 + 0.02 * NoiseAt(at));
    }
    grid->GetPointData()->SetRationalWeights(weights);
    const Divided first = DividedOf(grid);
    ExpectError(grid, first, "threads");
    for (int i = 0; i < 5; ++i)
    {
      const Divided again = DividedOf(grid);
      const MeshPart &a = first.Parts.front(), &b = again.Parts.front();
      bool areSame = a.NumberOfPoints == b.NumberOfPoints;
      for (std::int64_t p = 0; p < a.NumberOfPoints && areSame; ++p)
      {
        areSame = At(a, p) == At(b, p);
      }
      Expect(areSame, "threads: the same points");
    }
  }
}

}

int TestSubdividedCells(int, char*[])
{
  TestFunctions();
  TestCurved();
  TestOneBent();
  TestBudget();
  TestMissing();
  TestThreads();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
