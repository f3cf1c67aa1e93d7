// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/Ear.h"

#include <vtkObjectFactory.h>

namespace Fuzz
{

Ear::Ear(vtkObject* object)
  : Of(object)
{
  this->Tags[0] = object->AddObserver(vtkCommand::ErrorEvent, this, &Ear::HearError);
  this->Tags[1] = object->AddObserver(vtkCommand::WarningEvent, this, &Ear::HearWarning);
}

Ear::~Ear()
{
  this->Of->RemoveObserver(this->Tags[0]);
  this->Of->RemoveObserver(this->Tags[1]);
}

void Ear::HearError(vtkObject*, unsigned long, void* text)
{
  std::string said = static_cast<const char*>(text);
  const std::size_t begin = said.find("): ");
  said.erase(0, begin == std::string::npos ? 0 : begin + 3);
  // A setter that is given none of its choices says so at once: no frame does.
  if (said.find(" must be ") == std::string::npos || said.find("; it stays ") == std::string::npos)
  {
    ++this->Errors;
    this->Text = said;
  }
}

vtkStandardNewMacro(Silence);

Silence& Silence::Fall()
{
  static vtkSmartPointer<Silence> silence = []
  {
    auto made = vtkSmartPointer<Silence>::New();
    vtkOutputWindow::SetInstance(made);
    return made;
  }();
  return *silence;
}

void Silence::DisplayText(const char*) {}

void Silence::DisplayErrorText(const char* text)
{
  ++this->Errors;
  this->Text = text;
}

void Silence::DisplayWarningText(const char*) {}

void Silence::DisplayGenericWarningText(const char*) {}

}
