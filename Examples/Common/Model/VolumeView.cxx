// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/VolumeView.h"

#include "Files/Arrays.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Appearance.h"
#include "View/Picture.h"
#include "View/Viewpoint.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkCommand.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkImageShrink3D.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkStringArray.h>
#include <vtkTemporalCoherencePresets.h>
#include <vtkVector.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace
{

// Of Row::Background, of 255.
constexpr std::array<std::array<double, 3>, 3> Backgrounds = { { { 16.0, 18.0, 22.0 },
  { 128.0, 130.0, 134.0 }, { 255.0, 255.0, 255.0 } } };
constexpr double ShareFilled = 0.85; // of the view, by the volume's box

// The blend modes of Row::Drawing.
constexpr std::array<int, 6> BlendModes = { vtkVolumeMapper::ISOSURFACE_BLEND,
  vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
  vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
  vtkVolumeMapper::ADDITIVE_BLEND };

// The grey that a tenth of what is seen reaches.
double BrightGreyOf(vtkImageData* picture)
{
  const auto* color = static_cast<const unsigned char*>(picture->GetScalarPointer());
  std::vector<unsigned char> greys;
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
  {
    if (color[4 * i] > 0)
    {
      greys.push_back(color[4 * i]);
    }
  }
  if (greys.empty())
  {
    return 0.0;
  }
  const auto bright = greys.begin() + static_cast<std::ptrdiff_t>(greys.size() * 9 / 10);
  std::nth_element(greys.begin(), bright, greys.end());
  return *bright;
}

// While it lives, the mapper's progress is passed on, and what is answered back.
class Watched
{
public:
  Watched(vtkTemporalCoherenceVolumeMapper* mapper, unsigned long event, const Progress& progress)
    : Mapper(mapper)
    , Report(progress)
    , Tags({ mapper->AddObserver(event, this, &Watched::OnProgress),
        mapper->AddObserver(vtkCommand::ErrorEvent, this, &Watched::OnError) })
  {
  }
  ~Watched()
  {
    this->Mapper->RemoveObserver(this->Tags[0]);
    this->Mapper->RemoveObserver(this->Tags[1]);
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  bool IsStopped = false;
  bool HasFailed = false;

private:
  void OnProgress(vtkObject*, unsigned long, void* share)
  {
    this->IsStopped = this->IsStopped || !this->Report(*static_cast<double*>(share));
    if (this->IsStopped)
    {
      this->Mapper->SetAbortExecute(1);
    }
  }
  void OnError() { this->HasFailed = true; }

  vtkTemporalCoherenceVolumeMapper* Mapper;
  const Progress& Report;
  std::array<unsigned long, 2> Tags;
};

VolumeView::Mapping NewMapper()
{
  const auto mapper = VolumeView::Mapping::New();
  // The histogram beside the view shows where the isovalue lies in the range.
  mapper->WarnOfIsovaluesOff();
  return mapper;
}

void SetInput(const Volume& volume, int component, vtkTemporalCoherenceVolumeMapper* mapper)
{
  mapper->SetInputDataObject(volume.Data);
  ShowArray(volume, mapper);
  const std::vector<vtkDataArray*> arrays = ShownArrays(volume);
  const bool hasSeveral = !arrays.empty() && arrays.front()->GetNumberOfComponents() > 1;
  using Modes = vtkTemporalCoherenceVolumeMapper;
  mapper->SetVectorMode(!hasSeveral ? Modes::DISABLED
      : component < 0               ? Modes::MAGNITUDE
                                    : Modes::COMPONENT);
  mapper->SetVectorComponent(std::max(component, 0));
}

}

VolumeView::VolumeView()
  : Mapper(NewMapper())
{
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetInterpolationTypeToLinear();
}

VolumeView::Mapping VolumeView::Prepare(
  const Volume& volume, int component, double isovalue, const Progress& progress)
{
  const Mapping mapper = NewMapper();
  SetInput(volume, component, mapper);
  vtkNew<vtkVolume> actor;
  actor->SetMapper(mapper);
  actor->SetUserMatrix(volume.Placement);
  actor->GetProperty()->SetInterpolationTypeToLinear();
  actor->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
  vtkNew<vtkRenderer> renderer;
  renderer->ResetCamera(actor->GetBounds());
  vtkNew<vtkImageData> color;
  Watched watch(mapper, vtkCommand::VolumeMapperRenderProgressEvent, progress);
  constexpr int few = 16; // pixels: what depends on the data is the same for any picture
  mapper->MakeImage(renderer, actor, few, few, color, nullptr);
  if (watch.IsStopped)
  {
    throw UserError("Opening " + Quoted(volume.Name) + " was stopped; what was shown stays.");
  }
  // Errors are told once: by a mapper that somebody listens to.
  return watch.HasFailed ? NewMapper() : mapper;
}

void VolumeView::Show(
  const Volume& volume, int component, const std::array<double, 2>& range, const Mapping& by)
{
  this->Range = range;
  this->HasCells = HasMeshes(volume.Data);
  if (by)
  {
    this->Mapper = by;
    this->Actor->SetMapper(by);
  }
  SetInput(volume, component, this->Mapper);
  this->Actor->SetUserMatrix(volume.Placement);
  this->Mapper->GetBounds(this->Bounds.data());
  std::copy_n(this->Actor->GetBounds(), 6, this->BoundsInWorld.begin());
  this->Beside.Show(volume, component, this->Bounds);
  if (!this->Renderer->HasViewProp(this->Actor))
  {
    this->Renderer->AddVolume(this->Actor);
  }
}

// Colours and opacities are linear between markers. Unless one has a colour of its own, colours are
// the palette's.
void VolumeView::SetMarkers(const std::vector<Marker>& markers)
{
  vtkVolumeProperty* property = this->Actor->GetProperty();
  vtkContourValues* values = property->GetIsoSurfaceValues();
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacity;
  bool hasOwn = false;
  int count = 0;
  for (const Marker& marker : markers)
  {
    const Rgb color = this->ColorOf(marker);
    colors->AddRGBPoint(marker.Value, color[0], color[1], color[2]);
    hasOwn = hasOwn || marker.Color;
    if (marker.IsVisible)
    {
      values->SetValue(count++, marker.Value);
      opacity->AddPoint(marker.Value, marker.Opacity);
    }
  }
  if (count == 0)
  {
    values->SetValue(count++, markers[0].Value);
    opacity->AddPoint(markers[0].Value, 0.0);
  }
  values->SetNumberOfContours(count);
  property->SetScalarOpacity(opacity);
  if (hasOwn)
  {
    property->GetRGBTransferFunction()->DeepCopy(colors);
  }
}

// Opaque, from black to white.
void VolumeView::SetGreys(const std::vector<Marker>& ends)
{
  const double window = ends[1].Value - ends[0].Value;
  vtkTemporalCoherencePresets::ApplyWindowLevel(
    this->Actor->GetProperty(), window, ends[0].Value + 0.5 * window);
}

void VolumeView::SetLabels(const Look& look)
{
  vtkNew<vtkLookupTable> table;
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(look.Labels.size()));
  vtkNew<vtkIntArray> labels;
  vtkNew<vtkStringArray> names;
  for (const LabelLook& label : look.Labels)
  {
    table->SetTableValue(labels->InsertNextValue(label.Label), label.Color[0], label.Color[1],
      label.Color[2], label.IsVisible ? label.Opacity : 0.0);
    names->InsertNextValue(label.Name);
  }
  table->SetAnnotations(labels, names);
  this->Mapper->SetLabelTable(table);
  this->Mapper->SetLabelRadius(look.Values[Row::LabelRadius]);
}

