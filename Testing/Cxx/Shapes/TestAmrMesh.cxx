// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The hexahedra between the cells of adaptive grids are those that a search at every vertex of the
// finest lattice finds. They fill the space between the cells' centres without a gap, and have the
// values of the cells.

#include "Adaptive/AmrMesh.h"
#include "Checks/Expect.h"
#include "LinearCells.h"
#include "Volumes/AmrGrids.h"
#include "Volumes/Ghosts.h"

#include <vtkAMRGaussianPulseSource.h>
#include <vtkAbstractMapper.h>
#include <vtkUnsignedCharArray.h>

#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <tuple>

namespace
{

using namespace TemporalCoherence;

/// The centre of a cell, rounded, so that it is the same in both meshes.
using Centre = std::tuple<long, long, long>;
using Hexahedron = std::array<Centre, 8>;

Centre Rounded(const glm::dvec3& at)
{
  return { std::lround(at.x * 1e6), std::lround(at.y * 1e6), std::lround(at.z * 1e6) };
}

/// A leaf: its level and place; level -1 where there is none.
struct Leaf
{
  int Level = -1;
  glm::ivec3 Cell{ 0 };
};

/// The finest cell that holds a cell of the finest lattice, by a search through all boxes.
Leaf FindLeaf(const AmrTestLevels& levels, const glm::ivec3& finest)
{
  for (std::size_t level = levels.Boxes.size(); level-- > 0;)
  {
    const glm::dvec3 at = glm::dvec3(finest) / static_cast<double>(levels.RatioToFinest(level));
    const glm::ivec3 cell(glm::floor(at));
    for (const AmrTestBox& box : levels.Boxes[level])
    {
      if (cell == glm::clamp(cell, box.First, box.Last))
      {
        return { static_cast<int>(level), cell };
      }
    }
  }
  return {};
}

glm::dvec3 CentreOf(const AmrTestLevels& levels, const Leaf& leaf)
{
  return levels.Origin +
    (glm::dvec3(leaf.Cell) + 0.5) * levels.SpacingOf(static_cast<std::size_t>(leaf.Level));
}

/// True if a vertex of the finest lattice is a corner of a leaf.
bool IsCorner(const AmrTestLevels& levels, const glm::ivec3& vertex, const Leaf& leaf)
{
  const int ratio = levels.RatioToFinest(static_cast<std::size_t>(leaf.Level));
  const glm::ivec3 off = vertex - leaf.Cell * ratio;
  return off % ratio == glm::ivec3(0);
}

/// The definition: for each vertex of the leaves the cells in its octants.
std::set<Hexahedron> ExpectedHexahedra(const AmrTestLevels& levels)
{
  std::set<Hexahedron> found;
  const glm::ivec3 end = (levels.Boxes[0].back().Last + 1) * levels.RatioToFinest(0);
  for (int v = 0; v < (end.x + 1) * (end.y + 1) * (end.z + 1); ++v)
  {
    const glm::ivec3 vertex(
      v % (end.x + 1), v / (end.x + 1) % (end.y + 1), v / (end.x + 1) / (end.y + 1));
    Hexahedron hexahedron;
    bool isVertex = false, isInside = true;
    for (int octant = 0; octant < 8; ++octant)
    {
      const Leaf leaf = FindLeaf(
        levels, vertex - glm::ivec3(octant & 1 ? 0 : 1, octant & 2 ? 0 : 1, octant & 4 ? 0 : 1));
      isInside &= leaf.Level >= 0;
      if (leaf.Level >= 0)
      {
        isVertex |= IsCorner(levels, vertex, leaf);
        hexahedron[static_cast<std::size_t>(octant)] = Rounded(CentreOf(levels, leaf));
      }
    }
    if (isVertex && isInside)
    {
      found.insert(hexahedron);
    }
  }
  return found;
}

ScalarChoice Values()
{
  ScalarChoice choice;
  choice.Mode = VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  choice.IsByName = true;
  choice.Name = "values";
  return choice;
}

MeshPart MeshOf(vtkOverlappingAMR* amr, const ScalarChoice& choice, const std::string& what)
{
  std::vector<MeshPart> parts;
  std::string error;
  Expect(AppendAmrMesh(amr, choice, 0, parts, error), what + ": a mesh is made " + error);
  return parts.empty() ? MeshPart() : parts.front();
}

/// Each hexahedron once.
std::set<Hexahedron> HexahedraOf(const MeshPart& part, const std::string& what)
{
  std::set<Hexahedron> found;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    MeshCell cell;
    ReadCell(part, c, cell);
    Hexahedron hexahedron;
    std::transform(cell.Points.begin(), cell.Points.end(), hexahedron.begin(), Rounded);
    Expect(found.insert(hexahedron).second, what + ": each hexahedron is there once");
  }
  return found;
}

