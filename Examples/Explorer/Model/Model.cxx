// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Model.h"

#include "Program/Quoted.h"
#include "View/Isovalue.h"

#include <algorithm>
#include <sstream>

namespace
{

constexpr double StepsInRange = 256.0; // one for each value of 8 bits

}

Model::Model(const std::string& from, const std::string& up)
  : From(from)
  , Up(up)
{
}

void Model::Open(const Session& session)
{
  const std::string& path = session.Source.Path;
  Volume volume = ReadVolume(session.Source,
    [this, &path](double share)
    { return !this->Report || this->Report("Reading " + path, share); });
  const std::string name = Quoted(volume.Name);
  Histogram samples = CountSamples(volume.Image, name);
  const IsovalueChoice isovalue = ChooseIsovalue(samples, session.Isovalue, name);

  // Nothing can go wrong from here on.
  this->Shown = std::move(volume);
  this->Samples = std::move(samples);
  this->Current = session;
  this->Ahead = {};
  this->View.Show(this->Shown, this->Samples.Range);
  this->View.Apply(this->Current.Choices);
  this->SetIsovalue(isovalue.Value);
  if (session.Camera)
  {
    this->View.SetCamera(*session.Camera);
  }
  else
  {
    this->ResetView();
  }
}

std::string Model::Description() const
{
  std::ostringstream text;
  if (this->Shown.Image)
  {
    int n[3];
    this->Shown.Image->GetDimensions(n);
    text << n[0] << " x " << n[1] << " x " << n[2] << "  "
         << this->Shown.Image->GetScalarTypeAsString();
  }
  return text.str();
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
