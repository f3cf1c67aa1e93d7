// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_Studio_h
#define Gallery_Studio_h

#include "Style.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkActor;
class vtkAlgorithm;
class vtkPolyData;

/// An off-screen window with a lit scene, to be photographed. It needs a display (Display.h).
class Studio
{
public:
  /// \param size pixels of the square window in each direction
  explicit Studio(int size);

  /// Polygons in a colour.
  vtkActor* AddPolygons(vtkAlgorithm* source, const Style::Color& color);

  /// Thin lines along the edges of a box.
  void AddBox(const double bounds[6], const Style::Color& color);

  /// What the window shows, in half as many pixels in each direction, so that edges are smooth.
  vtkSmartPointer<vtkImageData> Photograph();

  /// The final picture of the window, half as large: light and edges are refined first.
  vtkSmartPointer<vtkImageData> PhotographFinal();

  /// The name of what draws the window, such as llvmpipe.
  std::string DrawnBy();

  vtkNew<vtkRenderer> Renderer;

private:
  vtkNew<vtkRenderWindow> Window;
};

#endif
