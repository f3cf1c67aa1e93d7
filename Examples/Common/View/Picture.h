// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

// An RGBA picture of the mapper (colours multiplied by alpha) in front of a background that passes
// from one colour, 0 to 255, at the bottom to another at the top.
vtkSmartPointer<vtkImageData> OnBackground(
  vtkImageData* rgba, const std::array<double, 3>& bottom, const std::array<double, 3>& top);

// An RGBA picture of the mapper as files have it: colours are not multiplied by alpha.
vtkSmartPointer<vtkImageData> WithoutBackground(vtkImageData* rgba);

// Throws UserError, with the remedy given ("name another directory with --output").
void WritePng(vtkImageData* picture, const std::string& path, const std::string& remedy);

#endif
