// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/StatisticsPanel.h"

#include "Panels/Numbers.h"

#include <algorithm>
#include <cmath>

namespace
{

// One "label ... value" after another, down a panel.
class Table
{
public:
  Table(Canvas& canvas, int top, int rowHeight)
    : Drawn(canvas)
    , Y(top)
    , RowHeight(rowHeight)
  {
  }

  void Row(const std::string& label, const std::string& value)
  {
    this->Drawn.Write(Theme::Margin, this->Y, this->RowHeight, label, SmallFont(), Theme::Quiet);
    this->Value(value);
  }

  void RowWithKey(const std::string& label, const std::string& value, const Color& key)
  {
    const Rect square = { Theme::Margin, this->Y + (this->RowHeight - 9) / 2, 9, 9 };
    this->Drawn.Fill(square, key);
    this->Drawn.Write(
      square.Right() + 7, this->Y, this->RowHeight, label, SmallFont(), Theme::Quiet);
    this->Value(value);
  }

  // Room for something else.
  Rect Skip()
  {
    const Rect row = { Theme::Margin, this->Y, this->Drawn.Width() - 2 * Theme::Margin,
      this->RowHeight };
    this->Y += this->RowHeight;
    return row;
  }

private:
  void Value(const std::string& value)
  {
    this->Drawn.WriteRight(this->Drawn.Width() - Theme::Margin, this->Y, this->RowHeight, value,
      SmallFont(), Theme::Text);
    this->Y += this->RowHeight;
  }

  Canvas& Drawn;
  int Y;
  int RowHeight;
};

std::string Percent(double share)
{
  return Fixed(100.0 * share, 1) + " %";
}

}

void StatisticsPanel::SetVolume(const std::string& name, const std::string& description)
{
  this->Name = name;
  this->Description = description;
  this->Invalidate();
}

void StatisticsPanel::SetFacts(const FrameFacts& facts)
{
  this->Last = facts;
  this->Invalidate();
}

void StatisticsPanel::DrawShares(Canvas& canvas, const Rect& row) const
{
  Rect part = { row.X, row.Y + row.Height / 2 - 4, 0, 8 };
  const double shares[3] = { this->Last.Hits, this->Last.PossibleHits, this->Last.Misses };
  const Color colors[3] = { Theme::Hit, Theme::Possible, Theme::Miss };
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    sum = std::min(sum + shares[i], 1.0);
    part.Width = static_cast<int>(std::lround(sum * row.Width)) - (part.X - row.X);
    canvas.Fill(part, colors[i]);
    part.X = part.Right();
  }
}

void StatisticsPanel::Draw(Canvas& canvas)
{
  const int row = canvas.Height() / Rows;
  const int width = canvas.Width() - 2 * Theme::Margin;
  canvas.Clear(Theme::Ground);
  canvas.Fill({ 0, 0, 1, canvas.Height() }, Theme::Line);
  const Font& title = row < 20 ? BoldFont() : LargeFont();
  canvas.Write(
    Theme::Margin, row / 3, row * 4 / 3, title.Shortened(this->Name, width), title, Theme::Text);
  canvas.Write(Theme::Margin, row * 5 / 3, row, SmallFont().Shortened(this->Description, width),
    SmallFont(), Theme::Quiet);

  Table table(canvas, 3 * row, row);
  table.Row("Route", this->Last.Route);
  table.Row("Mapper", Fixed(this->Last.Ms, 1) + " ms");
  table.Row("Window",
    this->WindowMs > 0.0
      ? Fixed(this->WindowMs, 1) + " ms   " + Fixed(1000.0 / this->WindowMs, 0) + " frames/s"
      : "-");
  this->DrawShares(canvas, table.Skip());
  table.RowWithKey("Hits", Percent(this->Last.Hits), Theme::Hit);
  table.RowWithKey("Possible hits", Percent(this->Last.PossibleHits), Theme::Possible);
  table.RowWithKey("Misses", Percent(this->Last.Misses), Theme::Miss);
  table.Row("Rays traced", Percent(this->Last.Traced));
  table.Row("Samples a ray", Fixed(this->Last.SamplesPerRay, 1));
  table.Row("Isomap", Fixed(this->Last.IsomapMiB, 1) + " MiB");
}
