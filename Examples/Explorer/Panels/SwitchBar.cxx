// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/SwitchBar.h"

#include "Model/Appearance.h"
#include "Model/Model.h"

#include <algorithm>
#include <cstddef>

namespace
{

constexpr int Columns = 2; // of buttons
constexpr int Gap = 6;

std::vector<Action> ActionsWithButton()
{
  std::vector<Action> buttons = AllActions();
  buttons.erase(std::remove_if(buttons.begin(), buttons.end(),
                  [](const Action& action) { return *action.Label == '\0'; }),
    buttons.end());
  return buttons;
}

int ButtonRows()
{
  return (static_cast<int>(ActionsWithButton().size()) + Columns - 1) / Columns;
}

void DrawToggle(Canvas& canvas, const Rect& row, bool isOn)
{
  const int height = std::min(row.Height - 8, 12);
  const Rect track = { row.Right() - 24, row.Y + (row.Height - height) / 2, 24, height };
  canvas.Fill(track, isOn ? Theme::Accent : Theme::Raised);
  canvas.Frame(track, isOn ? Theme::Accent : Theme::Faint);
  const int knob = height - 4;
  canvas.Fill({ isOn ? track.Right() - knob - 2 : track.X + 2, track.Y + 2, knob, knob },
    isOn ? Theme::Ground : Theme::Quiet);
}

}

int SwitchBar::Rows()
{
  // A button is a row and a fifth high with its gap; half a row above, between and below.
  return static_cast<int>(NumberOfChoices) + ButtonRows() + 3;
}

SwitchBar::SwitchBar(vtkRenderer* renderer, const Model& model)
  : Panel(renderer)
  , Shown(model)
  , Buttons(ActionsWithButton())
{
}

void SwitchBar::SetRecording(bool isRecording)
{
  this->IsRecording = isRecording;
  this->Invalidate();
}

bool SwitchBar::HasRow(std::size_t choice) const
{
  return this->Shown.Offers(AllChoices()[choice]);
}

Rect SwitchBar::RowOf(std::size_t choice) const
{
  return { Theme::Margin, this->RowHeight / 2 + static_cast<int>(choice) * this->RowHeight,
    this->Placed().Width - 2 * Theme::Margin, this->RowHeight };
}

Rect SwitchBar::ButtonOf(std::size_t button) const
{
  const int column = static_cast<int>(button) % Columns;
  const int row = static_cast<int>(button) / Columns;
  const int width = (this->Placed().Width - 2 * Theme::Margin - Gap) / Columns;
  const int height = this->RowHeight;
  const int gap = std::max(this->RowHeight / 5, 3);
  const int top = (static_cast<int>(NumberOfChoices) + 1) * this->RowHeight;
  return { Theme::Margin + column * (width + Gap), top + row * (height + gap), width, height };
}

SwitchBar::Target SwitchBar::At(int x, int y) const
{
  Target target;
  if (!this->Contains(x, y))
  {
    return target;
  }
  x -= this->Placed().X;
  y -= this->Placed().Y;
  for (std::size_t i = 0; i < NumberOfChoices; ++i)
  {
    if (this->HasRow(i) && this->RowOf(i).Contains(x, y))
    {
      target.Turned = AllChoices()[i].What;
    }
  }
  for (std::size_t i = 0; i < this->Buttons.size(); ++i)
  {
    if (this->ButtonOf(i).Contains(x, y))
    {
      target.Done = this->Buttons[i].What;
    }
  }
  return target;
}

void SwitchBar::ForEachPlace(
  const std::function<void(const std::string& name, int x, int y)>& tell) const
{
  const auto middle = [&](const std::string& name, const Rect& part)
  {
    tell(name, this->Placed().X + part.X + part.Width / 2,
      this->Placed().Y + part.Y + part.Height / 2);
  };
  for (std::size_t i = 0; i < NumberOfChoices; ++i)
  {
    if (this->HasRow(i))
    {
      middle(AllChoices()[i].Name, this->RowOf(i));
    }
  }
  for (std::size_t i = 0; i < this->Buttons.size(); ++i)
  {
    middle(this->Buttons[i].Name, this->ButtonOf(i));
  }
}

void SwitchBar::DrawChoice(Canvas& canvas, const Choice& choice, const Rect& row) const
{
  canvas.Write(row.X, row.Y, row.Height, std::string(1, choice.Key), SmallFont(), Theme::Accent);
  canvas.Write(row.X + 16, row.Y, row.Height, choice.Label, SmallFont(), Theme::Quiet);
  const Chosen& chosen = this->Shown.State().Choices;
  if (choice.IsSwitch())
  {
    DrawToggle(canvas, row, chosen.IsOn(choice.What));
    return;
  }
  int right = row.Right();
  if (choice.What == Choose::Palette && this->Shown.State().Isovalue)
  {
    const std::array<double, 2>& range = this->Shown.Counted().Range;
    const Rect strip = { right - 48, row.Y + (row.Height - 10) / 2, 48, 10 };
    for (int x = 0; x < strip.Width; ++x)
    {
      const double value = range[0] + (range[1] - range[0]) * x / (strip.Width - 1);
      canvas.Fill(
        { strip.X + x, strip.Y, 1, strip.Height }, ColorAt(this->Shown.View.Colors(), value));
    }
    right = strip.X - 8;
  }
  canvas.WriteRight(right, row.Y, row.Height, chosen.TextOf(choice.What), SmallFont(), Theme::Text);
}

void SwitchBar::DrawButton(Canvas& canvas, const Action& action, const Rect& button) const
{
  const bool isLit = action.What == Do::Record && this->IsRecording;
  canvas.Fill(button, isLit ? Theme::Warning : Theme::Raised);
  const Color key = isLit ? Theme::Ground : Theme::Accent;
  const Color text = isLit ? Theme::Ground : Theme::Text;
  canvas.Write(button.X + 8, button.Y, button.Height, std::string(1, action.Key), SmallFont(), key);
  canvas.Write(
    button.X + 24, button.Y, button.Height, isLit ? "Stop" : action.Label, SmallFont(), text);
}

void SwitchBar::Draw(Canvas& canvas)
{
  canvas.Clear(Theme::Ground);
  canvas.Fill({ 0, 0, 1, canvas.Height() }, Theme::Line);
  canvas.Fill(
    { Theme::Margin, this->RowHeight / 4, canvas.Width() - 2 * Theme::Margin, 1 }, Theme::Line);
  for (std::size_t i = 0; i < NumberOfChoices; ++i)
  {
    if (this->HasRow(i))
    {
      this->DrawChoice(canvas, AllChoices()[i], this->RowOf(i));
    }
  }
  for (std::size_t i = 0; i < this->Buttons.size(); ++i)
  {
    this->DrawButton(canvas, this->Buttons[i], this->ButtonOf(i));
  }
}
