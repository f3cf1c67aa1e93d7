// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridShape.h"

#include <vtkCellArray.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

namespace TemporalCoherence
{

glm::ivec3 DimensionsOf(vtkDataSet* data)
{
  glm::ivec3 dimensions(0);
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(&dimensions.x);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(&dimensions.x);
  }
  else if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(data))
  {
    curvilinear->GetDimensions(&dimensions.x);
  }
  return dimensions;
}

vtkCellArray* CellsOf(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return grid->GetCells();
  }
  auto* grid = vtkExplicitStructuredGrid::SafeDownCast(data);
  return grid ? grid->GetCells() : nullptr;
}

}
