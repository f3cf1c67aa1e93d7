// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalCoherenceVolumeMapperInternals_h
#define vtkTemporalCoherenceVolumeMapperInternals_h

#include "Frames/MapperFrames.h"
#include "Render/SampleDistance.h"
#include "Request/IsovalueCheck.h"
#include "Request/RequestFromMapper.h"
#include "Window/WindowRays.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
/// What a mapper holds besides its settings.
struct vtkTemporalCoherenceVolumeMapper::Internals
{
  TemporalCoherence::RequestFromMapper Requests;
  TemporalCoherence::MapperFrames Frames;
  TemporalCoherence::SampleDistanceChooser Distances;
  TemporalCoherence::WindowRays Rays;
  TemporalCoherence::IsovalueCheck Isovalues;
  std::string LastError;  ///< reported already; empty after a frame without error
  bool HasWarned = false; ///< of the limit of memory
  bool IsBusy = false;    ///< observers of a frame that is being made may call anything

  /// What is to be told of the isovalues of the last frame; or nothing.
  std::string CheckIsovalues(
    const TemporalCoherence::DrawnVolume& drawn, const TemporalCoherence::FrameRequest& request)
  {
    return request.Key.Samples.HasCells()
      ? this->Isovalues.Check(drawn, request, this->Frames.LastRanges())
      : std::string();
  }

  /// Remember what rays take, if the last frame had any traced or looked up.
  void Learn(double allowed)
  {
    const TemporalCoherence::FrameStatistics& last = this->Frames.Statistics();
    if (last.Made != TemporalCoherence::Route::Redisplay &&
      last.Made != TemporalCoherence::Route::Reshade)
    {
      // The next frames in the view need not build an isomap again.
      this->Distances.Learn(
        this->Frames.LastSize(), last.FrameTime - last.IsomapBuildTime, allowed);
    }
  }
};
VTK_ABI_NAMESPACE_END

#endif
