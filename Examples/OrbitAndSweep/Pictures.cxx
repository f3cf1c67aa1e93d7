// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Picture.h"

#include <vtkImageAppend.h>
#include <vtkImageResize.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace
{

constexpr int Columns = 6;
constexpr int ThumbnailWidth = 256;
constexpr int CaptionDpi = 72;
const char* const Remedy = "name another directory with --output";

// Two rows of the orbit, one of every other part.
int CellsOf(const std::string& part)
{
  return part == "orbit" ? 2 * Columns : Columns;
}

// Greys of the evening sky.
constexpr std::array<double, 3> Ground = { 74.0, 82.0, 96.0 };
constexpr std::array<double, 3> Sky = { 28.0, 33.0, 42.0 };

vtkSmartPointer<vtkImageData> Resized(vtkImageData* image, int width)
{
  int size[3];
  image->GetDimensions(size);
  const int height = std::max(1, static_cast<int>(std::lround(1.0 * width * size[1] / size[0])));
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(image);
  resize->SetOutputDimensions(width, height, 1);
  resize->Update();
  return resize->GetOutput();
}

// Lays white text over the picture's upper left corner.
void WriteCaption(vtkImageData* rgb, const std::string& caption)
{
  vtkTextRenderer* writer = vtkTextRenderer::GetInstance();
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(11);
  style->SetColor(1.0, 1.0, 1.0);
  vtkNew<vtkImageData> text;
  int textSize[2] = { 0, 0 };
  if (!writer || caption.empty() ||
    !writer->RenderString(style, vtkStdString(caption), text, textSize, CaptionDpi))
  {
    return;
  }
  int size[3];
  rgb->GetDimensions(size);
  int extent[6];
  text->GetExtent(extent);
  constexpr int margin = 6;
  const int width = std::min(textSize[0], size[0] - margin);
  const int height = std::min(textSize[1], size[1] - margin);
  const int bottom = size[1] - margin - height;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const auto* from = static_cast<const unsigned char*>(
        text->GetScalarPointer(extent[0] + x, extent[2] + y, extent[4]));
      auto* to = static_cast<unsigned char*>(rgb->GetScalarPointer(margin + x, bottom + y, 0));
      const double alpha = from[3] / 255.0;
      for (int c = 0; c < 3; ++c)
      {
        to[c] = static_cast<unsigned char>(std::lround(alpha * from[c] + (1.0 - alpha) * to[c]));
      }
    }
  }
}

// Pictures side by side (axis 0), or one on the other from the bottom (axis 1).
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

vtkSmartPointer<vtkImageData> EmptyCell(vtkImageData* like)
{
  auto cell = vtkSmartPointer<vtkImageData>::New();
  cell->SetDimensions(like->GetDimensions());
  cell->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* samples = static_cast<unsigned char*>(cell->GetScalarPointer());
  std::fill_n(samples, 3 * cell->GetNumberOfPoints(), static_cast<unsigned char>(28));
  return cell;
}

}

PictureBook::PictureBook(const std::string& directory)
  : Directory(directory)
{
  std::error_code error;
  std::filesystem::create_directories(this->Directory, error);
  const std::filesystem::path trial = this->Directory / "contact-sheet.png";
  if (error || !std::ofstream(trial))
  {
    throw UserError("The directory " + Quoted(directory) +
      " cannot be made or written in; name another with --output.");
  }
}

std::string PictureBook::ContactSheet() const
{
  return (this->Directory / "contact-sheet.png").string();
}

void PictureBook::Add(
  vtkImageData* picture, const std::string& part, int frame, int frames, const std::string& caption)
{
  const vtkSmartPointer<vtkImageData> rgb = OnBackground(picture, Ground, Sky);
  std::string number = std::to_string(frame);
  number.insert(0, 3 - std::min<std::size_t>(3, number.size()), '0');
  WritePng(rgb, (this->Directory / (part + "_" + number + ".png")).string(), Remedy);
  ++this->Written;

  // Evenly spread over the part: a frame goes in where the cell's number changes.
  const int cells = std::min(frames, CellsOf(part));
  if (frame != 0 && frame * cells / frames == (frame - 1) * cells / frames)
  {
    return;
  }
  vtkSmartPointer<vtkImageData> small = Resized(rgb, ThumbnailWidth);
  WriteCaption(small, caption);
  if (this->Thumbnails.count(part) == 0)
  {
    this->Parts.push_back(part);
  }
  this->Thumbnails[part].push_back(small);
}

void PictureBook::WriteContactSheet() const
{
  std::vector<vtkSmartPointer<vtkImageData>> rows;
  for (const std::string& part : this->Parts)
  {
    std::vector<vtkSmartPointer<vtkImageData>> cells = this->Thumbnails.at(part);
    while (cells.size() % Columns != 0)
    {
      cells.push_back(EmptyCell(cells.front()));
    }
    for (std::size_t first = 0; first < cells.size(); first += Columns)
    {
      rows.push_back(Appended({ cells.begin() + static_cast<std::ptrdiff_t>(first),
                                cells.begin() + static_cast<std::ptrdiff_t>(first + Columns) },
        0));
    }
  }
  // Images are counted from the bottom.
  std::reverse(rows.begin(), rows.end());
  WritePng(Appended(rows, 1), this->ContactSheet(), Remedy);
}
