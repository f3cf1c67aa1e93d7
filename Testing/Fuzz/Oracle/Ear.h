// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Ear_h
#define Fuzz_Ear_h

#include <vtkCommand.h>
#include <vtkObject.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace Fuzz
{

/// Listens to the errors and warnings of an object, which are not printed then.
class Ear
{
public:
  explicit Ear(vtkObject* object);
  ~Ear();
  Ear(const Ear&) = delete;
  Ear& operator=(const Ear&) = delete;

  int Errors = 0, Warnings = 0;
  std::string Text; ///< of the last error, without the name and the address of the object

private:
  void HearError(vtkObject*, unsigned long, void* text);
  void HearWarning() { ++this->Warnings; }

  vtkSmartPointer<vtkObject> Of;
  unsigned long Tags[2];
};

/// Takes what other objects say.
class Silence : public vtkOutputWindow
{
public:
  static Silence* New();
  vtkTypeMacro(Silence, vtkOutputWindow);

  /// From now on nothing is printed.
  static Silence& Fall();

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;

  int Errors = 0;
  std::string Text; ///< of the last one
};

}

#endif
