// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SwitchBar_h
#define SwitchBar_h

#include "Model/Actions.h"
#include "Model/Choices.h"
#include "Panels/Panel.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class Model;

// A row for each choice and buttons for actions, each with its key.
class SwitchBar : public Panel
{
public:
  // In units of Layout::RowHeight.
  static int Rows();

  SwitchBar(vtkRenderer* renderer, const Model& model);

  void SetRowHeight(int pixels) { this->RowHeight = pixels; }
  void SetRecording(bool isRecording);

  // What is at a place of the window, or nothing.
  struct Target
  {
    std::optional<Choose> Turned;
    std::optional<Do> Done;
  };
  Target At(int x, int y) const;

  // For scripts: the middle of each row and button in the window, by name.
  void ForEachPlace(const std::function<void(const std::string& name, int x, int y)>& tell) const;

protected:
  void Draw(Canvas& canvas) override;

private:
  bool HasRow(std::size_t choice) const;
  Rect RowOf(std::size_t choice) const;    // in the panel
  Rect ButtonOf(std::size_t button) const; // in the panel
  void DrawChoice(Canvas& canvas, const Choice& choice, const Rect& row) const;
  void DrawButton(Canvas& canvas, const Action& action, const Rect& button) const;

  const Model& Shown;
  std::vector<Action> Buttons;
  int RowHeight = 20;
  bool IsRecording = false;
};

#endif
