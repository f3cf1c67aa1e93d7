// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/IsovaluePanel.h"

#include "Model/Appearance.h"
#include "Model/Model.h"
#include "Panels/Numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

constexpr int HeadHeight = 26;
constexpr int FootHeight = 18;

}

IsovaluePanel::IsovaluePanel(vtkRenderer* renderer, const Model& model)
  : Panel(renderer)
  , Shown(model)
{
}

Rect IsovaluePanel::Plot() const
{
  const Rect& area = this->Placed();
  return { Theme::Margin, HeadHeight, std::max(area.Width - 2 * Theme::Margin, 2),
    std::max(area.Height - HeadHeight - FootHeight, 1) };
}

Rect IsovaluePanel::PlotInWindow() const
{
  Rect plot = this->Plot();
  plot.X += this->Placed().X;
  plot.Y += this->Placed().Y;
  return plot;
}

double IsovaluePanel::IsovalueAt(int windowX) const
{
  const Rect plot = this->Plot();
  const std::array<double, 2>& range = this->Shown.Counted().Range;
  const double share = static_cast<double>(windowX - this->Placed().X - plot.X) / (plot.Width - 1);
  return range[0] + std::clamp(share, 0.0, 1.0) * (range[1] - range[0]);
}

void IsovaluePanel::DrawBars(Canvas& canvas, const Rect& plot) const
{
  const Histogram& counted = this->Shown.Counted();
  const double most = *std::max_element(counted.Bins.begin(), counted.Bins.end());
  const double scale = plot.Height / std::log1p(most);
  const auto lastBin = static_cast<double>(counted.Bins.size() - 1);
  for (int column = 0; column < plot.Width; ++column)
  {
    const double share = static_cast<double>(column) / (plot.Width - 1);
    const double value = counted.Range[0] + share * (counted.Range[1] - counted.Range[0]);
    const auto bin = static_cast<std::size_t>(share * lastBin + 0.5);
    const int height = static_cast<int>(std::ceil(scale * std::log1p(counted.Bins[bin])));
    const Color color =
      value < this->Shown.Isovalue() ? Theme::Faint : ColorAt(this->Shown.View.Colors(), value);
    canvas.Fill({ plot.X + column, plot.Bottom() - height, 1, height }, color);
  }
}

void IsovaluePanel::Draw(Canvas& canvas)
{
  canvas.Clear(Theme::Ground);
  canvas.Fill({ 0, 0, canvas.Width(), 1 }, Theme::Line);
  const Rect plot = this->Plot();
  const std::array<double, 2>& range = this->Shown.Counted().Range;
  if (!(range[0] < range[1]))
  {
    return;
  }
  this->DrawBars(canvas, plot);
  canvas.Fill({ plot.X, plot.Bottom(), plot.Width, 1 }, Theme::Line);

  const double isovalue = this->Shown.Isovalue();
  const double share = (isovalue - range[0]) / (range[1] - range[0]);
  const int x = plot.X + static_cast<int>(std::lround(share * (plot.Width - 1)));
  canvas.Fill({ x - 1, plot.Y - 4, 2, plot.Height + 4 }, Theme::Accent);
  canvas.Fill({ x - 4, plot.Y - 6, 8, 6 }, Theme::Accent);

  const int labelWidth = SmallFont().WidthOf("Isovalue");
  canvas.Write(Theme::Margin, 2, HeadHeight - 6, "Isovalue", SmallFont(), Theme::Quiet);
  canvas.Write(
    Theme::Margin + labelWidth + 8, 2, HeadHeight - 6, AsText(isovalue), BoldFont(), Theme::Text);
  canvas.Write(
    plot.X, plot.Bottom() + 1, FootHeight - 1, AsText(range[0]), SmallFont(), Theme::Quiet);
  canvas.WriteRight(
    plot.Right(), plot.Bottom() + 1, FootHeight - 1, AsText(range[1]), SmallFont(), Theme::Quiet);
}
