// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReaderErrors_h
#define TemporalCoherence_ReaderErrors_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkCommand;
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Collects the errors of a reader, its executive and its parser as long as it lives. They are not
/// shown elsewhere meanwhile.
class ReaderErrors
{
public:
  explicit ReaderErrors(vtkAlgorithm* reader);
  ~ReaderErrors();
  ReaderErrors(const ReaderErrors&) = delete;
  ReaderErrors& operator=(const ReaderErrors&) = delete;

  /// Forget the errors.
  void Clear() { this->First.clear(); }

  /// The first error without its place in VTK's source; empty if there is none. Errors that a
  /// reader only numbers count, too.
  std::string Text() const;

private:
  static void Collect(vtkObject* sender, unsigned long event, void* self, void* text);

  vtkSmartPointer<vtkAlgorithm> Reader;
  vtkNew<vtkCallbackCommand> Observer;
  vtkSmartPointer<vtkCommand> EarlierObserver; ///< of the parser
  std::string First;
};

}

#endif
