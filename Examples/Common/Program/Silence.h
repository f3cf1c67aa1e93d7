// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Silence_h
#define Silence_h

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <sstream>
#include <streambuf>
#include <string>

// While it lives, neither VTK nor the format libraries below it (MetaIO) write on the terminal.
// They tell of a broken file in several lines; one sentence of ours takes their place.
class Silence
{
public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  // Whether VTK complained meanwhile.
  bool HeardErrors() const;
  bool HeardWarnings() const; // that name no object: vtkGenericWarningMacro

  // What would be on the terminal of the libraries below VTK that write in C++.
  std::string SaidByLibraries() const { return this->Nowhere.str(); }

private:
  vtkSmartPointer<vtkOutputWindow> Window;
  vtkSmartPointer<vtkOutputWindow> WindowBefore;
  vtkLogger::Verbosity LogBefore;
  std::ostringstream Nowhere;
  std::streambuf* OutBefore;
  std::streambuf* ErrBefore;
};

#endif
