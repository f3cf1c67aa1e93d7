// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "Request/ViewFromRenderer.h"
#include "Scene/Stopwatch.h"
#include "SettingsFromMapper.h"
#include "Window/PeelingPass.h"
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

/// False if the window asks to stop.
bool MayGoOn(vtkRenderWindow* window)
{
  return !(window && window->CheckAbortStatus());
}

/// True if somebody wants to know how far a frame is, or may stop it.
bool IsHeard(vtkTemporalCoherenceVolumeMapper& mapper, vtkRenderWindow* window)
{
  return mapper.HasObserver(vtkCommand::VolumeMapperRenderProgressEvent) ||
    (window && (window->GetAbortRender() || window->HasObserver(vtkCommand::AbortCheckEvent)));
}

/// Sets a flag for as long as it lives.
class Busy
{
public:
  explicit Busy(bool& flag)
    : Flag(flag)
  {
    flag = true;
  }
  ~Busy() { this->Flag = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

private:
  bool& Flag;
};

/// The frame in a renderer's window with the most rays; without a window, in the size of the last.
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
  const float distance = mapper.GetAutoAdjustSampleDistances()
    ? mapper.GetMinimumImageSampleDistance()
    : mapper.GetImageSampleDistance();
  const double finest = TemporalCoherence::FinestDistance(size);
  return { renderer, TemporalCoherence::RaysFor(size, std::max<double>(distance, finest)),
    renderer->GetTiledAspectRatio() };
}

}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper::vtkTemporalCoherenceVolumeMapper()
  : Internal(std::make_unique<Internals>())
{
  this->SetBlendModeToIsoSurface();
  this->AutoAdjustSampleDistances = 0;
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
  // What cannot be drawn is refused by the mapper, in one sentence, and not by the pipeline in two.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
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
  if (this->IsBusy("Render"))
  {
    return;
  }
  if (!renderer || !volume)
  {
    this->ReportOnce("Render needs a renderer and a volume; one of them is null.");
    return;
  }
  if (TemporalCoherence::IsPeeledAgain(volume))
  {
    // The picture is made; the next slab of it is drawn.
    std::string error;
    this->Internal->Frames.Present(
      renderer, volume, TemporalCoherence::PictureSizeOf(renderer), this->GetInput(), error);
    this->ReportOnce(error);
    return;
  }
  this->TellStart();
  this->TimeToDraw = 0.0;
  bool isMade = false;
  {
    TemporalCoherence::Stopwatch watch(this->TimeToDraw);
    const glm::ivec2 size = TemporalCoherence::PictureSizeOf(renderer);
    if (size.x > 0 && size.y > 0)
    {
      std::string error;
      const std::string lastError = this->Internal->LastError;
      isMade = this->RenderForWindow(renderer, volume, size.x, size.y);
      if (!this->GetRenderToImage())
      {
        // After an error this shows the last valid picture again.
        this->Internal->Frames.Present(renderer, volume, size, this->GetInput(), error);
      }
      if (isMade && error == lastError)
      {
        this->Internal->LastError = lastError; // the frame was made as before, and not shown
      }
      this->ReportOnce(error);
    }
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, &isMade);
}

