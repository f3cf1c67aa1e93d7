// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/ProgressPanel.h"

#include <algorithm>
#include <cmath>

void ProgressPanel::Show(const std::string& what, double share)
{
  this->What = what;
  this->Share = std::clamp(share, 0.0, 1.0);
  this->SetVisible(true);
}

void ProgressPanel::Draw(Canvas& canvas)
{
  const Rect inside = { 18, 12, canvas.Width() - 36, canvas.Height() - 24 };
  canvas.Clear(Theme::Raised);
  canvas.Frame({ 0, 0, canvas.Width(), canvas.Height() }, Theme::Line);
  canvas.Write(inside.X, inside.Y, 22, NormalFont().Shortened(this->What, inside.Width - 50),
    NormalFont(), Theme::Text);
  canvas.WriteRight(inside.Right(), inside.Y, 22,
    std::to_string(std::lround(100.0 * this->Share)) + " %", NormalFont(), Theme::Text);
  const Rect bar = { inside.X, inside.Y + 27, inside.Width, 8 };
  canvas.Fill(bar, Theme::Ground);
  canvas.Fill({ bar.X, bar.Y, static_cast<int>(std::lround(this->Share * bar.Width)), bar.Height },
    Theme::Accent);
  canvas.Write(inside.X, bar.Bottom() + 4, 20, "Escape stops it", SmallFont(), Theme::Quiet);
}
