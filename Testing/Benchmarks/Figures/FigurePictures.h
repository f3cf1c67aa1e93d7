// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_FigurePictures_h
#define Benchmarks_FigurePictures_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

/// Pictures put together into a figure, by VTK's image filters.
namespace FigurePictures
{

/// A picture of the mapper (RGBA) in front of a dark ground, with a caption at the lower left.
vtkSmartPointer<vtkImageData> WithCaption(vtkImageData* rgba, const std::string& caption);

/// Pictures of one size in rows, the first row at the top.
vtkSmartPointer<vtkImageData> Tile(
  const std::vector<std::vector<vtkSmartPointer<vtkImageData>>>& rows);

}

#endif