double Function(const glm::dvec3& at)
{
  return at.x * at.y - 0.3 * at.z * at.z + std::sin(at.x + at.z);
}

void ExpectValues(const MeshPart& part, const std::string& what)
{
  Expect(
    HasValuesOf(Function, part, 1e-9), what + ": values are those of the cells, at their centres");
}

void TestRandom()
{
  std::size_t most = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    const std::string what = "random " + std::to_string(seed);
    const AmrTestLevels levels = RandomAmr(seed);
    const auto amr = MakeAmr(levels, Function);
    if (seed % 2 == 0)
    {
      vtkAMRUtilities::BlankCells(amr); // readers flag refined cells, but not all sources do
    }
    const MeshPart part = MeshOf(amr, Values(), what);
    const std::set<Hexahedron> expected = ExpectedHexahedra(levels);
    Expect(HexahedraOf(part, what) == expected,
      what + ": " + std::to_string(part.NumberOfCells) + " hexahedra, " +
        std::to_string(expected.size()) + " expected");
    ExpectValues(part, what);
    most = std::max(most, expected.size());
  }
  Expect(most > 2000, "some grids are large");
}

/// Levels that do not touch the surface of the whole: the hexahedra fill a box, none is inside out,
/// and each face inside of the box has a hexahedron on both sides.
void TestWatertight()
{
  for (const int ratio : { 2, 4 })
  {
    for (const int depth : { 1, 2 })
    {
      const std::string what =
        "ratio " + std::to_string(ratio) + ", " + std::to_string(depth + 1) + " levels";
      AmrTestLevels levels;
      levels.Spacing = { 1.0, 0.5, 1.25 };
      levels.Boxes = { CutBox({ glm::ivec3(0), glm::ivec3(7) }, 4) };
      levels.Boxes.push_back(CutBox(
        { glm::ivec3(2 * ratio), glm::ivec3(6 * ratio - 1, 5 * ratio - 1, 4 * ratio - 1) }, 5));
      levels.Ratios = { ratio };
      if (depth == 2)
      {
        const int first = (2 * ratio + 2) * ratio;
        levels.Boxes.push_back({ { glm::ivec3(first), glm::ivec3(first + 2 * ratio - 1) } });
        levels.Ratios.push_back(ratio);
      }
      const MeshPart part = MeshOf(MakeAmr(levels, Function), Values(), what);
      double sum = 0.0, least = 1e300;
      for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
      {
        MeshCell cell;
        ReadCell(part, c, cell);
        sum += VolumeOf(cell);
        least = std::min(least, VolumeOf(cell));
      }
      const double volume = 7.0 * 7.0 * 7.0 * 0.5 * 1.25;
      Expect(std::abs(sum - volume) < 1e-9 * volume, what + ": volume " + std::to_string(sum));
      Expect(least > 0.0, what + ": none is inside out: " + std::to_string(least));
      std::size_t single = 0;
      for (const auto& [face, count] : CountFaces(part))
      {
        Expect(count <= 2, what + ": a face has at most two hexahedra");
        single += count == 1;
      }
      Expect(single == 6 * 7 * 7, what + ": all other faces have two");
    }
  }
}

