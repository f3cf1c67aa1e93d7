// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DicomFile_h
#define DicomFile_h

#include "Files/Rescale.h"

#include <vtkVector.h>

#include <string>
#include <vector>

// What the header of a DICOM file tells of a slice, which is one of its frames.
struct DicomSlice
{
  std::string Path;
  std::string Series; // identity
  unsigned Frame = 0, Frames = 1;
  unsigned Rows = 0, Columns = 0, Components = 1;
  double Number = 0.0;             // in the series
  double Distance = 0.0;           // to the next one, for slices without a position; 0 if not told
  std::vector<double> Position;    // of the first pixel: 3 numbers, or none
  std::vector<double> Spacing;     // between rows and between columns: 2 numbers above 0, or none
  std::vector<double> Orientation; // directions of a row and of a column: 6 numbers, or none
  Rescaling Values;
  std::string Fault; // why its pixels are not read here; seldom one

  std::string Name() const; // for people
  vtkVector3d Along() const { return vtkVector3d(this->Orientation.data()); }
  vtkVector3d Down() const { return vtkVector3d(this->Orientation.data() + 3); }
  vtkVector3d Normal() const { return this->Along().Cross(this->Down()); }
};

// The slices of a file, which has none if it is no DICOM or has no pixels, as reports have none.
// Throws UserError for a file that is not read here.
std::vector<DicomSlice> ReadDicomHeader(const std::string& path);

// The samples of all frames of a file, from the uppermost row to the lowest, components together.
vtkSmartPointer<vtkDataArray> ReadDicomPixels(const std::string& path);

#endif
