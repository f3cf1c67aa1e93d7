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
#include <cmath>
#include <utility>

namespace
{

constexpr double StepsInRange = 256.0; // one for each value of 8 bits
constexpr std::size_t MostRows = 64;   // surfaces, nodes
constexpr double MostOpacity = 0.6;    // of a ramp at first

// Nothing below the isovalue, and ever more above.
std::vector<Node> FirstRamp(const std::array<double, 2>& range, double isovalue)
{
  const double begin = std::clamp(isovalue, range[0], range[1]);
  std::vector<Node> ramp = { { range[0], 0.0 }, { range[1], MostOpacity } };
  if (begin > range[0] && begin < range[1])
  {
    ramp.insert(ramp.begin() + 1, { begin, 0.0 });
  }
  return ramp;
}

void FitColor(std::optional<Rgb>& color)
{
  for (std::size_t i = 0; color && i < 3; ++i)
  {
    (*color)[i] = std::clamp((*color)[i], 0.0, 1.0);
  }
}

}

Model::Model(const std::string& from, const std::string& up)
  : From(from)
  , Up(up)
{
}

Loaded Model::Load(Request request, const Progress& progress)
{
  Session& wanted = request.Wanted;
  Loaded loaded;
  // Of the whole, reading is told as the first half.
  loaded.Data = request.Have
    ? *request.Have
    : ReadVolume(wanted.Source, [&](double share) { return progress(0.5 * share); });
  ChooseArray(loaded.Data, wanted.Source.Array, wanted.Isovalue);
  const std::vector<vtkDataArray*> arrays = ShownArrays(loaded.Data);
  const int components = arrays.empty() ? 1 : arrays.front()->GetNumberOfComponents();
  if (wanted.Component >= components)
  {
    throw UserError("What is drawn of " + Quoted(loaded.Data.Name) + " has " +
      std::to_string(components) + " components, of which none has the number " +
      std::to_string(wanted.Component) + "; choose a smaller one.");
  }
  loaded.Samples = CountSamples(loaded.Data, wanted.Component);
  const std::array<double, 2>& range = loaded.Samples.Range;
  if (request.KeepsSurfaces && wanted.Isovalue)
  {
    wanted.Isovalue = std::clamp(*wanted.Isovalue, range[0], range[1]);
  }
  wanted.Isovalue = ChooseIsovalue(loaded.Samples, wanted.Isovalue, Quoted(loaded.Data.Name)).Value;
  if (!request.IsSameFile)
  {
    loaded.Mapper = VolumeView::Prepare(loaded.Data, wanted.Component, *wanted.Isovalue,
      [&](double share) { return progress(0.5 + 0.5 * share); });
  }
  loaded.For = std::move(request);
  return loaded;
}

