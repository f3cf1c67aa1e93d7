// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "AppearanceFromVolume.h"
#include "FieldFromImage.h"
#include "FrameRenderer.h"
#include "HiddenCellsFromImage.h"
#include "ImageFromFrame.h"
#include "InputFromMapper.h"
#include "LineTracer.h"
#include "PointsFromFrame.h"
#include "RegionFromMapper.h"
#include "SampleDistance.h"
#include "SelectionPass.h"
#include "Stopwatch.h"
#include "ViewFromRenderer.h"
#include "ViewerStates.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkTemporalCoherenceVolumeMapper);

struct vtkTemporalCoherenceVolumeMapper::Internals
{
  TemporalCoherence::InputFromMapper Input;
  TemporalCoherence::HiddenCellsOfImage Hidden;
  TemporalCoherence::ViewerStates Viewers;
  std::shared_ptr<TemporalCoherence::ViewerState> Last = Viewers.MakeState(); ///< made a frame
  std::shared_ptr<TemporalCoherence::ViewerState> Mapped = Last; ///< asked for an isomap or a frame
  TemporalCoherence::SampleDistanceChooser Distances;
  double PresentTime = 0.0;
  std::string LastError;  ///< reported already; empty after a frame without error
  bool HasWarned = false; ///< of the limit of memory
  bool IsBusy = false;    ///< observers of a frame that is being made may call anything

  const TemporalCoherence::FrameStatistics& Statistics() const
  {
    return this->Last->Frames.Statistics();
  }
  const TemporalCoherence::Isomap& LastIsomap() const
  {
    return this->Mapped->Frames.IsomapOfLastView();
  }

  /// Remember what rays take, if the last frame had any traced or looked up.
  void Learn(double allowed)
  {
    const TemporalCoherence::FrameStatistics& last = this->Statistics();
    if (last.Made != TemporalCoherence::Route::Redisplay &&
      last.Made != TemporalCoherence::Route::Reshade)
    {
      // The next frames in the view need not build an isomap again.
      this->Distances.Learn(
        this->Last->Frames.LastFrame().Size, last.FrameTime - last.IsomapBuildTime, allowed);
    }
  }
};