// What is at the focal point stays as large as it is.
void VolumeView::SetProjection(bool isParallel)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (isParallel == (camera->GetParallelProjection() != 0))
  {
    return;
  }
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  if (isParallel)
  {
    camera->SetParallelScale(tangent * camera->GetDistance());
  }
  else
  {
    camera->Dolly(camera->GetDistance() * tangent / camera->GetParallelScale());
  }
  camera->SetParallelProjection(isParallel);
  this->Renderer->ResetCameraClippingRange();
}

void VolumeView::Apply(Look& look)
{
  vtkVolumeProperty* property = this->Actor->GetProperty();
  this->Ground = Backgrounds[static_cast<std::size_t>(look.Choice(Row::Background))];
  this->Renderer->SetBackground(
    this->Ground[0] / 255.0, this->Ground[1] / 255.0, this->Ground[2] / 255.0);
  this->SetProjection(look.Choice(Row::Projection) != 0);
  SetPalette(property->GetRGBTransferFunction(), look.Choice(Row::Palette), this->Range);
  SetMaterial(property, look.Choice(Row::Material));
  double* shading = &look.Values[Row::Shading];
  if (look.Values[Row::OwnShading] != 0.0)
  {
    property->ShadeOn();
    property->SetAmbient(shading[0]);
    property->SetDiffuse(shading[1]);
    property->SetSpecular(shading[2]);
    property->SetSpecularPower(shading[3]);
  }
  shading[0] = property->GetAmbient();
  shading[1] = property->GetDiffuse();
  shading[2] = property->GetSpecular();
  shading[3] = property->GetSpecularPower();
  SetLight(this->Renderer, look.Choice(Row::Light));
  const bool areSurfaces = this->HasCells || !look.Blends();
  const int drawing = areSurfaces ? Drawing::Surfaces : look.Choice(Row::Drawing);
  const bool areLabels = look.Choice(Row::Drawing) == Drawing::Labels && this->AreLabels;
  this->Mapper->SetBlendMode(BlendModes[static_cast<std::size_t>(drawing)]);
  // Rays of blended volumes take long: fewer of them while something is dragged.
  this->Mapper->SetAutoAdjustSampleDistances(!areSurfaces);
  this->Mapper->SetMaximumImageSampleDistance(30.0f);
  if (!areSurfaces && look.IsProjection())
  {
    this->SetGreys(look.Greys);
  }
  else
  {
    this->SetMarkers(areSurfaces ? look.Surfaces : look.Nodes);
  }
  this->SetDensity(look, drawing);
  this->Mapper->SetSurfaceMode(
    areLabels ? vtkTemporalCoherenceVolumeMapper::LABELS : look.Choice(Row::Surface));
  this->Labels = areLabels ? look.Labels : std::vector<LabelLook>();
  if (areLabels)
  {
    this->SetLabels(look);
  }
  this->Mapper->SetSmoothMeshNormals(look.Values[Row::Gradients] != 0);
  this->Mapper->SetAmbientOcclusion(areSurfaces && look.Values[Row::Occlusion] != 0);
  this->Mapper->SetAmbientOcclusionRadius(look.Values[Row::OcclusionRadius] * this->LongestEdge());
  this->Mapper->SetAmbientOcclusionStrength(look.Values[Row::OcclusionStrength]);
  this->Mapper->SetShadows(areSurfaces && look.Values[Row::Shadows] != 0);
  this->Mapper->SetReuseAccuracy(
    vtkTemporalCoherenceVolumeMapper::EXACT + look.Choice(Row::Accuracy));
  this->Mapper->SetReuseFrames(look.Values[Row::ImageCache] != 0);
  this->Mapper->SetIsomap(look.Values[Row::Isomap] != 0);
  this->Mapper->SetSpaceLeaping(look.Values[Row::Leaping] != 0);
  this->Mapper->SetColorByAnswer(look.Values[Row::Answers] != 0);
  // A completed picture owes nothing to the cache: it would have no yellow.
  this->Mapper->SetRefineWhenStill(look.Values[Row::Answers] == 0);
  this->Mapper->SetCropping(look.Values[Row::Cropping] != 0);
  this->Mapper->SetCroppingRegionFlagsToSubVolume();
  this->Mapper->SetCroppingRegionPlanes(&look.Values[Row::Crop]);
  this->Mapper->RemoveAllClippingPlanes();
  if (look.Values[Row::Clipping] != 0)
  {
    this->Clip->SetOrigin(look.Clip.Origin.data());
    this->Clip->SetNormal(look.Clip.Normal.data());
    this->Mapper->AddClippingPlane(this->Clip);
  }
  this->Colors.Apply(look, areSurfaces, this->Mapper);
  this->Beside.Apply(look, property->GetRGBTransferFunction(), this->Colors.Key());
}

