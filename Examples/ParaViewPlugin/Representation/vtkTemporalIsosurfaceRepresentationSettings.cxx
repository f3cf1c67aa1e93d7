// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalIsosurfaceRepresentation.h"

#include "DistributedPart.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Lists arrive value by value.
template <typename Value>
void SetAt(std::vector<Value>& values, int i, const Value& value)
{
  const auto place = static_cast<std::size_t>(std::max(i, 0));
  values.resize(std::max(values.size(), place + 1));
  values[place] = value;
}

double ToUnitInterval(double number)
{
  return std::min(std::max(0.0, number), 1.0); // in this order NaN is 0
}

}

//------------------------------------------------------------------------------
int vtkTemporalIsosurfaceRepresentation::FillInputPortInformation(int port, vtkInformation* info)
{
  if (!this->Superclass::FillInputPortInformation(port, info))
  {
    return 0;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetInputArrayToProcess(
  int index, int port, int connection, int association, const char* name)
{
  const vtkMTimeType before = this->GetMTime();
  this->Superclass::SetInputArrayToProcess(index, port, connection, association, name);
  if (this->GetMTime() > before)
  {
    this->MarkModified(); // the values in all processes are asked for again
  }
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetNumberOfIsovalues(int number)
{
  this->Isovalues.resize(static_cast<std::size_t>(std::max(number, 0)));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetIsovalue(int i, double value)
{
  SetAt(this->Isovalues, i, value);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetSingleIsovalue(double value)
{
  this->SingleIsovalue = value;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetNumberOfIsosurfaces(int number)
{
  this->VolumeIsovalues.resize(static_cast<std::size_t>(std::max(number, 0)));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetIsosurfaceValue(int i, double value)
{
  SetAt(this->VolumeIsovalues, i, value);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetColor(vtkColorTransferFunction* table)
{
  this->Table = table;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetSolidColor(double red, double green, double blue)
{
  this->SolidColor->RemoveAllPoints();
  this->SolidColor->AddRGBPoint(0.0, red, green, blue);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetScalarOpacity(vtkPiecewiseFunction* function)
{
  this->OpacityFunction = function;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetOpacity(double opacity)
{
  const bool wasTranslucent = this->IsTranslucent();
  this->Opacity = opacity;
  this->ConstantOpacity->RemoveAllPoints();
  this->ConstantOpacity->AddPoint(0.0, opacity);
  this->Modified();
  this->PrepareAgainUnless(wasTranslucent);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetUseOpacityFunction(bool uses)
{
  const bool wasTranslucent = this->IsTranslucent();
  this->UseOpacityFunction = uses;
  this->Modified();
  this->PrepareAgainUnless(wasTranslucent);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetNumberOfSurfaceLooks(int number)
{
  const bool wasTranslucent = this->IsTranslucent();
  this->SurfaceLooks.resize(static_cast<std::size_t>(std::max(number, 0)), Look{ 1, 1, 1, 1 });
  this->Modified();
  this->PrepareAgainUnless(wasTranslucent);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetSurfaceLook(
  int i, double red, double green, double blue, double opacity)
{
  const bool wasTranslucent = this->IsTranslucent();
  Look look = { red, green, blue, opacity };
  for (double& number : look)
  {
    number = ToUnitInterval(number);
  }
  SetAt(this->SurfaceLooks, i, look);
  this->Modified();
  this->PrepareAgainUnless(wasTranslucent);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetNumberOfLabelOpacities(int number)
{
  this->LabelOpacities.resize(static_cast<std::size_t>(std::max(number, 0)), { 0.0, 1.0 });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetLabelOpacity(int i, double label, double opacity)
{
  SetAt(this->LabelOpacities, i, { label, ToUnitInterval(opacity) });
  this->Modified();
}

//------------------------------------------------------------------------------
/// Blocks of meshes are merged if they are translucent.
void vtkTemporalIsosurfaceRepresentation::PrepareAgainUnless(bool wasTranslucent)
{
  if (this->HasMeshes && this->IsTranslucent() != wasTranslucent)
  {
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetCropping(int crops)
{
  this->Crops = crops != 0;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetSurfaceArrayComponent(int component)
{
  this->SurfaceArrayComponent = component;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetSurfaceMode(int mode)
{
  const int layersBefore = this->CountGhostLayers();
  this->GetMapper()->SetSurfaceMode(mode);
  this->AskForGhostLayersUnless(layersBefore);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetLabelRadius(double samples)
{
  const int layersBefore = this->CountGhostLayers();
  this->GetMapper()->SetLabelRadius(samples);
  this->AskForGhostLayersUnless(layersBefore);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetOutsideLabel(int label)
{
  this->GetMapper()->SetOutsideLabel(label);
}

//------------------------------------------------------------------------------
/// Smooth labels depend on more samples around a point than other surfaces do.
int vtkTemporalIsosurfaceRepresentation::CountGhostLayers()
{
  constexpr double layersPerRadius = 2.8; // where the mapper cuts off the Gaussian of normals
  return LeastGhostLayers +
    (this->AreLabelsDrawn()
        ? static_cast<int>(std::ceil(layersPerRadius * this->GetMapper()->GetLabelRadius()))
        : 0);
}

//------------------------------------------------------------------------------
/// Several processes ask for ghost cells anew.
void vtkTemporalIsosurfaceRepresentation::AskForGhostLayersUnless(int layersBefore)
{
  if (this->CountGhostLayers() != layersBefore)
  {
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetAmbientOcclusion(bool on)
{
  this->GetMapper()->SetAmbientOcclusion(on);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetAmbientOcclusionRadius(double radius)
{
  this->GetMapper()->SetAmbientOcclusionRadius(radius);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetAmbientOcclusionStrength(double strength)
{
  this->GetMapper()->SetAmbientOcclusionStrength(strength);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetReuseAccuracy(int accuracy)
{
  this->GetMapper()->SetReuseAccuracy(accuracy);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetReuseFrames(bool on)
{
  this->GetMapper()->SetReuseFrames(on);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetIsomap(bool on)
{
  this->GetMapper()->SetIsomap(on);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetIsomapTolerance(double voxels)
{
  this->GetMapper()->SetIsomapTolerance(voxels);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetIsomapRange(double lowest, double highest)
{
  this->GetMapper()->SetIsomapRange(lowest, highest);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetIsomapMemoryLimit(int mebibytes)
{
  this->GetMapper()->SetIsomapMemoryLimit(mebibytes);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetRefineWhenStill(bool on)
{
  this->GetMapper()->SetRefineWhenStill(on);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetColorByAnswer(bool on)
{
  this->GetMapper()->SetColorByAnswer(on);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetShowStatistics(bool shows)
{
  this->ShowStatistics = shows;
  this->StatisticsText->SetVisibility(shows && this->GetVisibility());
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->StatisticsText->SetVisibility(visible && this->ShowStatistics);
}

//------------------------------------------------------------------------------
const char* vtkTemporalIsosurfaceRepresentation::GetRoute()
{
  return this->GetMapper()->GetStatistics()->GetRouteAsString();
}

//------------------------------------------------------------------------------
double vtkTemporalIsosurfaceRepresentation::GetFrameMilliseconds()
{
  return 1000.0 * this->GetMapper()->GetStatistics()->GetFrameTime();
}

//------------------------------------------------------------------------------
double vtkTemporalIsosurfaceRepresentation::GetFrameProgress()
{
  return this->GetMapper()->GetFrameProgress();
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalIsosurfaceRepresentation::GetNumberOfRays()
{
  return this->GetMapper()->GetStatistics()->GetNumberOfRays();
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalIsosurfaceRepresentation::GetNumberOfTracedRays()
{
  return this->GetMapper()->GetStatistics()->GetNumberOfTracedRays();
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalIsosurfaceRepresentation::GetNumberOfDefiniteHits()
{
  return this->GetMapper()->GetStatistics()->GetNumberOfDefiniteHits();
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalIsosurfaceRepresentation::GetNumberOfPossibleHits()
{
  return this->GetMapper()->GetStatistics()->GetNumberOfPossibleHits();
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalIsosurfaceRepresentation::GetIsomapMemory()
{
  return this->GetMapper()->GetStatistics()->GetIsomapMemory();
}

//------------------------------------------------------------------------------
vtkIdTypeArray* vtkTemporalIsosurfaceRepresentation::GetRouteCounts()
{
  return this->RouteCounts;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkTemporalIsosurfaceRepresentation::GetShownIsovalues()
{
  return this->ShownIsovalues;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkTemporalIsosurfaceRepresentation::GetScalarRange()
{
  return this->ScalarRange;
}
