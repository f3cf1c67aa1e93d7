// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Reading_h
#define Reading_h

#include "Program/UserError.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkCallbackCommand;
class vtkDataReader;
class vtkObject;

// Is told the share that is read, from 0 to 1; false stops the reading.
using ReadingProgress = std::function<bool(double share)>;

// Passes a reader's progress on, and what is answered back.
class Watch
{
public:
  Watch(vtkAlgorithm* reader, const ReadingProgress& progress);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Reads the file. Throws UserError if it was stopped.
  // \param timeStep from 1; other times than the first only of readers that have them
  void Update(const std::string& path, int timeStep = 1);

private:
  static void OnProgress(vtkObject*, unsigned long, void* clientData, void* callData);

  vtkAlgorithm* Reader;
  const ReadingProgress& Progress;
  vtkNew<vtkCallbackCommand> Command;
  bool IsStopped = false;
};

// Without it, a reader of VTK's legacy format reads the first array of each kind.
void ReadAllArrays(vtkDataReader* reader);

// How many time steps a reader tells of, at least 1. Its information must be up to date.
int TimeStepsOf(vtkAlgorithm* reader);

bool EndsWith(const std::string& text, const std::string& end);
std::string LowerCase(std::string text);

// What is told of a file that its reader refused, and of one that was stopped.
UserError Unreadable(const std::string& path);
UserError Stopped(const std::string& path);

// For the readers of IOImage, which know their files by CanReadFile.
template <typename Reader>
auto ReadImage(Reader* reader, const std::string& path, const ReadingProgress& progress)
{
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path);
  }
  reader->SetFileName(path.c_str());
  Watch(reader, progress).Update(path);
  return vtkSmartPointer(reader->GetOutput());
}

#endif
