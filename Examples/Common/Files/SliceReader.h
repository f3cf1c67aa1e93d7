// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SliceReader_h
#define SliceReader_h

#include "Files/PictureFile.h"
#include "Files/StackReader.h"

#include <vtkImageReader2.h>

#include <memory>

// A stack of slices as a reader of VTK: it reads the slices that it is asked for, and as ReadStack
// does. What is wrong with one of them is an error of VTK's.
class SliceReader : public vtkImageReader2
{
public:
  static SliceReader* New();
  vtkTypeMacro(SliceReader, vtkImageReader2);

  // Slices of one component, as the first one is.
  void SetSlices(const SliceStack& slices, const PictureKind& first);

protected:
  SliceReader() = default;
  ~SliceReader() override = default;

  void ExecuteInformation() override {} // it is known
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* information) override;

private:
  void ReadSlice(int slice, unsigned char* to);

  SliceStack Stack;
  PictureKind First;
  std::unique_ptr<PictureFile> Picture; // that is open
  int File = -1, Page = -1;             // where it is; from 0
};

#endif
