// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Translucent surfaces beside Open VKL, in the same run and views.

#include "Measuring.h"
#include "OpenVkl.h"
#include "Scenario.h"

#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Measuring::Median;
using Measuring::Ratio;

constexpr double Opacity = 0.4;
constexpr double Degrees = 2.0; ///< of the orbit, a frame
constexpr int UsualFrames = 5;

/// Skin over bone: a second isovalue.
const Volumes::Sample Head{ "cthead.vti", 600 };
constexpr double Bone = 1500.0;

const std::vector<Volumes::Sample>& LayerVolumes()
{
  static const std::vector<Volumes::Sample> volumes = { { "engine.vti", 70 }, { "brain.vti", 40 },
    { "spheres256", 100 }, { "marschner-lobb256", 128 }, Head };
  return volumes;
}

std::vector<double> IsovaluesOf(const Volumes::Sample& volume)
{
  const bool isHead = volume.Name == Head.Name && volume.Isovalue == Head.Isovalue;
  return isHead ? std::vector<double>{ volume.Isovalue, Bone }
                : std::vector<double>{ volume.Isovalue };
}

/// One way to draw layers.
struct Way
{
  std::string Who;
  std::unique_ptr<OpenVkl> Peer; ///< null: ours
  std::vector<double> Times = {};
  double Layers = 0.0; ///< of all frames
};

void Dress(Stage& stage, const std::vector<double>& isovalues)
{
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(isovalues.front(), Opacity);
  property->SetScalarOpacity(opacity);
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    property->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), isovalues[i]);
  }
}

std::vector<Way> WaysOf(const Stage& stage, const std::vector<double>& isovalues)
{
  std::vector<Way> ways;
  ways.push_back({ "ours, cold", nullptr });
  for (const std::string& kind : OpenVkl::Kinds())
  {
    std::unique_ptr<OpenVkl> peer = OpenVkl::Make(stage, kind);
    if (peer)
    {
      peer->SetIsovalues(isovalues);
      peer->SetOpacity(Opacity);
      ways.push_back({ "Open VKL, " + kind, std::move(peer) });
    }
  }
  return ways;
}

/// Each view by all ways in turn. The first one, which makes what the others need, is not counted.
void Measure(Stage& stage, int frames, std::vector<Way>& ways)
{
  Drawer drawer(stage);
  drawer.Mapper->ReuseFramesOff();
  drawer.Mapper->IsomapOff();
  for (int frame = 0; frame <= frames; ++frame)
  {
    for (Way& way : ways)
    {
      const double time = way.Peer ? way.Peer->Draw(stage) : drawer.Draw(stage);
      if (frame > 0)
      {
        way.Times.push_back(time);
        way.Layers +=
          static_cast<double>(way.Peer ? way.Peer->NumberOfLayers()
                                       : drawer.Mapper->GetStatistics()->GetNumberOfLayers());
      }
    }
    stage.Orbit(Degrees);
  }
}

bool Run(const Settings& settings, JsonWriter& json)
{
  if (OpenVkl::Kinds().empty())
  {
    std::cerr << "Open VKL is left out: it is not built in.\n";
  }
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms of " << frames << " views, all surfaces of opacity " << Opacity
            << "; layers: shaded surfaces of a frame, and by those of ours\n\n";
  const MarkdownTable table(
    { "volume", "isovalues", "who", "layers", "/ ours", "ms", "/ ours", "ns a layer" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const std::vector<double> isovalues = IsovaluesOf(volume);
    Dress(stage, isovalues);
    std::vector<Way> ways = WaysOf(stage, isovalues);
    Measure(stage, frames, ways);
    std::string names;
    for (const double isovalue : isovalues)
    {
      names += (names.empty() ? "" : ", ") + Plain(isovalue);
    }
    const Way& ours = ways.front();
    json.OpenList("ways");
    for (const Way& way : ways)
    {
      const double time = Median(way.Times), layers = way.Layers / frames;
      table.Row({ volume.Name, names, way.Who, Plain(std::round(layers)),
        Fixed(Ratio(way.Layers, ours.Layers), 3), Fixed(time, 1),
        Fixed(Ratio(time, Median(ours.Times)), 2), Fixed(1e6 * Ratio(time, layers), 0) });
      json.OpenObject();
      json.Add("who", way.Who);
      json.Add("layers", layers);
      json.Add("ms", time);
      json.Add("byOurs", Ratio(time, Median(ours.Times)));
      json.Close();
    }
    json.Close();
  };
  return ReportVolumes(settings, LayerVolumes(), json, measure);
}

}

Scenario Scenarios::LayerPeers()
{
  return { "layer-peers", "translucent surfaces beside Open VKL", Run };
}
