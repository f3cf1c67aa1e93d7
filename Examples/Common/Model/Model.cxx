// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Model.h"

#include "Files/Arrays.h"
#include "Files/LabelNames.h"
#include "Files/VolumeReader.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Isovalue.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTemporalCoherencePresets.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace
{

constexpr std::size_t MostMarkers = 64; // surfaces, nodes
constexpr double MostOpacity = 0.6;     // of a ramp at first
constexpr double LeastWindow = 1e-3;    // of the range
// Samples below black and above white of projections, as shares of all.
constexpr double BelowBlack = 0.01, AboveWhite = 0.0005;
// Values of scans whose range is not that of Hounsfield units are taken as this range.
constexpr double LeastOfScans = -1000.0, MostOfScans = 2000.0;
constexpr double Stored = 1024.0; // is added by scanners that write no negative values

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

// The value below which a share of the samples lies.
double ValueBelow(const Histogram& counted, double share, bool leavesOutLeast = false)
{
  const std::vector<double>& bins = counted.Bins;
  const std::size_t first = leavesOutLeast && bins.size() > 1 ? 1 : 0;
  const double all =
    std::accumulate(bins.begin() + static_cast<std::ptrdiff_t>(first), bins.end(), 0.0);
  std::size_t bin = first;
  double below = bins[bin];
  while (bin + 1 < bins.size() && below < share * all)
  {
    below += bins[++bin];
  }
  return counted.Range[0] +
    (counted.Range[1] - counted.Range[0]) * static_cast<double>(bin) /
    static_cast<double>(std::max<std::size_t>(bins.size() - 1, 1));
}

// So that a projection is neither black nor white: its values lie among the largest or the
// smallest.
std::vector<Marker> FirstGreys(const Histogram& counted, int drawing)
{
  const bool isLeast = drawing == Drawing::Minimum;
  double black = isLeast ? counted.Range[0] : ValueBelow(counted, BelowBlack);
  double white = isLeast ? ValueBelow(counted, 0.5, true) : ValueBelow(counted, 1.0 - AboveWhite);
  if (!(white > black))
  {
    black = counted.Range[0];
    white = counted.Range[1];
  }
  return { { black, 0.0 }, { white, 1.0 } };
}

void Name(const LabelName& named, LabelLook& label)
{
  label.Name = named.Name;
  label.Color = named.Color.value_or(label.Color);
  if (named.Opacity)
  {
    label.IsVisible = *named.Opacity > 0.0;
    label.Opacity = label.IsVisible ? *named.Opacity : label.Opacity;
  }
}

// None if there is no file of names beside a volume: other files may have such a name.
std::vector<LabelLook> LabelsNamedBeside(const std::string& volume)
{
  std::vector<LabelLook> labels;
  const std::string names = LabelNamesBeside(volume);
  try
  {
    for (const LabelName& named :
      names.empty() ? std::vector<LabelName>() : ReadLabelNames(names, true))
    {
      if (named.Label != 0) // the outside
      {
        Name(named, labels.emplace_back(LabelLook{ named.Label, ColorOfLabel(named.Label) }));
      }
    }
  }
  catch (const UserError&)
  {
  }
  return labels;
}

// All labels but 0, which is the outside. None if the samples can be no labels.
std::vector<int> LabelsOf(const Volume& volume)
{
  constexpr std::size_t most = 65535; // in a list that can be used
  std::set<int> found;
  for (vtkDataArray* array :
    AreWholeNumbers(volume) ? ShownArrays(volume) : std::vector<vtkDataArray*>())
  {
    const std::vector<int> labels = WholeNumbersOf(array, most + 2);
    found.insert(labels.begin(), labels.end());
  }
  found.erase(0);
  return found.size() > most ? std::vector<int>() : std::vector<int>(found.begin(), found.end());
}

bool AreSame(const std::vector<Marker>& one, const std::vector<Marker>& other)
{
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
    [](const Marker& a, const Marker& b)
    { return a.Value == b.Value && a.Opacity == b.Opacity && a.Color == b.Color; });
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
  request.Labels = LabelsOf(volume);
  if (!request.IsSameFile && wanted.Settings.Labels.empty())
  {
    request.Named = LabelsNamedBeside(wanted.Source.Path);
  }
  if (request.KeepsSurfaces && wanted.Isovalue)
  {
    const std::array<double, 2>& range = request.Samples.Range;
    wanted.Isovalue = std::clamp(*wanted.Isovalue, range[0], range[1]);
  }
  wanted.Isovalue = ChooseIsovalue(request.Samples, wanted.Isovalue, Quoted(volume.Name)).Value;
  request.Coloring = volume.Bricks ? ColorArrays() : ColorArrays(volume.Data);
  const ArrayColor& color = wanted.Settings.ColorBy;
  if (request.Coloring.Has(color.Name, color.Component))
  {
    request.Coloring.Range(color.Name, color.Component); // is known then
  }
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
  this->Labels = request.Labels;
  this->View.Show(this->Shown, this->Current.Component, this->Samples.Range, request.Mapper);
  this->View.Colors.Show(request.Coloring);
  this->View.SetAreLabels(this->CanBeLabels());
  if (!request.Named.empty() && this->CanBeLabels())
  {
    look.Labels = request.Named;
    look.Values[Row::Drawing] =
      request.Wanted.MaySuitFile ? Drawing::Labels : look.Values[Row::Drawing];
  }
  if (!request.KeepsSurfaces)
  {
    look.Surfaces.resize(request.IsSameFile ? 1 : std::max(look.Surfaces.size(), std::size_t{ 1 }));
    look.Surfaces[0].Value = *request.Wanted.Isovalue;
    look.Nodes.resize(request.IsSameFile ? 0 : look.Nodes.size());
    look.Greys.resize(request.IsSameFile ? 0 : look.Greys.size());
    look.Values[Row::Brightness] = request.IsSameFile ? 0.0 : look.Values[Row::Brightness];
  }
  // First, as a plane may be placed to suit the view.
  const bool hasCamera = request.IsSameFile || request.Wanted.HasCamera;
  hasCamera ? this->View.SetCamera(camera) : this->ResetView();
  this->SetSettings(look);
  if (hasCamera) // which another projection has changed
  {
    this->View.SetCamera(camera);
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
  if (look.Nodes.size() < 2)
  {
    look.Nodes = look.Values[Row::Preset] != 0.0 ? this->NodesOf(look.TextOf(Row::Preset))
                                                 : FirstRamp(range, look.Surfaces[0].Value);
    look.Values[Row::Shift] = 0.0;
  }
  // Nodes of a preset may lie beside the values of the data.
  const double width = range[1] - range[0];
  Fit(look.Nodes, { range[0] - width, range[1] + width }, true);
  look.Greys =
    look.Greys.size() == 2 ? look.Greys : FirstGreys(this->Samples, look.Choice(Row::Drawing));
  Fit(look.Greys, { range[0] - width, range[1] + width }, true);
  if (look.Greys[1].Value - look.Greys[0].Value < LeastWindow * width)
  {
    look.Greys[0].Value = std::min(look.Greys[0].Value, range[1] - LeastWindow * width);
    look.Greys[1].Value = look.Greys[0].Value + LeastWindow * width;
  }
  look.Greys = { { look.Greys[0].Value, 0.0 }, { look.Greys[1].Value, 1.0 } };
  double* normal = look.Clip.Normal.data();
  if (!(vtkMath::Norm(normal) < 1e15 && vtkMath::Normalize(normal) > 1e-15 &&
        vtkMath::Norm(look.Clip.Origin.data()) < 1e15))
  {
    look.Clip = look.Values[Row::Clipping] != 0 ? this->View.MiddlePlane() : Plane{};
  }
  if (this->CanBeLabels() && look.Choice(Row::Drawing) == Drawing::Labels)
  {
    look.Labels = this->LabelsFor(look.Labels);
  }
  look.ColorBy = this->View.Colors.Fitted(look.ColorBy);
  for (std::size_t row = Row::Shading; row < Row::Count; ++row)
  {
    const auto [least, most] = this->RangeOf(AllSettings()[row]);
    const bool isToBeFitted = row == Row::Brightness && look.Values[row] == 0.0;
    look.Values[row] = isToBeFitted ? 0.0 : std::clamp(look.Values[row], least, most);
  }
  for (std::size_t to = Row::Crop + 1; to < Row::Count; to += 2)
  {
    look.Values[to] = std::max(look.Values[to - 1], look.Values[to]);
  }
  return look;
}

bool Model::CanColorByArray() const
{
  const std::vector<ColorArrays::Item>& all = this->View.Colors.Arrays().All();
  return this->DrawsSurfaces() && (all.size() > 1 || (!all.empty() && all[0].Components > 1));
}

// Those that are known, and the data's, with colours of their own.
std::vector<LabelLook> Model::LabelsFor(std::vector<LabelLook> labels) const
{
  const auto isBefore = [](const LabelLook& a, const LabelLook& b) { return a.Label < b.Label; };
  std::stable_sort(labels.begin(), labels.end(), isBefore);
  const std::size_t known = labels.size();
  for (const int label : this->Labels)
  {
    const auto end = labels.begin() + static_cast<std::ptrdiff_t>(known);
    const LabelLook made{ label, ColorOfLabel(label) };
    if (!std::binary_search(labels.begin(), end, made, isBefore))
    {
      labels.push_back(made);
    }
  }
  std::inplace_merge(
    labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(known), labels.end(), isBefore);
  for (LabelLook& label : labels)
  {
    label.Opacity = std::isfinite(label.Opacity) ? std::clamp(label.Opacity, 0.0, 1.0) : 1.0;
  }
  return labels;
}

// What the file does not tell stays.
void Model::NameLabels(Look& look, const std::string& path)
{
  for (const LabelName& named : ReadLabelNames(path))
  {
    const auto same = std::find_if(look.Labels.begin(), look.Labels.end(),
      [&](const LabelLook& label) { return label.Label == named.Label; });
    if (same != look.Labels.end())
    {
      Name(named, *same);
    }
  }
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

void Model::Apply()
{
  Look& look = this->Current.Settings;
  if (this->AddsUp() && look.Values[Row::Brightness] == 0.0)
  {
    look.Values[Row::Brightness] = this->View.FittingBrightness(look);
  }
  this->View.Apply(look);
}

std::array<double, 2> Model::RangeOf(const Setting& number) const
{
  const std::array<double, 2>& range = this->Samples.Range;
  const double width = range[1] - range[0];
  if (number.Axis)
  {
    const double* along = &this->View.DataBounds()[2 * *number.Axis];
    return { along[0], along[1] };
  }
  switch (number.Place())
  {
    case Row::Shift:
      return { -0.5 * width, 0.5 * width };
    case Row::Window:
      return { LeastWindow * width, width };
    case Row::Level:
      return range;
    default:
      return number.Range;
  }
}

double Model::NumberOf(const Setting& number, const Look& look, std::size_t marker) const
{
  const std::vector<Marker>& greys = look.Greys;
  switch (number.Place())
  {
    case Row::Opacity:
      return (look.*this->MarkersIn())[marker].Opacity;
    case Row::Window:
      return greys[1].Value - greys[0].Value;
    case Row::Level:
      return 0.5 * (greys[0].Value + greys[1].Value);
    default:
      return look.Values[number.Place()];
  }
}

void Model::SetNumber(const Setting& number, Look& look, std::size_t marker, double value) const
{
  std::vector<Marker>& greys = look.Greys;
  const double before = this->NumberOf(number, look, marker);
  switch (number.Place())
  {
    case Row::Opacity:
      this->MarkersOf(look)[marker].Opacity = value;
      return;
    case Row::Window:
      greys[0].Value -= 0.5 * (value - before);
      greys[1].Value += 0.5 * (value - before);
      return;
    case Row::Level:
      greys[0].Value += value - before;
      greys[1].Value += value - before;
      return;
    case Row::Shift:
      for (Marker& node : look.Nodes)
      {
        node.Value += value - before;
      }
      break;
    default:
      break;
  }
  look.Values[number.Place()] = value;
  if (number.Switch < Row::Count)
  {
    look.Values[number.Switch] = 1;
  }
}

void Model::SetChoice(Look& look, std::size_t choice, int word) const
{
  look.Values[choice] = word;
  if (choice == Row::Preset && word > 0)
  {
    look.Nodes = this->NodesOf(look.TextOf(Row::Preset));
    look.Values[Row::Shift] = 0.0;
  }
  else if (choice == Row::Drawing)
  {
    look.Greys.clear(); // those that suit it
    look.Values[Row::Brightness] = 0.0;
  }
}

void Model::ForgetPreset(Look& look) const
{
  const auto isSame = [&](Row::Which row)
  { return look.Values[row] == this->Settings().Values[row]; };
  if (!AreSame(look.Nodes, this->Settings().Nodes) && isSame(Row::Preset) && isSame(Row::Shift))
  {
    look.Values[Row::Preset] = 0.0;
  }
}

std::vector<Marker> Model::NodesOf(const char* preset) const
{
  const std::array<double, 2>& range = this->Samples.Range;
  double offset = 0.0, scale = 1.0;
  if (!vtkTemporalCoherencePresets::GetPresetIsInHounsfieldUnits(preset))
  {
    offset = ValueBelow(this->Samples, BelowBlack, true);
    scale = std::max(ValueBelow(this->Samples, 0.995, true) - offset, 1e-6 * (range[1] - range[0]));
  }
  else if (range[0] > -200.0)
  {
    const bool isStored = range[1] - range[0] > 1000.0;
    scale = isStored ? 1.0 : (range[1] - range[0]) / (MostOfScans - LeastOfScans);
    offset = isStored ? Stored : range[0] - scale * LeastOfScans;
  }
  vtkNew<vtkVolumeProperty> look;
  vtkTemporalCoherencePresets::Apply(preset, look, offset, scale);
  vtkPiecewiseFunction* const opacities = look->GetScalarOpacity();
  std::vector<Marker> nodes;
  for (int i = 0; i < opacities->GetSize(); ++i)
  {
    std::array<double, 4> node;
    opacities->GetNodeValue(i, node.data());
    Rgb color;
    look->GetRGBTransferFunction()->GetColor(node[0], color.data());
    nodes.push_back({ node[0], node[1], true, color });
  }
  return nodes;
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
    this->Settings().Values[Row::Surface], this->Settings().Values[Row::Projection],
    camera.ParallelScale };
  for (const Point& point : { camera.Position, camera.FocalPoint, camera.ViewUp })
  {
    sight.insert(sight.end(), point.begin(), point.end());
  }
  return sight;
}

bool Model::WantsIsomapAhead()
{
  const auto& values = this->Settings().Values;
  return this->IsOpen() && this->HasIsovalues() && values[Row::Ahead] != 0 &&
    values[Row::Isomap] != 0 && this->Ahead != this->PresentSight();
}
