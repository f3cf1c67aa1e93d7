// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_PngFile_h
#define Benchmarks_PngFile_h

#include <string>

class vtkImageData;

/// \throws Measuring::Failure if the file cannot be written
void WritePng(vtkImageData* image, const std::string& file);

#endif
