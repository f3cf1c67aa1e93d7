// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The last frame as images and as points, and its statistics.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetLastFrame(vtkImageData* frame, int arrays)
{
  static_assert(static_cast<int>(TemporalCoherence::ColorArray) == FRAME_COLOR &&
      static_cast<int>(TemporalCoherence::DepthArray) == FRAME_DEPTH &&
      static_cast<int>(TemporalCoherence::NormalsArray) == FRAME_NORMALS &&
      static_cast<int>(TemporalCoherence::IsovalueIndexArray) == FRAME_ISOVALUE_INDEX &&
      static_cast<int>(TemporalCoherence::AnswerArray) == FRAME_ANSWER &&
      static_cast<int>(TemporalCoherence::AllFrameArrays) == FRAME_ALL,
    "FrameArrays tells the same as FrameArray");
  std::string error;
  if (!frame)
  {
    error = "GetLastFrame got null for the frame; give it a vtkImageData.";
  }
  else if (arrays & ~FRAME_ALL)
  {
    error = "GetLastFrame got " + std::to_string(arrays) +
      " for the arrays; give it FRAME_ALL, or a sum of FRAME_COLOR, FRAME_DEPTH, FRAME_NORMALS, "
      "FRAME_ISOVALUE_INDEX and FRAME_ANSWER.";
  }
  const bool isThere =
    error.empty() && this->Internal->Frames.WriteImages({ { frame, arrays } }, error);
  this->Internal->ReportOnce(error);
  return isThere;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::GetColorImage(vtkImageData* image)
{
  std::string error;
  this->Internal->Frames.WriteBufferColors(image, error);
  this->Internal->ReportOnce(error);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::GetDepthImage(vtkImageData* image)
{
  std::string error;
  this->Internal->Frames.WriteBufferDepths(
    image, this->GetDepthImageScalarType(), this->GetClampDepthToBackface() != 0, error);
  this->Internal->ReportOnce(error);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetVisibleSurface(vtkPolyData* points)
{
  std::string error;
  if (!points)
  {
    error = "GetVisibleSurface got null for the points; give it a vtkPolyData.";
  }
  const bool isThere = points && this->Internal->Frames.WriteSurface(points, error);
  this->Internal->ReportOnce(error);
  return isThere;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetFrameIsFinal()
{
  return this->Internal->Frames.Statistics().Progress >= 1.0;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetFrameProgress()
{
  return this->Internal->Frames.Statistics().Progress;
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceStatistics* vtkTemporalCoherenceVolumeMapper::GetStatistics()
{
  using TemporalCoherence::Route;
  static_assert(static_cast<int>(Route::Cold) == ROUTE_COLD &&
      static_cast<int>(Route::IsomapBuild) == ROUTE_ISOMAP_BUILD &&
      static_cast<int>(Route::Recomposite) == ROUTE_RECOMPOSITE &&
      static_cast<int>(Route::KeepValues) == ROUTE_KEEP_VALUES &&
      static_cast<int>(Route::Antialias) == ROUTE_ANTIALIAS &&
      static_cast<int>(Route::Refine) == ROUTE_REFINE &&
      static_cast<int>(Route::KeepLabels) == ROUTE_KEEP_LABELS,
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
VTK_ABI_NAMESPACE_END