// Sums end at white, so that their brightness has to come from the density.
void VolumeView::SetDensity(const Look& look, int drawing)
{
  const Box& box = this->Bounds;
  const double diagonal = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  const double brightness = drawing >= Drawing::Average && look.Values[Row::Brightness] > 0.0
    ? look.Values[Row::Brightness]
    : 1.0;
  const double ofSums = drawing == Drawing::Additive ? brightness : 1.0;
  this->Actor->GetProperty()->SetScalarOpacityUnitDistance(
    std::max(0.01 * diagonal / (look.Values[Row::Density] * ofSums), 1e-30));
  const auto window = static_cast<float>(drawing == Drawing::Average ? 1.0 / brightness : 1.0);
  this->Mapper->SetFinalColorWindow(window);
  this->Mapper->SetFinalColorLevel(0.5f * window);
}

// From small pictures: a dark one has few greys, and is looked at again.
double VolumeView::FittingBrightness(Look look)
{
  constexpr int side = 32, trials = 6;
  constexpr double aim = 0.9 * 255, white = 255, least = 0.7 * 255;
  const std::array<double, 2>& limits = AllSettings()[Row::Brightness].Range;
  double& brightness = look.Values[Row::Brightness];
  brightness = 1.0;
  this->Renderer->ResetCameraClippingRange();
  this->Mapper->ProgressiveImagesOn(); // edges need no more rays here
  for (int trial = 0; trial < trials; ++trial)
  {
    this->Apply(look);
    vtkNew<vtkImageData> picture;
    const bool isMade =
      this->Mapper->MakeImage(this->Renderer, this->Actor, side, side, picture, nullptr);
    const double grey = isMade ? BrightGreyOf(picture) : 0.0;
    if (grey == 0.0)
    {
      brightness = isMade ? 0.0 : 1.0;
      break;
    }
    if (grey >= least && grey < white)
    {
      break;
    }
    brightness *= grey < white ? aim / grey : 0.1;
    brightness = std::clamp(brightness, limits[0], limits[1]);
  }
  this->Mapper->ProgressiveImagesOff();
  return brightness;
}

