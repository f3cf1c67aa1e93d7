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
/// The state of a mapper besides its settings.
struct vtkTemporalCoherenceVolumeMapper::Internals
{
  TemporalCoherence::RequestFromMapper Requests;
  TemporalCoherence::MapperFrames Frames;
  TemporalCoherence::SampleDistanceChooser Distances;
  TemporalCoherence::WindowRays Rays;
  TemporalCoherence::IsovalueCheck Isovalues;
  std::string LastError;  ///< reported already; empty after a frame without error
  bool HasWarned = false; ///< of the memory limit
  bool IsBusy = false;    ///< set while a frame is made, when observers may call anything

  /// The warning about the isovalues of the last frame; empty if there is none.
  std::string CheckIsovalues(
    const TemporalCoherence::DrawnVolume& drawn, const TemporalCoherence::FrameRequest& request)
  {
    return request.Key.Samples.HasCells()
      ? this->Isovalues.Check(drawn, request, this->Frames.LastRanges())
      : std::string();
  }

  /// Learn how long rays take, if the last frame traced or looked up any.
  void Learn(double allowed)
  {
    const TemporalCoherence::FrameStatistics& last = this->Frames.Statistics();
    if (last.Made != TemporalCoherence::Route::Redisplay &&
      last.Made != TemporalCoherence::Route::Reshade)
    {
      // Without the isomap, which the next frames in the view need not build again.
      this->Distances.Learn(
        this->Frames.LastSize(), last.FrameTime - last.IsomapBuildTime, allowed);
    }
  }
};
VTK_ABI_NAMESPACE_END

#endif
