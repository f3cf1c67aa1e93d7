// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_FigurePictures_h
#define Benchmarks_FigurePictures_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

class vtkRenderWindow;

/// Pictures put together into a figure, by VTK's image filters.
namespace FigurePictures
{

/// The dark colour behind all pictures.
constexpr std::array<unsigned char, 3> Ground = { 28, 33, 42 };

/// What a window shows.
vtkSmartPointer<vtkImageData> Grabbed(vtkRenderWindow* window);

/// Means of squares of so many pixels a side.
vtkSmartPointer<vtkImageData> Shrunk(vtkImageData* picture, int factor);

/// A picture of the mapper (RGBA) in front of the ground.
vtkSmartPointer<vtkImageData> OnGround(vtkImageData* rgba);

/// A picture of the mapper (RGBA) in front of a dark ground, with a caption at the lower left.
vtkSmartPointer<vtkImageData> WithCaption(vtkImageData* rgba, const std::string& caption);

/// Pictures of one size in rows, the first row at the top.
vtkSmartPointer<vtkImageData> Tile(
  const std::vector<std::vector<vtkSmartPointer<vtkImageData>>>& rows);

}

#endif
