// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Statistics of the last frame, and PrintSelf.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "vtkTemporalCoherenceVolumeMapperInternals.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
int vtkTemporalCoherenceVolumeMapper::GetRoute()
{
  using TemporalCoherence::Route;
  static_assert(static_cast<int>(Route::Cold) == ROUTE_COLD &&
      static_cast<int>(Route::IsomapBuild) == ROUTE_ISOMAP_BUILD &&
      static_cast<int>(Route::Recomposite) == ROUTE_RECOMPOSITE &&
      static_cast<int>(Route::KeepValues) == ROUTE_KEEP_VALUES,
    "Routes tells the same as Route");
  return static_cast<int>(this->Internal->Frames.Statistics().Made);
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceVolumeMapper::GetRouteAsString()
{
  return TemporalCoherence::NameOf(this->Internal->Frames.Statistics().Made);
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfRays()
{
  return this->Internal->Frames.Statistics().Rays;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfDefiniteHits()
{
  return this->Internal->Frames.Statistics().DefiniteHits;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfDefiniteMisses()
{
  return this->Internal->Frames.Statistics().DefiniteMisses;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfPossibleHits()
{
  return this->Internal->Frames.Statistics().PossibleHits;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfTracedRays()
{
  return this->Internal->Frames.Statistics().TracedRays;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfFieldSamples()
{
  return this->Internal->Frames.Statistics().FieldSamples;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfLayers()
{
  return this->Internal->Frames.Statistics().Layers;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfMergedLayers()
{
  return this->Internal->Frames.Statistics().MergedLayers;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetIsomapMemory()
{
  return static_cast<vtkIdType>(this->Internal->Frames.LastIsomap().MemoryInBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfIsomapKnots()
{
  return static_cast<vtkIdType>(this->Internal->Frames.LastIsomap().NumberOfKnots());
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetFrameTime()
{
  return this->Internal->Frames.Statistics().FrameTime + this->Internal->Frames.PresentTime();
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetTraceTime()
{
  return this->Internal->Frames.Statistics().TraceTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetQueryTime()
{
  return this->Internal->Frames.Statistics().QueryTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetIsomapBuildTime()
{
  return this->Internal->Frames.IsomapBuildTime();
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetShadeTime()
{
  return this->Internal->Frames.Statistics().ShadeTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetPresentTime()
{
  return this->Internal->Frames.PresentTime();
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceVolumeMapper::GetMeshSetUp()
{
  using TemporalCoherence::SetUpWork;
  static_assert(static_cast<int>(SetUpWork::None) == MESH_NONE &&
      static_cast<int>(SetUpWork::Built) == MESH_BUILT,
    "MeshSetUps tells the same as SetUpWork");
  return static_cast<int>(this->Internal->SetUp.Work);
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetMeshSetUpTime()
{
  return this->Internal->SetUp.Seconds;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetMeshMemory()
{
  return static_cast<vtkIdType>(this->Internal->SetUp.Memory);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetScalarsWereAveraged()
{
  return this->Internal->SetUp.AveragesCells;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetMeshPointError()
{
  return this->Internal->SetUp.Error.OfPoints;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetMeshValueError()
{
  return this->Internal->SetUp.Error.OfValues;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceMode: " << (this->SurfaceMode == THRESHOLD ? "THRESHOLD" : "CROSSING")
     << endl;
  os << indent << "VectorMode: " << this->VectorMode << endl;
  os << indent << "VectorComponent: " << this->VectorComponent << endl;
  os << indent << "AveragedGradients: " << this->AveragedGradients << endl;
  os << indent << "MeshMemoryLimit: " << this->MeshMemoryLimit << endl;
  os << indent << "ImageCache: " << this->ImageCache << endl;
  os << indent << "Isomap: " << this->Isomap << endl;
  os << indent << "ReuseAccuracy: " << this->ReuseAccuracy << endl;
  os << indent << "RefineWhenStill: " << this->RefineWhenStill << endl;
  os << indent << "NumberOfCachedImages: " << this->NumberOfCachedImages << endl;
  os << indent << "IsomapTolerance: " << this->IsomapTolerance << endl;
  os << indent << "IsomapRange: " << this->IsomapRange[0] << ", " << this->IsomapRange[1] << endl;
  os << indent << "IsomapMemoryLimit: " << this->IsomapMemoryLimit << endl;
  os << indent << "WarnOfIsovalues: " << this->WarnOfIsovalues << endl;
  os << indent << "MeshPointError: " << this->GetMeshPointError() << endl;
  os << indent << "MeshValueError: " << this->GetMeshValueError() << endl;
  os << indent << "Route: " << this->GetRouteAsString() << endl;
}
VTK_ABI_NAMESPACE_END
