// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Options.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Isovalue.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkMath.h>
#include <vtkTemporalCoherencePresets.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace
{

constexpr double ShareFilled = 0.92; // of the picture, by the volume's box
constexpr double ViewAngle = 30.0;   // degrees, before the box is fitted
constexpr double SeeThrough = 0.3;   // opacity of what lies before another surface
constexpr double EndsOfSweep = 0.05; // are left out of the range of values
constexpr double StepOfTurn = 5.0;   // degrees between views that have to hold the box

// Colours that differ, for one surface after the other.
constexpr std::array<Rgb, 6> Contrasts = { { { 0.93, 0.72, 0.54 }, { 0.30, 0.55, 0.85 },
  { 0.50, 0.78, 0.42 }, { 0.85, 0.35, 0.30 }, { 0.95, 0.85, 0.40 }, { 0.70, 0.52, 0.85 } } };

constexpr Rgb Dark = { 16.0 / 255.0, 18.0 / 255.0, 22.0 / 255.0 };
constexpr Rgb Black = {}; // of projections, which are black where their values are low

double WordOf(Row::Which choice, const std::string& word)
{
  const std::vector<const char*>& words = AllSettings()[choice].Words;
  const auto at =
    std::find_if(words.begin(), words.end(), [&](const char* known) { return word == known; });
  return static_cast<double>(at - words.begin());
}

template <typename Value>
Value ForSurface(const std::vector<Value>& given, std::size_t surface, const Value& otherwise)
{
  return given.empty() ? otherwise : given.size() == 1 ? given[0] : given[surface];
}

// A message of VTK's without its place in the code: what stands behind "Class (address): ".
std::string SentenceOf(const void* message)
{
  std::string text = static_cast<const char*>(message);
  const std::size_t at = text.find("): ");
  text.erase(0, at == std::string::npos ? 0 : at + 3);
  std::replace(text.begin(), text.end(), '\n', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}

// While it lives, what the mapper says is kept instead of printed.
class Scene::Messages
{
public:
  explicit Messages(Scene& scene)
    : Of(scene)
    , Mapper(scene.Shown.View.Mapper)
    , Tags({ this->Mapper->AddObserver(vtkCommand::ErrorEvent, this, &Messages::OnError),
        this->Mapper->AddObserver(vtkCommand::WarningEvent, this, &Messages::OnWarning) })
  {
  }
  ~Messages()
  {
    this->Mapper->RemoveObserver(this->Tags[0]);
    this->Mapper->RemoveObserver(this->Tags[1]);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  std::string Error;

private:
  void OnError(vtkObject*, unsigned long, void* text) { this->Error = SentenceOf(text); }
  void OnWarning(vtkObject*, unsigned long, void* text)
  {
    std::vector<std::string>& said = this->Of.Said;
    const std::string sentence = SentenceOf(text);
    if (std::find(said.begin(), said.end(), sentence) == said.end())
    {
      said.push_back(sentence);
    }
  }

  Scene& Of;
  VolumeView::Mapping Mapper;
  std::array<unsigned long, 2> Tags;
};

Scene::Scene(const Options& options, const Progress& progress)
  : Asked(options)
  , Shown(options.From, options.Up)
{
  this->Open(progress);
  Look look = this->Shown.Settings();
  this->SetSurfaces(look);
  if (this->Shown.HasNodes())
  {
    this->SetPreset(look);
  }
  if (this->Shown.Blends() && options.Preset.empty())
  {
    this->SetGreys(look);
  }
  if (options.Clip)
  {
    this->SetClip(look);
  }
  this->Shown.SetSettings(look);
  this->FitView();
}

void Scene::Open(const Progress& progress)
{
  const Options& o = this->Asked;
  Request request;
  Session& wanted = request.Wanted;
  wanted.Source = o.Source;
  if (!o.Isovalues.empty())
  {
    wanted.Isovalue = o.Isovalues[0];
  }
  this->IsChosen = o.Isovalues.empty();
  auto& values = wanted.Settings.Values;
  values[Row::Surface] = o.ThresholdMode;
  values[Row::Occlusion] = o.HasOcclusion;
  values[Row::Shadows] = o.HasShadows;
  values[Row::Projection] = o.IsParallel;
  values[Row::Drawing] = WordOf(Row::Drawing, o.Drawing);
  values[Row::Preset] = o.Preset.empty() ? 0.0 : WordOf(Row::Preset, o.Preset);
  Model::Load(request, progress);
  for (const double isovalue : o.Isovalues)
  {
    ChooseIsovalue(request.Samples, isovalue, Quoted(request.Data.Name));
  }
  this->Shown.Adopt(request);
  if (!o.DrawsSurfaces() && this->Shown.DrawsMesh())
  {
    throw UserError(Quoted(this->Shown.Data().Name) +
      " is a grid of cells, of which surfaces are "
      "drawn; leave --" +
      (o.Preset.empty() ? o.Drawing : "preset") + " out, or resample it to an image.");
  }
}

void Scene::SetSurfaces(Look& look)
{
  const Options& o = this->Asked;
  std::vector<double> isovalues = o.Isovalues;
  if (isovalues.empty())
  {
    isovalues = { look.Surfaces[0].Value };
  }
  if (o.Film == "sweep")
  {
    const bool isGiven = o.Isovalues.size() == 2;
    this->Sweep = { isGiven ? isovalues[0] : this->Shown.ValueAt(EndsOfSweep),
      isGiven ? isovalues[1] : this->Shown.ValueAt(1.0 - EndsOfSweep) };
    isovalues = { this->Sweep[0] };
  }
  const double highest = *std::max_element(isovalues.begin(), isovalues.end());
  look.Surfaces.clear();
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    const double opacity = isovalues[i] < highest ? SeeThrough : 1.0;
    look.Surfaces.push_back({ isovalues[i], ForSurface(o.Opacities, i, opacity), true,
      ForSurface(o.Colors, i, Contrasts[i % Contrasts.size()]) });
  }
}

void Scene::SetPreset(Look& look)
{
  for (Marker& node : look.Nodes)
  {
    node.Value += this->Asked.Shift.value_or(0.0);
  }
  // All presets show high values.
  const std::array<double, 2>& range = this->Shown.Counted().Range;
  const auto first = std::find_if(
    look.Nodes.begin(), look.Nodes.end(), [](const Marker& node) { return node.Opacity > 0.0; });
  const double end = first == look.Nodes.begin() ? first->Value : (first - 1)->Value;
  if (!this->Asked.Preset.empty() && range[1] <= end)
  {
    std::ostringstream what;
    what << "The preset \"" << this->Asked.Preset << "\" shows values above " << end
         << ", and those of " << Quoted(this->Shown.Data().Name) << " are " << range[0] << " to "
         << range[1]
         << ": nothing would be drawn; choose the preset mr, or move this one by --shift "
         << this->Asked.Shift.value_or(0.0) + range[0] - end << ".";
    throw UserError(what.str());
  }
}

void Scene::SetGreys(Look& look)
{
  const Options& o = this->Asked;
  const std::array<double, 2>& range = this->Shown.Counted().Range;
  const double width = range[1] - range[0];
  if (this->Shown.Projects())
  {
    const double level = o.Level.value_or(0.5 * (look.Greys[0].Value + look.Greys[1].Value));
    const double window = o.Window.value_or(look.Greys[1].Value - look.Greys[0].Value);
    look.Greys = { { level - 0.5 * window, 0.0 }, { level + 0.5 * window, 1.0 } };
    return;
  }
  // The mean counts values from 0 to 1 over their range.
  look.Nodes = { { range[0], 1.0 }, { range[1], 1.0 } };
  auto* const mapper = this->Shown.View.Mapper.Get();
  mapper->SetFinalColorWindow(static_cast<float>(o.Window.value_or(width) / width));
  mapper->SetFinalColorLevel(
    static_cast<float>((o.Level.value_or(0.5 * (range[0] + range[1])) - range[0]) / width));
}

void Scene::SetClip(Look& look)
{
  const Options::Cut& clip = *this->Asked.Clip;
  const auto axis = static_cast<std::size_t>(clip.Axis[1] - 'x');
  const Box& bounds = this->Shown.View.WorldBounds();
  const double from = bounds[2 * axis], to = bounds[2 * axis + 1];
  look.Values[Row::Clipping] = 1.0;
  look.Clip = {};
  look.Clip.Origin[axis] = clip.IsShare ? from + clip.Value * (to - from) : clip.Value;
  look.Clip.Normal[axis] = clip.Axis[0] == '+' ? -1.0 : 1.0; // to what is seen
}

// The box of the volume is as large as it can be in all pictures.
void Scene::FitView()
{
  const Options& o = this->Asked;
  vtkRenderer* const renderer = this->Shown.View.Renderer;
  const std::string& from = o.From.empty() ? this->Shown.Data().From : o.From;
  this->Around = Viewpoint(renderer, this->Shown.View.WorldBounds().data(), from, o.Up);
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetViewAngle(ViewAngle);
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(ViewAngle));
  const double aspect = 1.0 * o.Width / o.Height;
  const double turn = o.Film == "turn" ? 360.0 : StepOfTurn;
  double share = 0.0;
  for (double degrees = 0.0; degrees < turn; degrees += StepOfTurn)
  {
    this->Around.PlaceCamera(renderer, o.Azimuth + degrees, o.Elevation);
    camera->SetParallelScale(tangent * camera->GetDistance());
    share = std::max(share, this->Around.ShareOfView(renderer, aspect));
  }
  const double wider = share / ShareFilled / o.Zoom;
  camera->SetParallelScale(wider * camera->GetParallelScale());
  camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(wider * tangent)));
  this->Around.PlaceCamera(renderer, o.Azimuth, o.Elevation);
}