void Model::Adopt(Loaded loaded)
{
  const Request& request = loaded.For;
  const CameraState camera = this->View.Camera();
  this->Shown = std::move(loaded.Data);
  this->Samples = std::move(loaded.Samples);
  this->Current = request.Wanted;
  this->Ahead = {};
  this->View.Show(this->Shown, this->Current.Component, this->Samples.Range, loaded.Mapper);
  Look look = request.Wanted.Settings;
  if (look.Surfaces.empty())
  {
    look.Surfaces.emplace_back();
  }
  look.Surfaces[0].Isovalue = *request.Wanted.Isovalue;
  this->SetSettings(look);
  if (request.IsSameFile)
  {
    this->View.SetCamera(camera);
  }
  else if (request.Wanted.Camera)
  {
    this->View.SetCamera(*request.Wanted.Camera);
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
  this->Adopt(Load(request, [](double) { return true; }));
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
  Request request;
  request.Wanted = this->Current;
  request.Have = this->Shown;
  request.IsSameFile = true;
  request.Wanted.Source.Array = name;
  request.Wanted.Component = component;
  request.Wanted.Isovalue.reset();
  request.Wanted.Settings.Surfaces.clear();
  request.Wanted.Settings.Nodes.clear();
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
  Request request;
  request.Wanted = this->Current;
  request.IsSameFile = true;
  request.KeepsSurfaces = true;
  request.Wanted.Source.TimeStep = (step - 1 + count) % count + 1;
  request.Wanted.Source.Array = this->Shown.Array.Name;
  return request;
}

// Sessions are written by people, too.
Look Model::Fitted(Look look) const
{
  const std::array<double, 2>& range = this->Samples.Range;
  look.Surfaces.resize(std::clamp(look.Surfaces.size(), std::size_t{ 1 }, MostRows));
  for (Surface& surface : look.Surfaces)
  {
    surface.Isovalue = std::clamp(surface.Isovalue, range[0], range[1]);
    surface.Opacity = std::clamp(surface.Opacity, 0.0, 1.0);
    FitColor(surface.Color);
  }
  if (look.Nodes.size() < 2)
  {
    look.Nodes = FirstRamp(range, look.Surfaces[0].Isovalue);
  }
  look.Nodes.resize(std::min(look.Nodes.size(), MostRows));
  double least = range[0];
  for (Node& node : look.Nodes)
  {
    node.Value = least = std::clamp(node.Value, least, range[1]);
    node.Opacity = std::clamp(node.Opacity, 0.0, 1.0);
    FitColor(node.Color);
  }
  if (look.Clip)
  {
    double* normal = look.Clip->Normal.data();
    const bool isUsable = vtkMath::Norm(normal) < 1e15 && vtkMath::Normalize(normal) > 1e-15 &&
      vtkMath::Norm(look.Clip->Origin.data()) < 1e15;
    look.Clip = isUsable ? look.Clip : std::nullopt;
  }
  const std::array<double, 6> box = this->View.DataBounds();
  for (std::size_t i = 0; look.Crop && i < 6; ++i)
  {
    double& side = (*look.Crop)[i];
    const std::size_t axis = i & ~std::size_t{ 1 };
    side = std::clamp(side, box[axis], box[axis + 1]);
    side = i % 2 == 1 ? std::max(side, (*look.Crop)[i - 1]) : side;
  }
  for (std::size_t i = 0; look.Shading && i < 4; ++i)
  {
    (*look.Shading)[i] = std::clamp((*look.Shading)[i], 0.0, i < 3 ? 1.0 : 200.0);
  }
  return look;
}

void Model::SetSettings(const Look& look, bool isShown)
{
  this->Current.Settings = this->Fitted(look);
  this->Current.Isovalue = this->Current.Settings.Surfaces[0].Isovalue;
  if (isShown)
  {
    this->Apply();
  }
}

double Model::StepOfIsovalues() const
{
  return (this->Samples.Range[1] - this->Samples.Range[0]) / StepsInRange;
}

void Model::StepIsovalue(double steps, std::size_t surface)
{
  Look look = this->Settings();
  look.Surfaces[surface].Isovalue += steps * this->StepOfIsovalues();
  this->SetSettings(look);
}

bool Model::Offers(const Choice& choice) const
{
  const bool isForData =
    choice.For == Choice::Data::Any || (choice.For == Choice::Data::Meshes) == this->View.IsMesh();
  return isForData && (choice.What != Choose::Surface || this->DrawsSurfaces());
}

bool Model::DrawsSurfaces() const
{
  return this->View.IsMesh() || this->Settings().Choices[Choose::Drawing] == DrawSurfaces;
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
  WriteSession(this->Current, path);
}

Model::Sight Model::PresentSight()
{
  const int* size = this->View.Renderer->GetSize();
  return { this->View.Camera(), { size[0], size[1], this->Settings().Choices[Choose::Surface] } };
}

bool Model::WantsIsomapAhead()
{
  const Chosen& choices = this->Settings().Choices;
  return this->IsOpen() && this->DrawsSurfaces() && choices.IsOn(Choose::Ahead) &&
    choices.IsOn(Choose::Isomap) && !(this->Ahead == this->PresentSight());
}
