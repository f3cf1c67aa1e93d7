// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "Input/ToldChanges.h"
#include "Render/SampleDistance.h"
#include "Request/ViewFromRenderer.h"
#include "Scene/Timers.h"
#include "SettingsFromMapper.h"
#include "Window/PeelingPass.h"
#include "vtkTemporalCoherenceBrickSource.h"
#include "vtkTemporalCoherenceVolume.h"
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceVolumeMapper);

namespace
{

/// The frame with the most rays in a renderer's window; without a window, one of the last size.
TemporalCoherence::FrameSight FinestSight(
  vtkTemporalCoherenceVolumeMapper& mapper, vtkRenderer* renderer, const glm::ivec2& lastSize)
{
  if (!renderer->GetRenderWindow())
  {
    const double aspect = lastSize.y > 0 ? static_cast<double>(lastSize.x) / lastSize.y : 1.0;
    return { renderer, lastSize, aspect };
  }
  glm::ivec2 size, origin;
  renderer->GetTiledSizeAndOrigin(&size.x, &size.y, &origin.x, &origin.y);
  const double distance =
    std::max<double>(mapper.GetImageSampleDistance(), TemporalCoherence::FinestDistance(size));
  return { renderer, TemporalCoherence::RaysFor(size, distance), renderer->GetTiledAspectRatio() };
}

/// True if a prop is drawn in the opaque pass, and again in a volumetric pass behind it.
bool DrawsEdgesLater(vtkRenderer* renderer, vtkVolume* volume)
{
  return vtkTemporalCoherenceVolume::SafeDownCast(volume) && volume->HasOpaqueGeometry() &&
    !renderer->GetSelector() && !renderer->GetPass() &&
    !(renderer->GetUseDepthPeeling() && renderer->GetUseDepthPeelingForVolumes());
}

}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper::vtkTemporalCoherenceVolumeMapper()
  : Internal(std::make_unique<Internals>(this))
{
  this->SetBlendModeToIsoSurface();
  this->SampleDistance = 0.0f; // blended volumes converge
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper::~vtkTemporalCoherenceVolumeMapper() = default;

//------------------------------------------------------------------------------
int vtkTemporalCoherenceVolumeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (!this->Superclass::FillInputPortInformation(port, info))
  {
    return 0;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  // The mapper refuses other data with one error, where the pipeline would report two.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetBrickSource(vtkTemporalCoherenceBrickSource* source)
{
  this->SetInputConnection(source ? source->GetOutputPort() : nullptr);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetInputData(vtkDataSet* data)
{
  this->SetInputDataInternal(0, data);
}

//------------------------------------------------------------------------------
double* vtkTemporalCoherenceVolumeMapper::GetBounds()
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(this->GetDataObjectInput());
  if (!blocks)
  {
    return this->Superclass::GetBounds();
  }
  this->Update();
  blocks->GetBounds(this->Bounds);
  if (this->Bounds[0] > this->Bounds[1])
  {
    vtkMath::UninitializeBounds(this->Bounds);
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Internal->IsBusy("Render"))
  {
    return;
  }
  if (!renderer || !volume)
  {
    this->Internal->ReportOnce("Render needs a renderer and a volume; one of them is null.");
    return;
  }
  if (TemporalCoherence::IsPeeledAgain(volume))
  {
    // The picture exists; depth peeling draws its next slab.
    std::string error;
    this->Internal->Frames.Present(
      renderer, volume, TemporalCoherence::PictureSizeOf(renderer), this->GetInput(), error);
    this->Internal->ReportOnce(error);
    return;
  }
  this->Internal->TellStart();
  this->TimeToDraw = 0.0;
  bool isMade = false;
  {
    TemporalCoherence::Stopwatch watch(this->TimeToDraw);
    const glm::ivec2 size = TemporalCoherence::PictureSizeOf(renderer);
    if (size.x > 0 && size.y > 0)
    {
      std::string error;
      const std::string lastError = this->Internal->LastError;
      isMade = this->Internal->RenderForWindow(renderer, volume, size.x, size.y);
      if (!this->GetRenderToImage())
      {
        // After an error this shows the last valid picture again.
        const bool areLater = DrawsEdgesLater(renderer, volume);
        this->Internal->Frames.Present(renderer, volume, size, this->GetInput(), error,
          areLater ? TemporalCoherence::PicturePart::Inside : TemporalCoherence::PicturePart::All);
      }
      if (isMade && error == lastError)
      {
        this->Internal->LastError = lastError; // showing it failed as before: report that once
      }
      this->Internal->ReportOnce(error);
    }
  }
  // Those who hear of the end may draw the next frame.
  const double progress = this->GetFrameProgress();
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, &isMade);
  if (isMade)
  {
    this->Internal->TellProgress(progress, renderer->GetRenderWindow());
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::RenderEdges(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->GetRenderToImage() && DrawsEdgesLater(renderer, volume))
  {
    std::string error;
    this->Internal->Frames.Present(renderer, volume, TemporalCoherence::PictureSizeOf(renderer),
      this->GetInput(), error, TemporalCoherence::PicturePart::Edges);
    this->Internal->ReportOnce(error);
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::MakeImage(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, vtkImageData* color, vtkImageData* depth)
{
  return this->Internal->MakeImages(renderer, volume, width, height, color, depth, nullptr);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::MakeImage(
  vtkRenderer* renderer, vtkVolume* volume, int width, int height, vtkImageData* frame)
{
  if (!frame)
  {
    this->Internal->ReportOnce("MakeImage got null for the frame; give it a vtkImageData.");
    return false;
  }
  return this->Internal->MakeImages(renderer, volume, width, height, nullptr, nullptr, frame);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::BuildIsomap(vtkRenderer* renderer, vtkVolume* volume)
{
  Internals& internal = *this->Internal;
  if (internal.IsBusy("BuildIsomap"))
  {
    return false;
  }
  if (!renderer || !volume)
  {
    internal.ReportOnce("BuildIsomap needs a renderer and a volume; one of them is null.");
    return false;
  }
  const TemporalCoherence::FrameSight sight =
    FinestSight(*this, renderer, internal.Frames.LastSize());
  if (sight.Size.x < 1 || sight.Size.y < 1)
  {
    internal.ReportOnce("The size of the picture is not known; give the renderer a render window, "
                        "or render a frame before BuildIsomap.");
    return false;
  }
  // Honour abort requests that arrive during the pipeline update.
  this->SetAbortExecute(0);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    // Hide the pipeline's progress: nothing is built yet.
    const double shift = this->GetProgressShift(), scale = this->GetProgressScale();
    this->SetProgressShiftScale(shift, 0.0);
    this->Update();
    this->SetProgressShiftScale(shift, scale);
  }
  if (this->GetAbortExecute())
  {
    return false;
  }

  Internals::SharedProgress progress(
    [&](double done)
    {
      this->UpdateProgress(done);
      return !this->GetAbortExecute() && Internals::MayGoOn(renderer->GetRenderWindow());
    });
  TemporalCoherence::FrameRequest request;
  std::string error;
  if (!internal.MakeRequest(volume, sight, progress, request, error))
  {
    internal.ReportOnce(error);
    return false;
  }
  using Outcome = TemporalCoherence::Isomap::Outcome;
  Outcome outcome = Outcome::Impossible;
  {
    const Internals::Reading reading(request);
    const Internals::Busy busy(internal);
    outcome = internal.Frames.BuildIsomap(TemporalCoherence::Viewer::Of(renderer, volume), request,
      TemporalCoherence::OptionsOf(this, false), progress.OfRest(), error);
    if (error.empty())
    {
      internal.WarnOfIsomapLimit(outcome == Outcome::TooLarge);
    }
  }
  internal.ReportOnce(error);
  return outcome == Outcome::Built;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::ModifiedWithin(
  vtkImageData* image, const int extent[6], vtkDataArray* array)
{
  const bool isTold = image && extent &&
    TemporalCoherence::TellChange(
      image, array, { extent[0], extent[1], extent[2], extent[3], extent[4], extent[5] });
  if (!isTold)
  {
    vtkGenericWarningMacro(
      "ModifiedWithin found no array to call modified; give an image, an extent, and one of the "
      "image's arrays.");
  }
  return isTold;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::ClearCache()
{
  if (this->Internal->IsBusy("ClearCache"))
  {
    return;
  }
  Internals& internal = *this->Internal;
  internal.HasWarned = false;
  internal.Requests.Release();
  internal.Frames.Release();
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Frames.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::IsOpaque(vtkVolume* volume)
{
  return !volume ||
    this->Internal->Requests.IsOpaque(this, TemporalCoherence::SettingsOf(this), volume);
}
VTK_ABI_NAMESPACE_END