//------------------------------------------------------------------------------
/// Make a frame for a window, as coarse or as fine as is wished.
/// \return false if it is not made
bool vtkTemporalCoherenceVolumeMapper::RenderForWindow(
  vtkRenderer* renderer, vtkVolume* volume, int width, int height)
{
  Internals& internal = *this->Internal;
  const glm::ivec2 pixels(width, height);
  const double allowed = volume->GetAllocatedRenderTime();
  if (this->AutoAdjustSampleDistances)
  {
    // What is chosen can be asked for, as of other mappers, but is no modification.
    this->ImageSampleDistance = static_cast<float>(
      internal.Distances.Choose(pixels, allowed, static_cast<double>(this->ImageSampleDistance),
        { std::max<double>(
            this->MinimumImageSampleDistance, TemporalCoherence::FinestDistance(pixels)),
          this->MaximumImageSampleDistance }));
  }
  std::string warning;
  const glm::ivec2 rays =
    internal.Rays.For(pixels, static_cast<double>(this->ImageSampleDistance), volume, warning);
  this->Warn(warning);
  const bool isMade = this->RenderFrame(
    renderer, volume, rays.x, rays.y, renderer->GetTiledAspectRatio(), renderer->GetRenderWindow());
  if (isMade)
  {
    internal.Frames.SetPictureSize(pixels);
    internal.Learn(allowed);
  }
  return isMade;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::RenderFrame(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, double aspect, vtkRenderWindow* window)
{
  Internals& internal = *this->Internal;
  internal.Frames.ResetPresentTime();
  if (static_cast<vtkTypeInt64>(width) * height > VTK_INT_MAX)
  {
    this->ReportOnce("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels is too large; ask for at most " + std::to_string(VTK_INT_MAX) + " pixels.");
    return false;
  }
  TemporalCoherence::FrameRequest request;
  std::string error;
  if (!internal.Requests.Make(this, TemporalCoherence::SettingsOf(this), volume,
        { renderer, { width, height }, aspect }, request, error))
  {
    this->ReportOnce(error);
    return false;
  }

  TemporalCoherence::FrameRenderer::Options options = TemporalCoherence::OptionsOf(this);
  options.ReportsTiles = IsHeard(*this, window);
  bool isMade = false;
  {
    const Busy busy(internal.IsBusy);
    isMade = internal.Frames.Render(
      TemporalCoherence::Viewer::Of(renderer, volume), request, options,
      [&](double progress)
      {
        this->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &progress);
        return window ? MayGoOn(window) : !this->GetAbortExecute();
      },
      error);
    if (isMade)
    {
      this->WarnOfIsomapLimit(internal.Frames.IsIsomapTooLarge());
      if (this->WarnOfIsovalues)
      {
        this->Warn(internal.CheckIsovalues({ this, volume, renderer }, request));
      }
      internal.LastError.clear();
    }
  }
  this->ReportOnce(error);
  return isMade;
}

//------------------------------------------------------------------------------
/// What the error of a frame for a window would be; empty if it can be made.
std::string vtkTemporalCoherenceVolumeMapper::WhyRefused(vtkRenderer* renderer, vtkVolume* volume)
{
  std::string error;
  if (!this->Internal->IsBusy) // else Render() tells
  {
    const glm::ivec2 size = glm::max(TemporalCoherence::PictureSizeOf(renderer), 1);
    TemporalCoherence::FrameRequest request;
    this->Internal->Requests.Make(this, TemporalCoherence::SettingsOf(this), volume,
      { renderer, size, renderer->GetTiledAspectRatio() }, request, error);
  }
  return error;
}

//------------------------------------------------------------------------------
/// True, with an error, if a frame or an isomap is being made: what it is made with must stay.
bool vtkTemporalCoherenceVolumeMapper::IsBusy(const char* method)
{
  if (this->Internal->IsBusy)
  {
    this->ReportOnce(std::string(method) +
      " was called by an observer while a frame or an isomap " +
      "is being made; call it after VolumeMapperRenderEndEvent or BuildIsomap.");
  }
  return this->Internal->IsBusy;
}

//------------------------------------------------------------------------------
/// A frame begins: observers may change settings, but not begin another one.
void vtkTemporalCoherenceVolumeMapper::TellStart()
{
  const Busy busy(this->Internal->IsBusy);
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
}

