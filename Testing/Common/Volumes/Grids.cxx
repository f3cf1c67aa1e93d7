// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Grids.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace Grids
{
namespace
{

vtkDataArray* CoordinatesOf(vtkRectilinearGrid* grid, int axis)
{
  return axis == 0 ? grid->GetXCoordinates()
    : axis == 1    ? grid->GetYCoordinates()
                   : grid->GetZCoordinates();
}

}

std::vector<double> Even(int n)
{
  return FineInside(n, 0.0);
}

std::vector<double> FineInside(int n, double bend)
{
  constexpr double Pi = 3.14159265358979323846;
  std::vector<double> along;
  for (int i = 0; i < n; ++i)
  {
    const double s = 2.0 * i / (n - 1) - 1.0;
    along.push_back(s - bend * std::sin(Pi * s) / Pi);
  }
  return along;
}

std::vector<double> Random(int n, double ratio, unsigned int seed)
{
  std::mt19937 engine(seed);
  std::vector<double> along = { 0.0 };
  for (int i = 1; i < n; ++i)
  {
    const double share = 1e-3 * static_cast<double>(engine() % 1001u);
    along.push_back(along.back() + std::pow(ratio, share));
  }
  const double length = along.back();
  for (double& at : along)
  {
    at = 2.0 * at / length - 1.0;
  }
  return along;
}

void SetCoordinates(vtkRectilinearGrid* grid, int axis, const std::vector<double>& along, int type)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  for (const double at : along)
  {
    array->InsertNextTuple1(at);
  }
  axis == 0     ? grid->SetXCoordinates(array)
    : axis == 1 ? grid->SetYCoordinates(array)
                : grid->SetZCoordinates(array);
}

vtkSmartPointer<vtkRectilinearGrid> FromFormula(const Coordinates& along, int scalarType,
  const std::function<double(double, double, double)>& value)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(static_cast<int>(along[0].size()), static_cast<int>(along[1].size()),
    static_cast<int>(along[2].size()));
  for (int axis = 0; axis < 3; ++axis)
  {
    SetCoordinates(grid, axis, along[static_cast<std::size_t>(axis)]);
  }
  const auto scalars =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType));
  for (const double z : along[2])
  {
    for (const double y : along[1])
    {
      for (const double x : along[0])
      {
        scalars->InsertNextTuple1(value(x, y, z));
      }
    }
  }
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

vtkSmartPointer<vtkRectilinearGrid> FromImage(vtkImageData* image, int coordinateType)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  int dimensions[3];
  image->GetDimensions(dimensions);
  grid->SetDimensions(dimensions);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> along;
    for (int i = 0; i < dimensions[axis]; ++i)
    {
      along.push_back(image->GetOrigin()[axis] + i * image->GetSpacing()[axis]);
    }
    SetCoordinates(grid, axis, along, coordinateType);
  }
  grid->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  grid->GetCellData()->PassData(image->GetCellData());
  return grid;
}

vtkSmartPointer<vtkRectilinearGrid> Reversed(
  vtkRectilinearGrid* grid, const std::array<bool, 3>& axes)
{
  auto other = vtkSmartPointer<vtkRectilinearGrid>::New();
  int n[3];
  grid->GetDimensions(n);
  other->SetDimensions(n);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> along;
    for (int i = 0; i < n[axis]; ++i)
    {
      along.push_back(CoordinatesOf(grid, axis)->GetTuple1(i));
    }
    if (axes[static_cast<std::size_t>(axis)])
    {
      std::reverse(along.begin(), along.end());
    }
    SetCoordinates(other, axis, along);
  }
  vtkDataArray* samples = grid->GetPointData()->GetScalars();
  const auto reversed = vtkSmartPointer<vtkDataArray>::Take(samples->NewInstance());
  reversed->SetNumberOfTuples(samples->GetNumberOfTuples());
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    vtkIdType at[3] = { i % n[0], i / n[0] % n[1], i / n[0] / n[1] };
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = axes[static_cast<std::size_t>(axis)] ? n[axis] - 1 - at[axis] : at[axis];
    }
    reversed->SetTuple(i, (at[2] * n[1] + at[1]) * n[0] + at[0], samples);
  }
  other->GetPointData()->SetScalars(reversed);
  return other;
}

}
