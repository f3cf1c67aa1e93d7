// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Linear cells made of polyhedra, prisms and convex sets of points fill the space of the grid.
// Neighbours of any type share all points of their faces, and linear fields stay linear. Wrong
// cells get one sentence.

#include "Checks/Expect.h"
#include "LinearCells.h"
#include "Shapes/SubdividedCells.h"
#include "Volumes/CurvedGrids.h"
#include "Volumes/VtkMeshes.h"

#include <vtkCellArray.h>
#include <vtkCellTypeSource.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

using namespace TemporalCoherence;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Corners = std::vector<vtkIdType>;

double Linear(const glm::dvec3& at)
{
  return 2.0 * at.x - 3.0 * at.y + 0.5 * at.z + 1.0;
}

MeshPart PartOf(vtkUnstructuredGrid* grid, const std::string& what)
{
  std::vector<MeshPart> parts;
  std::string error;
  Subdivision told;
  Expect(AppendSubdividedCells(
           grid, grid->GetPointData()->GetScalars(), 0, nullptr, 0, parts, error, &told),
    what + ": cells are made " + error);
  Expect(told.Others == grid->GetNumberOfCells(), what + ": all cells count");
  return parts.empty() ? MeshPart() : parts.front();
}

/// Prisms over a pattern of hexagons, in layers.
class Honeycomb
{
public:
  /// \param typeOf of each cell: a polyhedron, or a hexagonal prism
  Honeycomb(int across, int layers, const std::function<int(int)>& typeOf)
  {
    this->Points->SetDataTypeToDouble();
    for (int c = 0; c < across * across * layers; ++c)
    {
      const int column = c % across, row = c / across % across, layer = c / across / across;
      Corners ends;
      for (int corner = 0; corner < 12; ++corner)
      {
        const double angle = (corner % 6 + 0.5) * 3.14159265358979323846 / 3.0;
        ends.push_back(
          this->PointAt({ std::sqrt(3.0) * (column + 0.5 * (row % 2)) + std::cos(angle),
            1.5 * row + std::sin(angle), double(layer + corner / 6) }));
      }
      if (typeOf(c) == VTK_POLYHEDRON)
      {
        this->AddPolyhedron(ends);
      }
      else
      {
        this->Made->InsertNextCell(VTK_HEXAGONAL_PRISM, 12, ends.data());
      }
    }
    this->Made->SetPoints(this->Points);
  }

  Grid Made = Grid::New();

private:
  vtkIdType PointAt(const glm::dvec3& at)
  {
    const std::array<long, 3> key{ std::lround(at.x * 1e6), std::lround(at.y * 1e6),
      std::lround(at.z * 1e6) };
    const auto found = this->Known.emplace(key, this->Points->GetNumberOfPoints());
    if (found.second)
    {
      this->Points->InsertNextPoint(at.x, at.y, at.z);
    }
    return found.first->second;
  }

  /// Its faces begin with any corner.
  void AddPolyhedron(const Corners& ends)
  {
    Corners stream;
    for (std::size_t face = 0; face < 6; ++face)
    {
      const std::size_t next = (face + 1) % 6;
      stream.insert(stream.end(), { 4, ends[next], ends[6 + next], ends[6 + face], ends[face] });
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
      stream.push_back(6);
      for (std::size_t corner = 0; corner < 6; ++corner)
      {
        stream.push_back(ends[6 * end + (corner + 2 * end) % 6]);
      }
    }
    this->Made->InsertNextCell(VTK_POLYHEDRON, 12, ends.data(), 8, stream.data());
  }

  vtkNew<vtkPoints> Points;
  std::map<std::array<long, 3>, vtkIdType> Known;
};

void GiveLinear(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 at;
    grid->GetPoint(p, &at.x);
    values->InsertNextValue(Linear(at));
  }
  grid->GetPointData()->SetScalars(values);
}

void ExpectLinear(const MeshPart& part, const std::string& what)
{
  Expect(HasValuesOf(Linear, part, 1e-12), what + ": a linear field stays linear");
}