void Scene::MoveTo(double share)
{
  const Options& o = this->Asked;
  if (o.Film == "turn")
  {
    this->Around.PlaceCamera(this->Shown.View.Renderer, o.Azimuth + 360.0 * share, o.Elevation);
    return;
  }
  Look look = this->Shown.Settings();
  look.Surfaces[0].Value = this->Sweep[0] + share * (this->Sweep[1] - this->Sweep[0]);
  this->Shown.SetSettings(look);
}

vtkSmartPointer<vtkImageData> Scene::Picture(const Progress& progress)
{
  const int samples = this->Asked.Samples;
  const Messages messages(*this);
  try
  {
    return this->Finished(this->Shown.View.Picture(
      samples * this->Asked.Width, samples * this->Asked.Height, progress, false));
  }
  catch (const UserError&)
  {
    if (messages.Error.empty())
    {
      throw;
    }
    throw UserError(messages.Error);
  }
}

// The mean of the rays of each pixel, in front of the background.
vtkSmartPointer<vtkImageData> Scene::Finished(vtkImageData* rgba)
{
  const Options& o = this->Asked;
  const auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(o.Width, o.Height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, o.IsTransparent ? 4 : 3);
  const auto* const rays = static_cast<const unsigned char*>(rgba->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(picture->GetScalarPointer());
  const auto samples = static_cast<std::size_t>(o.Samples);
  const std::size_t row = samples * static_cast<std::size_t>(o.Width);
  const double all = 255.0 * static_cast<double>(samples * samples);
  const bool isGrey = this->Shown.Blends() && o.Preset.empty();
  const Rgb background = o.Background.value_or(isGrey ? Black : Dark);
  for (std::size_t y = 0; y < static_cast<std::size_t>(o.Height); ++y)
  {
    for (std::size_t x = 0; x < static_cast<std::size_t>(o.Width); ++x)
    {
      std::array<double, 4> sum = {}; // of colours by their alphas, and of alphas
      for (std::size_t ray = 0; ray < samples * samples; ++ray)
      {
        const unsigned char* from =
          rays + 4 * ((y * samples + ray / samples) * row + x * samples + ray % samples);
        for (std::size_t c = 0; c < 3; ++c)
        {
          sum[c] += from[c] * from[3];
        }
        sum[3] += from[3];
      }
      this->IsSeen = this->IsSeen || sum[3] > 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double color = o.IsTransparent
          ? sum[c] / std::max(sum[3], 1.0)
          : sum[c] / all + 255.0 * (1.0 - sum[3] / all) * background[c];
        *to++ = static_cast<unsigned char>(std::lround(color));
      }
      if (o.IsTransparent)
      {
        *to++ = static_cast<unsigned char>(std::lround(255.0 * sum[3] / all));
      }
    }
  }
  return picture;
}