void TestHidden()
{
  AmrTestLevels levels;
  levels.Boxes = { CutBox({ glm::ivec3(0), glm::ivec3(5) }, 3),
    { { glm::ivec3(4), glm::ivec3(7) } } };
  levels.Ratios = { 2 };
  const auto amr = MakeAmr(levels, Function);
  const MeshPart whole = MeshOf(amr, Values(), "whole");
  vtkUniformGrid* fine = GridAt(amr, 1, 0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(fine->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(1 + 4 + 16, vtkDataSetAttributes::HIDDENCELL); // cell (1, 1, 1)
  ghosts->SetValue(0, vtkDataSetAttributes::DUPLICATECELL);       // is drawn
  fine->GetCellData()->AddArray(ghosts);
  const MeshPart part = MeshOf(amr, Values(), "with a hidden cell");
  Expect(whole.NumberOfCells - part.NumberOfCells == 8, "eight hexahedra need a hidden cell");
}

void TestPulse()
{
  vtkNew<vtkAMRGaussianPulseSource> source;
  source->SetDimension(3);
  source->Update();
  vtkOverlappingAMR* amr = source->GetOutput();
  Expect(!HasOneLevel(amr), "VTK's source has levels");
  ScalarChoice choice = Values();
  choice.Name = GridAt(amr, 0, 0)->GetCellData()->GetArray(0)->GetName();
  const MeshPart part = MeshOf(amr, choice, "VTK's source");
  std::cout << "VTK's source: " << part.NumberOfCells << " hexahedra, " << part.NumberOfPoints
            << " cells\n";
  double least = 1e300;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    MeshCell cell;
    ReadCell(part, c, cell);
    least = std::min(least, VolumeOf(cell));
  }
  Expect(part.NumberOfCells > 100 && least > 0.0, "VTK's source: none is inside out");
}

void ExpectError(vtkOverlappingAMR* amr, const ScalarChoice& choice, const std::string& part)
{
  std::vector<MeshPart> parts;
  std::string error;
  Expect(!AppendAmrMesh(amr, choice, 0, parts, error) && parts.empty(), "an error: " + part);
  Expect(error.find(part) != std::string::npos, "'" + error + "' tells '" + part + "'");
}

void TestErrors()
{
  AmrTestLevels levels;
  levels.Boxes = { { { glm::ivec3(0), glm::ivec3(3) } }, { { glm::ivec3(2), glm::ivec3(5) } } };
  levels.Ratios = { 2 };
  const auto amr = MakeAmr(levels, Function);
  ScalarChoice other = Values();
  other.Name = "nothing";
  ExpectError(amr, other, "nothing");

  vtkUniformGrid* fine = GridAt(amr, 1, 0);
  fine->SetOrigin(1.1, 1.0, 1.0);
  ExpectError(amr, Values(), "begins at 1.1");
  fine->SetOrigin(1.0, 1.0, 1.0);
  fine->SetSpacing(0.4, 0.5, 0.5);
  ExpectError(amr, Values(), "0.4");
  fine->SetSpacing(0.5, 0.5, 0.5);
  MeshOf(amr, Values(), "after all");
  for (const vtkIdType more : { -1, 1 })
  {
    Ghosts::AddFlags(fine->GetCellData(), fine->GetNumberOfCells() + more);
    ExpectError(amr, Values(), "Block 0 of level 1 has a ghost array 'vtkGhostType' of ");
  }
  fine->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  // More values than cells are those of other cells.
  for (const vtkIdType tuples : { vtkIdType(3), fine->GetNumberOfPoints() })
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName("values");
    values->SetNumberOfTuples(tuples);
    fine->GetCellData()->SetScalars(values);
    ExpectError(amr, Values(), "'values' of " + std::to_string(tuples) + " tuples, but 64 cells");
  }
}

}

int TestAmrMesh(int, char*[])
{
  TestRandom();
  TestWatertight();
  TestHidden();
  TestPulse();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
