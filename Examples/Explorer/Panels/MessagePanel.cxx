// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/MessagePanel.h"

#include <algorithm>

namespace
{

constexpr int Padding = 10;
constexpr int LineHeight = 19;
constexpr int MostWidth = 760;

}

void MessagePanel::Say(const std::string& sentence, bool isWarning)
{
  this->Sentence = sentence;
  this->IsWarning = isWarning;
}

void MessagePanel::Clear()
{
  this->Sentence.clear();
  this->SetVisible(false);
}

void MessagePanel::Fit(const Rect& space, int windowHeight)
{
  const int most = std::min(space.Width, MostWidth) - 2 * Padding - 3;
  this->Lines = NormalFont().Wrapped(this->Sentence, std::max(most, 20));
  int width = 0;
  for (const std::string& line : this->Lines)
  {
    width = std::max(width, NormalFont().WidthOf(line));
  }
  const int height = LineHeight * static_cast<int>(this->Lines.size()) + 2 * Padding;
  this->Place(
    { space.X, space.Y, width + 2 * Padding + 3, std::min(height, space.Height) }, windowHeight);
  this->SetVisible(this->HasMessage());
}

void MessagePanel::Draw(Canvas& canvas)
{
  canvas.Clear(Theme::Raised);
  canvas.Fill({ 0, 0, 3, canvas.Height() }, this->IsWarning ? Theme::Warning : Theme::Accent);
  int y = Padding;
  for (const std::string& line : this->Lines)
  {
    canvas.Write(3 + Padding, y, LineHeight, line, NormalFont(), Theme::Text);
    y += LineHeight;
  }
}
