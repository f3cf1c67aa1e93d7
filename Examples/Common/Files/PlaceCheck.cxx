// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/PlaceCheck.h"

#include "Files/Arrays.h"
#include "Files/Drawn.h"
#include "Program/UserError.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace
{

// Filters of VTK believe that there are as many points as dimensions say.
bool IsWholeGrid(vtkDataSet* set)
{
  int n[3] = { 0, 0, 0 };
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(set))
  {
    grid->GetDimensions(n);
    vtkDataArray* const coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    return std::equal(coordinates, coordinates + 3, n,
      [](vtkDataArray* array, int count) { return array && array->GetNumberOfTuples() == count; });
  }
  if (auto* grid = vtkStructuredGrid::SafeDownCast(set))
  {
    grid->GetDimensions(n);
    return grid->GetPoints() &&
      grid->GetPoints()->GetNumberOfPoints() == static_cast<vtkIdType>(n[0]) * n[1] * n[2];
  }
  return true;
}

// How many points a linear cell has; 0 for cells of other types.
vtkIdType PointsOfType(int type)
{
  switch (type)
  {
    case VTK_TETRA:
      return 4;
    case VTK_PYRAMID:
      return 5;
    case VTK_WEDGE:
      return 6;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return 8;
    default:
      return 0;
  }
}

// Readers believe what files say of cells, and filters what readers say.
bool HasWholeCells(vtkUnstructuredGrid* grid)
{
  vtkCellArray* const cells = grid->GetCells();
  if (!cells)
  {
    return true;
  }
  const auto offsets = vtk::DataArrayValueRange<1>(cells->GetOffsetsArray());
  const auto points = vtk::DataArrayValueRange<1>(cells->GetConnectivityArray());
  const double count = static_cast<double>(grid->GetNumberOfPoints());
  const double size = static_cast<double>(points.size());
  double begin = 0.0;
  vtkIdType cell = -1;
  for (const double end : offsets)
  {
    const vtkIdType needed = cell < 0 ? 0 : PointsOfType(grid->GetCellType(cell));
    const double has = end - begin;
    if (has < 0.0 || end > size || (needed > 0 && has != static_cast<double>(needed)))
    {
      return false;
    }
    begin = end;
    ++cell;
  }
  return std::all_of(
    points.begin(), points.end(), [count](double point) { return point >= 0.0 && point < count; });
}

bool HasFinitePoints(vtkDataSet* set)
{
  auto* const points = vtkPointSet::SafeDownCast(set);
  if (!points || !points->GetPoints())
  {
    return true;
  }
  const auto coordinates = vtk::DataArrayValueRange<3>(points->GetPoints()->GetData());
  return std::all_of(coordinates.begin(), coordinates.end(),
    [](double coordinate) { return std::isfinite(coordinate); });
}

void RemoveUnfitting(vtkDataSetAttributes* attributes, vtkIdType tuples)
{
  for (int i = attributes->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (attributes->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
    {
      attributes->RemoveArray(i);
    }
  }
}

}

void RemoveUnfitting(vtkDataSet* set)
{
  RemoveUnfitting(set->GetPointData(), set->GetNumberOfPoints());
  RemoveUnfitting(set->GetCellData(), set->GetNumberOfCells());
}

bool CanBeSeen(const vtkVector3d& corner, const std::array<vtkVector3d, 3>& edges)
{
  constexpr double Largest = 1e15, Farthest = 1e9, Flattest = 1e-6;
  for (const vtkVector3d& v : { corner, edges[0], edges[1], edges[2] })
  {
    // False for what is no number, too.
    if (!(std::abs(v[0]) <= Largest && std::abs(v[1]) <= Largest && std::abs(v[2]) <= Largest))
    {
      return false;
    }
  }
  const std::array<double, 3> lengths = { edges[0].Norm(), edges[1].Norm(), edges[2].Norm() };
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  if (!(*shortest >= std::max(1.0 / Largest, Flattest * *longest)))
  {
    return false;
  }
  // Of edges at right angles it would be 1.
  const double upright =
    std::abs(edges[0].Cross(edges[1]).Dot(edges[2])) / (lengths[0] * lengths[1] * lengths[2]);
  return upright >= Flattest && corner.Norm() <= Farthest * *longest;
}

void CheckMesh(vtkDataObject* data, const std::string& name)
{
  vtkBoundingBox box;
  vtkIdType cells = 0;
  for (vtkDataSet* set : DataSetsOf(data))
  {
    if (!IsWholeGrid(set))
    {
      throw UserError(
        name + " has fewer or more points than its dimensions say; check that the file is whole.");
    }
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(set);
    if (grid && !HasWholeCells(grid))
    {
      throw UserError(
        name + " has cells with points that are not there; check that the file is whole.");
    }
    if (!HasFinitePoints(set))
    {
      throw UserError(name + " has points with coordinates that are no numbers; correct them.");
    }
    RemoveUnfitting(set);
    double bounds[6];
    set->GetBounds(bounds);
    box.AddBounds(bounds);
    cells += HasVolume(set) ? set->GetNumberOfCells() : 0;
  }
  if (cells == 0)
  {
    throw UserError(
      name + " has no cells with volume; check that the file is whole, or choose another.");
  }
  vtkVector3d corner, lengths;
  box.GetMinPoint(corner.GetData());
  box.GetLengths(lengths.GetData());
  if (!CanBeSeen(corner,
        { vtkVector3d(lengths[0], 0.0, 0.0), vtkVector3d(0.0, lengths[1], 0.0),
          vtkVector3d(0.0, 0.0, lengths[2]) }))
  {
    throw UserError(name +
      " has points with which it cannot be seen: it is flat, or they lie too far away, or are no "
      "numbers; correct them.");
  }
}