void ExpectSpace(
  const MeshPart& part, double volume, std::size_t outerFaces, const std::string& what)
{
  double sum = 0.0;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    MeshCell cell;
    ReadCell(part, c, cell);
    sum += std::abs(VolumeOf(cell)); // polyhedra are not turned in any direction
  }
  Expect(std::abs(sum - volume) < 1e-9 * volume,
    what + ": volume " + std::to_string(sum) + ", not " + std::to_string(volume));
  std::size_t single = 0;
  for (const auto& [face, count] : CountFaces(part))
  {
    Expect(count <= 2, what + ": a face has at most two cells");
    single += count == 1;
  }
  Expect(single == outerFaces,
    what + ": " + std::to_string(single) + " faces with one cell, not " +
      std::to_string(outerFaces));
}

void TestHoneycomb()
{
  for (const int kind : { 0, 1, 2 })
  {
    const std::string what = kind == 0 ? "polyhedra" : kind == 1 ? "prisms" : "both";
    const Honeycomb comb(4, 3,
      [&](int cell)
      { return kind == 0 || (kind == 2 && cell % 3 == 1) ? VTK_POLYHEDRON : VTK_HEXAGONAL_PRISM; });
    GiveLinear(comb.Made);
    const MeshPart part = PartOf(comb.Made, what);
    ExpectLinear(part, what);
    // A rhombus of 4 x 4 hexagons has 30 edges around it: 6 * 16, without twice the 33 inner ones.
    ExpectSpace(part, 16 * 3 * 1.5 * std::sqrt(3.0), 30 * 3 + 2 * 16 * 6, what);
  }
}

double SumOfVolumes(const MeshPart& part)
{
  double sum = 0.0;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    MeshCell cell;
    ReadCell(part, c, cell);
    sum += std::abs(VolumeOf(cell));
  }
  return sum;
}

void TestOthers()
{
  for (const int type : { VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM })
  {
    vtkNew<vtkCellTypeSource> source;
    source->SetCellType(type);
    source->SetBlocksDimensions(2, 2, 2);
    source->Update();
    const Grid grid = Grid::New();
    grid->DeepCopy(source->GetOutput());
    GiveLinear(grid);
    const std::string what = "VTK's source of type " + std::to_string(type);
    const MeshPart part = PartOf(grid, what);
    const double sum = SumOfVolumes(part);
    Expect(std::abs(sum - 8.0) < 1e-5, what + ": volume " + std::to_string(sum));
    ExpectLinear(part, what);
  }
  const Grid sets = TileCubes(VTK_CONVEX_POINT_SET, HexahedronPattern(VTK_HEXAHEDRON), 3);
  GiveLinear(sets);
  const MeshPart part = PartOf(sets, "convex sets");
  ExpectLinear(part, "convex sets");
  ExpectSpace(part, 1.0, 6 * 9 * 2, "convex sets");
}

/// Thin convex sets are filled, and points that are no numbers are left out.
void TestConvexSets()
{
  for (const double thickness : { 0.3, 0.1, 1e-3, 1e-6 })
  {
    const std::string what = "convex sets " + std::to_string(thickness) + " thin";
    const Grid sets = TileCubes(VTK_CONVEX_POINT_SET, HexahedronPattern(VTK_HEXAHEDRON), 3);
    for (vtkIdType p = 0; p < sets->GetNumberOfPoints(); ++p)
    {
      double at[3];
      sets->GetPoint(p, at);
      sets->GetPoints()->SetPoint(p, at[0], at[1], thickness * at[2]);
    }
    GiveLinear(sets);
    const MeshPart part = PartOf(sets, what);
    ExpectLinear(part, what);
    ExpectSpace(part, thickness, 6 * 9 * 2, what);
    for (vtkIdType p = 0; p < sets->GetNumberOfPoints(); ++p)
    {
      double at[3];
      sets->GetPoint(p, at);
      sets->GetPoints()->SetPoint(p, at[0] + at[2], at[1] + 0.5 * at[0], at[2] - 0.7 * at[0]);
    }
    const double share = SumOfVolumes(PartOf(sets, what + ", turned")) / thickness;
    const glm::dvec3 x(1.0, 0.5, -0.7), y(0.0, 1.0, 0.0), z(1.0, 0.0, 1.0);
    const double expected = glm::dot(glm::cross(x, y), z);
    Expect(std::abs(share / expected - 1.0) < 1e-3, what + ", turned: " + std::to_string(share));
  }
  const Grid set = TileCubes(VTK_CONVEX_POINT_SET, HexahedronPattern(VTK_HEXAHEDRON), 1);
  const vtkIdType nowhere = set->GetPoints()->InsertNextPoint(std::nan(""), 0.0, 0.0);
  vtkNew<vtkIdList> ids;
  set->GetCellPoints(0, ids);
  ids->InsertNextId(nowhere);
  const Grid withNowhere = Grid::New();
  withNowhere->SetPoints(set->GetPoints());
  withNowhere->InsertNextCell(VTK_CONVEX_POINT_SET, ids);
  GiveLinear(withNowhere);
  const double volume = SumOfVolumes(PartOf(withNowhere, "a point nowhere"));
  Expect(std::abs(volume - 1.0) < 1e-9, "a point nowhere: volume " + std::to_string(volume));
}

