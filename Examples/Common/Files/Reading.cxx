// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Reading.h"

#include "Program/Quoted.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkDataReader.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cctype>

Watch::Watch(vtkAlgorithm* reader, const ReadingProgress& progress)
  : Reader(reader)
  , Progress(progress)
{
  if (this->Progress)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&Watch::OnProgress);
    this->Reader->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
}

Watch::~Watch()
{
  this->Reader->RemoveObserver(this->Command);
}

void Watch::Update(const std::string& path, int timeStep)
{
  if (timeStep > 1)
  {
    const double* times =
      this->Reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    this->Reader->UpdateTimeStep(times[timeStep - 1]);
  }
  else
  {
    this->Reader->Update();
  }
  if (this->IsStopped)
  {
    throw Stopped(path);
  }
}

void Watch::OnProgress(vtkObject*, unsigned long, void* clientData, void* callData)
{
  auto* self = static_cast<Watch*>(clientData);
  if (!self->IsStopped && !self->Progress(*static_cast<double*>(callData)))
  {
    self->IsStopped = true;
    self->Reader->SetAbortExecute(1);
  }
}

void ReadAllArrays(vtkDataReader* reader)
{
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
}

int TimeStepsOf(vtkAlgorithm* reader)
{
  return std::max(
    1, reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

UserError Unreadable(const std::string& path)
{
  return UserError(Quoted(path) +
    " could not be read as what its suffix says; check that the file is whole and of that "
    "format.");
}

UserError Stopped(const std::string& path)
{
  return UserError("Reading " + Quoted(path) + " was stopped; open it again to read all of it.");
}
