// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StatisticsPanel_h
#define StatisticsPanel_h

#include "Model/VolumeView.h"
#include "Panels/Panel.h"

#include <string>

// The volume's name, and how the last frame was made.
class StatisticsPanel : public Panel
{
public:
  static constexpr int Rows = 13;

  using Panel::Panel;

  void SetVolume(const std::string& name, const std::string& description);
  void SetFacts(const FrameFacts& facts);
  void SetWindowMs(double ms) { this->WindowMs = ms; } // shown with the next facts

protected:
  void Draw(Canvas& canvas) override;

private:
  void DrawShares(Canvas& canvas, const Rect& row) const;

  std::string Name;
  std::string Description;
  FrameFacts Last;
  double WindowMs = 0.0;
};

#endif
