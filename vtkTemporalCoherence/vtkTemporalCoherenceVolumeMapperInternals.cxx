// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a mapper makes a frame, with its errors and warnings.
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include "Request/ViewFromRenderer.h"
#include "SettingsFromMapper.h"
#include "Window/RayEnds.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// True if an observer wants the progress of a frame, or may stop it.
bool IsHeard(vtkTemporalCoherenceVolumeMapper& mapper, vtkRenderWindow* window)
{
  return mapper.HasObserver(vtkCommand::VolumeMapperRenderProgressEvent) ||
    (window && (window->GetAbortRender() || window->HasObserver(vtkCommand::AbortCheckEvent)));
}

/// The time that a frame in a window takes at most to read samples in bricks, if others follow.
constexpr std::chrono::milliseconds TimeToRead(80);

}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::RenderForWindow(
  vtkRenderer* renderer, vtkVolume* volume, int width, int height)
{
  const glm::ivec2 pixels(width, height);
  const double allowed = volume->GetAllocatedRenderTime();
  std::string warning;
  const glm::ivec2 rays =
    this->Rays.For(pixels, static_cast<double>(this->Self->ImageSampleDistance), volume, warning);
  this->Warn(warning);
  const bool isMade =
    this->RenderFrame(renderer, volume, rays.x, rays.y, renderer->GetTiledAspectRatio(),
      renderer->GetRenderWindow(), this->ChooseRays(renderer, volume, rays, allowed));
  if (isMade)
  {
    this->Frames.SetPictureSize(pixels);
    this->Frames.LearnTimes(allowed, this->Self->GetBlendMode());
  }
  return isMade;
}