/// A cell with a point that has no value is left out as a whole.
void TestWithoutValues()
{
  const Grid sets = TileCubes(VTK_CONVEX_POINT_SET, HexahedronPattern(VTK_HEXAHEDRON), 3);
  GiveLinear(sets);
  sets->GetPointData()->GetScalars()->SetComponent(0, 0, std::nan("")); // a corner of one cell
  const double volume = SumOfVolumes(PartOf(sets, "a convex set without a value"));
  Expect(std::abs(volume - 26.0 / 27.0) < 1e-9,
    "a convex set without a value: volume " + std::to_string(volume));
}

/// A cell with a flag is left out, and its neighbours keep their numbers.
void TestHidden()
{
  const Honeycomb comb(
    2, 1, [](int cell) { return cell % 2 ? VTK_POLYHEDRON : VTK_HEXAGONAL_PRISM; });
  GiveLinear(comb.Made);
  const std::array<std::uint8_t, 4> flags{ 0, 2, 0, 1 };
  std::vector<MeshPart> parts;
  std::string error;
  Expect(AppendSubdividedCells(comb.Made.Get(), comb.Made->GetPointData()->GetScalars(), 0,
           flags.data(), 2, parts, error) &&
      parts.size() == 1,
    "cells are made");
  std::map<std::int64_t, int> originals;
  for (std::int64_t c = 0; c < parts.front().NumberOfCells; ++c)
  {
    ++originals[parts.front().Originals.IdAt(c)];
  }
  const std::map<std::int64_t, int> expected{ { 0, 6 }, { 2, 6 }, { 3, 6 + 2 * 6 } };
  Expect(originals == expected, "cells have their numbers, and that with the flag is left out");
}

void ExpectError(const GivenCells& cells, const std::string& part)
{
  vtkUnstructuredGrid* const grid = cells.Grid;
  std::vector<MeshPart> parts;
  std::string error;
  Expect(!AppendSubdividedCells(
           cells, grid->GetPointData()->GetScalars(), 0, nullptr, 0, parts, error) &&
      parts.empty(),
    "an error: " + part);
  Expect(error.find(part) != std::string::npos, "'" + error + "' tells '" + part + "'");
}

Grid WithCell(int type, const Corners& ids)
{
  const Grid grid = TileCubes(VTK_HEXAHEDRON, HexahedronPattern(VTK_HEXAHEDRON), 3);
  grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  GiveLinear(grid);
  return grid;
}

void TestErrors()
{
  ExpectError(WithCell(VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8 }).Get(),
    "Cell 27 of the input is a VTK_QUADRATIC_TETRA with 9 points, but needs 10");
  ExpectError(WithCell(VTK_LAGRANGE_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7, 8 }).Get(),
    "Cell 27 of the input is a VTK_LAGRANGE_HEXAHEDRON with 9 points");
  ExpectError(
    WithCell(VTK_HEXAGONAL_PRISM, { 0, 1, 2, 3, 4, 5, 6, 7 }).Get(), "8 points, but needs 12");
  ExpectError(WithCell(VTK_PENTAGONAL_PRISM, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 99 }).Get(),
    "has the point 99, but");
  // Cells of other types are not looked at.
  std::vector<MeshPart> parts;
  std::string error;
  const Grid grid = WithCell(VTK_TETRA, { 0, 1, 99 });
  Expect(AppendSubdividedCells(
           grid.Get(), grid->GetPointData()->GetScalars(), 0, nullptr, 0, parts, error) &&
      parts.empty(),
    "nothing to do");
}

