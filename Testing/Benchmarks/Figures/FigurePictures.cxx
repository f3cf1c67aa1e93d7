// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FigurePictures.h"

#include <vtkImageAppend.h>
#include <vtkImageBlend.h>
#include <vtkImageChangeInformation.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>

namespace FigurePictures
{
namespace
{

/// The caption's letters are as high as this part of the picture.
constexpr int CaptionPart = 28;
constexpr int WidestFigure = 1000; ///< pixels a page can show
constexpr int SmallestCaption = 14;
constexpr int Dpi = 72;

vtkSmartPointer<vtkImageData> GroundLike(vtkImageData* picture)
{
  auto ground = vtkSmartPointer<vtkImageData>::New();
  ground->SetDimensions(picture->GetDimensions());
  ground->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* samples = static_cast<unsigned char*>(ground->GetScalarPointer());
  const vtkIdType pixels = ground->GetNumberOfPoints();
  for (vtkIdType i = 0; i < pixels; ++i, samples += Ground.size())
  {
    std::copy(Ground.begin(), Ground.end(), samples);
  }
  return ground;
}

/// The words as an RGBA image that begins at (margin, margin).
vtkSmartPointer<vtkImageData> Written(const std::string& words, int size, int margin)
{
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(size);
  style->SetColor(1.0, 1.0, 1.0);
  vtkNew<vtkImageData> text;
  std::array<int, 2> textSize = { 0, 0 };
  vtkTextRenderer* writer = vtkTextRenderer::GetInstance();
  if (!writer || !writer->RenderString(style, vtkStdString(words), text, textSize.data(), Dpi))
  {
    return nullptr;
  }
  vtkNew<vtkImageChangeInformation> place;
  place->SetInputData(text);
  place->SetOutputExtentStart(margin, margin, 0);
  place->Update();
  return place->GetOutput();
}

vtkSmartPointer<vtkImageData> Appended(
  const std::vector<vtkSmartPointer<vtkImageData>>& images, int axis)
{
  vtkNew<vtkImageAppend> append;
  append->SetAppendAxis(axis);
  for (const vtkSmartPointer<vtkImageData>& image : images)
  {
    append->AddInputData(image);
  }
  append->Update();
  return append->GetOutput();
}

}

vtkSmartPointer<vtkImageData> Grabbed(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

vtkSmartPointer<vtkImageData> Shrunk(vtkImageData* picture, int factor)
{
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(picture);
  shrink->SetShrinkFactors(factor, factor, 1);
  shrink->MeanOn();
  shrink->Update();
  return shrink->GetOutput();
}

vtkSmartPointer<vtkImageData> OnGround(vtkImageData* rgba)
{
  vtkNew<vtkImageBlend> blend;
  blend->AddInputData(GroundLike(rgba));
  blend->AddInputData(rgba);
  blend->Update();
  return blend->GetOutput();
}

vtkSmartPointer<vtkImageData> WithCaption(vtkImageData* rgba, const std::string& caption)
{
  const int size = std::max(SmallestCaption, rgba->GetDimensions()[1] / CaptionPart);
  vtkNew<vtkImageBlend> blend;
  blend->AddInputData(GroundLike(rgba));
  blend->AddInputData(rgba);
  if (const vtkSmartPointer<vtkImageData> text = Written(caption, size, size / 2))
  {
    blend->AddInputData(text);
  }
  blend->Update();
  return blend->GetOutput();
}

vtkSmartPointer<vtkImageData> Tile(
  const std::vector<std::vector<vtkSmartPointer<vtkImageData>>>& rows)
{
  // Images are counted from the bottom.
  std::vector<vtkSmartPointer<vtkImageData>> stack;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
  {
    stack.push_back(Appended(*row, 0));
  }
  const vtkSmartPointer<vtkImageData> figure = Appended(stack, 1);
  return Shrunk(figure, (figure->GetDimensions()[0] + WidestFigure - 1) / WidestFigure);
}

}
