// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/Silence.h"

#include <vtkObjectFactory.h>

#include <iostream>

namespace
{

class ErrorWindow : public vtkOutputWindow
{
public:
  static ErrorWindow* New();
  vtkTypeMacro(ErrorWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { this->HasErrors = true; }
  void DisplayGenericWarningText(const char*) override { this->HasWarnings = true; }

  bool HasErrors = false;
  bool HasWarnings = false;
};
vtkStandardNewMacro(ErrorWindow);

}

Silence::Silence()
  : Window(vtkSmartPointer<ErrorWindow>::New())
  , WindowBefore(vtkOutputWindow::GetInstance())
  , LogBefore(vtkLogger::GetCurrentVerbosityCutoff())
  , OutBefore(std::cout.rdbuf(this->Nowhere.rdbuf()))
  , ErrBefore(std::cerr.rdbuf(this->Nowhere.rdbuf()))
{
  vtkOutputWindow::SetInstance(this->Window);
  // Errors go to the log as well as to the window.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

Silence::~Silence()
{
  vtkLogger::SetStderrVerbosity(this->LogBefore);
  vtkOutputWindow::SetInstance(this->WindowBefore);
  std::cout.rdbuf(this->OutBefore);
  std::cerr.rdbuf(this->ErrBefore);
}

bool Silence::HeardWarnings() const
{
  return static_cast<ErrorWindow*>(this->Window.Get())->HasWarnings;
}

bool Silence::HeardErrors() const
{
  return static_cast<ErrorWindow*>(this->Window.Get())->HasErrors;
}
