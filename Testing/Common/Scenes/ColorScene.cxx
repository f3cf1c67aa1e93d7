// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/ColorScene.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>

namespace ColorArrays
{

void Add(vtkDataSet* data, bool onCells, const char* name, int type, int components)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  const vtkIdType count = onCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double at[6];
    if (onCells)
    {
      double bounds[6];
      data->GetCellBounds(i, bounds);
      for (int a = 0; a < 3; ++a)
      {
        at[a] = 0.5 * (bounds[2 * a] + bounds[2 * a + 1]);
      }
    }
    else
    {
      data->GetPoint(i, at);
    }
    for (int c = 0; c < components; ++c)
    {
      const double wave = std::sin(0.4 * at[0] + c) + std::cos(0.3 * at[1] - 0.5 * at[2]);
      array->SetComponent(i, c, 60.0 + 30.0 * wave);
    }
  }
  vtkDataSetAttributes* const to =
    onCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  to->AddArray(array);
}

void AddAll(vtkDataSet* data)
{
  Add(data, false, "heat", VTK_DOUBLE, 1);
  Add(data, false, "flow", VTK_FLOAT, 3);
  Add(data, true, "cell heat", VTK_UNSIGNED_SHORT, 1);
}

vtkSmartPointer<vtkImageData> Ball()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(17, 15, 14);
  image->SetOrigin(2.0, -3.0, 1.0);
  image->SetSpacing(1.0, 1.2, 0.9);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double at[3];
    image->GetPoint(i, at);
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, std::hypot(at[0] - 10.3, at[1] - 5.1, at[2] - 6.2));
  }
  AddAll(image);
  return image;
}

}

ColorScene::ColorScene(vtkDataObject* data)
  : Scene(nullptr, { Isovalue })
{
  this->Mapper->SetInputDataObject(data);
  this->Volume->GetProperty()->ShadeOff();
  auto* const colors = this->Volume->GetProperty()->GetRGBTransferFunction();
  colors->RemoveAllPoints();
  colors->AddRGBPoint(10.0, 0.0, 0.2, 1.0);
  colors->AddRGBPoint(60.0, 1.0, 0.9, 0.7);
  colors->AddRGBPoint(110.0, 0.9, 0.1, 0.0);
  this->LookFrom(1.0, 2.0, 0.7);
  this->ColorBy(false, "heat");
}

void ColorScene::ColorBy(bool onCells, const char* name, int component)
{
  this->Mapper->SetColorArrayName(name);
  this->Mapper->SetColorArrayOnCells(onCells);
  this->Mapper->SetColorArrayComponent(component);
}

vtkScalarsToColors* ColorScene::Table()
{
  return this->Mapper->GetColorTable() ? this->Mapper->GetColorTable()
                                       : this->Volume->GetProperty()->GetRGBTransferFunction();
}
