// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendFrames.h"

#include "Measuring.h"

#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

namespace BlendFrames
{
namespace
{

constexpr double Degrees = 1.0;
constexpr double DragShare = 0.004; ///< of the range of values

/// The look of a stage, and the changes that a user makes.
class Scene
{
public:
  Scene(Stage& stage, const BlendLooks::Look& look)
    : Of(stage)
    , Look(look)
  {
    vtkVolumeProperty* property = stage.Volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.2);
    property->SetDiffuse(0.8);
    // Highlights of VTK 9.1 are those of another model than ours: errors are compared without.
    property->SetSpecular(0.0);
    property->SetScalarOpacityUnitDistance(stage.VoxelSize());
    BlendLooks::Apply(look, property);
    stage.ResetView();
  }

  void Make(Change change)
  {
    vtkVolumeProperty* property = this->Of.Volume->GetProperty();
    ++this->Made;
    switch (change)
    {
      case Change::View:
        this->Of.Orbit(Degrees);
        break;
      case Change::Ramp:
        this->Look = BlendLooks::Dragged(this->Look, this->Of.ShareOfRange(DragShare));
        BlendLooks::Apply(this->Look, property);
        break;
      case Change::Color:
        this->Look = BlendLooks::Recolored(this->Look);
        BlendLooks::Apply(this->Look, property);
        break;
      case Change::Light:
        property->SetDiffuse(this->Made % 2 == 0 ? 0.8 : 0.7);
        break;
    }
  }

private:
  Stage& Of;
  BlendLooks::Look Look;
  int Made = 0;
};

using Ways = std::vector<std::unique_ptr<BlendWays::Way>>;

/// Rounds of one change. The first step makes what all others need, and is not counted.
void Time(Stage& stage, Scene& scene, const Ways& ways, Change change, int rounds,
  std::vector<Figures>& figures)
{
  std::vector<std::vector<double>> times(ways.size());
  for (int round = 0; round <= rounds; ++round)
  {
    for (const auto& way : ways)
    {
      way->BeforeChange(stage);
    }
    scene.Make(change);
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      if (ways[i]->IsSlow && (round > 1 || change != Change::View))
      {
        continue;
      }
      const double time = ways[i]->Draw(stage);
      times[i].insert(times[i].end(), round > 0 ? 1 : 0, time);
    }
  }
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    figures[i].Times[static_cast<std::size_t>(change)] = Measuring::Median(times[i]);
  }
}

}

std::vector<Figures> Measure(
  Stage& stage, const BlendLooks::Look& look, int mode, int rounds, bool hasWindow)
{
  Scene scene(stage, look);
  const Ways ways = BlendWays::All(stage, mode, hasWindow);
  const BlendErrors::Truth truth(stage, look, mode);
  std::vector<Figures> figures;
  for (const auto& way : ways)
  {
    way->Draw(stage);
    figures.push_back(
      { way->Who, { Measuring::None, Measuring::None, Measuring::None, Measuring::None },
        truth.Of(way->Shown()) });
  }
  Time(stage, scene, ways, Change::View, rounds, figures);
  if (mode == vtkVolumeMapper::COMPOSITE_BLEND)
  {
    for (const Change change : { Change::Ramp, Change::Color, Change::Light })
    {
      Time(stage, scene, ways, change, rounds, figures);
    }
  }
  return figures;
}

}