//------------------------------------------------------------------------------
TemporalCoherence::FewerRays vtkTemporalCoherenceVolumeMapper::Internals::ChooseRays(
  vtkRenderer* renderer, vtkVolume* volume, const glm::ivec2& rays, double allowed) const
{
  TemporalCoherence::FewerRays fewer;
  if (!this->Self->AutoAdjustSampleDistances || this->Self->GetRenderToImage())
  {
    return fewer;
  }
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const TemporalCoherence::RayBudget::Choice choice =
    this->Frames.ChooseRays(TemporalCoherence::Viewer::Of(renderer, volume),
      static_cast<std::int64_t>(rays.x) * rays.y, allowed - this->Frames.PresentTime(),
      static_cast<double>(this->Self->MaximumImageSampleDistance), this->Self->GetBlendMode());
  fewer.Distance = choice.Distance;
  fewer.MostDistance = static_cast<double>(this->Self->MaximumImageSampleDistance);
  if (allowed < TemporalCoherence::RayBudget::InteractiveTime)
  {
    fewer.Elapsed = [begin, until = std::max(choice.Until, 1e-9)]()
    { return std::chrono::duration<double>(Clock::now() - begin).count() / until; };
  }
  return fewer;
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper::Internals::Reading::Reading(
  const TemporalCoherence::FrameRequest& request)
  : Request(request)
{
  for (const auto& volume : request.Volumes)
  {
    volume->BeginFrame();
  }
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper::Internals::Reading::~Reading()
{
  const TemporalCoherence::FrameKey& key = this->Request.Key;
  for (const auto& volume : this->Request.Volumes)
  {
    volume->EndFrame(key.IsBlended() ? std::vector<double>() : key.Isosurfaces().Isovalues);
  }
}

//------------------------------------------------------------------------------
std::string vtkTemporalCoherenceVolumeMapper::Internals::Reading::Mistake() const
{
  std::string mistake;
  for (const auto& volume : this->Request.Volumes)
  {
    mistake = mistake.empty() ? volume->Mistake() : mistake;
  }
  return mistake;
}

//------------------------------------------------------------------------------
TemporalCoherence::Impatience vtkTemporalCoherenceVolumeMapper::Internals::ChooseReading(
  const TemporalCoherence::FrameRequest& request, vtkRenderWindow* window) const
{
  TemporalCoherence::Impatience reading;
  // Somebody must render again, such as a refiner: who hears of progress does so.
  const bool isFollowed =
    window && window->HasObserver(vtkTemporalCoherenceVolumeMapper::FrameProgressEvent);
  if (!isFollowed || request.Volumes.empty() || this->Self->GetRenderToImage())
  {
    return reading;
  }
  using Clock = std::chrono::steady_clock;
  const Clock::time_point until = Clock::now() + TimeToRead;
  reading.StandIn = request.Volumes.front()->Coarse();
  reading.Deadline =
    std::chrono::duration_cast<std::chrono::nanoseconds>(until.time_since_epoch()).count();
  reading.HasTime = [until]() { return Clock::now() < until; };
  return reading;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::RenderFrame(vtkRenderer* renderer,
  vtkVolume* volume, int width, int height, double aspect, vtkRenderWindow* window,
  const TemporalCoherence::FewerRays& fewer)
{
  this->Frames.ResetPresentTime();
  if (static_cast<vtkTypeInt64>(width) * height > VTK_INT_MAX)
  {
    this->ReportOnce("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels is too large; ask for at most " + std::to_string(VTK_INT_MAX) + " pixels.");
    return false;
  }
  SharedProgress progress(
    [&](double done)
    {
      this->Self->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &done);
      return window ? MayGoOn(window) : !this->Self->GetAbortExecute();
    });
  TemporalCoherence::FrameRequest request;
  std::string error;
  if (!this->MakeRequest(volume, { renderer, { width, height }, aspect }, progress, request, error))
  {
    this->ReportOnce(error);
    return false;
  }
  if (window && request.Key.IsBlended() &&
    !this->EndAtOpaqueProps(renderer, volume, request, error))
  {
    this->ReportOnce(error);
    return false;
  }

  TemporalCoherence::FrameRenderer::Options options =
    TemporalCoherence::OptionsOf(this->Self, !window || this->Self->GetRenderToImage());
  options.ReportsTiles = IsHeard(*this->Self, window);
  options.Light.AtOnce = !window && !this->Self->ProgressiveImages;
  options.Fewer = fewer;
  options.Reading = this->ChooseReading(request, window);
  bool isMade = false;
  std::string mistake;
  {
    const Reading reading(request);
    const Busy busy(*this);
    isMade = this->Frames.Render(
      TemporalCoherence::Viewer::Of(renderer, volume), request, options, progress.OfRest(), error);
    if (isMade)
    {
      this->SetUp = request.SetUp;
      this->WarnOfIsomapLimit(this->Frames.IsIsomapTooLarge());
      this->WarnOfDivision();
      if (this->Self->WarnOfIsovalues)
      {
        this->Warn(this->CheckPicture({ this->Self, volume, renderer }, request));
      }
      this->LastError.clear();
    }
    mistake = reading.Mistake();
  }
  this->ReportOnce(error);
  if (mistake != this->LastMistake)
  {
    this->LastMistake = mistake;
    this->ReportOnce(mistake);
  }
  return isMade;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::EndAtOpaqueProps(vtkRenderer* renderer,
  vtkVolume* volume, TemporalCoherence::FrameRequest& request, std::string& error)
{
  TemporalCoherence::FrameKey& key = request.Key;
  try
  {
    request.ComparesDepths =
      !TemporalCoherence::FindRayEnds(renderer, volume, key.View, key.Blended().Ends);
    return true;
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for the depths of " + std::to_string(key.View.Size.x) +
      " x " + std::to_string(key.View.Size.y) +
      " pixels, behind which the volume is hidden; free memory or make the window smaller.";
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::MakeRequest(vtkVolume* volume,
  const TemporalCoherence::FrameSight& sight, SharedProgress& progress,
  TemporalCoherence::FrameRequest& request, std::string& error)
{
  const Busy busy(*this); // observers of the progress may call anything
  return this->Requests.Make(this->Self, TemporalCoherence::SettingsOf(this->Self), volume, sight,
    request, error, progress.OfSetUp());
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::MakeImages(vtkRenderer* renderer,
  vtkVolume* volume, int width, int height, vtkImageData* color, vtkImageData* depth,
  vtkImageData* frame)
{
  if (this->IsBusy("MakeImage"))
  {
    return false;
  }
  if (!renderer || !volume)
  {
    this->ReportOnce("MakeImage needs a renderer and a volume; one of them is null.");
    return false;
  }
  if (width < 1 || height < 1)
  {
    this->ReportOnce("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels is empty; give a width and a height of at least 1.");
    return false;
  }
  if (color && color == depth)
  {
    this->ReportOnce("MakeImage got the same image for colors and depths; give it two images, "
                     "or one for the whole frame: MakeImage(renderer, volume, width, height, "
                     "frame).");
    return false;
  }
  // Honour abort requests that arrive during the pipeline update.
  this->Self->SetAbortExecute(0);
  if (this->Self->GetNumberOfInputConnections(0) > 0)
  {
    this->Self->Update();
  }
  this->TellStart();
  bool isMade = this->RenderFrame(
    renderer, volume, width, height, static_cast<double>(width) / height, nullptr);
  if (isMade && this->Self->GetAbortExecute() && !this->Self->GetProgressiveImages())
  {
    // New colours are shown before all of their light is found or edges are smooth.
    isMade = this->Frames.Statistics().Progress >= 1.0;
  }
  if (isMade)
  {
    this->Frames.SetPictureSize({ width, height });
    this->Frames.LearnTimes(VTK_DOUBLE_MAX, this->Self->GetBlendMode());
  }
  // Write the images before the end event: its observers may draw the next frame.
  std::string error;
  const bool isWritten = isMade &&
    this->Frames.WriteImages(
      { { color, FRAME_COLOR }, { depth, FRAME_DEPTH }, { frame, FRAME_ALL } }, error);
  this->ReportOnce(error);
  bool isDone = isWritten;
  const double progress = this->Self->GetFrameProgress();
  this->Self->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, &isDone);
  if (isMade)
  {
    this->TellProgress(progress, nullptr);
  }
  return isWritten;
}

//------------------------------------------------------------------------------
std::string vtkTemporalCoherenceVolumeMapper::Internals::WhyRefused(
  vtkRenderer* renderer, vtkVolume* volume)
{
  std::string error;
  if (!this->IsMaking) // else Render() reports it
  {
    const glm::ivec2 size = glm::max(TemporalCoherence::PictureSizeOf(renderer), 1);
    TemporalCoherence::FrameRequest request;
    this->Requests.Make(this->Self, TemporalCoherence::SettingsOf(this->Self), volume,
      { renderer, size, renderer->GetTiledAspectRatio() }, request, error);
  }
  return error;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::IsBusy(const char* method)
{
  if (this->IsMaking)
  {
    this->ReportOnce(std::string(method) +
      " must not be called while a frame or an isomap is being made; call it after "
      "VolumeMapperRenderEndEvent, or after BuildIsomap has returned.");
  }
  return this->IsMaking;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::MayGoOn(vtkRenderWindow* window)
{
  return !(window && window->CheckAbortStatus());
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Internals::TellStart()
{
  const Busy busy(*this);
  this->Self->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Internals::TellProgress(
  double progress, vtkRenderWindow* window)
{
  this->Self->InvokeEvent(FrameProgressEvent, &progress);
  if (window)
  {
    window->InvokeEvent(FrameProgressEvent, &progress);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Internals::ReportOnce(const std::string& error)
{
  if (!error.empty() && error != this->LastError)
  {
    this->LastError = error;
    vtkErrorWithObjectMacro(this->Self, << error);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Internals::WarnOfIsomapLimit(bool isTooLarge)
{
  if (this->HasWarned || this->Self->IsomapMemoryLimit == 0 ||
    !(isTooLarge || this->Frames.IsIsomapTooLarge()))
  {
    return;
  }
  this->HasWarned = true;
  vtkWarningWithObjectMacro(this->Self,
    "The isomap of this view does not fit into IsomapMemoryLimit ("
      << this->Self->IsomapMemoryLimit
      << " MiB). Its least recently used bands are dropped, and built again when they are needed. "
         "Raise the limit, or set a narrower IsomapRange or a larger IsomapTolerance.");
}

//------------------------------------------------------------------------------
std::string vtkTemporalCoherenceVolumeMapper::Internals::ReasonOf(
  TemporalCoherence::DivisionLimit limit) const
{
  const std::string fewer = " fewer cells, for example with vtkExtractCells.";
  switch (limit)
  {
    case TemporalCoherence::DivisionLimit::Memory:
      return "MeshMemoryLimit (" + std::to_string(this->Self->MeshMemoryLimit) +
        " MiB) allows no more cells. Raise the limit, or draw" + fewer;
    case TemporalCoherence::DivisionLimit::Cells:
      return "there would be too many linear cells. Draw" + fewer;
    default:
      return "an edge is divided into no more than 512 parts, one of a pyramid into 16. If that "
             "shows, divide the cells before.";
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Internals::WarnOfDivision()
{
  constexpr double largestError = 0.01;
  const TemporalCoherence::DivisionError& error = this->SetUp.Error;
  const bool isLarge = error.OfPoints > largestError || error.OfValues > largestError;
  if (isLarge && !this->HasWarnedOfDivision)
  {
    vtkWarningWithObjectMacro(this->Self,
      "Curved cells of the input are drawn with an error of up to "
        << 100.0 * error.OfPoints << " % of their size (GetMeshPointError) and "
        << 100.0 * error.OfValues << " % of the range of their values (GetMeshValueError), as "
        << this->ReasonOf(error.Limit));
  }
  this->HasWarnedOfDivision = isLarge;
  if (error.Overlapping > 0 && !this->HasWarnedOfOverlap)
  {
    vtkWarningWithObjectMacro(this->Self,
      << error.Overlapping << " concave "
      << (error.Overlapping == 1 ? "polyhedron is" : "polyhedra are") << " drawn beyond the faces ("
      << error.Overlaps
      << "), as no division into parts was found. Check that the faces close and do not cross each "
         "other, divide the cells, or leave them out with vtkExtractCells.");
  }
  this->HasWarnedOfOverlap = error.Overlapping > 0;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::Internals::Warn(const std::string& warning)
{
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(this->Self, << warning);
  }
}
VTK_ABI_NAMESPACE_END
