// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/MapperFrames.h"

#include "Frames/SelectionPass.h"
#include "Output/BufferImages.h"
#include "Output/PointsFromFrame.h"
#include "Scene/Timers.h"
#include "Volumes/Medium/BlendTracer.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <exception>

namespace TemporalCoherence
{
namespace
{

std::string TextOf(const glm::ivec2& size)
{
  return std::to_string(size.x) + " x " + std::to_string(size.y);
}

std::string TextOf(const glm::ivec3& size)
{
  return TextOf(glm::ivec2(size)) + " x " + std::to_string(size.z);
}

/// Report progress that never falls, even if a band of an isomap proves too costly and is begun
/// again, narrower.
ReportProgress Rising(const ReportProgress& report, double& farthest)
{
  return [&](double progress)
  {
    farthest = std::max(farthest, progress);
    return report(farthest);
  };
}

}

// Lack of memory throws bad_alloc, or length_error if a size exceeds its type.

bool MapperFrames::Render(const Viewer& viewer, const FrameRequest& request,
  const FrameRenderer::Options& options, const ReportProgress& report, std::string& error)
{
  try
  {
    double farthest = 0.0;
    const ReportProgress tell = Rising(report, farthest);
    const std::shared_ptr<ViewerState> state = this->Viewers.Serve(viewer);
    if (!state->Engine.Render(request.Key, options, tell))
    {
      return false;
    }
    state->IsovaluePlaces = request.IsovaluePlaces;
    state->Cells = request.Cells;
    state->ComparesDepths = request.ComparesDepths;
    if (state->Engine.Statistics().Made != Route::Redisplay)
    {
      state->PictureNumber = NewPictureNumber();
    }
    this->Last = this->Mapped = state;
    tell(1.0);
    return true;
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for a frame of " + TextOf(request.Key.View.Size) +
      " pixels and the block ranges of " + TextOf(request.Key.Samples.Dimensions) +
      " samples; free memory, keep fewer cached images, or render a part of the volume "
      "(vtkExtractVOI) or fewer pixels.";
    return false;
  }
}

RayBudget::Choice MapperFrames::ChooseRays(
  const Viewer& viewer, std::int64_t pixels, double allowed, double most, int kind) const
{
  const auto state = this->Viewers.Find(viewer);
  return (state ? state->Budget : RayBudget()).Choose(pixels, allowed, most, kind);
}

Isomap::Outcome MapperFrames::BuildIsomap(const Viewer& viewer, const FrameRequest& request,
  const FrameRenderer::Options& options, const ReportProgress& report, std::string& error)
{
  try
  {
    double farthest = 0.0;
    this->Mapped = this->Viewers.Serve(viewer);
    return this->Mapped->Engine.BuildIsomap(request.Key, options, Rising(report, farthest));
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for an isomap; free memory, or set an IsomapRange that is "
            "narrower.";
    return Isomap::Outcome::Impossible;
  }
}

void MapperFrames::Present(vtkRenderer* renderer, vtkVolume* volume, const glm::ivec2& size,
  vtkDataSet* data, std::string& error, PicturePart part)
{
  const auto state = this->Viewers.Find(Viewer::Of(renderer, volume));
  if (!state || state->Engine.LastFrame().IsEmpty() || state->PictureSize != size)
  {
    return;
  }
  Stopwatch watch(this->SecondsToPresent);
  try
  {
    if (renderer->GetSelector())
    {
      PresentToSelector(renderer, volume, data, *state, error);
    }
    else if (const auto pass = PeelingPass::Of(volume))
    {
      state->Peels.Present(*pass, renderer, volume, state->Shown(), error);
    }
    else
    {
      ShownFrame shown = state->Shown();
      shown.Part = part;
      state->Presenter.Present(renderer, volume, shown, error);
    }
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory to show a picture of " + TextOf(size) +
      " pixels; free memory or make the window smaller.";
  }
}

namespace
{

/// Write images of a frame.
/// \return false if there is no frame, or on error
template <typename Writer>
bool WriteImagesOf(const Frame& frame, const Writer& write, std::string& error)
{
  if (frame.IsEmpty())
  {
    return false;
  }
  try
  {
    write();
    return true;
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for images of " + TextOf(frame.Size) +
      " pixels; free memory or ask for fewer pixels.";
    return false;
  }
}

}

bool MapperFrames::WriteImages(const std::vector<FrameImage>& images, std::string& error) const
{
  const Frame& frame = this->Last->Engine.LastFrame();
  return WriteImagesOf(
    frame, [&]() { TemporalCoherence::WriteImages(frame, this->Last->IsovaluePlaces, images); },
    error);
}

bool MapperFrames::WriteBufferColors(vtkImageData* image, std::string& error) const
{
  const FrameRenderer& frames = this->Last->Engine;
  return image &&
    WriteImagesOf(
      frames.LastFrame(), [&]() { WriteColors(frames.LastFrame(), frames.LastKey(), image); },
      error);
}

bool MapperFrames::WriteBufferDepths(
  vtkImageData* image, int scalarType, bool endsAtBox, std::string& error) const
{
  const FrameRenderer& frames = this->Last->Engine;
  return image &&
    WriteImagesOf(
      frames.LastFrame(),
      [&]() { WriteDepths(frames.LastFrame(), frames.LastKey(), scalarType, endsAtBox, image); },
      error);
}

bool MapperFrames::WriteSurface(vtkPolyData* points, std::string& error) const
{
  const FrameRenderer& frames = this->Last->Engine;
  if (frames.LastFrame().IsEmpty())
  {
    return false;
  }
  if (frames.LastKey().IsBlended())
  {
    error = "The last frame shows no surface, since its volume is blended; call "
            "SetBlendModeToIsoSurface() and render, or read depths with GetLastFrame.";
    return false;
  }
  try
  {
    WritePoints(frames.LastFrame(), frames.LastKey(), this->Last->IsovaluePlaces, points);
    return true;
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for the points of the visible surface; free memory or "
            "render fewer pixels.";
    return false;
  }
}

std::optional<PixelHit> MapperFrames::FindHit(int x, int y) const
{
  const FrameRenderer& frames = this->Last->Engine;
  return FindPixelHit(frames.LastFrame(), frames.LastKey().View, this->Last->PictureSize, x, y);
}

CellOrigin MapperFrames::FindCell(int x, int y) const
{
  const auto hit = this->FindHit(x, y);
  return hit && this->Last->Cells ? this->Last->Cells->Of(hit->Cell) : CellOrigin();
}

std::optional<LineHit> MapperFrames::FindHit(
  const FrameRequest& request, const glm::dvec3& begin, const glm::dvec3& end, std::string& error)
{
  try
  {
    return TraceLine(request.Key, this->Last->Engine.RangesOf(request.Key), begin, end);
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for the block ranges of the input; free memory, or pick in "
            "a part of the volume (vtkExtractVOI).";
    return std::nullopt;
  }
}

}
