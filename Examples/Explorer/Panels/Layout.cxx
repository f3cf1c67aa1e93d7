// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Layout.h"

#include "Panels/StatisticsPanel.h"
#include "Panels/SwitchBar.h"

#include <algorithm>

namespace
{

constexpr int MostRowHeight = 25;
constexpr int LeastRowHeight = 15;
constexpr int LeastViewWidth = 280;

Rect Middle(const Rect& around, int width, int height)
{
  const int w = std::min(width, around.Width - 2 * Theme::Margin);
  const int h = std::min(height, around.Height - 2 * Theme::Margin);
  return { around.X + (around.Width - w) / 2, around.Y + (around.Height - h) / 2, std::max(w, 0),
    std::max(h, 0) };
}

}

Layout::Layout(int width, int height)
{
  const int rows = StatisticsPanel::Rows + SwitchBar::Rows();
  this->RowHeight = std::clamp(height / rows, LeastRowHeight, MostRowHeight);
  int bar = width < 1000 ? 220 : 264;
  if (width - bar < LeastViewWidth || this->RowHeight * rows > height)
  {
    bar = 0;
  }
  const int viewWidth = width - bar;
  const int isovalueHeight = std::clamp(height * 15 / 100, 64, 124);
  const int statisticsHeight = StatisticsPanel::Rows * this->RowHeight;
  this->View = { 0, 0, viewWidth, std::max(height - isovalueHeight, 1) };
  this->Isovalue = { 0, this->View.Height, viewWidth, height - this->View.Height };
  this->Statistics = { viewWidth, 0, bar, statisticsHeight };
  this->Switches = { viewWidth, statisticsHeight, bar, height - statisticsHeight };
  this->Message = { Theme::Margin, Theme::Margin, viewWidth - 2 * Theme::Margin,
    this->View.Height - 2 * Theme::Margin };
  this->Progress = Middle(this->View, 420, 84);
  this->List = Middle(this->View, 560, 620);
}
