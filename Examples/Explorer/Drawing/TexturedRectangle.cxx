// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/TexturedRectangle.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>

TexturedRectangle::TexturedRectangle(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Corners->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> quads;
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  quads->InsertNextCell(4, ids);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  const double corners[4][2] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  for (const double* corner : corners)
  {
    coordinates->InsertNextTuple(corner);
  }
  vtkNew<vtkPolyData> rectangle;
  rectangle->SetPoints(this->Corners);
  rectangle->SetPolys(quads);
  rectangle->GetPointData()->SetTCoords(coordinates);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(rectangle);
  this->Texture->InterpolateOff();
  this->Texture->SetColorModeToDirectScalars();
  this->Actor->SetMapper(mapper);
  this->Actor->SetTexture(this->Texture);
  this->Actor->VisibilityOff();
  this->Renderer->AddViewProp(this->Actor);
}

TexturedRectangle::~TexturedRectangle()
{
  this->Renderer->RemoveViewProp(this->Actor);
}

void TexturedRectangle::Place(const Rect& rect, int windowHeight)
{
  this->Corners->SetPoint(0, 0.0, 0.0, 0.0);
  this->Corners->SetPoint(1, rect.Width, 0.0, 0.0);
  this->Corners->SetPoint(2, rect.Width, rect.Height, 0.0);
  this->Corners->SetPoint(3, 0.0, rect.Height, 0.0);
  this->Corners->Modified();
  this->Actor->SetPosition(rect.X, windowHeight - rect.Bottom());
}

void TexturedRectangle::SetVisible(bool isVisible)
{
  this->Actor->SetVisibility(isVisible);
}

void TexturedRectangle::SetImage(vtkImageData* image)
{
  image->Modified();
  this->Texture->SetInputData(image);
}