namespace
{

TemporalCoherence::FrameRenderer::Options MakeOptions(vtkTemporalCoherenceVolumeMapper& mapper)
{
  using Mapper = vtkTemporalCoherenceVolumeMapper;
  TemporalCoherence::FrameRenderer::Options options;
  options.SpaceLeaping = mapper.GetSpaceLeaping() != 0;
  options.Reuse.ImageCache = mapper.GetImageCache() != 0;
  options.Reuse.Isomap = mapper.GetIsomap() != 0;
  options.Reuse.RefineWhenStill = mapper.GetRefineWhenStill() != 0;
  switch (mapper.GetReuseAccuracy())
  {
    case Mapper::EXACT:
      options.Accuracy = TemporalCoherence::ReuseAccuracy::Exact;
      break;
    case Mapper::PAPER:
      options.Accuracy = TemporalCoherence::ReuseAccuracy::Paper;
      break;
    default:
      options.Accuracy = TemporalCoherence::ReuseAccuracy::Bounded;
      break;
  }
  options.InterpolateColors = mapper.GetImageCacheShading() == Mapper::CACHE_INTERPOLATE;
  options.Images.Policy = mapper.GetImageCachePolicy() == Mapper::KEY_IMAGE
    ? TemporalCoherence::ImageCachePolicy::KeyImage
    : TemporalCoherence::ImageCachePolicy::Latest;
  options.Images.KeyImageInterval = mapper.GetKeyImageInterval();
  options.Images.NumberOfImages = mapper.GetNumberOfCachedImages();
  options.Map.Range = { mapper.GetIsomapRange()[0], mapper.GetIsomapRange()[1] };
  options.Map.Tolerance = mapper.GetIsomapTolerance();
  options.Map.HasNormals = mapper.GetIsomapShading() == Mapper::INTERPOLATE;
  options.Map.MemoryLimit = static_cast<std::size_t>(mapper.GetIsomapMemoryLimit()) << 20;
  return options;
}

TemporalCoherence::VectorChoice MakeVectorChoice(vtkTemporalCoherenceVolumeMapper& mapper)
{
  using Modes = TemporalCoherence::VectorChoice::Modes;
  TemporalCoherence::VectorChoice choice;
  choice.Component = mapper.GetVectorComponent();
  switch (mapper.GetVectorMode())
  {
    case vtkTemporalCoherenceVolumeMapper::MAGNITUDE:
      choice.Mode = Modes::Magnitude;
      break;
    case vtkTemporalCoherenceVolumeMapper::COMPONENT:
      choice.Mode = Modes::Component;
      break;
    default:
      choice.Mode = Modes::Property;
      break;
  }
  return choice;
}

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

}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper::vtkTemporalCoherenceVolumeMapper()
  : Internal(std::make_unique<Internals>())
{
  this->SetBlendModeToIsoSurface();
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
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  this->TimeToDraw = 0.0;
  {
    TemporalCoherence::Stopwatch watch(this->TimeToDraw);
    const glm::ivec2 size = TemporalCoherence::PictureSizeOf(renderer);
    if (size.x > 0 && size.y > 0)
    {
      this->RenderForWindow(renderer, volume, size.x, size.y);
      this->PresentFrame(renderer, volume, size.x, size.y);
    }
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

//------------------------------------------------------------------------------
/// Make a frame for a window, as coarse as is wished.
void vtkTemporalCoherenceVolumeMapper::RenderForWindow(
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
        { this->MinimumImageSampleDistance, this->MaximumImageSampleDistance }));
  }
  const glm::ivec2 rays =
    TemporalCoherence::RaysFor(pixels, static_cast<double>(this->ImageSampleDistance));
  if (this->RenderFrame(renderer, volume, rays.x, rays.y, renderer->GetTiledAspectRatio(),
        renderer->GetRenderWindow()))
  {
    internal.Last->PictureSize = pixels;
    internal.Learn(allowed);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::PresentFrame(
  vtkRenderer* renderer, vtkVolume* volume, int width, int height)
{
  // After an error this shows the last valid picture again.
  Internals& internal = *this->Internal;
  const auto state = internal.Viewers.Find(TemporalCoherence::Viewer::Of(renderer, volume));
  if (!state || state->Frames.LastFrame().IsEmpty() ||
    state->PictureSize != glm::ivec2(width, height))
  {
    return;
  }
  TemporalCoherence::Stopwatch watch(internal.PresentTime);
  std::string error;
  bool isShown = false;
  try
  {
    isShown = renderer->GetSelector()
      ? TemporalCoherence::PresentToSelector(renderer, volume, this->GetInput(), *state, error)
      : state->Presenter.Present(renderer, volume, state->Frames.LastFrame(),
          state->Frames.LastKey().Seen, state->Picture, error);
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory to show a picture of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels; free memory or make the window smaller.";
  }
  if (!isShown)
  {
    this->ReportOnce(error);
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::RenderFrame(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, double aspect, vtkRenderWindow* window)
{
  Internals& internal = *this->Internal;
  internal.PresentTime = 0.0;

  TemporalCoherence::FrameKey key;
  std::vector<int> places;
  std::string error;
  if (static_cast<vtkTypeInt64>(width) * height > VTK_INT_MAX)
  {
    this->ReportOnce("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels is too large; ask for at most " + std::to_string(VTK_INT_MAX) + " pixels.");
    return false;
  }
  if (!this->MakeFrameKey(renderer, volume, width, height, aspect, key, places, error))
  {
    this->ReportOnce(error);
    return false;
  }

  std::shared_ptr<TemporalCoherence::ViewerState> state;
  try
  {
    const Busy busy(internal.IsBusy);
    state = internal.Viewers.Serve(TemporalCoherence::Viewer::Of(renderer, volume));
    TemporalCoherence::FrameRenderer::Options options = MakeOptions(*this);
    options.ReportsTiles = IsHeard(*this, window);
    double farthest = 0.0; // a band that turns out too costly is begun again, narrower
    const auto tell = [&](double progress)
    {
      farthest = std::max(farthest, progress);
      double told = farthest;
      this->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &told);
      return window ? MayGoOn(window) : !this->GetAbortExecute();
    };
    if (!state->Frames.Render(key, options, tell))
    {
      return false;
    }
    internal.Last = internal.Mapped = state;
    tell(1.0);
    this->WarnOfIsomapLimit(state->Frames.IsIsomapTooLarge());
  }
  catch (const std::exception&) // bad_alloc, or length_error where a size has no number
  {
    this->ReportOnce("There is not enough memory for a frame of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels and the block ranges of " +
      std::to_string(key.Samples.Dimensions.x) + " x " + std::to_string(key.Samples.Dimensions.y) +
      " x " + std::to_string(key.Samples.Dimensions.z) +
      " samples; free memory, keep fewer cached images, or render a part of the volume "
      "(vtkExtractVOI) or fewer pixels.");
    return false;
  }
  state->IsovaluePlaces = places;
  state->Picture += internal.Statistics().Made != TemporalCoherence::Route::Redisplay;
  internal.LastError.clear();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::MakeFrameKey(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, double aspect, TemporalCoherence::FrameKey& key, std::vector<int>& places,
  std::string& error)
{
  vtkVolumeProperty* property = volume->GetProperty();
  TemporalCoherence::MapperInput input;
  if (!this->Internal->Input.Find(this, property, MakeVectorChoice(*this), input, error) ||
    !TemporalCoherence::FindSurfaces(property, input.Look, key.Sought, places, error))
  {
    return false;
  }
  key.Sought.Mode = this->SurfaceMode == THRESHOLD ? TemporalCoherence::SurfaceMode::Threshold
                                                   : TemporalCoherence::SurfaceMode::Crossing;

  if (renderer)
  {
    if (!TemporalCoherence::MakeView(renderer, { width, height }, aspect, key.Seen, error))
    {
      return false;
    }
    key.Look =
      TemporalCoherence::MakeAppearance(property, input.Look, renderer, key.Sought.Isovalues);
    key.Look.ColorByAnswer = this->ColorByAnswer != 0;
  }

  // An image without points has no array either: an empty picture, as for images without cells.
  if (!input.Array)
  {
    return true;
  }
  const TemporalCoherence::ImageAxes axes = TemporalCoherence::AxesOf(input.Image, input.OnCells);
  key.Sought.BySteepness =
    TemporalCoherence::MakeGradientOpacity(property, input.Look, glm::abs(axes.Step));
  if (!TemporalCoherence::MakeField(
        input.Image, input.Array, input.OnCells, input.Component, key.Samples, error) ||
    !this->Internal->Hidden.Find(input.Image, input.OnCells, key.Samples.Hidden, error) ||
    !TemporalCoherence::MakePlacement(input.Image, input.OnCells, volume, key.Where, error) ||
    !TemporalCoherence::MakeRegion(this, axes, key.Kept, error))
  {
    return false;
  }
  key.Samples.Grid = input.Grid;
  key.Samples.Between = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
    ? TemporalCoherence::Interpolation::Nearest
    : TemporalCoherence::Interpolation::Linear;
  return true;
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
void vtkTemporalCoherenceVolumeMapper::ReportOnce(const std::string& error)
{
  if (error != this->Internal->LastError)
  {
    this->Internal->LastError = error;
    vtkErrorMacro(<< error);
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::RenderToImage(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, vtkImageData* color, vtkImageData* depth)
{
  return this->RenderToImage(
    renderer, volume, width, height, color, depth, nullptr, nullptr, nullptr);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::RenderToImage(vtkRenderer* renderer, vtkVolume* volume,
  int width, int height, vtkImageData* color, vtkImageData* depth, vtkImageData* normals,
  vtkImageData* isovalueIndex, vtkImageData* answer)
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
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  const bool isMade = this->RenderFrame(
    renderer, volume, width, height, static_cast<double>(width) / height, nullptr);
  if (isMade)
  {
    this->Internal->Last->PictureSize = glm::ivec2(width, height);
    this->Internal->Learn(VTK_DOUBLE_MAX);
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
  return isMade && this->GetLastFrame(color, depth, normals, isovalueIndex, answer);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetLastFrame(vtkImageData* color, vtkImageData* depth,
  vtkImageData* normals, vtkImageData* isovalueIndex, vtkImageData* answer)
{
  const TemporalCoherence::Frame& frame = this->Internal->Last->Frames.LastFrame();
  if (frame.IsEmpty())
  {
    return false;
  }
  try
  {
    TemporalCoherence::WritePicture(frame, this->Internal->Last->IsovaluePlaces,
      { color, depth, normals, isovalueIndex, answer });
    return true;
  }
  catch (const std::exception&)
  {
    this->ReportOnce("There is not enough memory for images of " + std::to_string(frame.Size.x) +
      " x " + std::to_string(frame.Size.y) + " pixels; free memory or ask for fewer pixels.");
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::GetVisibleSurface(vtkPolyData* points)
{
  const TemporalCoherence::FrameRenderer& frames = this->Internal->Last->Frames;
  if (!points || frames.LastFrame().IsEmpty())
  {
    return false;
  }
  try
  {
    TemporalCoherence::WritePoints(
      frames.LastFrame(), frames.LastKey(), this->Internal->Last->IsovaluePlaces, points);
    return true;
  }
  catch (const std::exception&)
  {
    this->ReportOnce("There is not enough memory for the points of the visible surface; free "
                     "memory or render fewer pixels.");
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::PickPixel(
  int x, int y, double position[3], double normal[3], int* isovalueIndex)
{
  const TemporalCoherence::Frame& frame = this->Internal->Last->Frames.LastFrame();
  const glm::ivec2 pixels = this->Internal->Last->PictureSize;
  if (frame.IsEmpty() || x < 0 || y < 0 || x >= pixels.x || y >= pixels.y)
  {
    return false;
  }
  if (frame.Size != pixels)
  {
    // A coarse frame: the ray that the pixel shows.
    const glm::dvec2 rays = (glm::dvec2(x, y) + 0.5) / glm::dvec2(pixels) * glm::dvec2(frame.Size);
    x = std::min(static_cast<int>(rays.x), frame.Size.x - 1);
    y = std::min(static_cast<int>(rays.y), frame.Size.y - 1);
  }
  const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
  const int surface = frame.Isovalues[pixel];
  if (surface == TemporalCoherence::Frame::NoSurface)
  {
    return false;
  }
  const TemporalCoherence::Ray ray = this->Internal->Last->Frames.LastKey().Seen.RayThrough(x, y);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (position)
    {
      position[axis] = ray.Origin[axis] + frame.Depth[pixel] * ray.Direction[axis];
    }
    if (normal)
    {
      normal[axis] = static_cast<double>(frame.Normals[pixel][axis]);
    }
  }
  if (isovalueIndex)
  {
    *isovalueIndex = this->Internal->Last->IsovaluePlaces[static_cast<std::size_t>(surface)];
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::IntersectWithLine(vtkVolume* volume, const double p1[3],
  const double p2[3], double& t, double position[3], double normal[3], int* isovalueIndex)
{
  if (this->IsBusy("IntersectWithLine"))
  {
    return false;
  }
  if (!volume)
  {
    this->ReportOnce("IntersectWithLine needs a volume, but it is null.");
    return false;
  }
  const glm::dvec3 begin(p1[0], p1[1], p1[2]), end(p2[0], p2[1], p2[2]);
  const double length = glm::distance(begin, end);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    std::ostringstream what;
    what << "There is no line from (" << p1[0] << ", " << p1[1] << ", " << p1[2] << ") to ("
         << p2[0] << ", " << p2[1] << ", " << p2[2] << "); give it two finite ends that differ.";
    this->ReportOnce(what.str());
    return false;
  }
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  TemporalCoherence::FrameKey key;
  std::vector<int> places;
  std::string error;
  if (!this->MakeFrameKey(nullptr, volume, 1, 1, 1.0, key, places, error))
  {
    this->ReportOnce(error);
    return false;
  }
  try
  {
    const auto hit = TemporalCoherence::TraceLine(
      key, this->Internal->Last->Frames.FiniteRangeOf(key), begin, end);
    if (!hit)
    {
      return false;
    }
    t = hit->Distance / length;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (position)
      {
        position[axis] = hit->Position[axis];
      }
      if (normal)
      {
        normal[axis] = hit->Normal[axis];
      }
    }
    if (isovalueIndex)
    {
      *isovalueIndex = places[static_cast<std::size_t>(hit->Surface)];
    }
    return true;
  }
  catch (const std::exception&)
  {
    this->ReportOnce("There is not enough memory for the block ranges of the input; free memory, "
                     "or pick in a part of the volume (vtkExtractVOI).");
    return false;
  }
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
  glm::ivec2 size = internal.Last->Frames.LastFrame().Size;
  double aspect = size.y > 0 ? static_cast<double>(size.x) / size.y : 1.0;
  if (renderer->GetRenderWindow())
  {
    int x, y;
    renderer->GetTiledSizeAndOrigin(&size.x, &size.y, &x, &y);
    const float distance = this->AutoAdjustSampleDistances ? this->MinimumImageSampleDistance
                                                           : this->ImageSampleDistance;
    size = TemporalCoherence::RaysFor(size, static_cast<double>(distance));
    aspect = renderer->GetTiledAspectRatio();
  }
  if (size.x < 1 || size.y < 1)
  {
    this->ReportOnce("The size of the picture is not known; give the renderer a render window or "
                     "render a frame before BuildIsomap.");
    return false;
  }
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }

  TemporalCoherence::FrameKey key;
  std::vector<int> places;
  std::string error;
  if (!this->MakeFrameKey(renderer, volume, size.x, size.y, aspect, key, places, error))
  {
    this->ReportOnce(error);
    return false;
  }
  try
  {
    this->SetAbortExecute(0);
    const Busy busy(internal.IsBusy);
    double farthest = 0.0; // a band that turns out too costly is begun again, narrower
    internal.Mapped = internal.Viewers.Serve(TemporalCoherence::Viewer::Of(renderer, volume));
    const auto outcome = internal.Mapped->Frames.BuildIsomap(key, MakeOptions(*this),
      [&](double progress)
      {
        farthest = std::max(farthest, progress);
        this->UpdateProgress(farthest);
        return !this->GetAbortExecute() && MayGoOn(renderer->GetRenderWindow());
      });
    this->WarnOfIsomapLimit(outcome == TemporalCoherence::Isomap::Outcome::TooLarge);
    return outcome == TemporalCoherence::Isomap::Outcome::Built;
  }
  catch (const std::exception&)
  {
    this->ReportOnce("There is not enough memory for an isomap; free memory, or set an IsomapRange "
                     "that is narrower.");
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::WarnOfIsomapLimit(bool isTooLarge)
{
  Internals& internal = *this->Internal;
  if (internal.HasWarned || this->IsomapMemoryLimit == 0 ||
    !(isTooLarge || internal.LastIsomap().HasDropped()))
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
void vtkTemporalCoherenceVolumeMapper::ReleaseReuse()
{
  if (this->IsBusy("ReleaseReuse"))
  {
    return;
  }
  Internals& internal = *this->Internal;
  internal.HasWarned = false;
  internal.Hidden.Release();
  internal.Input.Release();
  internal.Viewers = TemporalCoherence::ViewerStates();
  internal.Last = internal.Mapped = internal.Viewers.MakeState();
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Viewers.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::IsOpaque(vtkVolume* volume)
{
  TemporalCoherence::MapperInput input;
  std::string error; // the next frame tells of it
  this->Internal->Input.Find(this, volume->GetProperty(), MakeVectorChoice(*this), input, error);
  return TemporalCoherence::IsOpaque(volume->GetProperty(), input.Look);
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceVolumeMapper::GetRoute()
{
  return static_cast<int>(this->Internal->Statistics().Made);
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceVolumeMapper::GetRouteAsString()
{
  return TemporalCoherence::NameOf(this->Internal->Statistics().Made);
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfRays()
{
  return this->Internal->Statistics().Rays;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfDefiniteHits()
{
  return this->Internal->Statistics().DefiniteHits;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfDefiniteMisses()
{
  return this->Internal->Statistics().DefiniteMisses;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfPossibleHits()
{
  return this->Internal->Statistics().PossibleHits;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfTracedRays()
{
  return this->Internal->Statistics().TracedRays;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfFieldSamples()
{
  return this->Internal->Statistics().FieldSamples;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetIsomapMemory()
{
  return static_cast<vtkIdType>(this->Internal->LastIsomap().MemoryInBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceVolumeMapper::GetNumberOfIsomapKnots()
{
  return static_cast<vtkIdType>(this->Internal->LastIsomap().NumberOfKnots());
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetFrameTime()
{
  return this->Internal->Statistics().FrameTime + this->Internal->PresentTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetTraceTime()
{
  return this->Internal->Statistics().TraceTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetQueryTime()
{
  return this->Internal->Statistics().QueryTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetIsomapBuildTime()
{
  return this->Internal->Mapped->Frames.Statistics().IsomapBuildTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetShadeTime()
{
  return this->Internal->Statistics().ShadeTime;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceVolumeMapper::GetPresentTime()
{
  return this->Internal->PresentTime;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceMode: " << (this->SurfaceMode == THRESHOLD ? "THRESHOLD" : "CROSSING")
     << endl;
  os << indent << "VectorMode: " << this->VectorMode << endl;
  os << indent << "VectorComponent: " << this->VectorComponent << endl;
  os << indent << "ImageCache: " << this->ImageCache << endl;
  os << indent << "Isomap: " << this->Isomap << endl;
  os << indent << "SpaceLeaping: " << this->SpaceLeaping << endl;
  os << indent << "ColorByAnswer: " << this->ColorByAnswer << endl;
  os << indent << "ReuseAccuracy: " << this->ReuseAccuracy << endl;
  os << indent << "RefineWhenStill: " << this->RefineWhenStill << endl;
  os << indent << "ImageCachePolicy: " << this->ImageCachePolicy << endl;
  os << indent << "KeyImageInterval: " << this->KeyImageInterval << endl;
  os << indent << "NumberOfCachedImages: " << this->NumberOfCachedImages << endl;
  os << indent << "ImageCacheShading: " << this->ImageCacheShading << endl;
  os << indent << "IsomapTolerance: " << this->IsomapTolerance << endl;
  os << indent << "IsomapRange: " << this->IsomapRange[0] << ", " << this->IsomapRange[1] << endl;
  os << indent << "IsomapMemoryLimit: " << this->IsomapMemoryLimit << endl;
  os << indent << "IsomapShading: " << this->IsomapShading << endl;
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << endl;
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << endl;
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << endl;
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << endl;
  os << indent << "Route: " << this->GetRouteAsString() << endl;
}
