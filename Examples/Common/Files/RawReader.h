// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RawReader_h
#define RawReader_h

#include "Files/Reading.h"
#include "Program/VolumeSource.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

// Throws UserError if a file has another size than bare samples of a layout.
void RequireRawSize(const std::string& path, const RawLayout& layout);

// Bare samples. Throws UserError.
vtkSmartPointer<vtkImageData> ReadRaw(const std::string& path, const RawLayout& layout,
  bool isBigEndian, const ReadingProgress& progress);

#endif
