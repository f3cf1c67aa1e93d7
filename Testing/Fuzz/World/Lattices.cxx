// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "World/Arrays.h"
#include "World/Inputs.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Fuzz
{
namespace Inputs
{
namespace
{

// Since VTK 9.6 coordinates with several components end the program.
constexpr int MostComponents = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0) ? 1 : 2;

vtkSmartPointer<vtkDataArray> MakeCoordinates(World& world, int count)
{
  Bytes& from = world.From;
  vtkSmartPointer<vtkDataArray> array = vtkSmartPointer<vtkDoubleArray>::New();
  if (from.OneIn(4))
  {
    array = vtkSmartPointer<vtkFloatArray>::New();
  }
  else if (from.OneIn(8))
  {
    array = vtkSmartPointer<vtkIntArray>::New();
  }
  array->SetNumberOfComponents(std::min(from.OneIn(30) ? 2 : 1, MostComponents));
  array->SetNumberOfTuples(count);
  array->Fill(0.0);
  const int kind = from.Pick(6);
  const double sign = from.OneIn(4) ? -1.0 : 1.0;
  double at = from.OneIn(4) ? from.Between(-20.0, 20.0) : 0.0;
  for (int i = 0; i < count; ++i)
  {
    array->SetComponent(i, 0, at);
    const double steps[] = { 1.0, 1.0 + 0.2 * i, from.Between(1.0, 3.0), std::pow(2.0, i % 9),
      1.0 + 1e-6 * i, i % 2 ? 1.0 : 4.0 };
    at += sign * steps[kind];
  }
  std::string fault;
  if (count > 0 && from.IsWild())
  {
    const int where = from.Pick(count);
    const double values[] = { array->GetComponent(0, 0), std::numeric_limits<double>::quiet_NaN(),
      from.Wild(), array->GetComponent(where, 0) + 1e-14, -1e9 };
    double value = from.OneOf(values);
    if (array->GetDataType() == VTK_INT)
    {
      value = std::isfinite(value) ? std::min(std::max(value, -2e9), 2e9) : 0.0;
    }
    else if (array->GetDataType() == VTK_FLOAT && std::abs(value) > 3e38)
    {
      value = std::numeric_limits<double>::infinity();
    }
    array->SetComponent(where, 0, value);
    Story::Tell("  coordinate ", where, " is ", value);
  }
  if (from.IsWild())
  {
    array->SetNumberOfTuples(from.OneIn(2) ? 0 : count + 1);
  }
  return array;
}

}

vtkSmartPointer<vtkDataObject> MakeGrid(World& world)
{
  Bytes& from = world.From;
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  int points[3];
  for (int& length : points)
  {
    length = 3 + from.Pick(8) - (from.OneIn(15) ? 3 : 0);
  }
  const int first = from.OneIn(6) ? from.Pick(11) - 5 : 0;
  grid->SetExtent(first, first + points[0] - 1, 0, points[1] - 1, -first, points[2] - 1 - first);
  Story::Tell("  a grid of ", points[0], " x ", points[1], " x ", points[2]);
  grid->SetXCoordinates(MakeCoordinates(world, points[0]));
  grid->SetYCoordinates(MakeCoordinates(world, points[1]));
  if (!from.IsWild() || !from.OneIn(4))
  {
    grid->SetZCoordinates(MakeCoordinates(world, points[2]));
  }
  const bool onCells = from.OneIn(5);
  int cells[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[axis] = points[axis] > 1 ? points[axis] - 1 : points[axis];
  }
  const auto array = Arrays::Make(world, Arrays::PlacesOf(onCells ? cells : points));
  Arrays::Survey(world, array);
  (onCells ? static_cast<vtkDataSetAttributes*>(grid->GetCellData()) : grid->GetPointData())
    ->SetScalars(array);
  if (from.OneIn(10))
  {
    Arrays::AddGhosts(world, grid->GetPointData(), grid->GetNumberOfPoints());
  }
  if (from.OneIn(10))
  {
    Arrays::AddGhosts(world, grid->GetCellData(), grid->GetNumberOfCells());
  }
  return grid;
}

namespace
{

/// A block on the lattice of the first one, beside it, over it or away from it; or something else.
vtkSmartPointer<vtkDataObject> MakeBlock(World& world, vtkImageData* first)
{
  Bytes& from = world.From;
  if (from.IsWild())
  {
    switch (from.Pick(5))
    {
      case 0:
        return nullptr;
      case 1:
        return MakeImage(world);
      case 2:
        return vtkSmartPointer<vtkPolyData>::New();
      case 3:
        return vtkSmartPointer<vtkImageData>::New();
      default:
        return MakeGrid(world);
    }
  }
  int extent[6], points[3];
  first->GetExtent(extent);
  const int axis = from.Pick(3);
  const int length = extent[2 * axis + 1] - extent[2 * axis];
  const int shifts[] = { length, length, -length, length + 2, length - 1, 0, 5 * length };
  const int shift = from.OneOf(shifts);
  if (std::abs(static_cast<double>(extent[2 * axis]) + 2.0 * shift) > 1e9)
  {
    return nullptr;
  }
  const auto block = vtkSmartPointer<vtkImageData>::New();
  const bool byOrigin = from.OneIn(3);
  block->SetSpacing(first->GetSpacing());
  block->SetDirectionMatrix(first->GetDirectionMatrix());
  double origin[3];
  first->GetOrigin(origin);
  if (byOrigin)
  {
    for (int row = 0; row < 3; ++row)
    {
      origin[row] +=
        first->GetDirectionMatrix()->GetElement(row, axis) * first->GetSpacing()[axis] * shift;
    }
  }
  else
  {
    extent[2 * axis] += shift;
    extent[2 * axis + 1] += shift;
  }
  block->SetOrigin(origin);
  block->SetExtent(extent);
  block->GetDimensions(points);
  const bool onCells = first->GetPointData()->GetScalars() == nullptr;
  vtkDataArray* model =
    onCells ? first->GetCellData()->GetScalars() : first->GetPointData()->GetScalars();
  if (!model)
  {
    return block;
  }
  int samples[3];
  for (int a = 0; a < 3; ++a)
  {
    samples[a] = onCells && points[a] > 1 ? points[a] - 1 : points[a];
  }
  const auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(model->GetDataType()));
  array->SetName(model->GetName());
  array->SetNumberOfComponents(model->GetNumberOfComponents());
  array->SetNumberOfTuples(model->GetNumberOfTuples());
  if (array->GetNumberOfTuples() > 0)
  {
    array->Fill(0.0);
  }
  Arrays::Rewrite(world, array, Arrays::PlacesOf(samples), true);
  (onCells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData())
    ->SetScalars(array);
  if (from.OneIn(6))
  {
    Arrays::AddGhosts(world, block->GetCellData(), block->GetNumberOfCells());
  }
  Story::Tell(
    "  a block shifted by ", shift, " along axis ", axis, byOrigin ? ", by its origin" : "");
  return block;
}

}

vtkSmartPointer<vtkDataObject> MakeBlocks(World& world)
{
  Bytes& from = world.From;
  Story::Tell("  blocks, the first of them:");
  const vtkSmartPointer<vtkImageData> first = MakeImage(world);
  const int count = from.Pick(4);
  const auto image = [&](int i)
  { return i == 0 ? vtkSmartPointer<vtkDataObject>(first) : MakeBlock(world, first); };
  if (first->GetNumberOfPoints() < 0 || first->GetNumberOfPoints() > 100000)
  {
    return first;
  }
  if (from.OneIn(3))
  {
    const auto all = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    for (int i = 0; i < count; ++i)
    {
      vtkNew<vtkPartitionedDataSet> set;
      set->SetPartition(0, image(i));
      all->SetPartitionedDataSet(static_cast<unsigned>(i), set);
    }
    return all;
  }
  const auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int i = 0; i < count; ++i)
  {
    if (from.OneIn(5))
    {
      vtkNew<vtkMultiBlockDataSet> inner;
      inner->SetBlock(0, image(i));
      all->SetBlock(static_cast<unsigned>(i), inner);
    }
    else
    {
      all->SetBlock(static_cast<unsigned>(i), image(i));
    }
  }
  return all;
}

}
}
