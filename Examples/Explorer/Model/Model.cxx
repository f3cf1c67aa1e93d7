// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Model.h"

#include "Files/Arrays.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Isovalue.h"

#include <algorithm>
#include <utility>

namespace
{

constexpr double StepsInRange = 256.0; // one for each value of 8 bits

}

Model::Model(const std::string& from, const std::string& up)
  : From(from)
  , Up(up)
{
}

Volume Model::Read(const VolumeSource& source)
{
  return ReadVolume(source,
    [this, &source](double share)
    { return !this->Report || this->Report("Reading " + source.Path, share); });
}

void Model::Open(const Session& session)
{
  Volume volume = this->Read(session.Source);
  ChooseArray(volume, session.Source.Array, session.Isovalue);
  Histogram samples = CountSamples(volume);
  Session opened = session;
  opened.Isovalue = ChooseIsovalue(samples, session.Isovalue, Quoted(volume.Name)).Value;

  // Nothing can go wrong from here on.
  this->Show(std::move(volume), std::move(samples), opened);
  if (session.Camera)
  {
    this->View.SetCamera(*session.Camera);
  }
  else
  {
    this->ResetView();
  }
}

// All but the camera.
void Model::Show(Volume volume, Histogram samples, const Session& session)
{
  this->Shown = std::move(volume);
  this->Samples = std::move(samples);
  this->IsMesh = HasMeshes(this->Shown.Data);
  this->Current = session;
  this->Ahead = {};
  this->View.Show(this->Shown, this->Samples.Range);
  this->View.Apply(this->Current.Choices);
  this->SetIsovalue(*session.Isovalue);
}

std::string Model::Description() const
{
  std::string text = this->Shown.Data ? DescriptionOf(this->Shown) : "";
  if (this->Shown.TimeSteps > 1)
  {
    text += "  step " + std::to_string(this->Current.Source.TimeStep) + " of " +
      std::to_string(this->Shown.TimeSteps);
  }
  return text;
}

void Model::TurnArray()
{
  const std::string name = NextArray(this->Shown);
  if (name.empty())
  {
    throw UserError(
      Quoted(this->Shown.Name) + " has one array only; open a file that has several to turn them.");
  }
  // If all its values are the same, the key leads past it.
  ChooseArray(this->Shown, name);
  Histogram samples = CountSamples(this->Shown);
  Session session = this->Current;
  session.Source.Array = name;
  session.Isovalue = ChooseIsovalue(samples, std::nullopt, Quoted(name)).Value;
  this->Show(this->Shown, std::move(samples), session);
}

void Model::TurnTimeStep(int steps)
{
  const int count = this->Shown.TimeSteps;
  if (count < 2)
  {
    throw UserError(
      Quoted(this->Shown.Name) + " has one time step only; open a file that has several.");
  }
  Session session = this->Current;
  session.Source.TimeStep = (session.Source.TimeStep - 1 + steps + count) % count + 1;
  session.Source.Array = this->Shown.Array.Name;
  Volume volume = this->Read(session.Source);
  Histogram samples = CountSamples(volume);
  // The isovalue stays if it can.
  session.Isovalue = std::clamp(this->Isovalue(), samples.Range[0], samples.Range[1]);
  this->Show(std::move(volume), std::move(samples), session);
}

void Model::SetIsovalue(double isovalue)
{
  const std::array<double, 2>& range = this->Samples.Range;
  this->Current.Isovalue = std::clamp(isovalue, range[0], range[1]);
  this->View.SetIsovalue(this->Isovalue());
}

void Model::StepIsovalue(double steps)
{
  const std::array<double, 2>& range = this->Samples.Range;
  this->SetIsovalue(this->Isovalue() + steps * (range[1] - range[0]) / StepsInRange);
}

void Model::Turn(Choose what, int steps)
{
  const int count = static_cast<int>(ChoiceOf(what).Values.size());
  int& value = this->Current.Choices[what];
  value = (value + steps + count) % count;
  this->View.Apply(this->Current.Choices);
}

void Model::ResetView()
{
  this->View.LookFrom(this->From.empty() ? this->Shown.From : this->From, this->Up);
}

void Model::Save(const std::string& path)
{
  this->Current.Camera = this->View.Camera();
  WriteSession(this->Current, path);
}

bool Model::BuildIsomap()
{
  this->Ahead = this->PresentSight();
  return this->View.BuildIsomap([this](double share)
    { return !this->Report || this->Report("Building the isomap of this view", share); });
}

Model::Sight Model::PresentSight()
{
  const int* size = this->View.Renderer->GetSize();
  return { this->View.Camera(), { size[0], size[1], this->Current.Choices[Choose::Surface] } };
}

bool Model::WantsIsomapAhead()
{
  const Chosen& choices = this->Current.Choices;
  return choices.IsOn(Choose::Ahead) && choices.IsOn(Choose::Isomap) &&
    !(this->Ahead == this->PresentSight());
}
