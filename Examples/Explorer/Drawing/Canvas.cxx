// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Canvas.h"

#include <algorithm>
#include <cstddef>

namespace
{

unsigned char Blend(unsigned char below, unsigned char above, int coverage)
{
  return static_cast<unsigned char>(below + (above - below) * coverage / 255);
}

}

void Canvas::Resize(int width, int height)
{
  if (this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  this->Size[0] = width;
  this->Size[1] = height;
  this->Pixels->SetDimensions(width, height, 1);
  this->Pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
}

unsigned char* Canvas::PixelAt(int x, int y)
{
  auto* first = static_cast<unsigned char*>(this->Pixels->GetScalarPointer());
  const std::ptrdiff_t row = this->Size[1] - 1 - y;
  return first + 4 * (row * this->Size[0] + x);
}

void Canvas::Clear(const Color& color)
{
  this->Fill({ 0, 0, this->Size[0], this->Size[1] }, color);
}

void Canvas::Fill(const Rect& rect, const Color& color)
{
  const int left = std::max(rect.X, 0), right = std::min(rect.Right(), this->Size[0]);
  const int top = std::max(rect.Y, 0), bottom = std::min(rect.Bottom(), this->Size[1]);
  for (int y = top; y < bottom; ++y)
  {
    unsigned char* pixel = this->PixelAt(left, y);
    for (int x = left; x < right; ++x, pixel += 4)
    {
      pixel[0] = color.Red;
      pixel[1] = color.Green;
      pixel[2] = color.Blue;
      pixel[3] = 255;
    }
  }
}

void Canvas::Frame(const Rect& rect, const Color& color)
{
  this->Fill({ rect.X, rect.Y, rect.Width, 1 }, color);
  this->Fill({ rect.X, rect.Bottom() - 1, rect.Width, 1 }, color);
  this->Fill({ rect.X, rect.Y, 1, rect.Height }, color);
  this->Fill({ rect.Right() - 1, rect.Y, 1, rect.Height }, color);
}

void Canvas::Write(
  int left, int top, int height, const std::string& text, const Font& font, const Color& color)
{
  const int bottom = top + (height + font.Height()) / 2; // first row below the line
  int pen = left;
  for (const char character : text)
  {
    const Font::Glyph& glyph = font.GlyphOf(character);
    const unsigned char* coverage = glyph.Coverage.data();
    for (int row = 0; row < glyph.Height; ++row)
    {
      const int y = bottom - 1 - glyph.Bottom - row;
      for (int column = 0; column < glyph.Width; ++column, ++coverage)
      {
        const int x = pen + glyph.Left + column;
        if (*coverage == 0 || x < 0 || x >= this->Size[0] || y < 0 || y >= this->Size[1])
        {
          continue;
        }
        unsigned char* pixel = this->PixelAt(x, y);
        pixel[0] = Blend(pixel[0], color.Red, *coverage);
        pixel[1] = Blend(pixel[1], color.Green, *coverage);
        pixel[2] = Blend(pixel[2], color.Blue, *coverage);
      }
    }
    pen += glyph.Advance;
  }
}

void Canvas::WriteRight(
  int right, int top, int height, const std::string& text, const Font& font, const Color& color)
{
  this->Write(right - font.WidthOf(text), top, height, text, font, color);
}

void Canvas::WriteMiddle(
  const Rect& rect, const std::string& text, const Font& font, const Color& color)
{
  this->Write(
    rect.X + (rect.Width - font.WidthOf(text)) / 2, rect.Y, rect.Height, text, font, color);
}

const Font& SmallFont()
{
  static const Font font(Theme::SmallText, false);
  return font;
}

const Font& NormalFont()
{
  static const Font font(Theme::NormalText, false);
  return font;
}

const Font& BoldFont()
{
  static const Font font(Theme::NormalText, true);
  return font;
}

const Font& LargeFont()
{
  static const Font font(Theme::LargeText, true);
  return font;
}
