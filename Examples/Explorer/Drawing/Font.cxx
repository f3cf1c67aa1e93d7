// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Font.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace
{

constexpr int Dpi = 72; // a point is a pixel

struct Box
{
  int Width = 0;
  int Bottom = 0;
  int Top = 0;
};

Box BoxOf(vtkTextProperty* style, const std::string& text)
{
  int bounds[4] = { 0, -1, 0, -1 };
  vtkTextRenderer* writer = vtkTextRenderer::GetInstance();
  if (writer)
  {
    writer->GetBoundingBox(style, vtkStdString(text), bounds, Dpi, vtkTextRenderer::FreeType);
  }
  return { bounds[1] - bounds[0] + 1, bounds[2], bounds[3] };
}

Font::Glyph MakeGlyph(vtkTextProperty* style, char character, const Box& line)
{
  Font::Glyph glyph;
  const std::string text(1, character);
  // Between two letters: the box of a character alone ends where its ink ends.
  glyph.Advance = BoxOf(style, "H" + text + "H").Width - BoxOf(style, "HH").Width;
  vtkTextRenderer* writer = vtkTextRenderer::GetInstance();
  vtkNew<vtkImageData> image;
  int size[2] = { 0, 0 };
  if (!writer || character == ' ' ||
    !writer->RenderString(style, vtkStdString(text), image, size, Dpi, vtkTextRenderer::FreeType))
  {
    return glyph;
  }
  int extent[6];
  image->GetExtent(extent);
  glyph.Left = extent[0];
  glyph.Bottom = extent[2] - line.Bottom;
  glyph.Width = size[0];
  glyph.Height = size[1];
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* pixel = static_cast<const unsigned char*>(
        image->GetScalarPointer(extent[0] + x, extent[2] + y, extent[4]));
      glyph.Coverage.push_back(pixel[3]);
    }
  }
  return glyph;
}

}

Font::Font(int pixels, bool isBold)
{
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(pixels);
  style->SetBold(isBold);
  style->SetColor(1.0, 1.0, 1.0);
  const Box line = BoxOf(style, "Ag|");
  this->LineHeight = line.Top - line.Bottom + 1;
  for (char character = First; character <= Last; ++character)
  {
    this->Glyphs[static_cast<std::size_t>(character - First)] = MakeGlyph(style, character, line);
  }
}

const Font::Glyph& Font::GlyphOf(char character) const
{
  const bool isThere = character >= First && character <= Last;
  return this->Glyphs[static_cast<std::size_t>((isThere ? character : '?') - First)];
}

int Font::WidthOf(const std::string& text) const
{
  int width = 0;
  for (const char character : text)
  {
    width += this->GlyphOf(character).Advance;
  }
  return width;
}

std::string Font::Shortened(const std::string& text, int width) const
{
  if (this->WidthOf(text) <= width)
  {
    return text;
  }
  std::string shorter = text;
  while (!shorter.empty() && this->WidthOf(shorter + "...") > width)
  {
    shorter.pop_back();
  }
  return shorter + "...";
}

std::vector<std::string> Font::Wrapped(const std::string& text, int width) const
{
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (!lines.back().empty() && this->WidthOf(longer) > width)
    {
      lines.emplace_back();
      longer = word;
    }
    // A path may be longer than a line.
    while (this->WidthOf(longer) > width && longer.size() > 1)
    {
      std::size_t fits = longer.size() - 1;
      while (fits > 1 && this->WidthOf(longer.substr(0, fits)) > width)
      {
        --fits;
      }
      lines.back() = longer.substr(0, fits);
      longer.erase(0, fits);
      lines.emplace_back();
    }
    lines.back() = longer;
  }
  return lines;
}
