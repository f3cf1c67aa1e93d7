// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/VtkMeshes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkVersionMacros.h>

#include <array>
#include <vector>

namespace VtkMeshes
{
namespace
{

/// Corners of a voxel, x + 2 y + 4 z, of each cell that it is divided into, in VTK's order; 8 is
/// the middle.
std::vector<std::vector<int>> DivisionInto(int cellType)
{
  switch (cellType)
  {
    case VTK_VOXEL:
      return { { 0, 1, 2, 3, 4, 5, 6, 7 } };
    case VTK_HEXAHEDRON:
      return { { 0, 1, 3, 2, 4, 5, 7, 6 } };
    case VTK_WEDGE:
      return { { 0, 1, 3, 4, 5, 7 }, { 0, 3, 2, 4, 7, 6 } };
    case VTK_TETRA: // around the diagonal from 0 to 7
      return { { 0, 1, 3, 7 }, { 0, 3, 2, 7 }, { 0, 2, 6, 7 }, { 0, 6, 4, 7 }, { 0, 4, 5, 7 },
        { 0, 5, 1, 7 } };
    default: // pyramids, the base of each a face
      return { { 0, 1, 3, 2, 8 }, { 4, 6, 7, 5, 8 }, { 0, 4, 5, 1, 8 }, { 2, 3, 7, 6, 8 },
        { 0, 2, 6, 4, 8 }, { 1, 5, 7, 3, 8 } };
  }
}

/// The mean of points of an image.
void AppendMean(vtkDataArray* array, const std::array<vtkIdType, 9>& corners)
{
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < 8; ++i)
    {
      sum += array->GetComponent(corners[i], c);
    }
    array->InsertComponent(corners[8], c, sum / 8.0);
  }
}

/// Point arrays of a grid that gets further points: copies.
void CopyPointData(vtkImageData* image, vtkDataSet* grid)
{
  grid->GetPointData()->DeepCopy(image->GetPointData());
}

vtkIdType PointAt(vtkImageData* image, int i, int j, int k)
{
  const int* n = image->GetDimensions();
  return i + static_cast<vtkIdType>(n[0]) * (j + static_cast<vtkIdType>(n[1]) * k);
}

}

vtkSmartPointer<vtkPoints> PointsOf(vtkImageData* image, int type)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, image->GetPoint(i));
  }
  return points;
}

vtkSmartPointer<vtkUnstructuredGrid> Unstructured(vtkImageData* image, int cellType)
{
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto points = PointsOf(image);
  cellType == VTK_PYRAMID ? CopyPointData(image, grid)
                          : grid->GetPointData()->ShallowCopy(image->GetPointData());
  grid->GetCellData()->CopyAllocate(image->GetCellData());
  const auto division = DivisionInto(cellType);
  const int* n = image->GetDimensions();
  vtkIdType voxel = 0;
  for (int k = 0; k + 1 < n[2]; ++k)
  {
    for (int j = 0; j + 1 < n[1]; ++j)
    {
      for (int i = 0; i + 1 < n[0]; ++i, ++voxel)
      {
        std::array<vtkIdType, 9> corners{};
        for (int c = 0; c < 8; ++c)
        {
          corners[static_cast<std::size_t>(c)] =
            PointAt(image, i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
        }
        if (cellType == VTK_PYRAMID)
        {
          corners[8] = points->GetNumberOfPoints();
          AppendMean(points->GetData(), corners);
          points->Modified();
          for (int a = 0; a < grid->GetPointData()->GetNumberOfArrays(); ++a)
          {
            AppendMean(grid->GetPointData()->GetArray(a), corners);
          }
        }
        for (const std::vector<int>& part : division)
        {
          std::vector<vtkIdType> ids;
          for (const int corner : part)
          {
            ids.push_back(corners[static_cast<std::size_t>(corner)]);
          }
          const vtkIdType cell =
            grid->InsertNextCell(cellType, static_cast<vtkIdType>(ids.size()), ids.data());
          grid->GetCellData()->CopyData(image->GetCellData(), voxel, cell);
        }
      }
    }
  }
  grid->SetPoints(points);
  return grid;
}

vtkDataArray* TypesOf(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

vtkSmartPointer<vtkStructuredGrid> Curvilinear(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(image->GetDimensions());
  grid->SetPoints(PointsOf(image, VTK_FLOAT));
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return grid;
}

vtkSmartPointer<vtkExplicitStructuredGrid> Explicit(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkExplicitStructuredGrid>::New();
  grid->SetDimensions(image->GetDimensions());
  grid->SetPoints(PointsOf(image));
  grid->SetCells(Unstructured(image, VTK_HEXAHEDRON)->GetCells());
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return grid;
}

vtkSmartPointer<vtkRectilinearGrid> Rectilinear(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  const int* n = image->GetDimensions();
  grid->SetDimensions(n);
  std::array<vtkSmartPointer<vtkDoubleArray>, 3> axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    auto& along = axes[static_cast<std::size_t>(axis)];
    along = vtkSmartPointer<vtkDoubleArray>::New();
    for (int i = 0; i < n[axis]; ++i)
    {
      along->InsertNextValue(image->GetOrigin()[axis] + i * image->GetSpacing()[axis]);
    }
  }
  grid->SetXCoordinates(axes[0]);
  grid->SetYCoordinates(axes[1]);
  grid->SetZCoordinates(axes[2]);
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return grid;
}

}
