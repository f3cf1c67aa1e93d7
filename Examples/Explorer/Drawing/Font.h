// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Font_h
#define Font_h

#include <array>
#include <string>
#include <vector>

// The printable ASCII characters of VTK's own sans-serif font in one size, drawn once. Text is put
// together from them, so that numbers may change in every frame at no cost worth naming.
class Font
{
public:
  struct Glyph
  {
    int Left = 0;   // from the pen to the first column
    int Bottom = 0; // from the line's lower edge to the lowest row
    int Width = 0;
    int Height = 0;
    int Advance = 0;                     // from this pen to the next
    std::vector<unsigned char> Coverage; // rows from the lowest
  };

  Font(int pixels, bool isBold);

  // '?' stands for what is not printable ASCII.
  const Glyph& GlyphOf(char character) const;
  int WidthOf(const std::string& text) const;
  int Height() const { return this->LineHeight; }

  // The text, its end replaced by "..." where it is wider.
  std::string Shortened(const std::string& text, int width) const;

  // The text in lines no wider than that, broken at spaces where there are some.
  std::vector<std::string> Wrapped(const std::string& text, int width) const;

private:
  static constexpr char First = ' ';
  static constexpr char Last = '~';
  std::array<Glyph, Last - First + 1> Glyphs;
  int LineHeight = 0;
};

#endif