std::string Scene::Description() const
{
  const Options& o = this->Asked;
  const Look& look = this->Shown.Settings();
  const std::array<double, 2>& range = this->Shown.Counted().Range;
  std::ostringstream text;
  text << Quoted(this->Shown.Data().Name) << ", " << this->Shown.Description() << ", values "
       << range[0] << " to " << range[1] << ": ";
  if (!o.Preset.empty())
  {
    text << "preset \"" << o.Preset << "\"";
  }
  else if (this->Shown.Projects())
  {
    text << o.Drawing << ", black at " << look.Greys[0].Value << ", white at "
         << look.Greys[1].Value;
  }
  else if (this->Shown.Blends())
  {
    text << o.Drawing;
  }
  else if (o.Film == "sweep")
  {
    text << "surface from " << this->Sweep[0] << " to " << this->Sweep[1];
  }
  else
  {
    text << (look.Surfaces.size() > 1 ? "surfaces at " : "surface at ");
    for (const Marker& surface : look.Surfaces)
    {
      text << (&surface == look.Surfaces.data() ? "" : ", ") << surface.Value;
    }
    text << (this->IsChosen ? ", chosen from the histogram" : "");
  }
  return text.str();
}

std::vector<std::string> Scene::Remarks() const
{
  std::vector<std::string> remarks;
  const std::string name = Quoted(this->Shown.Data().Name);
  if (!this->Shown.Data().Remark.empty())
  {
    remarks.push_back(this->Shown.Data().Remark);
  }
  if (!this->Asked.Preset.empty() && !this->Shown.HasHounsfieldUnits() &&
    vtkTemporalCoherencePresets::GetPresetIsInHounsfieldUnits(this->Asked.Preset.c_str()))
  {
    remarks.push_back("The values of " + name +
      " are no Hounsfield units, so the preset was fitted "
      "to them; --shift moves it, and the preset mr suits any unit.");
  }
  remarks.insert(remarks.end(), this->Said.begin(), this->Said.end());
  if (!this->IsSeen)
  {
    remarks.push_back("Nothing of " + name +
      " is in the picture; change --clip, --zoom or the "
      "isovalue.");
  }
  return remarks;
}