// In the world.
double VolumeView::LongestEdge() const
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkMatrix4x4* matrix = this->Actor->GetMatrix();
    const double edge = std::hypot(
      matrix->GetElement(0, axis), matrix->GetElement(1, axis), matrix->GetElement(2, axis));
    const auto at = static_cast<std::size_t>(2 * axis);
    longest = std::max(longest, edge * (this->Bounds[at + 1] - this->Bounds[at]));
  }
  return longest;
}

void VolumeView::LookFrom(const std::string& from, const std::string& up)
{
  const double* bounds = this->Actor->GetBounds();
  Viewpoint(this->Renderer, bounds, from, up).PlaceCamera(this->Renderer, 0.0);
  // As large as it can be as it lies there; a little smaller, so that it may be turned.
  double widest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double x = bounds[corner & 1], y = bounds[2 + ((corner >> 1) & 1)],
           z = bounds[4 + ((corner >> 2) & 1)];
    this->Renderer->WorldToView(x, y, z);
    widest = std::max({ widest, std::abs(x), std::abs(y) });
  }
  this->Renderer->GetActiveCamera()->Zoom(std::clamp(ShareFilled / widest, 0.3, 3.0));
}

CameraState VolumeView::Camera() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  CameraState state;
  camera->GetPosition(state.Position.data());
  camera->GetFocalPoint(state.FocalPoint.data());
  camera->GetViewUp(state.ViewUp.data());
  state.ViewAngle = camera->GetViewAngle();
  state.ParallelScale = camera->GetParallelScale();
  return state;
}

Plane VolumeView::MiddlePlane() const
{
  Plane plane;
  const vtkVector3d forward(this->Renderer->GetActiveCamera()->GetDirectionOfProjection());
  vtkVector3d right = forward.Cross(vtkVector3d(this->Renderer->GetActiveCamera()->GetViewUp()));
  right.Normalize();
  for (int i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(i);
    plane.Origin[axis] = 0.5 * (this->BoundsInWorld[2 * axis] + this->BoundsInWorld[2 * axis + 1]);
    plane.Normal[axis] = 0.8 * forward[i] - 0.6 * right[i];
  }
  return plane;
}

void VolumeView::SetCamera(const CameraState& state)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(state.Position.data());
  camera->SetFocalPoint(state.FocalPoint.data());
  camera->SetViewUp(state.ViewUp.data());
  camera->SetViewAngle(state.ViewAngle);
  camera->SetParallelScale(state.ParallelScale);
  this->Renderer->ResetCameraClippingRange();
}

bool VolumeView::BuildIsomap(const Progress& progress)
{
  const Watched watch(this->Mapper, vtkCommand::ProgressEvent, progress);
  this->Mapper->SetIsomapRange(this->Range.data());
  const bool isBuilt = this->Mapper->BuildIsomap(this->Renderer, this->Actor);
  // Views that follow begin with narrow bands again.
  this->Mapper->SetIsomapRange(1.0, 0.0);
  return isBuilt;
}

