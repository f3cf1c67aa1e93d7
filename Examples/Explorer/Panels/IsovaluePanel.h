// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef IsovaluePanel_h
#define IsovaluePanel_h

#include "Panels/Panel.h"

class Model;

// The histogram of the samples, in a logarithmic scale and in the colours that surfaces have, with
// the isovalue as a line to drag.
class IsovaluePanel : public Panel
{
public:
  IsovaluePanel(vtkRenderer* renderer, const Model& model);

  // The isovalue at a column of the window.
  double IsovalueAt(int windowX) const;

  // In the window: from the least isovalue to the greatest.
  Rect PlotInWindow() const;

protected:
  void Draw(Canvas& canvas) override;

private:
  Rect Plot() const; // in the panel
  void DrawBars(Canvas& canvas, const Rect& plot) const;

  const Model& Shown;
};

#endif