/// An offset that is wrong by much or little, before or after its array.
void TestWrongOffsets()
{
  for (const int type : { VTK_QUADRATIC_HEXAHEDRON, VTK_CONVEX_POINT_SET })
  {
    for (const double wrong : { -1.0, -1e12, -9e18, 7.0, 1e6, 1e8, 1e12, 9e18 })
    {
      const Grid grid = TileCubes(type, HexahedronPattern(type), 2);
      GiveLinear(grid);
      grid->GetCells()->GetOffsetsArray()->SetComponent(3, 0, wrong);
      ExpectError({ grid, "Block 2 ('rotor')" },
        "Cell 2 of Block 2 ('rotor') has points that begin or end outside of the ");
    }
  }
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) // later ones have no stream of faces

/// Wrong numbers of faces and points, and wrong places of them.
void TestWrongFaces()
{
  const auto expect =
    [](const std::string& part, const std::function<void(vtkUnstructuredGrid*)>& spoil)
  {
    const Honeycomb comb(2, 1, [](int) { return VTK_POLYHEDRON; });
    GiveLinear(comb.Made);
    spoil(comb.Made);
    ExpectError(comb.Made.Get(), part);
  };
  const auto outside = [&](vtkIdType at, vtkIdType wrong)
  {
    expect("Cell 0 of the input is a VTK_POLYHEDRON with faces that begin or end outside",
      [=](vtkUnstructuredGrid* grid) { grid->GetFaces()->SetValue(at, wrong); });
  };
  for (const vtkIdType wrong : { vtkIdType(-1), vtkIdType(1000000000), vtkIdType(1) << 62 })
  {
    outside(0, wrong); // faces
    outside(1, wrong); // points of the first face
    expect("Cell 0 of the input is a VTK_POLYHEDRON with faces that name points which are not",
      [=](vtkUnstructuredGrid* grid) { grid->GetFaces()->SetValue(2, wrong); });
  }
  for (const vtkIdType wrong : { vtkIdType(-2), vtkIdType(1) << 40 })
  {
    expect("Cell 1 of the input is a VTK_POLYHEDRON with faces that begin or end outside",
      [=](vtkUnstructuredGrid* grid) { grid->GetFaceLocations()->SetValue(1, wrong); });
  }
  expect("Cell 2 of the input is a VTK_POLYHEDRON with faces that begin or end outside",
    [](vtkUnstructuredGrid* grid) { grid->GetFaceLocations()->SetNumberOfValues(2); });
  for (const bool hasLocation : { false, true })
  {
    expect("Cell 3 of the input is a VTK_POLYHEDRON without faces",
      [=](vtkUnstructuredGrid* grid)
      {
        const vtkIdType location = grid->GetFaceLocations()->GetValue(3);
        grid->GetFaces()->SetValue(location, 0);
        grid->GetFaceLocations()->SetValue(3, hasLocation ? location : -1);
      });
  }
}

#endif

void TestWithoutFaces()
{
  const Grid grid = WithCell(VTK_HEXAHEDRON, { 0, 1, 4, 3, 9, 10, 13, 12 });
  VtkMeshes::TypesOf(grid)->SetComponent(5, 0, VTK_POLYHEDRON);
  ExpectError(grid.Get(), "Cell 5 of the input is a VTK_POLYHEDRON without faces; give them");
}

/// All points of a cell at one place, or on a line, or one of them NaN: no crash, no endless loop.
void TestDegenerate()
{
  const Grid grid = Grid::New();
  grid->DeepCopy(
    TileCubes(VTK_TRIQUADRATIC_HEXAHEDRON, HexahedronPattern(VTK_TRIQUADRATIC_HEXAHEDRON), 2));
  Bend(grid, 1.0, 0.05, 0.1);
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); p += 3)
  {
    grid->GetPoints()->SetPoint(p, 0.0, 0.0, p % 2 ? std::nan("") : 0.0);
  }
  const Corners same(27, 5);
  grid->InsertNextCell(VTK_TRIQUADRATIC_HEXAHEDRON, 27, same.data());
  std::vector<MeshPart> parts;
  std::string error;
  Expect(AppendSubdividedCells(
           grid.Get(), grid->GetPointData()->GetScalars(), 0, nullptr, 0, parts, error),
    "degenerate cells are divided " + error);
}

}

int TestPolyhedronCells(int, char*[])
{
  TestHoneycomb();
  TestOthers();
  TestConvexSets();
  TestWithoutValues();
  TestHidden();
  TestErrors();
  TestWrongOffsets();
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  TestWrongFaces();
#endif
  TestWithoutFaces();
  TestDegenerate();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