vtkSmartPointer<vtkImageData> VolumeView::LastFrame()
{
  vtkNew<vtkImageData> frame;
  using M = vtkTemporalCoherenceVolumeMapper;
  const int depth = this->Beside.HasAny() ? M::FRAME_DEPTH : 0;
  if (!this->Mapper->GetLastFrame(frame, M::FRAME_COLOR | depth))
  {
    throw UserError("There is no picture yet; open a volume first.");
  }
  return this->Finished(frame.Get(), true, 1);
}

vtkSmartPointer<vtkImageData> VolumeView::Picture(
  int width, int height, const Progress& progress, bool hasBackground, int raysOfSide)
{
  vtkNew<vtkImageData> frame;
  this->Renderer->ResetCameraClippingRange();
  const Watched watch(this->Mapper, vtkCommand::VolumeMapperRenderProgressEvent, progress);
  width *= raysOfSide;
  height *= raysOfSide;
  // Without annotations, depths would only take memory.
  const bool isMade = this->Beside.HasAny()
    ? this->Mapper->MakeImage(this->Renderer, this->Actor, width, height, frame)
    : this->Mapper->MakeImage(this->Renderer, this->Actor, width, height, frame, nullptr);
  if (!isMade)
  {
    throw UserError(watch.IsStopped ? "The picture was stopped, and is not saved."
                                    : "The picture could not be made; choose a smaller size.");
  }
  return this->Finished(frame.Get(), hasBackground, raysOfSide);
}

// With annotations, as large as they are in the view.
vtkSmartPointer<vtkImageData> VolumeView::Finished(
  vtkSmartPointer<vtkImageData> frame, bool hasBackground, int raysOfSide)
{
  if (this->Beside.HasAny())
  {
    this->Beside.DrawOver(frame);
  }
  if (raysOfSide > 1)
  {
    vtkNew<vtkImageShrink3D> mean;
    mean->SetInputData(frame);
    mean->SetShrinkFactors(raysOfSide, raysOfSide, 1);
    mean->AveragingOn();
    mean->Update();
    frame = mean->GetOutput();
  }
  return hasBackground ? OnBackground(frame, this->Ground, this->Ground) : WithoutBackground(frame);
}

// Where the ray through the pixel meets the clipping plane.
std::optional<VolumeView::Seen> VolumeView::CutAt(int x, int y)
{
  if (!this->Beside.ShowsCut())
  {
    return std::nullopt;
  }
  std::array<Point, 2> ends; // of the ray
  for (std::size_t end = 0; end < 2; ++end)
  {
    this->Renderer->SetDisplayPoint(x + 0.5, y + 0.5, static_cast<double>(end));
    this->Renderer->DisplayToWorld();
    const double* const world = this->Renderer->GetWorldPoint();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ends[end][axis] = world[axis] / world[3];
    }
  }
  Seen seen;
  double share = 0.0;
  if (!vtkPlane::IntersectWithLine(ends[0].data(), ends[1].data(), this->Clip->GetNormal(),
        this->Clip->GetOrigin(), share, seen.Place.data()))
  {
    return std::nullopt;
  }
  const std::optional<double> sample = this->Beside.SampleAt(seen.Place);
  seen.Value = sample.value_or(0.0);
  seen.IsCut = true;
  return sample ? std::optional<Seen>(seen) : std::nullopt;
}

std::optional<VolumeView::Seen> VolumeView::SeenAt(int x, int y)
{
  std::optional<Seen> seen = this->CutAt(x, y);
  Seen surface;
  Point normal;
  int index = -1;
  const bool isHit =
    this->Mapper->PickPixel(x, y, surface.Place.data(), normal.data(), &index) && index >= 0;
  const double* const eye = this->Renderer->GetActiveCamera()->GetPosition();
  const auto distance = [eye](const Seen& of)
  { return vtkMath::Distance2BetweenPoints(of.Place.data(), eye); };
  if (isHit && (!seen || distance(surface) < distance(*seen)))
  {
    surface.Value = this->Labels.empty()
      ? this->Actor->GetProperty()->GetIsoSurfaceValues()->GetValue(index)
      : index;
    for (const LabelLook& label : this->Labels)
    {
      surface.Label = label.Label == index ? label.Name : surface.Label;
    }
    return surface;
  }
  return seen;
}

Rgb VolumeView::ColorOf(const Marker& marker) const
{
  Rgb color = marker.Color.value_or(Rgb{});
  if (!marker.Color)
  {
    this->Actor->GetProperty()->GetRGBTransferFunction()->GetColor(marker.Value, color.data());
  }
  return color;
}
