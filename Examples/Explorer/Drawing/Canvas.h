// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Canvas_h
#define Canvas_h

#include "Drawing/Font.h"
#include "Drawing/Theme.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <string>

// Pixels from the upper left corner, as mice and layouts count.
struct Rect
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  int Right() const { return this->X + this->Width; }
  int Bottom() const { return this->Y + this->Height; }
  bool Contains(int x, int y) const
  {
    return x >= this->X && x < this->Right() && y >= this->Y && y < this->Bottom();
  }
};

// An RGBA image to draw rectangles and text in.
class Canvas
{
public:
  void Resize(int width, int height);
  int Width() const { return this->Size[0]; }
  int Height() const { return this->Size[1]; }

  void Clear(const Color& color);
  void Fill(const Rect& rect, const Color& color);
  void Frame(const Rect& rect, const Color& color); // one pixel wide, inside

  // The line of text is centred between top and top + height.
  void Write(
    int left, int top, int height, const std::string& text, const Font& font, const Color& color);
  void WriteRight(
    int right, int top, int height, const std::string& text, const Font& font, const Color& color);
  void WriteMiddle(const Rect& rect, const std::string& text, const Font& font, const Color& color);

  vtkImageData* Image() { return this->Pixels; }

private:
  unsigned char* PixelAt(int x, int y); // y from the top

  int Size[2] = { 0, 0 };
  vtkNew<vtkImageData> Pixels;
};

// The fonts that all panels share; made when they are first asked for.
const Font& SmallFont();
const Font& NormalFont();
const Font& BoldFont();
const Font& LargeFont();

#endif
