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
  ++this->Errors;
  this->Text = static_cast<const char*>(text);
  const std::size_t begin = this->Text.find("): ");
  this->Text.erase(0, begin == std::string::npos ? 0 : begin + 3);
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
