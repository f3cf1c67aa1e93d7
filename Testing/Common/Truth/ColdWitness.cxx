// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/ColdWitness.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// The first of blocks, which are all alike.
vtkDataObject* FirstOf(vtkDataObject* data)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return data;
  }
  const auto leaves = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  leaves->InitTraversal();
  return leaves->GetCurrentDataObject();
}

/// Shortest distance between neighbouring samples along an axis.
double SpacingOf(vtkDataObject* data, int axis)
{
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!grid)
  {
    return vtkImageData::SafeDownCast(FirstOf(data))->GetSpacing()[axis];
  }
  vtkDataArray* coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  double shortest = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 1; i < coordinates[axis]->GetNumberOfTuples(); ++i)
  {
    const double step = coordinates[axis]->GetTuple1(i) - coordinates[axis]->GetTuple1(i - 1);
    shortest = std::min(shortest, std::abs(step));
  }
  return shortest;
}

double ShortestEdge(vtkDataObject* data, vtkVolume* volume)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    double edge[3];
    for (int row = 0; row < 3; ++row)
    {
      edge[row] = volume->GetMatrix()->GetElement(row, axis) * SpacingOf(data, axis);
    }
    shortest = std::min(shortest, vtkMath::Norm(edge));
  }
  return shortest;
}

}

bool ColdWitness::Draw(Scene& scene)
{
  this->Mapper->SetInputDataObject(scene.Mapper->GetInputDataObject(0, 0));
  this->Mapper->SetBlendMode(scene.Mapper->GetBlendMode());
  this->Mapper->SetAverageIPScalarRange(scene.Mapper->GetAverageIPScalarRange());
  this->Mapper->SetFinalColorWindow(scene.Mapper->GetFinalColorWindow());
  this->Mapper->SetFinalColorLevel(scene.Mapper->GetFinalColorLevel());
  this->Mapper->SetSurfaceMode(scene.Mapper->GetSurfaceMode());
  this->Mapper->SetShadows(scene.Mapper->GetShadows());
  this->Mapper->SetVectorMode(scene.Mapper->GetVectorMode());
  this->Mapper->SetVectorComponent(scene.Mapper->GetVectorComponent());
  this->Mapper->SetColorArrayName(scene.Mapper->GetColorArrayName());
  this->Mapper->SetColorArrayOnCells(scene.Mapper->GetColorArrayOnCells());
  this->Mapper->SetColorArrayComponent(scene.Mapper->GetColorArrayComponent());
  this->Mapper->SetColorArrayOpacity(scene.Mapper->GetColorArrayOpacity());
  this->Mapper->SetColorTable(scene.Mapper->GetColorTable());
  this->Mapper->SetCropping(scene.Mapper->GetCropping());
  this->Mapper->SetCroppingRegionPlanes(scene.Mapper->GetCroppingRegionPlanes());
  this->Mapper->SetCroppingRegionFlags(scene.Mapper->GetCroppingRegionFlags());
  this->Mapper->SetClippingPlanes(scene.Mapper->GetClippingPlanes());
  this->Mapper->SetMaskInput(scene.Mapper->GetMaskInput());
  this->Mapper->SetMaskType(scene.Mapper->GetMaskType());
  this->Mapper->SetMaskBlendFactor(scene.Mapper->GetMaskBlendFactor());
  this->Mapper->SetScalarMode(scene.Mapper->GetScalarMode());
  this->Mapper->SelectScalarArray(scene.Mapper->GetArrayId());
  this->Mapper->SelectScalarArray(scene.Mapper->GetArrayName());
  this->Mapper->SetArrayAccessMode(scene.Mapper->GetArrayAccessMode());
  this->Mapper->ClearCache();
  int size[3];
  scene.Color->GetDimensions(size);
  return this->Mapper->MakeImage(
           scene.Renderer, scene.Volume, size[0], size[1], this->Color, this->Depth) &&
    std::string(this->Mapper->GetStatistics()->GetRouteAsString()) == "Cold";
}

vtkIdType ColdWitness::CountDifferent(const Scene& scene, double voxels) const
{
  vtkDataObject* data = this->Mapper->GetInputDataObject(0, 0);
  return this->Count(scene, voxels * ShortestEdge(data, scene.Volume));
}

vtkIdType ColdWitness::Count(const Scene& scene, double apart) const
{
  const auto* here = static_cast<const float*>(this->Depth->GetScalarPointer());
  const auto* there = static_cast<const float*>(scene.Depth->GetScalarPointer());
  const vtkIdType pixels = this->Depth->GetNumberOfPoints();
  if (pixels != scene.Depth->GetNumberOfPoints())
  {
    return pixels;
  }
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    const bool isHit = std::isfinite(here[i]);
    const bool isFar =
      isHit && apart >= 0.0 && static_cast<double>(std::abs(here[i] - there[i])) > apart;
    different += isHit != std::isfinite(there[i]) || isFar ? 1 : 0;
  }
  return different;
}

bool IsRoute(Scene& scene, const std::string& route)
{
  return scene.Mapper->GetStatistics()->GetRouteAsString() == route;
}
