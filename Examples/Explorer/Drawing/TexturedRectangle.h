// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TexturedRectangle_h
#define TexturedRectangle_h

#include "Drawing/Canvas.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

class vtkRenderer;

// An image, pixel for pixel, on a renderer that covers the window. It is sent to OpenGL only when
// it has been modified.
class TexturedRectangle
{
public:
  explicit TexturedRectangle(vtkRenderer* renderer);
  ~TexturedRectangle();
  TexturedRectangle(const TexturedRectangle&) = delete;
  TexturedRectangle& operator=(const TexturedRectangle&) = delete;

  void Place(const Rect& rect, int windowHeight);
  void SetVisible(bool isVisible);
  void SetImage(vtkImageData* image);

private:
  vtkRenderer* Renderer;
  vtkNew<vtkPoints> Corners;
  vtkNew<vtkTexture> Texture;
  vtkNew<vtkTexturedActor2D> Actor;
};

#endif
