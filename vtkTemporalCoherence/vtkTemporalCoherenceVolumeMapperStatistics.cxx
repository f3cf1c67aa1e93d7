// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Statistics of the last frame, and PrintSelf.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "vtkTemporalCoherenceVolumeMapperInternals.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTemporalCoherenceStatistics* vtkTemporalCoherenceVolumeMapper::GetStatistics()
{
  using TemporalCoherence::Route;
  static_assert(static_cast<int>(Route::Cold) == ROUTE_COLD &&
      static_cast<int>(Route::IsomapBuild) == ROUTE_ISOMAP_BUILD &&
      static_cast<int>(Route::Recomposite) == ROUTE_RECOMPOSITE &&
      static_cast<int>(Route::KeepValues) == ROUTE_KEEP_VALUES,
    "Routes tells the same as Route");
  using TemporalCoherence::SetUpWork;
  static_assert(static_cast<int>(SetUpWork::None) == MESH_NONE &&
      static_cast<int>(SetUpWork::Built) == MESH_BUILT,
    "MeshSetUps tells the same as SetUpWork");

  const TemporalCoherence::MapperFrames& frames = this->Internal->Frames;
  const TemporalCoherence::FrameStatistics& last = frames.Statistics();
  const TemporalCoherence::FieldSetUp& setUp = this->Internal->SetUp;
  vtkTemporalCoherenceStatistics& told = *this->Internal->Statistics;
  told.Route = static_cast<int>(last.Made);
  told.RouteName = TemporalCoherence::NameOf(last.Made);
  told.NumberOfRays = last.Rays;
  told.NumberOfDefiniteHits = last.DefiniteHits;
  told.NumberOfDefiniteMisses = last.DefiniteMisses;
  told.NumberOfPossibleHits = last.PossibleHits;
  told.NumberOfTracedRays = last.TracedRays;
  told.NumberOfFieldSamples = last.FieldSamples;
  told.NumberOfLayers = last.Layers;
  told.NumberOfMergedLayers = last.MergedLayers;
  told.IsomapMemory = static_cast<vtkIdType>(frames.LastIsomap().MemoryInBytes());
  told.NumberOfIsomapKnots = static_cast<vtkIdType>(frames.LastIsomap().NumberOfKnots());
  told.FrameTime = last.FrameTime + frames.PresentTime();
  told.TraceTime = last.TraceTime;
  told.QueryTime = last.QueryTime;
  told.IsomapBuildTime = frames.IsomapBuildTime();
  told.ShadeTime = last.ShadeTime;
  told.PresentTime = frames.PresentTime();
  told.MeshSetUp = static_cast<int>(setUp.Work);
  told.MeshSetUpTime = setUp.Seconds;
  told.MeshMemory = static_cast<vtkIdType>(setUp.Memory);
  told.ScalarsWereAveraged = setUp.AveragesCells;
  told.MeshPointError = setUp.Error.OfPoints;
  told.MeshValueError = setUp.Error.OfValues;
  return &told;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceMode: " << (this->SurfaceMode == THRESHOLD ? "THRESHOLD" : "CROSSING")
     << endl;
  os << indent << "VectorMode: " << this->VectorMode << endl;
  os << indent << "VectorComponent: " << this->VectorComponent << endl;
  os << indent << "SmoothMeshNormals: " << this->SmoothMeshNormals << endl;
  os << indent << "MeshMemoryLimit: " << this->MeshMemoryLimit << endl;
  os << indent << "ReuseFrames: " << this->ReuseFrames << endl;
  os << indent << "Isomap: " << this->Isomap << endl;
  os << indent << "ReuseAccuracy: " << this->ReuseAccuracy << endl;
  os << indent << "RefineWhenStill: " << this->RefineWhenStill << endl;
  os << indent << "NumberOfCachedImages: " << this->NumberOfCachedImages << endl;
  os << indent << "IsomapTolerance: " << this->IsomapTolerance << endl;
  os << indent << "IsomapRange: " << this->IsomapRange[0] << ", " << this->IsomapRange[1] << endl;
  os << indent << "IsomapMemoryLimit: " << this->IsomapMemoryLimit << endl;
  os << indent << "FixedStepSampling: " << this->FixedStepSampling << endl;
  os << indent << "WarnOfIsovalues: " << this->WarnOfIsovalues << endl;
  os << indent << "Statistics:" << endl;
  this->GetStatistics()->PrintSelf(os, indent.GetNextIndent());
}
VTK_ABI_NAMESPACE_END
