// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Model.h"

#include "Files/Arrays.h"
#include "Files/VolumeReader.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Isovalue.h"

#include <vtkDataArray.h>
#include <vtkMath.h>

#include <algorithm>

namespace
{

constexpr std::size_t MostMarkers = 64; // surfaces, nodes
constexpr double MostOpacity = 0.6;     // of a ramp at first

// Nothing below the isovalue, and ever more above.
std::vector<Marker> FirstRamp(const std::array<double, 2>& range, double isovalue)
{
  std::vector<Marker> ramp = { { range[0], 0.0 }, { range[1], MostOpacity } };
  if (isovalue > range[0] && isovalue < range[1])
  {
    ramp.insert(ramp.begin() + 1, { isovalue, 0.0 });
  }
  return ramp;
}

void Fit(std::vector<Marker>& markers, const std::array<double, 2>& range, bool areAscending)
{
  markers.resize(std::min(markers.size(), MostMarkers));
  double least = range[0];
  for (Marker& marker : markers)
  {
    marker.Value = std::clamp(marker.Value, least, range[1]);
    least = areAscending ? marker.Value : least;
    marker.Opacity = std::clamp(marker.Opacity, 0.0, 1.0);
    for (std::size_t i = 0; marker.Color && i < 3; ++i)
    {
      (*marker.Color)[i] = std::clamp((*marker.Color)[i], 0.0, 1.0);
    }
  }
}

}

Model::Model(const std::string& from, const std::string& up)
  : From(from)
  , Up(up)
{
}

void Model::Load(Request& request, const Progress& progress)
{
  Session& wanted = request.Wanted;
  Volume& volume = request.Data;
  if (!volume.Data)
  {
    // Of the whole, reading is told as the first half.
    volume = ReadVolume(wanted.Source, [&](double share) { return progress(0.5 * share); });
  }
  ChooseArray(volume, wanted.Source.Array, wanted.Isovalue);
  const std::vector<vtkDataArray*> arrays = ShownArrays(volume);
  const int components = arrays.empty() ? 1 : arrays.front()->GetNumberOfComponents();
  if (wanted.Component >= components)
  {
    throw UserError("What is drawn of " + Quoted(volume.Name) + " has " +
      std::to_string(components) + " components, of which none has the number " +
      std::to_string(wanted.Component) + "; choose a smaller one.");
  }
  request.Samples = CountSamples(volume, wanted.Component);
  if (request.KeepsSurfaces && wanted.Isovalue)
  {
    const std::array<double, 2>& range = request.Samples.Range;
    wanted.Isovalue = std::clamp(*wanted.Isovalue, range[0], range[1]);
  }
  wanted.Isovalue = ChooseIsovalue(request.Samples, wanted.Isovalue, Quoted(volume.Name)).Value;
  if (!request.IsSameFile)
  {
    request.Mapper = VolumeView::Prepare(volume, wanted.Component, *wanted.Isovalue,
      [&](double share) { return progress(0.5 + 0.5 * share); });
  }
}

void Model::Adopt(Request& request)
{
  // Settings may have changed since the other array or step was asked for.
  Look look = request.IsSameFile ? this->Settings() : request.Wanted.Settings;
  const CameraState camera = request.IsSameFile ? this->View.Camera() : request.Wanted.Camera;
  this->Shown = request.Data;
  this->Samples = request.Samples;
  this->Current = request.Wanted;
  this->Ahead = {};
  this->View.Show(this->Shown, this->Current.Component, this->Samples.Range, request.Mapper);
  if (!request.KeepsSurfaces)
  {
    look.Surfaces.resize(request.IsSameFile ? 1 : std::max(look.Surfaces.size(), std::size_t{ 1 }));
    look.Surfaces[0].Value = *request.Wanted.Isovalue;
    look.Nodes.resize(request.IsSameFile ? 0 : look.Nodes.size());
  }
  this->SetSettings(look);
  if (request.IsSameFile || request.Wanted.HasCamera)
  {
    this->View.SetCamera(camera);
  }
  else
  {
    this->ResetView();
  }
}

void Model::Open(const Session& session)
{
  Request request;
  request.Wanted = session;
  Load(request, [](double) { return true; });
  this->Adopt(request);
}

std::string Model::Description() const
{
  std::string text = this->IsOpen() ? DescriptionOf(this->Shown) : "";
  if (this->Shown.TimeSteps > 1)
  {
    text += "  step " + std::to_string(this->Current.Source.TimeStep) + " of " +
      std::to_string(this->Shown.TimeSteps);
  }
  return text;
}

