// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MedicalReader_h
#define MedicalReader_h

#include "Files/Reading.h"
#include "Files/Volume.h"

#include <string>

// Files of scanners tell more than VTK's readers apply: what values the samples stand for, and
// where they lie. All throw UserError.
void ReadMetaImage(const std::string& path, const ReadingProgress& progress, Volume& volume);
// Whether the samples of a MetaImage stand for other values.
bool IsRescaledMetaImage(const std::string& path);
// \param timeStep from 1, of a file of several
void ReadNifti(
  const std::string& path, int timeStep, const ReadingProgress& progress, Volume& volume);

// The slices of a folder: those of the series that has most of them, where their headers say. Of
// programs that were built without GDCM, which reads the files, a folder is refused.
void ReadDicom(const std::string& path, const ReadingProgress& progress, Volume& volume);

#endif