//------------------------------------------------------------------------------
/// Report an error, if there is one, other than the last.
void vtkTemporalCoherenceVolumeMapper::ReportOnce(const std::string& error)
{
  if (!error.empty() && error != this->Internal->LastError)
  {
    this->Internal->LastError = error;
    vtkErrorMacro(<< error);
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::RenderToImage(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, vtkImageData* color, vtkImageData* depth)
{
  return this->RenderToImages(renderer, volume, width, height, color, depth, nullptr);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::RenderToImage(
  vtkRenderer* renderer, vtkVolume* volume, int width, int height, vtkImageData* frame)
{
  if (!frame)
  {
    this->ReportOnce("RenderToImage needs an image for the frame, but got null; give it a "
                     "vtkImageData.");
    return false;
  }
  return this->RenderToImages(renderer, volume, width, height, nullptr, nullptr, frame);
}

//------------------------------------------------------------------------------
/// Make a frame and write it into images, any of which may be null.
/// \param frame gets all arrays
bool vtkTemporalCoherenceVolumeMapper::RenderToImages(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, vtkImageData* color, vtkImageData* depth, vtkImageData* frame)
{
  if (this->IsBusy("RenderToImage"))
  {
    return false;
  }
  if (!renderer || !volume)
  {
    this->ReportOnce("RenderToImage needs a renderer and a volume; one of them is null.");
    return false;
  }
  if (width < 1 || height < 1)
  {
    this->ReportOnce("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels has none; give a width and a height of at least 1.");
    return false;
  }
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  this->SetAbortExecute(0);
  this->TellStart();
  bool isMade = this->RenderFrame(
    renderer, volume, width, height, static_cast<double>(width) / height, nullptr);
  if (isMade)
  {
    this->Internal->Frames.SetPictureSize({ width, height });
    this->Internal->Learn(VTK_DOUBLE_MAX);
  }
  // Before observers hear of it, who may draw the next one.
  std::string error;
  const bool isWritten = isMade &&
    this->Internal->Frames.WriteImages(
      { { color, FRAME_COLOR }, { depth, FRAME_DEPTH }, { frame, FRAME_ALL } }, error);
  this->ReportOnce(error);
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, &isMade);
  return isWritten;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::BuildIsomap(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->IsBusy("BuildIsomap"))
  {
    return false;
  }
  if (!renderer || !volume)
  {
    this->ReportOnce("BuildIsomap needs a renderer and a volume; one of them is null.");
    return false;
  }
  Internals& internal = *this->Internal;
  const TemporalCoherence::FrameSight sight =
    FinestSight(*this, renderer, internal.Frames.LastSize());
  if (sight.Size.x < 1 || sight.Size.y < 1)
  {
    this->ReportOnce("The size of the picture is not known; give the renderer a render window or "
                     "render a frame before BuildIsomap.");
    return false;
  }
  // Who asks to stop while the input is updated is heard, too.
  this->SetAbortExecute(0);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    // Nothing is built yet, whatever the pipeline says.
    const double shift = this->GetProgressShift(), scale = this->GetProgressScale();
    this->SetProgressShiftScale(shift, 0.0);
    this->Update();
    this->SetProgressShiftScale(shift, scale);
  }
  if (this->GetAbortExecute())
  {
    return false;
  }

  TemporalCoherence::FrameRequest request;
  std::string error;
  if (!internal.Requests.Make(
        this, TemporalCoherence::SettingsOf(this), volume, sight, request, error))
  {
    this->ReportOnce(error);
    return false;
  }
  using Outcome = TemporalCoherence::Isomap::Outcome;
  Outcome outcome = Outcome::Impossible;
  {
    const Busy busy(internal.IsBusy);
    outcome = internal.Frames.BuildIsomap(
      TemporalCoherence::Viewer::Of(renderer, volume), request, TemporalCoherence::OptionsOf(this),
      [&](double progress)
      {
        this->UpdateProgress(progress);
        return !this->GetAbortExecute() && MayGoOn(renderer->GetRenderWindow());
      },
      error);
    if (error.empty())
    {
      this->WarnOfIsomapLimit(outcome == Outcome::TooLarge);
    }
  }
  this->ReportOnce(error);
  return outcome == Outcome::Built;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::WarnOfIsomapLimit(bool isTooLarge)
{
  Internals& internal = *this->Internal;
  if (internal.HasWarned || this->IsomapMemoryLimit == 0 ||
    !(isTooLarge || internal.Frames.LastIsomap().HasDropped()))
  {
    return;
  }
  internal.HasWarned = true;
  vtkWarningMacro("The isomap of this view does not fit IsomapMemoryLimit ("
    << this->IsomapMemoryLimit
    << " MiB): what was used least is built again when it is needed. Raise the limit, or set a "
       "narrower IsomapRange or a larger IsomapTolerance.");
}

//------------------------------------------------------------------------------
/// Say a warning, if there is one.
void vtkTemporalCoherenceVolumeMapper::Warn(const std::string& warning)
{
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::ReleaseReuse()
{
  if (this->IsBusy("ReleaseReuse"))
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