Request Model::OtherArray(const std::string& name, int component) const
{
  Request request = { this->Current, true, false, this->Shown };
  request.Wanted.Source.Array = name;
  request.Wanted.Component = component;
  request.Wanted.Isovalue.reset();
  return request;
}

Request Model::NextArrayOfFile() const
{
  const std::string name = NextArray(this->Shown);
  if (name.empty())
  {
    throw UserError(
      Quoted(this->Shown.Name) + " has one array only; open a file that has several to turn them.");
  }
  return this->OtherArray(name, 0);
}

Request Model::OtherTimeStep(int step) const
{
  const int count = this->Shown.TimeSteps;
  if (count < 2)
  {
    throw UserError(
      Quoted(this->Shown.Name) + " has one time step only; open a file that has several.");
  }
  Request request = { this->Current, true, true };
  request.Wanted.Source.TimeStep = (step - 1 + count) % count + 1;
  request.Wanted.Source.Array = this->Shown.Array.Name;
  return request;
}

// Sessions are written by people, too.
Look Model::Fitted(Look look) const
{
  const std::array<double, 2>& range = this->Samples.Range;
  look.Surfaces.resize(std::max(look.Surfaces.size(), std::size_t{ 1 }));
  Fit(look.Surfaces, range, false);
  look.Nodes = look.Nodes.size() < 2 ? FirstRamp(range, look.Surfaces[0].Value) : look.Nodes;
  Fit(look.Nodes, range, true);
  double* normal = look.Clip.Normal.data();
  if (!(vtkMath::Norm(normal) < 1e15 && vtkMath::Normalize(normal) > 1e-15 &&
        vtkMath::Norm(look.Clip.Origin.data()) < 1e15))
  {
    look.Clip = look.Values[Row::Clipping] != 0 ? this->View.MiddlePlane() : Plane{};
  }
  for (std::size_t row = Row::Shading; row < Row::Count; ++row)
  {
    const auto [least, most] = this->RangeOf(AllSettings()[row]);
    look.Values[row] = std::clamp(look.Values[row], least, most);
  }
  for (std::size_t to = Row::Crop + 1; to < Row::Count; to += 2)
  {
    look.Values[to] = std::max(look.Values[to - 1], look.Values[to]);
  }
  return look;
}

void Model::SetSettings(const Look& look, bool isShown)
{
  this->Current.Settings = this->Fitted(look);
  this->Current.Isovalue = this->Current.Settings.Surfaces[0].Value;
  if (isShown)
  {
    this->Apply();
  }
}

std::array<double, 2> Model::RangeOf(const Setting& number) const
{
  const double* along = number.Axis ? &this->View.DataBounds()[2 * *number.Axis] : nullptr;
  return along ? std::array<double, 2>{ along[0], along[1] } : number.Range;
}

void Model::ResetView()
{
  this->View.LookFrom(this->From.empty() ? this->Shown.From : this->From, this->Up);
}

void Model::LookFrom(const std::string& from)
{
  this->View.LookFrom(from, from[1] == this->Up[1] ? (from[1] == 'z' ? "+y" : "+z") : this->Up);
}

void Model::Save(const std::string& path)
{
  // Cameras make the way up a unit vector, each time by a bit or two: until it stays.
  for (int i = 0; i < 8; ++i)
  {
    this->View.SetCamera(this->View.Camera());
  }
  this->Current.Camera = this->View.Camera();
  this->Current.HasCamera = true;
  WriteSession(this->Current, path);
}

std::vector<double> Model::PresentSight()
{
  const CameraState camera = this->View.Camera();
  const int* size = this->View.Renderer->GetSize();
  std::vector<double> sight = { camera.ViewAngle, 1.0 * size[0], 1.0 * size[1],
    this->Settings().Values[Row::Surface] };
  for (const Point& point : { camera.Position, camera.FocalPoint, camera.ViewUp })
  {
    sight.insert(sight.end(), point.begin(), point.end());
  }
  return sight;
}

bool Model::WantsIsomapAhead()
{
  const auto& values = this->Settings().Values;
  return this->IsOpen() && this->DrawsSurfaces() && values[Row::Ahead] != 0 &&
    values[Row::Isomap] != 0 && this->Ahead != this->PresentSight();
}
