// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Volume_h
#define Volume_h

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>
#include <vtkTemporalCoherenceBrickSource.h>

#include <string>

// An array of numbers, at the points or of the cells; without a name, the active scalars at points.
struct ArrayChoice
{
  std::string Name;
  bool IsOnCells = false;
};

struct Volume
{
  vtkSmartPointer<vtkDataObject> Data;     // an image, a grid, or a composite of such
  vtkSmartPointer<vtkMatrix4x4> Placement; // from the data's space to the patient's; may be null
  std::string Name;                        // for people: the file's name, printable
  std::string From = "-y";                 // the viewer's place that suits this kind of file
  ArrayChoice Array;                       // what is drawn
  int TimeSteps = 1;                       // that the file has
  bool IsRaw = false;                      // of bare samples, whose type the user told
  std::string Remark;                      // a sentence on what is drawn otherwise; seldom one

  // Of a volume that is read as it is needed; else null. Nothing may ask for all of its samples:
  // for that there is a small image in memory.
  vtkSmartPointer<vtkTemporalCoherenceBrickSource> Bricks;
  vtkSmartPointer<vtkImageData> Coarse;
};

#endif
