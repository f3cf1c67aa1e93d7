// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenario.h"

#include <algorithm>
#include <iostream>

namespace
{

constexpr int QuickFrames = 5;

}

int Settings::FramesOr(int usual) const
{
  return this->Frames > 0 ? this->Frames : this->IsQuick ? std::min(usual, QuickFrames) : usual;
}

std::vector<Volumes::Sample> Settings::VolumesOr(const std::vector<::Volumes::Sample>& usual) const
{
  static const std::vector<::Volumes::Sample> quick = { { "spheres128", 100 },
    { "engine.vti", 70 } };
  return !this->Volumes.empty() ? this->Volumes : this->IsQuick ? quick : usual;
}

bool ForEachStage(const Settings& settings, const std::vector<Volumes::Sample>& usual,
  const std::function<void(const Volumes::Sample&, Stage&)>& measure)
{
  bool isMeasured = false;
  for (const Volumes::Sample& volume : settings.VolumesOr(usual))
  {
    const vtkSmartPointer<vtkImageData> image = LoadOrTell(volume.Name);
    if (image)
    {
      std::cerr << "  " << volume.Name << ' ' << volume.Isovalue << std::endl;
      Stage stage(image, volume.Isovalue, settings.Size, settings.From);
      measure(volume, stage);
      isMeasured = true;
    }
  }
  return isMeasured;
}

bool ReportVolumes(const Settings& settings, const std::vector<Volumes::Sample>& usual,
  JsonWriter& json, const std::function<void(const Volumes::Sample&, Stage&)>& measure)
{
  json.OpenList("volumes");
  const bool isMeasured = ForEachStage(settings, usual,
    [&](const Volumes::Sample& volume, Stage& stage)
    {
      json.OpenObject();
      json.Add("volume", volume.Name);
      json.Add("isovalue", volume.Isovalue);
      measure(volume, stage);
      json.Close();
    });
  json.Close();
  return isMeasured;
}

const std::vector<Volumes::Sample>& ManyVolumes()
{
  static const std::vector<Volumes::Sample> volumes = { { "spheres256", 100 },
    { "marschner-lobb256", 128 }, { "marschner-lobb512", 128 }, { "engine.vti", 70 },
    { "engine.vti", 180 }, { "brain.vti", 40 }, { "brain.vti", 90 }, { "cthead.vti", 600 },
    { "bonsai.vti", 40 }, { "aneurism.vti", 60 }, { "heptane.vti", 60 }, { "isabel.vti", 20 },
    { "homo.vti", 0.03 }, { "ch2better.nii.gz", 40 } };
  return volumes;
}

const std::vector<Volumes::Sample>& FewVolumes()
{
  static const std::vector<Volumes::Sample> volumes = { { "spheres256", 100 },
    { "marschner-lobb512", 128 }, { "engine.vti", 70 }, { "bonsai.vti", 40 },
    { "ch2better.nii.gz", 40 } };
  return volumes;
}

std::vector<Scenario> Scenarios::All()
{
  return { Routes(), Peers(), LayerPeers(), Meshes(), ImageCache(), Drift(), Isomap(), Drags(),
    Growth(), Threads(), Vectors(), Structures(), Window(), Features(), Opacities(), Floor(),
    BlendedVolumes(), ColorJumps() };
}
