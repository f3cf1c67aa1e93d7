// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DicomSlice_h
#define DicomSlice_h

#include <vtkVector.h>

#include <optional>
#include <string>
#include <vector>

// What the header of a DICOM file tells of a slice.
struct DicomSlice
{
  std::string Path;
  std::string Series; // identity
  unsigned Rows = 0, Columns = 0, Bits = 0;
  double Components = 1.0;
  double Bytes = 0.0; // of pixels
  std::optional<vtkVector3d> Position;
  std::vector<double> Spacing;     // between rows and between columns: 2 numbers above 0, or none
  std::vector<double> Orientation; // directions of a row and of a column: 6 numbers, or none

  bool HasPixels() const { return this->Bytes > 0.0 && this->Rows > 0 && this->Columns > 0; }
  vtkVector3d Along() const { return vtkVector3d(this->Orientation.data()); }
  vtkVector3d Down() const { return vtkVector3d(this->Orientation.data() + 3); }
  vtkVector3d Normal() const { return this->Along().Cross(this->Down()); }
};

// None if a file is no DICOM. Throws UserError for one that is not read here.
std::optional<DicomSlice> ReadDicomHeader(const std::string& path);

#endif
